#include "models/respiration/respiration_words.h"

#include <QCoreApplication>
#include <QStringList>

namespace carina
{
namespace
{

QString breathingWords(const char* text)
{
    return QCoreApplication::translate("Respiration", text);
}

} // namespace

QString conditionText(ConditionKind kind)
{
    switch (kind) {
    case ConditionKind::Normal:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Normal"));
    case ConditionKind::Ards:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "ARDS"));
    case ConditionKind::Copd:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "COPD"));
    case ConditionKind::Asthma:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Asthma"));
    case ConditionKind::SimplePneumothorax:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Pneumothorax, simple"));
    case ConditionKind::TensionPneumothorax:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Pneumothorax, tension"));
    case ConditionKind::Atelectasis:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Atelectasis"));
    case ConditionKind::MainstemIntubation:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Mainstem intubation"));
    case ConditionKind::Obstruction:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Obstruction"));
    case ConditionKind::StiffChest:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Stiff chest"));
    }
    return {};
}

QString sideText(ConditionSide side)
{
    switch (side) {
    case ConditionSide::Both:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Both lungs"));
    case ConditionSide::Right:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Right lung"));
    case ConditionSide::Left:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Left lung"));
    }
    return {};
}

QString modeText(VentilationMode mode)
{
    switch (mode) {
    case VentilationMode::Spontaneous:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Spontaneous"));
    case VentilationMode::VolumeControl:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Volume control"));
    case VentilationMode::PressureControl:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Pressure control"));
    }
    return {};
}

QString positionText(BodyPosition position)
{
    switch (position) {
    case BodyPosition::Supine:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Supine"));
    case BodyPosition::Sitting:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Sitting"));
    case BodyPosition::Prone:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Prone"));
    case BodyPosition::RightLateral:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Right lateral"));
    case BodyPosition::LeftLateral:
        return breathingWords(QT_TRANSLATE_NOOP("Respiration", "Left lateral"));
    }
    return {};
}

QString conditionText(const LungCondition& condition)
{
    if (condition.kind == ConditionKind::Normal)
        return conditionText(condition.kind);
    return QCoreApplication::translate("Respiration", "%1, %2, severity\u00a0%3",
                                       "condition; which lung; severity, 0 to 1")
        .arg(conditionText(condition.kind), sideText(condition.side).toLower())
        .arg(condition.severity, 0, 'f', 2);
}

QString conditionText(const LungConditions& conditions)
{
    if (conditions.empty())
        return conditionText(ConditionKind::Normal);
    QStringList texts;
    for (const LungCondition& condition : conditions)
        texts += conditionText(condition);
    return texts.join(QStringLiteral(" + "));
}

QString ventilatorText(const VentilatorSettings& settings)
{
    const QString mode = modeText(settings.mode);
    if (settings.mode == VentilationMode::Spontaneous)
        return mode;
    const QString withPeep =
        QCoreApplication::translate("Respiration", "%1, PEEP\u00a0%2\u00a0cmH2O",
                                    "how it is ventilated")
            .arg(mode)
            .arg(inCmH2O(settings.peep), 0, 'f', 0);
    if (settings.mode == VentilationMode::VolumeControl)
        return withPeep;
    return QCoreApplication::translate("Respiration", "%1, %2\u00a0cmH2O above it",
                                       "ventilation with its PEEP; pressure")
        .arg(withPeep)
        .arg(inCmH2O(settings.drivingPressure), 0, 'f', 0);
}

} // namespace carina
