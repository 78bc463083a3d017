#include "apps/lab/rendering/event_option.h"

#include "apps/lab/command/words.h"
#include "models/airway/airway_presets.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

QString eventNames()
{
    QStringList names;
    for (int kind = 0; kind < kAirwayEventKinds; ++kind)
        names += QString::fromLatin1(eventName(static_cast<AirwayEventKind>(kind)));
    return names.join(QStringLiteral(", "));
}

/// Of "NAME" or "NAME=S".
Result<AirwayEvent> eventOf(const Words& words, const QString& given, double usual)
{
    const QString name = given.section(QLatin1Char('='), 0, 0);
    const auto kind = eventNamed(name.toStdString());
    if (!kind)
        return words.refuse(
            QStringLiteral("has no --event %1; choose one of %2.").arg(name, eventNames()));
    if (name == given)
        return AirwayEvent{*kind, usual};
    bool isNumber = false;
    const double severity = given.mid(name.size() + 1).toDouble(&isNumber);
    if (!isNumber || !(severity >= 0.0 && severity <= 1.0))
        return words.refuse(
            QStringLiteral("needs --event %1 with a severity from 0 to 1.").arg(name));
    return AirwayEvent{*kind, severity};
}

Result<AirwayEvents> eventsOfPreset(const Words& words)
{
    if (words.has(kEvent) || words.has(kEventSeverity))
        return words.refuse(QStringLiteral("takes --preset or --event, not both."));
    if (const AirwayPreset* preset = presetNamed(words.text(kPreset).toStdString()))
        return preset->events;
    QStringList names;
    for (const AirwayPreset& preset : airwayPresets())
        names += QString::fromUtf8(preset.name.data(), qsizetype(preset.name.size()));
    return words.unknownWord(kPreset, names);
}

} // namespace

Result<AirwayEvents> eventsOption(const Words& words)
{
    if (words.has(kPreset))
        return eventsOfPreset(words);
    if (words.has(kEventSeverity) && !words.has(kEvent))
        return words.refuse(QStringLiteral("takes --severity of an --event."));
    const auto usual = words.number(kEventSeverity, 0.0, 1.0, 1.0);
    if (!usual)
        return tl::unexpected(usual.error());
    AirwayEvents events;
    for (const QString& given : words.texts(kEvent)) {
        const auto event = eventOf(words, given, *usual);
        if (!event)
            return tl::unexpected(event.error());
        events.push_back(*event);
    }
    std::ranges::sort(events, {}, &AirwayEvent::kind);
    if (!areProper(events))
        return words.refuse(QStringLiteral("takes each --event once."));
    return events;
}

Result<AirwayEvents> eachEventOption(const Words& words)
{
    if (words.has(kEvent))
        return eventsOption(words);
    return words.number(kEventSeverity, 0.0, 1.0, 1.0).map([](double severity) {
        AirwayEvents events;
        for (int kind = 0; kind < kAirwayEventKinds; ++kind)
            events.push_back({static_cast<AirwayEventKind>(kind), severity});
        return events;
    });
}

} // namespace carina::lab
