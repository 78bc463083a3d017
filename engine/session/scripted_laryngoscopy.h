#pragma once

#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"
#include "engine/core/session_time.h"

namespace carina
{

/// The patient and the blade of a scripted laryngoscopy.
struct LaryngoscopyScript {
    UpperAirway airway;  ///< as found in the surfaces
    ThroatField throat;  ///< by which they follow the jaw
    RigidTransform held; ///< X_AJ of the mandible in the surfaces
    Blade blade = bladeOf(BladeKind::Macintosh3);
    Length lift = kUsualLift;
    Duration period = std::chrono::seconds{20};
};

/// Blade and jaw at a time of a laryngoscopy that repeats: from the teeth over the tongue into the
/// vallecula and lifted within the first 36 % of the period, held so up to 74 %, and out the same
/// way. Continuous in time, and at rest in each step. A pure function of time.
/// @param neck with which the airway lies; the pose of the jaw is in the frame of the head
[[nodiscard]] LaryngoscopyPose scriptedLaryngoscopy(const LaryngoscopyScript& script, SessionTime t,
                                                    const NeckField& neck = {});

/// By how much of a period a scripted tube (ScriptedHands) comes later than it does by itself. It
/// is brought in from 10 % to 50 % by itself: so from 34 % to 74 %, where the blade's lift ends,
/// which is at least 0.7 of the whole from 30 % on.
inline constexpr double kTubeAfterBlade = 0.24;

} // namespace carina
