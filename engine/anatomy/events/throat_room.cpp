#include "engine/anatomy/events/throat_room.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

/// What a burn swells, as a share of the event that does nothing else.
constexpr std::array kSwollenByBurn{AirwayEvent{AirwayEventKind::TongueOedema, 0.3},
                                    AirwayEvent{AirwayEventKind::PharyngealSwelling, 0.7},
                                    AirwayEvent{AirwayEventKind::Epiglottitis, 0.4},
                                    AirwayEvent{AirwayEventKind::LaryngealOedema, 0.7}};

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
    const double burn = severityOf(drawn, AirwayEventKind::Burn);
    for (const AirwayEvent& ofBurn : kSwollenByBurn)
        if (shows(ofBurn.kind))
            worsen(drawn, {ofBurn.kind, ofBurn.severity * burn});
    double together = 0.0;
    for (const AirwayEventKind kind : kInThroat)
        together += severityOf(drawn, kind);
    for (AirwayEvent& event : drawn)
        if (together > kMostInThroat && isInThroat(event))
            event.severity *= kMostInThroat / together;
    return drawn;
}

} // namespace carina
