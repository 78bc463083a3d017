#include "engine/anatomy/events/neck_changes.h"

#include "engine/anatomy/events/change_lengths.h"

#include <algorithm>
#include <numeric>

namespace carina::airway_change
{
namespace
{

constexpr double kMostOfTrachea = 0.75; ///< of its diameter, in a stenosis
constexpr double kMostOfTracheaByGoitre = 0.35;

} // namespace

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

} // namespace carina::airway_change
