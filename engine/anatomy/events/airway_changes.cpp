#include "engine/anatomy/events/airway_changes.h"

#include "engine/anatomy/events/change_lengths.h"
#include "engine/anatomy/events/color_changes.h"
#include "engine/anatomy/events/larynx_changes.h"
#include "engine/anatomy/events/mouth_changes.h"
#include "engine/anatomy/events/neck_changes.h"
#include "engine/anatomy/events/swallow.h"
#include "engine/anatomy/events/throat_room.h"
#include "engine/core/expects.h"

#include <algorithm>

namespace carina
{

AirwayField airwayChanges(const UpperAirway& airway, const AirwayEvents& events, double inspiration)
{
    using namespace airway_change;
    CARINA_EXPECTS(areProper(events) && inspiration >= 0.0 && inspiration <= 1.0);
    const ShowsEvent shows = [&airway](AirwayEventKind kind) { return canShow(airway, kind); };
    const AirwayEvents drawn = asDrawn(events, shows);
    const auto drawnSeverity = [&drawn](AirwayEventKind kind) { return severityOf(drawn, kind); };
    AirwayField field;
    const double swallow = drawnSeverity(AirwayEventKind::Swallowing);
    const double shut =
        std::max(drawnSeverity(AirwayEventKind::Laryngospasm), cordsInSwallow(swallow));
    const double closing = cordsClosing(shut, inspiration);
    if (closing != 0.0 && shows(AirwayEventKind::Laryngospasm))
        moveCords(field, airway, closing);
    const auto change = [&](double severity, auto how) {
        if (severity > 0.0)
            how(field, airway, severity);
    };
    change(drawnSeverity(AirwayEventKind::LaryngealWeb), joinCords);
    change(drawnSeverity(AirwayEventKind::TongueOedema), swellTongue);
    change(drawnSeverity(AirwayEventKind::AngioOedema), swellMouth);
    const auto changeByBoth = [&](AirwayEventKind one, AirwayEventKind other, auto how) {
        if (drawnSeverity(one) > 0.0 || drawnSeverity(other) > 0.0)
            how(field, airway, drawnSeverity(one), drawnSeverity(other));
    };
    changeByBoth(AirwayEventKind::PharyngealSwelling, AirwayEventKind::NeckObesity, narrowPharynx);
    changeByBoth(AirwayEventKind::TrachealStenosis, AirwayEventKind::Goitre, narrowTrachea);
    change(drawnSeverity(AirwayEventKind::Epiglottitis), swellEpiglottis);
    change(std::max(drawnSeverity(AirwayEventKind::LaryngealOedema),
                    drawnSeverity(AirwayEventKind::AngioOedema)),
           swellEntrance);
    change(drawnSeverity(AirwayEventKind::FloppyEpiglottis), letEpiglottisFall);
    change(drawnSeverity(AirwayEventKind::AnteriorLarynx), moveLarynxForward);
    change(drawnSeverity(AirwayEventKind::ExternalPressure), pressLarynx);
    changeByBoth(AirwayEventKind::TrachealDeviation, AirwayEventKind::Goitre, moveTrachea);
    change(drawnSeverity(AirwayEventKind::Goitre), bulgeNeck);
    change(drawnSeverity(AirwayEventKind::NeckObesity), thickenNeck);
    change(drawnSeverity(AirwayEventKind::ProminentIncisors), protrudeIncisors);
    change(drawnSeverity(AirwayEventKind::FragileTeeth), loosenIncisor);
    change(riseInSwallow(swallow), raisePalate);
    change(riseInSwallow(swallow), raiseLarynx); // with all that was changed before
    change(drawnSeverity(AirwayEventKind::AngioOedema), makePale);
    if (shows(AirwayEventKind::Epiglottitis)) // as red as it was set
        change(severityOf(events, AirwayEventKind::Epiglottitis), reddenEpiglottis);
    change(drawnSeverity(AirwayEventKind::Burn), scorch);
    return field;
}

bool canShow(const UpperAirway& airway, AirwayEventKind kind)
{
    using airway_change::kMansEpiglottis;
    using airway_change::kMansGlottis;
    constexpr double kLeastOfMans = 0.1; // smaller ones are none
    const bool hasWay = airway.size() > kLeastOfMans;
    const bool hasGlottis = airway.glottis() > kLeastOfMans * kMansGlottis;
    switch (kind) {
    case AirwayEventKind::TongueOedema:
        return hasWay && airway.p_A_tongue;
    case AirwayEventKind::PharyngealSwelling:
    case AirwayEventKind::NeckObesity:
    case AirwayEventKind::Trismus:
    case AirwayEventKind::StiffNeck:
        return hasWay;
    case AirwayEventKind::ProminentIncisors:
    case AirwayEventKind::FragileTeeth:
        return hasWay && airway.hasIncisors;
    case AirwayEventKind::TrachealStenosis:
    case AirwayEventKind::TrachealDeviation:
    case AirwayEventKind::Goitre:
        return airway.windpipe && airway.windpipeSize() > kLeastOfMans;
    case AirwayEventKind::Epiglottitis:
    case AirwayEventKind::FloppyEpiglottis:
        return (airway.p_A_epiglottisTip - airway.p_A_epiglottisBase).norm()
               > kLeastOfMans * kMansEpiglottis.si;
    case AirwayEventKind::AngioOedema:
    case AirwayEventKind::Burn:
    case AirwayEventKind::Secretions:
    case AirwayEventKind::Blood:
    case AirwayEventKind::Vomit:
    case AirwayEventKind::ForeignBody:
    case AirwayEventKind::Swallowing:
        return hasWay && hasGlottis;
    case AirwayEventKind::LaryngealOedema:
    case AirwayEventKind::Laryngospasm:
    case AirwayEventKind::AnteriorLarynx:
    case AirwayEventKind::LaryngealWeb:
    case AirwayEventKind::ExternalPressure:
        break;
    }
    return hasGlottis;
}

std::string_view partNeeded(AirwayEventKind kind)
{
    switch (kind) {
    case AirwayEventKind::TongueOedema:
        return "a tongue";
    case AirwayEventKind::TrachealStenosis:
    case AirwayEventKind::TrachealDeviation:
    case AirwayEventKind::Goitre:
        return "a trachea";
    case AirwayEventKind::ProminentIncisors:
    case AirwayEventKind::FragileTeeth:
        return "upper incisors";
    default:
        return {};
    }
}

} // namespace carina
