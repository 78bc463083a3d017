#pragma once

#include "engine/anatomy/laryngoscopy/blade.h"
#include "engine/anatomy/laryngoscopy/upper_airway.h"

#include <array>

namespace carina
{

/// How far a laryngoscopy has come, named after what is to be seen from there.
enum class LaryngoscopyStep : std::uint8_t {
    Teeth,      ///< the tip at the upper incisors
    Uvula,      ///< over the tongue
    Epiglottis, ///< at the base of the tongue; nothing is lifted yet
    Partial,    ///< in the vallecula, or behind the epiglottis; not lifted wholly
    Full,       ///< lifted
};
inline constexpr std::array kLaryngoscopySteps{LaryngoscopyStep::Teeth, LaryngoscopyStep::Uvula,
                                               LaryngoscopyStep::Epiglottis,
                                               LaryngoscopyStep::Partial, LaryngoscopyStep::Full};

/// The name of a step in files and JSON: "full_view".
[[nodiscard]] const char* stepName(LaryngoscopyStep step);

/// The share of the whole lift in a step: 0 up to LaryngoscopyStep::Epiglottis, 0.7 and 1.
[[nodiscard]] double liftShare(LaryngoscopyStep step);

/// To the front and to the feet alike, in A; unit.
[[nodiscard]] Vec3 liftDirection(const UpperAirway& airway);

/// Blade and jaw of one patient at a moment.
struct LaryngoscopyPose {
    RigidTransform X_AL;
    /// Of the mandible in the frame of the head, the identity with the mouth closed.
    RigidTransform X_AJ;
    Length lift{}; ///< along the handle, from where the tip was placed
    /// How the tissue gives way, after it has followed the jaw.
    BladeField field{};
};

/// Where a blade is in one step: in the midsagittal plane, its tip where the path of a tube passes
/// over the tongue, in the end in the vallecula (or behind the epiglottis, for a blade that lifts
/// this itself), and turned so that it passes kTeethClearance below the upper incisors. The jaw
/// opens as the blade goes in, and comes forward with the lift, which is to the front and to the
/// feet alike, as a handle at 45 degrees is pulled.
///
/// @param held X_AJ of the mandible in the surfaces, where the places of the airway were found
/// @param throat by which the patient's tissue follows the jaw from there
/// @param lift   of LaryngoscopyStep::Full in grown people and children; in an infant, whose way
///               from incisors to glottis is less than 0.9 of that of the reference man, less in
///               proportion. 0.7 of it is that of Partial
/// @param neck   with which the airway moves; the blade goes in as before in the frame of the head
[[nodiscard]] LaryngoscopyPose laryngoscopyPose(const UpperAirway& airway,
                                                const ThroatField& throat, const Blade& blade,
                                                LaryngoscopyStep step, Length lift,
                                                const RigidTransform& held = {},
                                                const NeckField& neck = {});

/// The same between two steps: jaw, lift and the place of the tip are interpolated linearly, and
/// the blade is turned for these.
/// @param progress by the numbers of the steps, 0 to 4; what is beyond counts as the nearest
[[nodiscard]] LaryngoscopyPose laryngoscopyPose(const UpperAirway& airway,
                                                const ThroatField& throat, const Blade& blade,
                                                double progress, Length lift,
                                                const RigidTransform& held = {},
                                                const NeckField& neck = {});

/// The lift of a good view: of ours, for the geometry of an adult with the head in neutral
/// position.
inline constexpr Length kUsualLift = millimetres(22.0);
inline constexpr Length kTeethClearance = millimetres(5.0);

/// The places, in A, by which the tip of a blade goes in while nothing is lifted: at the teeth,
/// over the tongue, at its base, and in the vallecula or behind the epiglottis.
/// @param moved the places after they have followed the jaw
[[nodiscard]] std::array<Vec3, 4> restingWay(const UpperAirway& moved, const Blade& blade);

/// The tissue in front of a blade at a pose, wherever it is: the tongue is pushed away, and the
/// larynx is tilted with its epiglottis as far as the blade's tip has taken the vallecula forward,
/// or, by a blade that lifts the epiglottis itself, until this lies before the blade. A tip that
/// has not come down to the vallecula tilts it less the farther above it is.
/// @param moved the places after they have followed the jaw
[[nodiscard]] BladeField bladeInTissue(const UpperAirway& moved, const Blade& blade,
                                       const RigidTransform& X_AL);

/// Whether the tip of a blade is in mouth or throat: at most kMostFromWay, in an adult, from the
/// way of a tube to the glottis or from the vallecula. Of ours; a lift takes the tip 20 mm from
/// there.
/// @param moved as of bladeInTissue
[[nodiscard]] bool isInMouth(const UpperAirway& moved, const Blade& blade,
                             const RigidTransform& X_AL);
inline constexpr Length kMostFromWay = millimetres(40.0);

} // namespace carina
