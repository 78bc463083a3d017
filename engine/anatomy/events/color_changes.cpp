#include "engine/anatomy/events/color_changes.h"

#include "engine/anatomy/events/change_lengths.h"

namespace carina::airway_change
{
namespace
{

constexpr Rgb kPale{236, 196, 184};
constexpr Rgb kCherry{182, 22, 40};
constexpr Rgb kErythema{158, 38, 40};
constexpr Rgb kSoot{44, 37, 33};

} // namespace

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

} // namespace carina::airway_change
