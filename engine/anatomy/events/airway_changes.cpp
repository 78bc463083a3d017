#include "engine/anatomy/events/airway_changes.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace carina
{
namespace
{

/// Lengths below are those of a man at severity 1. Whatever is of the larynx is in proportion to
/// his glottis as upperAirwayOf finds it, whatever is of the epiglottis to its height, all else to
/// his way from incisors to glottis.
constexpr Length kMansGlottis = millimetres(24.5);
constexpr Length kMansEpiglottis = millimetres(29.1);

/// Of cords that are open as in the surfaces, in shares of the length of the glottis: a V, and its
/// two sides as far apart behind the vocal processes.
constexpr double kProcesses = 0.6;
constexpr double kHalfInFront = 0.018;
constexpr double kHalfAtProcesses = 0.21;

/// Widths of the glottis, in those of the surfaces, at both ends of a quiet breath.
constexpr double kWidestGlottis = 10.1 / 9.0;
constexpr double kNarrowestGlottis = 5.7 / 9.0;

constexpr double kMostOfVestibule = 0.55; ///< that the folds come together
constexpr double kMostOfPharynx = 0.6;
constexpr double kMostOfPharynxByFat = 0.35;
constexpr double kMostOfTrachea = 0.75; ///< of its diameter, in a stenosis
constexpr double kMostOfTracheaByGoitre = 0.35;

/// What a burn swells, as a share of the event that does nothing else.
constexpr double kTongueByBurn = 0.3;
constexpr double kPharynxByBurn = 0.7;
constexpr double kEpiglottisByBurn = 0.4;
constexpr double kEntranceByBurn = 0.7;

/// What they look like: of ours.
constexpr Rgb kPale{236, 196, 184};
constexpr Rgb kCherry{182, 22, 40};
constexpr Rgb kErythema{158, 38, 40};
constexpr Rgb kSoot{44, 37, 33};

/// Both tissues that the tongue's base and the epiglottis before it are of.
constexpr auto kThroatAndLarynx =
    AirwayTissues(only(AirwayTissue::Throat) | only(AirwayTissue::Larynx));

/// Those that the lower lip, and the upper one with its gum, are of.
constexpr auto kLipsTissues = AirwayTissues(only(AirwayTissue::Throat) | only(AirwayTissue::Skin));

/// Across the midplane, to the right of who looks at the patient from the front.
Vec3 rightOf(const UpperAirway& airway) { return airway.up_A.cross(airway.forward_A()); }
Vec3 patientsRightOf(const UpperAirway& airway) { return -rightOf(airway); }

/// Two narrowings of one lumen by these shares, one after the other.
double bothShares(double one, double other) { return 1.0 - (1.0 - one) * (1.0 - other); }

/// Of the narrowest that events make of it, at least what the breath leaves.
double cordsClosing(double severity, double inspiration)
{
    const double breath = (kInspirationAsMade - inspiration) * (kWidestGlottis - kNarrowestGlottis);
    return std::lerp(breath, AirwayField::kMostClosing, severity);
}

void moveCords(AirwayField& field, const UpperAirway& airway, double closing)
{
    const Length glottis = airway.glottis();
    field.closeCords({.p_A_front = airway.p_A_commissure,
                      .right_A = rightOf(airway),
                      .back_A = -airway.forward_A(),
                      .up_A = airway.up_A,
                      .toWidest = kProcesses * glottis,
                      .halfInFront = kHalfInFront * glottis,
                      .halfAtWidest = kHalfAtProcesses * glottis},
                     closing);
}

/// The more severe, the longer: up to kShutFrom it is not shut, but comes to be. It ends where its
/// narrowing fades behind.
void joinCords(AirwayField& field, const UpperAirway& airway, double severity)
{
    constexpr double kShortest = 0.25; // of the glottis
    constexpr double kLongest = 0.6;
    constexpr double kShutFrom = 0.2;
    constexpr double kEnd = std::midpoint(formula::kNarrowBack, formula::kNarrowEnd);
    const Length glottis = airway.glottis();
    const double toWidest = std::lerp(kShortest, kLongest, severity) / kEnd;
    const double widest = std::min(formula::kNarrowBack * toWidest / kProcesses, 1.0);
    field.joinCords({.p_A_front = airway.p_A_commissure,
                     .right_A = rightOf(airway),
                     .back_A = -airway.forward_A(),
                     .up_A = airway.up_A,
                     .toWidest = toWidest * glottis,
                     .halfInFront = kHalfInFront * glottis,
                     .halfAtWidest = std::lerp(kHalfInFront, kHalfAtProcesses, widest) * glottis},
                    std::min(severity / kShutFrom, 1.0) * AirwayField::kMostClosing);
}

void swellTongue(AirwayField& field, const UpperAirway& airway, double severity)
{
    const double size = airway.size();
    const Vec3 upAndBack = (airway.up_A - 0.5 * airway.forward_A()).normalized();
    field.swell({.p_A_centre = *airway.p_A_tongue,
                 .across = size * millimetres(42.0),
                 .along = size * millimetres(42.0),
                 .outward = severity * size * millimetres(9.0),
                 .shift_A = severity * size * 5e-3 * upAndBack,
                 .depth = size * millimetres(8.0),
                 .tissues = only(AirwayTissue::Throat)});
    const Vec3 p_A_base =
        0.5 * (airway.p_A_vallecula + airway.p_A_epiglottisTip) + size * 16e-3 * airway.forward_A();
    field.swell({.p_A_centre = p_A_base,
                 .across = size * millimetres(30.0),
                 .along = size * millimetres(30.0),
                 .outward = severity * size * millimetres(5.0),
                 .shift_A = severity * size * 1e-3 * (3.0 * airway.up_A - 9.0 * airway.forward_A()),
                 .depth = size * millimetres(8.0)});
}

/// By swelling, and by fat.
void narrowPharynx(AirwayField& field, const UpperAirway& airway, double swelling, double fat)
{
    const double size = airway.size();
    const auto fromUvula = [&](double forward_mm, double down_mm) {
        return Vec3{airway.p_A_uvula
                    + size * 1e-3 * (forward_mm * airway.forward_A() - down_mm * airway.up_A)};
    };
    field.narrowPharynx({.p_A_front = fromUvula(13.0, 3.0),
                         .right_A = rightOf(airway),
                         .back_A = -airway.forward_A(),
                         .up_A = airway.up_A,
                         .toWidest = size * millimetres(20.0),
                         .halfInFront = size * millimetres(17.0),
                         .halfAtWidest = size * millimetres(17.0),
                         .outer = 1.7},
                        bothShares(swelling * kMostOfPharynx, fat * kMostOfPharynxByFat));
    field.swell({.p_A_centre = fromUvula(-16.0, 5.0),
                 .axis_A = airway.up_A,
                 .across = size * millimetres(22.0),
                 .along = size * millimetres(34.0),
                 .outward = swelling * size * millimetres(1.5),
                 .shift_A = size * 1e-3 * (6.0 * swelling + 3.0 * fat) * airway.forward_A()});
}

void swellEpiglottis(AirwayField& field, const UpperAirway& airway, double severity)
{
    constexpr double kMiddle = 0.62; // of its height
    const Vec3 leaf = airway.p_A_epiglottisTip - airway.p_A_epiglottisBase;
    const double size = leaf.norm() / kMansEpiglottis.si;
    field.swell({.p_A_centre = airway.p_A_epiglottisBase + kMiddle * leaf,
                 .axis_A = rightOf(airway).cross(leaf).normalized(),
                 .across = size * millimetres(20.0),
                 .along = size * millimetres(14.0),
                 .outward = severity * size * millimetres(7.5),
                 .depth = size * millimetres(1.5),
                 .isFlat = true});
}

void swellEntrance(AirwayField& field, const UpperAirway& airway, double severity)
{
    const Length glottis = airway.glottis();
    const double size = glottis / kMansGlottis;
    field.narrowVestibule({.p_A_front = airway.p_A_commissure + size * 12e-3 * airway.up_A,
                           .right_A = rightOf(airway),
                           .back_A = -airway.forward_A(),
                           .up_A = airway.up_A,
                           .toWidest = kProcesses * glottis,
                           .halfInFront = size * millimetres(3.2),
                           .halfAtWidest = size * millimetres(9.2),
                           .outer = 1.5},
                          severity * kMostOfVestibule);
    field.swell({.p_A_centre = airway.p_A_notch
                               + size * 1e-3 * (8.0 * airway.up_A - 2.0 * airway.forward_A()),
                 .across = size * millimetres(16.0),
                 .along = size * millimetres(16.0),
                 .outward = severity * size * millimetres(4.0),
                 .shift_A = severity * size * 1e-3 * (4.0 * airway.forward_A() + 1.5 * airway.up_A),
                 .depth = size * millimetres(2.0)});
}

/// Its reach ends above the vallecula, so that the leaf bends.
void letEpiglottisFall(AirwayField& field, const UpperAirway& airway, double severity)
{
    const Vec3 leaf = airway.p_A_epiglottisTip - airway.p_A_epiglottisBase;
    const double size = leaf.norm() / kMansEpiglottis.si;
    field.swell(
        {.p_A_centre = airway.p_A_epiglottisTip,
         .axis_A = leaf.normalized(),
         .across = size * millimetres(24.0),
         .along = size * millimetres(25.0),
         .shift_A = -severity * size * 1e-3 * (13.0 * airway.forward_A() + 4.0 * airway.up_A),
         .tissues = kThroatAndLarynx});
}

/// Its reach ends at the upper end of the trachea, 26 mm below the cords of a man, and near the
/// vallecula, where a blade's tip is.
void moveLarynxForward(AirwayField& field, const UpperAirway& airway, double severity)
{
    const double size = airway.glottis() / kMansGlottis;
    const Vec3 p_A_middle = 0.5 * (airway.p_A_commissure + airway.p_A_notch);
    field.swell(
        {.p_A_centre = p_A_middle - size * 5e-3 * airway.up_A,
         .axis_A = airway.up_A,
         .across = size * millimetres(34.0),
         .along = size * millimetres(20.0),
         .shift_A = severity * size * 1e-3 * (11.0 * airway.forward_A() + 2.0 * airway.up_A)});
}

/// Within the same reach, so that trachea and vallecula stay.
void pressLarynx(AirwayField& field, const UpperAirway& airway, double severity)
{
    const double size = airway.glottis() / kMansGlottis;
    const Vec3 p_A_middle = 0.5 * (airway.p_A_commissure + airway.p_A_notch);
    field.swell({.p_A_centre = p_A_middle - size * 5e-3 * airway.up_A,
                 .axis_A = airway.up_A,
                 .across = size * millimetres(34.0),
                 .along = size * millimetres(20.0),
                 .shift_A = severity * size * 1e-3
                            * (-8.0 * airway.forward_A() + 4.0 * airway.up_A
                               + 6.0 * patientsRightOf(airway))});
}

/// By a stenosis from all sides, by a goitre from both.
void narrowTrachea(AirwayField& field, const UpperAirway& airway, double stenosis, double goitre)
{
    constexpr double kMiddle = std::midpoint(formula::kNarrowFront, formula::kNarrowBack);
    constexpr double kReach = 1.4; // of half the width
    const WindpipePlace& place = *airway.windpipe;
    const Length toWidest = metres(std::max(
        {airway.windpipeSize() * 15e-3, kReach * place.halfWidth.si, kReach * place.halfDepth.si}));
    const double fromMiddle = kMiddle * toWidest.si;
    const auto lumen = [&](const Vec3& across_A, const Vec3& along_A, Length half) {
        return Lumen{.p_A_front = place.p_A_middle - fromMiddle * along_A,
                     .right_A = across_A,
                     .back_A = along_A,
                     .up_A = airway.up_A,
                     .toWidest = toWidest,
                     .halfInFront = half,
                     .halfAtWidest = half,
                     .outer = 1.6};
    };
    field.narrowWindpipe(lumen(rightOf(airway), -airway.forward_A(), place.halfWidth),
                         bothShares(stenosis * kMostOfTrachea, goitre * kMostOfTracheaByGoitre));
    field.flattenWindpipe(lumen(airway.forward_A(), rightOf(airway), place.halfDepth),
                          stenosis * kMostOfTrachea);
}

/// Its reach ends at the upper end of the trachea, and where the lungs come near it below.
void moveTrachea(AirwayField& field, const UpperAirway& airway, double deviation, double goitre)
{
    const double size = airway.windpipeSize();
    field.swell(
        {.p_A_centre = airway.windpipe->p_A_middle - size * 15e-3 * airway.up_A,
         .axis_A = airway.up_A,
         .across = size * millimetres(40.0),
         .along = size * millimetres(34.0),
         .shift_A = size * 1e-3 * (14.0 * deviation + 5.0 * goitre) * patientsRightOf(airway),
         .tissues = only(AirwayTissue::Windpipe)});
}

/// The skin before a goitre.
void bulgeNeck(AirwayField& field, const UpperAirway& airway, double severity)
{
    if (!airway.p_A_neck)
        return;
    const double size = airway.windpipeSize();
    field.swell({.p_A_centre = *airway.p_A_neck - size * 8e-3 * airway.forward_A(),
                 .axis_A = rightOf(airway),
                 .across = size * millimetres(36.0),
                 .along = size * millimetres(60.0),
                 .shift_A = severity * size * 16e-3 * airway.forward_A(),
                 .tissues = only(AirwayTissue::Skin)});
}

/// What fat does but to the walls of the pharynx: the base of the tongue, and the skin all round.
void thickenNeck(AirwayField& field, const UpperAirway& airway, double severity)
{
    const double size = airway.size();
    field.swell({.p_A_centre = 0.5 * (airway.p_A_vallecula + airway.p_A_epiglottisTip)
                               + size * 16e-3 * airway.forward_A(),
                 .across = size * millimetres(30.0),
                 .along = size * millimetres(30.0),
                 .outward = severity * size * millimetres(3.0),
                 .shift_A = severity * size * 1e-3 * (airway.up_A - 4.0 * airway.forward_A()),
                 .depth = size * millimetres(8.0)});
    const double neck = airway.windpipeSize();
    field.swell({.p_A_centre =
                     0.5 * (airway.p_A_commissure + airway.p_A_notch) - neck * 20e-3 * airway.up_A,
                 .axis_A = airway.up_A,
                 .across = neck * millimetres(125.0),
                 .along = neck * millimetres(60.0),
                 .outward = severity * neck * millimetres(30.0),
                 .depth = neck * millimetres(30.0),
                 .tissues = only(AirwayTissue::Skin)});
}

/// To the front and down as the face has it. Roots and jaw stay.
void protrudeIncisors(AirwayField& field, const UpperAirway& airway, double severity)
{
    const double size = airway.size();
    field.swell({.p_A_centre = airway.p_A_incisors + size * 4e-3 * Vec3::UnitZ(),
                 .axis_A = Vec3::UnitX(),
                 .across = size * millimetres(15.0),
                 .along = size * millimetres(26.0),
                 .shift_A = -severity * size * 1e-3 * (7.0 * Vec3::UnitY() + 2.5 * Vec3::UnitZ()),
                 .tissues = AirwayTissues(only(AirwayTissue::Teeth) | kLipsTissues)});
}

void swellLip(AirwayField& field, const UpperAirway& airway, const Vec3& p_A_lip, double severity)
{
    const double size = airway.size();
    field.swell({.p_A_centre = p_A_lip,
                 .axis_A = rightOf(airway),
                 .across = size * millimetres(16.0),
                 .along = size * millimetres(30.0),
                 .outward = severity * size * millimetres(5.0),
                 .shift_A = severity * size * 4e-3 * airway.forward_A(),
                 .tissues = kLipsTissues});
}

/// Lips and the front of the tongue; what swells of the larynx does so by swellEntrance.
void swellMouth(AirwayField& field, const UpperAirway& airway, double severity)
{
    for (const auto& p_A_lip : {airway.p_A_upperLip, airway.p_A_lowerLip})
        if (p_A_lip)
            swellLip(field, airway, *p_A_lip, severity);
    if (!airway.p_A_tongue)
        return;
    const double size = airway.size();
    field.swell({.p_A_centre = *airway.p_A_tongue
                               + size * 1e-3 * (18.0 * airway.forward_A() + 8.0 * airway.up_A),
                 .across = size * millimetres(24.0),
                 .along = size * millimetres(24.0),
                 .outward = severity * size * millimetres(5.0),
                 .shift_A = severity * size * 3e-3 * (airway.forward_A() + airway.up_A),
                 .depth = size * millimetres(6.0),
                 .tissues = only(AirwayTissue::Throat)});
}

/// Where swellMouth and swellEntrance swell it: little blood is left in what is so tense.
void makePale(AirwayField& field, const UpperAirway& airway, double severity)
{
    constexpr double kMost = 0.6;
    const double size = airway.size();
    if (airway.p_A_upperLip && airway.p_A_lowerLip)
        field.tint({.p_A_centre = 0.5 * (*airway.p_A_upperLip + *airway.p_A_lowerLip),
                    .axis_A = rightOf(airway),
                    .across = size * millimetres(26.0),
                    .along = size * millimetres(36.0),
                    .color = kPale,
                    .share = kMost * severity,
                    .tissues = kLipsTissues});
    if (airway.p_A_tongue)
        field.tint({.p_A_centre = *airway.p_A_tongue
                                  + size * 1e-3 * (18.0 * airway.forward_A() + 8.0 * airway.up_A),
                    .across = size * millimetres(32.0),
                    .along = size * millimetres(32.0),
                    .color = kPale,
                    .share = kMost * severity,
                    .tissues = only(AirwayTissue::Throat)});
    const double larynx = airway.glottis() / kMansGlottis;
    field.tint({.p_A_centre = airway.p_A_notch + larynx * 8e-3 * airway.up_A,
                .across = larynx * millimetres(22.0),
                .along = larynx * millimetres(22.0),
                .color = kPale,
                .share = kMost * severity,
                .tissues = only(AirwayTissue::Larynx)});
}

/// The epiglottis and what of the folds is at it, not the cords.
void reddenEpiglottis(AirwayField& field, const UpperAirway& airway, double severity)
{
    constexpr double kMost = 0.8;
    constexpr double kMiddle = 0.7; // of its height
    const Vec3 leaf = airway.p_A_epiglottisTip - airway.p_A_epiglottisBase;
    const double size = leaf.norm() / kMansEpiglottis.si;
    field.tint({.p_A_centre = airway.p_A_epiglottisBase + kMiddle * leaf,
                .axis_A = leaf.normalized(),
                .across = size * millimetres(25.0),
                .along = size * millimetres(22.0),
                .color = kCherry,
                .share = kMost * severity,
                .tissues = only(AirwayTissue::Larynx)});
}

/// Red from the mouth to the cords, and soot on tongue, palate and epiglottis.
void scorch(AirwayField& field, const UpperAirway& airway, double severity)
{
    constexpr double kMostRed = 0.7;
    constexpr double kMostSoot = 0.8;
    const double size = airway.size();
    field.tint({.p_A_centre = 0.5 * (airway.p_A_uvula + airway.p_A_epiglottisTip),
                .across = size * millimetres(75.0),
                .along = size * millimetres(75.0),
                .color = kErythema,
                .share = kMostRed * severity});
    const auto blacken = [&](const Vec3& p_A_centre, Length reach, AirwayTissue tissue) {
        field.tint({.p_A_centre = p_A_centre,
                    .across = size * reach,
                    .along = size * reach,
                    .color = kSoot,
                    .share = kMostSoot * severity,
                    .tissues = only(tissue)});
    };
    if (airway.p_A_tongue)
        blacken(*airway.p_A_tongue + size * 12e-3 * airway.up_A, millimetres(30.0),
                AirwayTissue::Throat);
    blacken(airway.p_A_uvula, millimetres(24.0), AirwayTissue::Pharynx);
    blacken(airway.p_A_epiglottisTip, millimetres(20.0), AirwayTissue::Larynx);
}

} // namespace

AirwayField airwayChanges(const UpperAirway& airway, const AirwayEvents& events, double inspiration)
{
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
    change(swollen(AirwayEventKind::TongueOedema, kTongueByBurn), swellTongue);
    change(severityOf(AirwayEventKind::AngioOedema), swellMouth);
    const auto changeByBoth = [&](double one, double other, auto how) {
        if (one > 0.0 || other > 0.0)
            how(field, airway, one, other);
    };
    changeByBoth(swollen(AirwayEventKind::PharyngealSwelling, kPharynxByBurn),
                 severityOf(AirwayEventKind::NeckObesity), narrowPharynx);
    changeByBoth(severityOf(AirwayEventKind::TrachealStenosis), severityOf(AirwayEventKind::Goitre),
                 narrowTrachea);
    change(swollen(AirwayEventKind::Epiglottitis, kEpiglottisByBurn), swellEpiglottis);
    change(std::max(swollen(AirwayEventKind::LaryngealOedema, kEntranceByBurn),
                    severityOf(AirwayEventKind::AngioOedema)),
           swellEntrance);
    change(severityOf(AirwayEventKind::FloppyEpiglottis), letEpiglottisFall);
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
