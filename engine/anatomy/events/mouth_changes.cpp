#include "engine/anatomy/events/mouth_changes.h"

#include "engine/anatomy/events/change_lengths.h"

namespace carina::airway_change
{
namespace
{

constexpr double kMostOfPharynx = 0.6; ///< that its side walls come together
constexpr double kMostOfPharynxByFat = 0.35;

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

} // namespace

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

/// Its reach ends at the tonsils.
void raisePalate(AirwayField& field, const UpperAirway& airway, double rise)
{
    const double size = airway.size();
    field.swell({.p_A_centre = airway.p_A_uvula + size * 8e-3 * airway.up_A,
                 .across = size * millimetres(18.0),
                 .along = size * millimetres(18.0),
                 .shift_A = rise * size * 5e-3 * (airway.up_A - airway.forward_A()),
                 .tissues = only(AirwayTissue::Pharynx)});
}

void protrudeIncisors(AirwayField& field, const UpperAirway& airway, double severity)
{
    const double size = airway.size();
    field.swell({.p_A_centre = airway.p_A_incisors + size * 4e-3 * Vec3::UnitZ(),
                 .axis_A = Vec3::UnitX(),
                 .across = size * millimetres(15.0),
                 .along = size * millimetres(26.0),
                 .shift_A = -severity * size * 1e-3 * (7.0 * Vec3::UnitY() + 2.5 * Vec3::UnitZ()),
                 .tissues = AirwayTissues(kUpperTeethTissues | kLipsTissues)});
}

void loosenIncisor(AirwayField& field, const UpperAirway& airway, double severity)
{
    const double size = airway.size();
    field.swell({.p_A_centre = airway.p_A_incisors,
                 .across = size * millimetres(40.0),
                 .along = size * millimetres(13.0),
                 .shift_A = -severity * size * 1e-3 * (1.4 * Vec3::UnitY() + 0.5 * Vec3::UnitZ()),
                 .tissues = only(AirwayTissue::LooseTooth)});
}

} // namespace carina::airway_change
