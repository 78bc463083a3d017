#pragma once

#include "engine/sync/strategies/drift.h"
#include "engine/sync/wire/stream_cpo.h"

#include <optional>

namespace carina
{

/// A streamed object as another participant draws it: extrapolated from its newest sample, and
/// blended to the next one without a jump.
///
/// A sample is extrapolated with its velocity for kHorizon; then the velocity fades to zero over
/// kFade, because the true motion is unknown. Where the next sample differs from the drawn pose by
/// more than kSmallestTurn or kSmallestShift, the difference d is reduced to zero over kBlend:
///
///     X(t) = B(s) X_carried(t)      B(s) = (1 - 3 s^2 + 2 s^3) of d       s = (t - taken) / kBlend
///
/// with d as a rotation vector and a translation, so that pose and velocity are continuous at both
/// ends.
class StreamView
{
public:
    static constexpr Duration kHorizon = std::chrono::milliseconds{150};
    static constexpr Duration kFade = std::chrono::milliseconds{100};
    static constexpr Duration kBlend = std::chrono::milliseconds{50};
    static constexpr Angle kSmallestTurn = degrees(0.1);
    static constexpr Length kSmallestShift = millimetres(0.1);
    /// A sample older than this when drawn is stale.
    static constexpr Duration kStaleAfter = std::chrono::milliseconds{300};

    /// The next sample, newer than the last (StreamTable::accept); `drawn` is the session time that
    /// is being drawn.
    void take(const StreamCpo& sample, SessionTime drawn);

    /// X_AO at session time t. @pre take() was called.
    [[nodiscard]] RigidTransform at(SessionTime t) const;
    [[nodiscard]] bool isStale(SessionTime t) const;

private:
    struct Difference {
        Vec3 turn = Vec3::Zero();  ///< rotation vector in A, radians
        Vec3 shift = Vec3::Zero(); ///< in A, metres
        SessionTime since{};
    };

    std::optional<StreamCpo> m_newest;
    Difference m_difference;
};

/// Of a time since a sample the part for which its velocity is to go on in full, for the same way:
/// all for StreamView::kHorizon, and then ever less until StreamView::kFade is over. Seconds.
[[nodiscard]] double carriedSeconds(Duration sinceSample);

/// The pose X_AO of a sample extrapolated to session time t, as in StreamView; constant before the
/// time of the sample.
[[nodiscard]] RigidTransform carriedOn(const StreamCpo& sample, SessionTime t);

} // namespace carina
