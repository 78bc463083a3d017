#include "engine/anatomy/events/airway_event.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

constexpr std::array<const char*, kAirwayEventKinds> kNames{"tongue_oedema",
                                                            "pharyngeal_swelling",
                                                            "epiglottitis",
                                                            "laryngeal_oedema",
                                                            "laryngospasm",
                                                            "floppy_epiglottis",
                                                            "anterior_larynx",
                                                            "angio_oedema",
                                                            "laryngeal_web",
                                                            "external_pressure",
                                                            "tracheal_stenosis",
                                                            "tracheal_deviation",
                                                            "goitre",
                                                            "neck_obesity",
                                                            "prominent_incisors",
                                                            "trismus",
                                                            "stiff_neck",
                                                            "burn",
                                                            "secretions",
                                                            "blood",
                                                            "vomit",
                                                            "foreign_body",
                                                            "fragile_teeth",
                                                            "swallowing"};

} // namespace

const char* eventName(AirwayEventKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<AirwayEventKind> eventNamed(std::string_view name)
{
    const auto found = std::ranges::find(kNames, name);
    if (found == kNames.end())
        return std::nullopt;
    return static_cast<AirwayEventKind>(found - kNames.begin());
}

double severityOf(const AirwayEvents& events, AirwayEventKind kind)
{
    const auto found = std::ranges::find(events, kind, &AirwayEvent::kind);
    return found == events.end() ? 0.0 : found->severity;
}

void worsen(AirwayEvents& events, const AirwayEvent& by)
{
    if (by.severity <= 0.0)
        return;
    const auto place = std::ranges::lower_bound(events, by.kind, {}, &AirwayEvent::kind);
    if (place == events.end() || place->kind != by.kind)
        events.insert(place, by);
    else
        place->severity = std::max(place->severity, by.severity);
}

bool areProper(const AirwayEvents& events)
{
    const auto unordered = std::ranges::adjacent_find(
        events, [](const AirwayEvent& a, const AirwayEvent& b) { return a.kind >= b.kind; });
    return unordered == events.end() && std::ranges::all_of(events, [](const AirwayEvent& event) {
               return static_cast<int>(event.kind) < kAirwayEventKinds && event.severity >= 0.0
                      && event.severity <= 1.0;
           });
}

} // namespace carina
