#include "apps/lab/patient_options.h"

#include "apps/lab/condition_names.h"
#include "engine/anatomy/builtin_patient.h"
#include "engine/io/anatomy_set.h"

namespace carina::lab
{
namespace
{

constexpr double kUsualSeverity = 0.6;

template <class Kind>
Result<Kind> namedOption(const QCommandLineParser& parser, const char* command, const char* name,
                         std::optional<Kind> (*named)(std::string_view))
{
    if (!parser.isSet(QString::fromLatin1(name)))
        return Kind{};
    const std::string word = parser.value(QString::fromLatin1(name)).toStdString();
    const auto kind = named(word);
    if (!kind)
        return fail(Errc::OutOfRange,
                    std::string{command} + " knows no --" + name + " " + word + ".");
    return *kind;
}

Result<Subject> builtinSubject(BuiltinPatient patient)
{
    return builtinPatient(patient).map([patient](Anatomy&& anatomy) {
        return Subject{std::move(anatomy), buildOf(dimensionsOf(patient))};
    });
}

} // namespace

void addValueOptions(QCommandLineParser& parser, std::initializer_list<const char*> names)
{
    for (const char* name : names) {
        const QString word = QString::fromLatin1(name);
        parser.addOption(QCommandLineOption{word, {}, word});
    }
}

void addPatientOptions(QCommandLineParser& parser)
{
    addValueOptions(parser, {"anatomy", "patient", "condition", "severity", "side"});
}

Result<double> numberOption(const QCommandLineParser& parser, const char* command, const char* name,
                            double least, double greatest)
{
    bool isNumber = false;
    const double number = parser.value(QString::fromLatin1(name)).toDouble(&isNumber);
    if (!isNumber || !(number >= least && number <= greatest)) {
        return fail(Errc::OutOfRange,
                    QStringLiteral("%1 needs --%2 with a number from %3 to %4.")
                        .arg(QString::fromLatin1(command), QString::fromLatin1(name))
                        .arg(least)
                        .arg(greatest)
                        .toStdString());
    }
    return number;
}

Result<LungCondition> conditionOption(const QCommandLineParser& parser, const char* command)
{
    const auto kind = namedOption(parser, command, "condition", conditionNamed);
    if (!kind)
        return tl::unexpected(kind.error());
    const auto side = namedOption(parser, command, "side", sideNamed);
    if (!side)
        return tl::unexpected(side.error());
    const auto severity = parser.isSet(QStringLiteral("severity"))
                              ? numberOption(parser, command, "severity", 0.0, 1.0)
                              : Result<double>{kUsualSeverity};
    if (!severity)
        return tl::unexpected(severity.error());
    if (*kind == ConditionKind::MainstemIntubation && *side == ConditionSide::Both)
        return fail(Errc::OutOfRange,
                    std::string{command} + " needs --side for a tube in a main bronchus.");
    return LungCondition{*kind, *kind == ConditionKind::Normal ? 0.0 : *severity, *side};
}

Result<Subject> subjectOption(const QCommandLineParser& parser, const char* command)
{
    const QString patient = parser.value(QStringLiteral("patient"));
    if (parser.isSet(QStringLiteral("anatomy"))) {
        if (!patient.isEmpty())
            return fail(Errc::OutOfRange,
                        std::string{command} + " takes --anatomy or --patient, not both.");
        return loadAnatomySet(parser.value(QStringLiteral("anatomy")).toStdString(),
                              AnatomyCache::defaultFolder())
            .map([](LoadedSet&& loaded) {
                return Subject{std::move(loaded.set.anatomy), PatientBuild{}};
            });
    }
    if (patient == QStringLiteral("adult"))
        return builtinSubject(BuiltinPatient::Adult);
    if (patient.isEmpty() || patient == QStringLiteral("child"))
        return builtinSubject(BuiltinPatient::TwelveYears);
    return fail(Errc::OutOfRange,
                std::string{command} + " knows --patient adult and --patient child.");
}

} // namespace carina::lab
