#include "apps/program/listening_round.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"
#include "evaluation/intubation/hand_track.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace carina::program
{
namespace
{

constexpr double kArc_m = 0.04; ///< over the chest, half way

/// With -z of the stylus to the back, +y of A.
RigidTransform listeningAt(const Vec3& p_A)
{
    return {rotationFromVector(0.5 * std::numbers::pi * Vec3::UnitX()), p_A};
}

} // namespace

ListeningRound::ListeningRound(const Vec3& p_A_parked, std::vector<Vec3> p_A_places)
    : m_p_A_places{std::move(p_A_places)},
      m_stops{{Duration::min(), RigidTransform::translation(p_A_parked)}}
{
}

void ListeningRound::listen(Duration from, Duration until)
{
    CARINA_EXPECTS(m_stops.size() == 1 || from >= m_stops.back().from + kListenerReach);
    const RigidTransform X_AS_parked = m_stops.front().X_AS;
    const std::size_t before = m_stops.size();
    for (const Vec3& p_A : m_p_A_places) {
        if (until - from < kListenerReach + kAtEachPlace)
            break;
        m_stops.push_back({from, listeningAt(p_A)});
        from += kListenerReach + kAtEachPlace;
    }
    if (m_stops.size() > before)
        m_stops.push_back({from, X_AS_parked});
}

RigidTransform ListeningRound::at(Duration t) const
{
    const auto next = std::ranges::upper_bound(m_stops, t, {}, &Stop::from);
    const auto stop = next == m_stops.begin() ? next : std::prev(next);
    if (stop == m_stops.begin())
        return stop->X_AS;
    const RigidTransform& X_AS = std::prev(stop)->X_AS;
    const double share =
        minimumJerk(std::min(toSeconds(t - stop->from) / toSeconds(kListenerReach), 1.0));
    const double above = kArc_m * std::sin(std::numbers::pi * share);
    return RigidTransform::translation(-above * Vec3::UnitY())
           * interpolate(X_AS, stop->X_AS, share);
}

} // namespace carina::program
