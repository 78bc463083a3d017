#include "apps/lab/command/patient_options.h"

#include "apps/lab/command/patient_words.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/io/anatomy_set/anatomy_set.h"

namespace carina::lab
{
namespace
{

constexpr double kUsualSeverity = 0.6;

/// Who is meant where `--anatomy` and `--patient` stand beside each other.
Result<PatientParameters> subjectFigures(const Words& words)
{
    return patientOption(words,
                         words.has(kAnatomy) ? BuiltinPatient::Adult : BuiltinPatient::TwelveYears);
}

} // namespace

Result<PatientParameters> patientOption(const Words& words, BuiltinPatient otherwise)
{
    if (!words.has(kPatient))
        return parametersOf(otherwise);
    const auto figures = patientFromWords(words.text(kPatient).toStdString());
    if (!figures)
        return words.refuse(
            QStringLiteral("--patient: %1.").arg(QString::fromStdString(figures.error().detail)));
    return figures;
}

Result<LungCondition> conditionOption(const Words& words)
{
    const auto kind = words.word(kCondition, kNamedConditions, &NamedCondition::kind);
    if (!kind)
        return tl::unexpected(kind.error());
    const auto side = words.word(kSide, kNamedSides, &NamedSide::side);
    if (!side)
        return tl::unexpected(side.error());
    const auto severity = words.number(kSeverity, 0.0, 1.0, kUsualSeverity);
    if (!severity)
        return tl::unexpected(severity.error());
    if (*kind == ConditionKind::Normal) {
        if (words.has(kSeverity) || words.has(kSide))
            return words.refuse(
                QStringLiteral("takes --severity and --side of a --condition that is not normal."));
        return LungCondition{};
    }
    if (*kind == ConditionKind::MainstemIntubation && *side == ConditionSide::Both)
        return words.refuse(QStringLiteral("needs --side for a tube in a main bronchus."));
    return LungCondition{*kind, *severity, *side};
}

Result<VentilationMode> ventilatorOption(const Words& words)
{
    return words.word(kVentilator, kNamedVentilators, &NamedVentilator::mode);
}

Result<BodyPosition> positionOption(const Words& words)
{
    if (!words.has(kPosition))
        return BodyPosition::Supine;
    const std::string word = words.text(kPosition).toStdString();
    for (const BodyPosition position : kBodyPositions)
        if (positionName(position) == word)
            return position;
    return words.refuse(QStringLiteral("has no --position %1.").arg(QString::fromStdString(word)));
}

Result<PatientBuild> buildOption(const Words& words)
{
    return subjectFigures(words).map(
        [](const PatientParameters& figures) { return buildOf(dimensionsFor(figures).value()); });
}

Result<Subject> subjectOption(const Words& words)
{
    const auto figures = subjectFigures(words);
    if (!figures)
        return tl::unexpected(figures.error());
    const PatientBuild build = buildOf(dimensionsFor(*figures).value());
    if (words.has(kAnatomy)) {
        return loadAnatomySet(words.text(kAnatomy).toStdString(), AnatomyCache::defaultFolder())
            .map([&](LoadedSet&& loaded) {
                return Subject{std::move(loaded.set.anatomy), build};
            });
    }
    return patientFor(*figures).map([&](Anatomy&& anatomy) {
        return Subject{std::move(anatomy), build};
    });
}

Result<Anatomy> restingOption(const Words& words)
{
    if (words.has(kAnatomy))
        return loadAnatomySet(words.text(kAnatomy).toStdString(), AnatomyCache::defaultFolder())
            .map([](LoadedSet&& loaded) { return std::move(loaded.set.anatomy); });
    return patientOption(words, BuiltinPatient::Adult).and_then([](const PatientParameters& who) {
        return patientFor(who, Posture::Rest);
    });
}

} // namespace carina::lab
