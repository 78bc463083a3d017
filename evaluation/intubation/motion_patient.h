#pragma once

#include "engine/anatomy/airway/centreline.h"
#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/geometry/deformation/neck_field.h"
#include "engine/geometry/deformation/throat_field.h"
#include "evaluation/intubation/way_walls.h"

#include <array>
#include <cstdint>

namespace carina
{

/// Where the tip of a tube is led.
enum class TipTarget : std::uint8_t { Trachea, RightMain, LeftMain, Oesophagus, Arytenoid };
inline constexpr std::array kTipTargets{TipTarget::Trachea, TipTarget::RightMain,
                                        TipTarget::LeftMain, TipTarget::Oesophagus,
                                        TipTarget::Arytenoid};

/// A way of a tube's tip in the surfaces of a patient, and arc lengths along it, metres. All ways
/// of a patient are the same up to the fork.
struct TipWay {
    Centreline line_A;  ///< from kPathInFrontOfTeeth in front of the incisors
    double teeth = 0.0; ///< at the upper incisors
    double fork = 0.0;  ///< kForkAboveGlottis, in an adult, above the glottis
    double gate = 0.0;  ///< at the level of the glottis, in it or behind; of the arytenoid: its end
    double carina = 0.0; ///< at the carina's level across the trachea, of the ways that pass it
    double end = 0.0;
    /// Around it, from the teeth on, in ascending order; what a tube opens for itself is round.
    std::vector<WallsAround> walls{};
};
inline constexpr Length kForkAboveGlottis = millimetres(15.0); ///< of ours

/// The airway that a laryngoscope is put into, and X_AJ of the mandible in its surfaces.
struct AirwayForBlade {
    UpperAirway upper;
    ThroatField throat;
    RigidTransform held;
};

/// A patient, as a motion of evaluation/intubation knows one: places and lines, found from the
/// surfaces here and not by what is to be measured with the motion.
struct MotionPatient {
    AirwayLandmarks airway;
    UpperAirway upper;
    ThroatField throat;
    RigidTransform held; ///< X_AJ of the mandible in the surfaces
    /// That of these surfaces; where there are others, in which nothing holds tongue and larynx,
    /// that of these.
    AirwayForBlade forBlade;
    std::array<TipWay, kTipTargets.size()> ways;

    [[nodiscard]] const TipWay& way(TipTarget target) const
    {
        return ways[static_cast<std::size_t>(target)];
    }
};

/// Finds the ways:
///
/// - trachea: the path of the landmarks;
/// - a main bronchus: from that, well above the carina, into the means of the bronchus' surface at
///   two distances from the carina, and straight on;
/// - oesophagus: from the fork behind the arytenoids into the means of its sections, from its upper
///   end down;
/// - arytenoid: from the fork onto the right one, beside the interarytenoid notch.
///
/// The walls around them are those of mouth, throat, larynx and trachea; main bronchi and
/// oesophagus, of which surfaces tell the middle and not how far they let a tube, are of the usual
/// width, as is what lies beside an arytenoid.
///
/// @param held X_AJ of the mandible in the surfaces (heldJaw)
/// @returns NoAirway with what is missing
[[nodiscard]] Result<MotionPatient> motionPatient(const Anatomy& anatomy,
                                                  const RigidTransform& held);

/// How jaw and neck of a patient lie at a moment.
struct HeldTissue {
    RigidTransform X_AJ; ///< of the mandible in the frame of the head, the identity if shut
    NeckField neck;
};

/// A place of a way where neck and jaw have taken it. Between the teeth and midway to the glottis
/// the way follows the jaw more and more, as the tip goes along the palate there.
[[nodiscard]] Vec3 placeOnWay(const MotionPatient& patient, const TipWay& way, double along,
                              const HeldTissue& tissue);

/// The length of a piece of a way as neck and jaw have taken it; negative where `to` is before
/// `from`.
[[nodiscard]] Length lengthOfWay(const MotionPatient& patient, const TipWay& way, double from,
                                 double to, const HeldTissue& tissue);

} // namespace carina
