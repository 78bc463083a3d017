#pragma once

#include "engine/sync/strategies/drift.h"
#include "engine/sync/wire/stream_cpo.h"

#include <optional>

namespace carina
{

/// A streamed object as it is drawn elsewhere: carried on from its newest sample, and brought to
/// the next without a jump.
///
/// A sample is carried on by its velocity for kHorizon; then the velocity fades to zero over kFade,
/// for nobody knows where it went. When the next sample puts the object elsewhere than it was
/// drawn, by more than kSmallestTurn or kSmallestShift, the difference d is worked off over kBlend:
///
///     X(t) = B(s) X_carried(t)      B(s) = (1 - 3 s^2 + 2 s^3) of d       s = (t - taken) / kBlend
///
/// d a rotation vector and a shift, so that pose and velocity are continuous at either end.
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

    /// The next sample, newer than the last (StreamTable::accept), while `drawn` is being drawn.
    /// @returns how far it puts the object from where it was drawn for that time: the drift of the
    ///          view; nothing for the first.
    std::optional<Drift> take(const StreamCpo& sample, SessionTime drawn);

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

/// The pose of a sample carried on to session time t, as above; before its time it stays.
[[nodiscard]] RigidTransform carriedOn(const StreamCpo& sample, SessionTime t);

} // namespace carina
