#include "apps/lab/patient_options.h"

#include "apps/lab/condition_names.h"
#include "apps/lab/figures_option.h"
#include "engine/anatomy/builtin_patient.h"
#include "engine/io/anatomy_set.h"

namespace carina::lab
{
namespace
{

constexpr double kUsualSeverity = 0.6;

struct NamedVentilator {
    std::string_view name;
    VentilationMode mode;
};

constexpr std::array kNamedVentilators{
    NamedVentilator{"none", VentilationMode::Spontaneous},
    NamedVentilator{"volume", VentilationMode::VolumeControl},
    NamedVentilator{"pressure", VentilationMode::PressureControl}};

} // namespace

void addPatientOptions(QCommandLineParser& parser)
{
    addValueOptions(parser, {"anatomy", "patient", "condition", "severity", "side", "ventilator"});
}

Result<LungCondition> conditionOption(const QCommandLineParser& parser, const char* command)
{
    const auto kind =
        wordOption(parser, command, "condition", kNamedConditions, &NamedCondition::kind);
    if (!kind)
        return tl::unexpected(kind.error());
    const auto side = wordOption(parser, command, "side", kNamedSides, &NamedSide::side);
    if (!side)
        return tl::unexpected(side.error());
    const bool hasSeverity = parser.isSet(QStringLiteral("severity"));
    const auto severity = hasSeverity ? numberOption(parser, command, "severity", 0.0, 1.0)
                                      : Result<double>{kUsualSeverity};
    if (!severity)
        return tl::unexpected(severity.error());
    if (*kind == ConditionKind::Normal) {
        if (hasSeverity || parser.isSet(QStringLiteral("side")))
            return fail(Errc::OutOfRange,
                        std::string{command}
                            + " takes --severity and --side of a --condition that is not normal.");
        return LungCondition{};
    }
    if (*kind == ConditionKind::MainstemIntubation && *side == ConditionSide::Both)
        return fail(Errc::OutOfRange,
                    std::string{command} + " needs --side for a tube in a main bronchus.");
    return LungCondition{*kind, *severity, *side};
}

Result<VentilationMode> ventilatorOption(const QCommandLineParser& parser, const char* command)
{
    return wordOption(parser, command, "ventilator", kNamedVentilators, &NamedVentilator::mode);
}

std::string_view ventilatorName(VentilationMode mode)
{
    return std::ranges::find(kNamedVentilators, mode, &NamedVentilator::mode)->name;
}

Result<Subject> subjectOption(const QCommandLineParser& parser, const char* command)
{
    const bool isSet = parser.isSet(QStringLiteral("anatomy"));
    const auto figures =
        figuresOption(parser, command, isSet ? BuiltinPatient::Adult : BuiltinPatient::TwelveYears);
    if (!figures)
        return tl::unexpected(figures.error());
    const PatientBuild build = buildOf(dimensionsFor(*figures).value());
    if (isSet) {
        return loadAnatomySet(parser.value(QStringLiteral("anatomy")).toStdString(),
                              AnatomyCache::defaultFolder())
            .map([&](LoadedSet&& loaded) {
                return Subject{std::move(loaded.set.anatomy), build};
            });
    }
    return patientFor(*figures).map([&](Anatomy&& anatomy) {
        return Subject{std::move(anatomy), build};
    });
}

} // namespace carina::lab
