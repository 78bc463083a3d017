#include "engine/anatomy/events/throat_room.h"

#include "engine/anatomy/events/swallow.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <span>

namespace carina
{
namespace
{

/// What a burn swells, as a share of the event that does nothing else.
constexpr std::array kSwollenByBurn{AirwayEvent{AirwayEventKind::TongueOedema, 0.3},
                                    AirwayEvent{AirwayEventKind::PharyngealSwelling, 0.7},
                                    AirwayEvent{AirwayEventKind::Epiglottitis, 0.4},
                                    AirwayEvent{AirwayEventKind::LaryngealOedema, 0.7}};

/// What comes together in a swallow while the larynx rises, likewise.
constexpr std::array kMovedBySwallow{AirwayEvent{AirwayEventKind::PharyngealSwelling, 0.5},
                                     AirwayEvent{AirwayEventKind::LaryngealOedema, 0.6},
                                     AirwayEvent{AirwayEventKind::FloppyEpiglottis, 0.8}};

constexpr std::array kInThroat{AirwayEventKind::TongueOedema, AirwayEventKind::PharyngealSwelling,
                               AirwayEventKind::Epiglottitis, AirwayEventKind::FloppyEpiglottis};
constexpr double kMostInThroat = 2.0;

bool isInThroat(const AirwayEvent& event)
{
    return std::ranges::find(kInThroat, event.kind) != kInThroat.end();
}

} // namespace

AirwayEvents asDrawn(const AirwayEvents& events, const ShowsEvent& shows)
{
    CARINA_EXPECTS(areProper(events));
    AirwayEvents drawn = events;
    std::erase_if(drawn, [&shows](const AirwayEvent& event) { return !shows(event.kind); });
    const auto worsenAll = [&](std::span<const AirwayEvent> by, double severity) {
        for (const AirwayEvent& each : by)
            if (shows(each.kind))
                worsen(drawn, {each.kind, each.severity * severity});
    };
    worsenAll(kSwollenByBurn, severityOf(drawn, AirwayEventKind::Burn));
    worsenAll(kMovedBySwallow, riseInSwallow(severityOf(drawn, AirwayEventKind::Swallowing)));
    double together = 0.0;
    for (const AirwayEventKind kind : kInThroat)
        together += severityOf(drawn, kind);
    for (AirwayEvent& event : drawn)
        if (together > kMostInThroat && isInThroat(event))
            event.severity *= kMostInThroat / together;
    return drawn;
}

} // namespace carina
