#include "apps/lab/figures_option.h"

#include "engine/anatomy/patient_name.h"

namespace carina::lab
{

Result<PatientParameters> figuresOption(const QCommandLineParser& parser, const char* command,
                                        BuiltinPatient otherwise)
{
    const QString option = QStringLiteral("patient");
    if (!parser.isSet(option))
        return parametersOf(otherwise);
    const auto figures = patientFromWords(parser.value(option).toStdString());
    if (!figures)
        return fail(Errc::OutOfRange,
                    std::string{command} + " --patient: " + figures.error().detail + ".");
    return figures;
}

} // namespace carina::lab
