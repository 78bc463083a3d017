#include "models/vitals/vital_words.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace carina
{
namespace
{

QString vitalWords(const char* text) { return QCoreApplication::translate("Vitals", text); }

QString inWhole(double value) { return QString::number(std::lround(value)); }

/// More than what is heard everywhere on a chest.
bool isHeard(double loudness) { return loudness > 1.5 * kThroughChest; }

} // namespace

QString alarmText(const VitalAlarms::Active& alarm, const AlarmLimits& limits)
{
    switch (alarm.alarm) {
    case VitalAlarm::NoHeartbeat:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "No heartbeat"));
    case VitalAlarm::Apnoea:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "Apnoea: no exhaled CO2 for %1\u00a0s"))
            .arg(inWhole(toSeconds(limits.apnoea)));
    case VitalAlarm::LowSaturation: {
        const bool isVeryLow = alarm.priority == AlarmPriority::High;
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "SpO2 below %1\u00a0%"))
            .arg(inWhole(100.0 * (isVeryLow ? limits.veryLowSaturation : limits.lowSaturation)));
    }
    case VitalAlarm::SlowHeart:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "Heart rate below %1\u00a0/min"))
            .arg(inWhole(inPerMinute(limits.slowHeart)));
    case VitalAlarm::FastHeart:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "Heart rate above %1\u00a0/min"))
            .arg(inWhole(inPerMinute(limits.fastHeart)));
    case VitalAlarm::LowPressure:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "Systolic pressure below %1\u00a0mmHg"))
            .arg(inWhole(inMmHg(limits.lowSystolic)));
    case VitalAlarm::HighPressure:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "Systolic pressure above %1\u00a0mmHg"))
            .arg(inWhole(inMmHg(limits.highSystolic)));
    case VitalAlarm::NoProbe:
        break;
    }
    return vitalWords(QT_TRANSLATE_NOOP("Vitals", "Oximeter probe off"));
}

QString priorityText(AlarmPriority priority)
{
    switch (priority) {
    case AlarmPriority::High:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "high priority"));
    case AlarmPriority::Medium:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "medium priority"));
    case AlarmPriority::Low:
        break;
    }
    return vitalWords(QT_TRANSLATE_NOOP("Vitals", "low priority"));
}

QString soundText(SoundKind kind)
{
    switch (kind) {
    case SoundKind::Oximeter:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "Oximeter tone"));
    case SoundKind::Alarm:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "Alarms"));
    case SoundKind::Breath:
        return vitalWords(QT_TRANSLATE_NOOP("Vitals", "Breath sounds"));
    case SoundKind::Heart:
        break;
    }
    return vitalWords(QT_TRANSLATE_NOOP("Vitals", "Heart tones"));
}

QString heardText(const VitalsModel::Heard& heard)
{
    if (!heard.isOnChest)
        return {};
    QStringList parts;
    const auto add = [&parts](double loudness, const char* text) {
        if (isHeard(loudness))
            parts << vitalWords(text);
    };
    add(heard.loudness.right, QT_TRANSLATE_NOOP("Vitals", "right lung"));
    add(heard.loudness.left, QT_TRANSLATE_NOOP("Vitals", "left lung"));
    add(heard.loudness.trachea, QT_TRANSLATE_NOOP("Vitals", "trachea"));
    add(heard.loudness.stomach, QT_TRANSLATE_NOOP("Vitals", "gurgling in the stomach"));
    add(heard.loudness.heart, QT_TRANSLATE_NOOP("Vitals", "heart"));
    if (heard.wheezes)
        parts << vitalWords(QT_TRANSLATE_NOOP("Vitals", "wheezing"));
    return parts.isEmpty() ? vitalWords(QT_TRANSLATE_NOOP("Vitals", "nothing is heard here"))
                           : parts.join(QStringLiteral(", "));
}

} // namespace carina
