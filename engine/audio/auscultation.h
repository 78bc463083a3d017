#pragma once

#include "engine/core/units.h"

namespace carina
{

/// Distances of a stethoscope, for which a trainee holds the stylus's tip, from where each sound
/// comes from: the middle of each lung, the stomach, the heart and the trachea in the neck, each as
/// it projects onto the skin; and from the skin itself.
struct AuscultationDistances {
    Length right{};
    Length left{};
    Length stomach{};
    Length heart{};
    Length trachea{};
    Length skin{};
};

/// How loud each sound is heard there, 0 to 1.
struct AuscultationGains {
    double right = 0.0;
    double left = 0.0;
    double stomach = 0.0;
    double heart = 0.0;
    double trachea = 0.0;

    friend bool operator==(const AuscultationGains&, const AuscultationGains&) = default;
};

/// What a stethoscope hears at a place.
///
/// Nothing farther than kAuscultationContact from the skin. Else each gain is a Gaussian of the
/// distance with the standard deviation kAuscultationReach, and at least kThroughChest: breath
/// sounds of one lung are heard over the other, which is why a tube in a main bronchus is missed by
/// ear. Lengths and shares are of ours.
/// @param scale the patient's height as a share of a grown person's, by which the reach scales
/// @pre scale is above 0
[[nodiscard]] AuscultationGains auscultate(const AuscultationDistances& distances,
                                           double scale = 1.0);

inline constexpr Length kAuscultationContact = millimetres(15.0);
inline constexpr Length kAuscultationReach = millimetres(45.0);
inline constexpr double kThroughChest = 0.06;

} // namespace carina
