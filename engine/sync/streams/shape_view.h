#pragma once

#include "engine/sync/wire/stream_cpo.h"

#include <deque>
#include <optional>

namespace carina
{

/// A form between two that were sent, or beyond the second: each place of the object is at
/// p + times (q - p), p being where it has the first form and q where it has the second.
struct ShapeBetween {
    StreamShape from;
    StreamShape to;
    double times = 0.0;
};

/// The form of a streamed object as another participant draws it.
///
/// Between two forms its places are interpolated. Beyond the newest they go on as fast as since the
/// latest form that is at least kBaseline older, for as long as a pose does (StreamView): a tube
/// that is pushed bends on while its connector moves on. All constants are of ours.
class ShapeView
{
public:
    /// Shorter, and the noise of a tracked connector is a fast bending.
    static constexpr Duration kBaseline = std::chrono::milliseconds{80};
    /// Forms that are farther apart are not of one motion.
    static constexpr Duration kLongestGap = std::chrono::milliseconds{300};
    /// Of 60 in a second: 1 s.
    static constexpr std::size_t kKept = 64;

    /// The next form; one that is not later than the newest says nothing.
    void take(const StreamShape& shape);
    /// The object has no form any more that is known.
    void clear() { m_shapes.clear(); }

    /// At session time t; the oldest before that. Nothing while none is known, and more than
    /// kLongestGap after the newest.
    [[nodiscard]] std::optional<ShapeBetween> at(SessionTime t) const;

private:
    [[nodiscard]] ShapeBetween beyond(SessionTime t) const;

    std::deque<StreamShape> m_shapes; ///< by time
};

} // namespace carina
