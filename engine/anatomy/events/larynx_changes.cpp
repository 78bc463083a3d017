#include "engine/anatomy/events/larynx_changes.h"

#include "engine/anatomy/events/airway_changes.h"
#include "engine/anatomy/events/change_lengths.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace carina::airway_change
{
namespace
{

/// Of cords that are open as in the surfaces, in shares of the length of the glottis: a V, and its
/// two sides as far apart behind the vocal processes.
constexpr double kProcesses = 0.6;
constexpr double kHalfInFront = 0.018;
constexpr double kHalfAtProcesses = 0.21;

/// Widths of the glottis, in those of the surfaces, at both ends of a quiet breath.
constexpr double kWidestGlottis = 10.1 / 9.0;
constexpr double kNarrowestGlottis = 5.7 / 9.0;

constexpr double kMostOfVestibule = 0.55; ///< that the folds come together

/// Both tissues that the tongue's base and the epiglottis before it are of.
constexpr auto kThroatAndLarynx =
    AirwayTissues(only(AirwayTissue::Throat) | only(AirwayTissue::Larynx));
/// And what the larynx takes along.
constexpr auto kThroatAndNeck =
    AirwayTissues(kThroatTissues | only(AirwayTissue::Windpipe) | only(AirwayTissue::Skin));

} // namespace

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

/// Up to kShutFrom it is not shut, but comes to be. It ends where its narrowing fades behind.
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

/// With all that surrounds it but spine and jaw.
void raiseLarynx(AirwayField& field, const UpperAirway& airway, double rise)
{
    const double size = airway.glottis() / kMansGlottis;
    const Vec3 p_A_middle = 0.5 * (airway.p_A_commissure + airway.p_A_notch);
    field.swell({.p_A_centre = p_A_middle + size * 6e-3 * airway.forward_A(),
                 .axis_A = airway.up_A,
                 .across = size * millimetres(70.0),
                 .along = size * millimetres(60.0),
                 .shift_A = rise * size * 1e-3 * (17.0 * airway.up_A + 7.0 * airway.forward_A()),
                 .tissues = kThroatAndNeck});
}

} // namespace carina::airway_change
