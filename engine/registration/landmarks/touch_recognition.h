#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// The landmarks of a catalogue and their touches so far.
struct TouchesSoFar {
    std::span<const Vec3> p_AQ;                ///< the landmarks in the anatomy frame A, metres
    std::span<const std::optional<Vec3>> p_TQ; ///< touches, in the tracker frame T; nothing: open
};

/// The classification of a new touch.
enum class TouchVerdict : std::uint8_t {
    Landmark,  ///< an open landmark
    Again,     ///< a landmark that was touched before: replaces that touch
    Renamed,   ///< only fits if earlier touches are assigned to other landmarks
    Ambiguous, ///< several landmarks are possible
    Nowhere,   ///< no landmark
};

/// The result of recogniseTouch.
struct TouchFinding {
    TouchVerdict verdict = TouchVerdict::Nowhere;
    /// Catalogue index of the touched landmark; of the most likely one where there is none.
    std::size_t landmark = 0;
    std::vector<std::size_t> candidates{}; ///< where ambiguous: all possible, most likely first
    /// Distance of the touch from `landmark` by a fit of the other touches; nothing where they do
    /// not determine a fit.
    std::optional<Length> distance{};
    /// Where renamed: the new assignment of all touches, with this one, per landmark.
    std::vector<std::optional<Vec3>> renamed_p_TQ{};
};

/// Recognises which landmark a new touch is, so that landmarks can be touched in any order.
///
/// With n touches assigned to landmarks, the statistic of the hypothesis "landmark k" is
///
///     chi^2_k = (misfit of n + 1 with the new touch at k - misfit of n) / (FLE^2 / 3)
///
/// with the misfits of poseMisfit. It is chi-squared distributed with as many degrees of freedom as
/// the n touches constrain the new point: three where they determine a pose, two for two touches or
/// touches on a line, one for a single touch. For a landmark touched before, the smaller of two
/// statistics is used, from the distance of both touches and from the fit of the others, so that an
/// earlier touch at a wrong place can be replaced.
///
/// The landmark of the smallest chi^2 is accepted where it is below the kPlausibleShare quantile
/// and all others are at least kClearLead larger (a likelihood ratio of 1000). While the touches do
/// not determine a pose, distances alone cannot tell left from right; then the proposed landmark is
/// accepted where it is plausible. This assignment is wrong if another landmark was touched; that
/// shows as soon as four or more touches do not fit together, and a search over all assignments
/// then finds the one that explains them.
///
/// A touch that is nowhere is judged again with the landmarks at the size of the manikin, where the
/// touches, four or more with this one, show that it differs from that of the anatomy
/// (manikinScale).
///
/// @param p_TQ     the new touch, in T, metres
/// @param fle      the fiducial localisation error, RMS, above 0
/// @param proposed the open landmark that the user was asked to touch
/// @pre `earlier` has as many touches as landmarks; `proposed` is open.
/// @returns TooFewLandmarks for a catalogue of fewer than three; NotFinite for NaN or infinity and
///          OutOfRange for a kilometre or more.
[[nodiscard]] Result<TouchFinding> recogniseTouch(const TouchesSoFar& earlier, const Vec3& p_TQ,
                                                  Length fle,
                                                  std::optional<std::size_t> proposed = {});

/// A likelihood ratio of 1000 as a difference of chi-squared: 2 ln 1000.
inline constexpr double kClearLead = 13.8155;

} // namespace carina
