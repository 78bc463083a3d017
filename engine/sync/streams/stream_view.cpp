#include "engine/sync/streams/stream_view.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <algorithm>

namespace carina
{

double carriedSeconds(Duration sinceSample)
{
    const double full = toSeconds(std::clamp(sinceSample, Duration{}, StreamView::kHorizon));
    const double fade = toSeconds(StreamView::kFade);
    const double faded = std::clamp(toSeconds(sinceSample - StreamView::kHorizon), 0.0, fade);
    return full + faded - faded * faded / (2.0 * fade);
}

RigidTransform carriedOn(const StreamCpo& sample, SessionTime t)
{
    if (!sample.motion)
        return sample.X_AO;
    const double seconds = carriedSeconds(t - sample.time);
    return {rotationFromVector(seconds * sample.motion->w_AO) * sample.X_AO.rotation(),
            sample.X_AO.translation() + seconds * sample.motion->v_AO};
}

void StreamView::take(const StreamCpo& sample, SessionTime drawn)
{
    if (!m_newest) {
        m_newest = sample;
        return;
    }
    const RigidTransform before = at(drawn);
    const RigidTransform after = carriedOn(sample, drawn);
    m_newest = sample;
    const Drift drift = driftBetween(after, before);
    m_difference = {Vec3::Zero(), Vec3::Zero(), drawn};
    if (drift.rotation > kSmallestTurn || drift.position > kSmallestShift)
        m_difference = {rotationVector(before.rotation() * after.rotation().conjugate()),
                        before.translation() - after.translation(), drawn};
}

RigidTransform StreamView::at(SessionTime t) const
{
    CARINA_EXPECTS(m_newest);
    const RigidTransform carried = carriedOn(*m_newest, t);
    const double s = std::clamp(toSeconds(t - m_difference.since) / toSeconds(kBlend), 0.0, 1.0);
    const double left = 1.0 - s * s * (3.0 - 2.0 * s);
    return {rotationFromVector(left * m_difference.turn) * carried.rotation(),
            carried.translation() + left * m_difference.shift};
}

bool StreamView::isStale(SessionTime t) const
{
    return !m_newest || t - m_newest->time > kStaleAfter;
}

} // namespace carina
