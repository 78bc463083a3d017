#include "engine/anatomy/events/airway_changes.h"

#include "engine/anatomy/events/change_lengths.h"
#include "engine/anatomy/events/color_changes.h"
#include "engine/anatomy/events/larynx_changes.h"
#include "engine/anatomy/events/mouth_changes.h"
#include "engine/anatomy/events/neck_changes.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <initializer_list>
#include <numeric>

namespace carina
{
namespace
{

/// What a burn swells, as a share of the event that does nothing else.
constexpr double kTongueByBurn = 0.3;
constexpr double kPharynxByBurn = 0.7;
constexpr double kEpiglottisByBurn = 0.4;
constexpr double kEntranceByBurn = 0.7;

/// Swollen tongue, pharynx and epiglottis, and one that has fallen back, take the same room, the
/// throat's: two of them at their worst fill it, and of more each has less. Of ours.
constexpr double kMostInThroat = 2.0;

double shareOfThroat(std::initializer_list<double> severities)
{
    const double together = std::accumulate(severities.begin(), severities.end(), 0.0);
    return together > kMostInThroat ? kMostInThroat / together : 1.0;
}

} // namespace

AirwayField airwayChanges(const UpperAirway& airway, const AirwayEvents& events, double inspiration)
{
    using namespace airway_change;
    CARINA_EXPECTS(areProper(events) && inspiration >= 0.0 && inspiration <= 1.0);
    const auto severityOf = [&](AirwayEventKind kind) {
        const auto found = std::ranges::find(events, kind, &AirwayEvent::kind);
        return found == events.end() || !canShow(airway, kind) ? 0.0 : found->severity;
    };
    AirwayField field;
    const double closing = cordsClosing(severityOf(AirwayEventKind::Laryngospasm), inspiration);
    if (closing != 0.0 && canShow(airway, AirwayEventKind::Laryngospasm))
        moveCords(field, airway, closing);
    const auto change = [&](double severity, auto how) {
        if (severity > 0.0)
            how(field, airway, severity);
    };
    change(severityOf(AirwayEventKind::LaryngealWeb), joinCords);
    const double burn = severityOf(AirwayEventKind::Burn);
    const auto swollen = [&](AirwayEventKind kind, double ofBurn) {
        return canShow(airway, kind) ? std::max(severityOf(kind), ofBurn * burn) : 0.0;
    };
    const double tongue = swollen(AirwayEventKind::TongueOedema, kTongueByBurn);
    const double pharynx = swollen(AirwayEventKind::PharyngealSwelling, kPharynxByBurn);
    const double epiglottis = swollen(AirwayEventKind::Epiglottitis, kEpiglottisByBurn);
    const double floppy = severityOf(AirwayEventKind::FloppyEpiglottis);
    const double share = shareOfThroat({tongue, pharynx, epiglottis, floppy});
    change(share * tongue, swellTongue);
    change(severityOf(AirwayEventKind::AngioOedema), swellMouth);
    const auto changeByBoth = [&](double one, double other, auto how) {
        if (one > 0.0 || other > 0.0)
            how(field, airway, one, other);
    };
    changeByBoth(share * pharynx, severityOf(AirwayEventKind::NeckObesity), narrowPharynx);
    changeByBoth(severityOf(AirwayEventKind::TrachealStenosis), severityOf(AirwayEventKind::Goitre),
                 narrowTrachea);
    change(share * epiglottis, swellEpiglottis);
    change(std::max(swollen(AirwayEventKind::LaryngealOedema, kEntranceByBurn),
                    severityOf(AirwayEventKind::AngioOedema)),
           swellEntrance);
    change(share * floppy, letEpiglottisFall);
    change(severityOf(AirwayEventKind::AnteriorLarynx), moveLarynxForward);
    change(severityOf(AirwayEventKind::ExternalPressure), pressLarynx);
    changeByBoth(severityOf(AirwayEventKind::TrachealDeviation),
                 severityOf(AirwayEventKind::Goitre), moveTrachea);
    change(severityOf(AirwayEventKind::Goitre), bulgeNeck);
    change(severityOf(AirwayEventKind::NeckObesity), thickenNeck);
    change(severityOf(AirwayEventKind::ProminentIncisors), protrudeIncisors);
    change(severityOf(AirwayEventKind::AngioOedema), makePale);
    change(severityOf(AirwayEventKind::Epiglottitis), reddenEpiglottis);
    change(burn, scorch);
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
