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

/// Landmarks of a catalogue, and those of them that are touched.
struct TouchesSoFar {
    std::span<const Vec3> p_AQ;                ///< where they are, in the anatomy frame A, metres
    std::span<const std::optional<Vec3>> p_TQ; ///< of each, in the tracker frame T; nothing: open
};

/// What one more touch is.
enum class TouchVerdict : std::uint8_t {
    Landmark,  ///< an open landmark
    Again,     ///< a landmark that was touched before: to be done anew
    Renamed,   ///< none as the others are named; another naming of all touches explains it
    Ambiguous, ///< several landmarks would do
    Nowhere,   ///< no landmark
};

struct TouchFinding {
    TouchVerdict verdict = TouchVerdict::Nowhere;
    /// The landmark touched, by its place in the catalogue; otherwise the likeliest.
    std::size_t landmark = 0;
    std::vector<std::size_t> candidates{}; ///< where ambiguous: all that would do, likeliest first
    /// Of the touch from the place of `landmark`, by a fit to the others; nothing where they
    /// determine none.
    std::optional<Length> distance{};
    /// Where renamed: all touches, this one too, by their landmarks.
    std::vector<std::optional<Vec3>> renamed_p_TQ{};
};

/// Recognises which landmark a new touch is, so that landmarks can be touched in any order.
///
/// With n touches named, the touch speaks against landmark k by
///
///     chi^2_k = (misfit of all n + 1, the new one being k, less misfit of the n) / (FLE^2 / 3)
///
/// with misfits as poseMisfit. For errors of this size it is chi-squared with as many degrees of
/// freedom as the n hold the new point by: three where they determine a pose, so that it judges the
/// distance from where their fit has k; two for two or a line; one for a distance to a single one.
/// A landmark touched before is judged by the distance of the two touches, or by the fit of the
/// others, whichever is kinder: an earlier touch at a wrong place can be done anew.
///
/// The least chi^2 is a landmark where it stays below what all but one touch in a thousand do, and
/// where every other lies kClearLead above it, which makes it a thousand times as likely as each
/// other. While fewer than three determine no pose, the landmark that a person was asked for is
/// taken where it is plausible: distances alone cannot tell left from right. That naming may be
/// wrong where somebody touches what was not asked for. It shows as soon as four or more touches
/// do not fit together as named; then a search over all namings finds the one that explains them.
///
/// @param p_TQ     the new touch, metres
/// @param fle      root of the expected squared length of an error, above 0
/// @param proposed the open landmark that was asked for
/// @pre as many places as touches; `proposed` is open.
/// @returns TooFewLandmarks for a catalogue of fewer than three; NotFinite for NaN or infinity and
///          OutOfRange for a kilometre or more.
[[nodiscard]] Result<TouchFinding> recogniseTouch(const TouchesSoFar& earlier, const Vec3& p_TQ,
                                                  Length fle,
                                                  std::optional<std::size_t> proposed = {});

/// A thousand to one, as a difference of chi-squared: 2 ln 1000.
inline constexpr double kClearLead = 13.8155;

} // namespace carina
