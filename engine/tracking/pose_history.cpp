#include "engine/tracking/pose_history.h"

#include "engine/geometry/rotation.h"
#include "engine/tracking/prediction.h"
#include "engine/tracking/reframed.h"

#include <algorithm>
#include <cmath>

namespace carina
{

namespace
{

// Far enough for any clock, near enough that two such times can be subtracted.
constexpr Duration kFarthestTime = std::chrono::hours{100 * 365 * 24};

bool isUsable(const PoseSample& sample)
{
    const Duration time = sample.time.time_since_epoch();
    const bool motionFinite =
        !sample.motion
        || (sample.motion->v_FO.allFinite() && sample.motion->w_FO.allFinite()
            && sample.motion->a_FO.allFinite() && sample.motion->alpha_FO.allFinite());
    return time <= kFarthestTime && time >= -kFarthestTime && motionFinite
           && sample.X_FO.translation().allFinite() && std::isfinite(sample.error);
}

Motion motionBetween(const PoseSample& a, const PoseSample& b)
{
    const double seconds = toSeconds(b.time - a.time);
    return {(b.X_FO.translation() - a.X_FO.translation()) / seconds,
            rotationVector(b.X_FO.rotation() * a.X_FO.rotation().conjugate()) / seconds};
}

PoseSample placed(const DevicePlace& place, const PoseSample& X_DO)
{
    PoseSample X_FO = reframed(place.X_FD, X_DO);
    X_FO.time -= place.late;
    return X_FO;
}

PoseSample lostSince(const PoseSample& before, SessionTime t)
{
    PoseSample lost = before;
    lost.time = t;
    lost.motion.reset();
    lost.validity = Validity::Lost;
    lost.how = before.time == t ? How::Exact : How::Predicted;
    return lost;
}

PoseSample between(const PoseSample& a, const PoseSample& b, SessionTime t)
{
    const double share = toSeconds(t - a.time) / toSeconds(b.time - a.time);
    return {.time = t,
            .X_FO = interpolate(a.X_FO, b.X_FO, share),
            .motion = motionBetween(a, b),
            .validity = std::max(a.validity, b.validity),
            .error = std::max(a.error, b.error),
            .how = How::Interpolated};
}

/// Moves a pose on by its motion.
void predict(PoseSample& pose, double seconds)
{
    Motion& motion = *pose.motion;
    pose.X_FO = movedOn(pose.X_FO, motion, seconds);
    if (motion.growth)
        pose.deviation =
            PoseDeviation{metres(ErrorGrowth::rmsAfter(seconds, motion.growth->position)),
                          radians(ErrorGrowth::rmsAfter(seconds, motion.growth->rotation))};
    motion.growth.reset(); // it counts from the newest sample
}

} // namespace

void PoseHistory::placeDevice(const DevicePlace& place)
{
    const std::scoped_lock lock{m_mutex};
    m_place = place;
}

std::optional<RigidTransform> PoseHistory::deviceFrame() const
{
    const std::scoped_lock lock{m_mutex};
    return m_place ? std::optional{m_place->X_FD} : std::nullopt;
}

void PoseHistory::treat(const PoseTreatment& treatment)
{
    const std::scoped_lock lock{m_mutex};
    if (treatment.smooths && !m_treatment.smooths)
        m_smoothing = {};
    m_treatment = treatment;
}

bool PoseHistory::push(const PoseSample& measured)
{
    if (!isUsable(measured))
        return false;
    const std::scoped_lock lock{m_mutex};
    const PoseSample raw = m_place ? placed(*m_place, measured) : measured;
    const PoseSample sample = m_treatment.smooths ? m_smoothing.smoothed(raw) : raw;
    const auto place = std::ranges::lower_bound(m_samples, sample.time, {}, &PoseSample::time);
    if (place != m_samples.end() && place->time == sample.time) {
        *place = sample;
        return true;
    }
    const bool full = m_samples.size() >= m_limits.capacity;
    if (full && place == m_samples.begin())
        return false;
    m_samples.insert(place, sample);
    if (full)
        m_samples.pop_front();
    return true;
}

std::optional<PoseSample> PoseHistory::at(SessionTime t) const
{
    const std::scoped_lock lock{m_mutex};
    const auto after = std::ranges::upper_bound(m_samples, t, {}, &PoseSample::time);
    if (after == m_samples.begin())
        return std::nullopt;
    const PoseSample& before = *std::prev(after);
    const auto index = static_cast<std::size_t>(std::prev(after) - m_samples.begin());
    if (before.validity == Validity::Lost)
        return lostSince(before, t);
    if (after == m_samples.end() || before.time == t)
        return carriedOn(index, t);
    if (after->validity == Validity::Lost || after->time - before.time > m_limits.longestGap)
        return lostSince(before, t);
    return between(before, *after, t);
}

std::optional<PoseSample> PoseHistory::newest() const
{
    const std::scoped_lock lock{m_mutex};
    if (m_samples.empty())
        return std::nullopt;
    return m_samples.back();
}

std::vector<PoseSample> PoseHistory::samples() const
{
    const std::scoped_lock lock{m_mutex};
    return {m_samples.begin(), m_samples.end()};
}

void PoseHistory::clear()
{
    const std::scoped_lock lock{m_mutex};
    m_samples.clear();
}

std::optional<Motion> PoseHistory::motionOf(std::size_t index) const
{
    const PoseSample& sample = m_samples[index];
    if (sample.motion)
        return sample.motion;
    for (std::size_t i = index; i-- > 0;) {
        if (sample.time - m_samples[i].time > m_limits.longestGap)
            return std::nullopt;
        if (m_samples[i].validity != Validity::Lost)
            return motionBetween(m_samples[i], sample);
    }
    return std::nullopt;
}

PoseSample PoseHistory::carriedOn(std::size_t index, SessionTime t) const
{
    PoseSample pose = m_samples[index];
    const Duration ahead = t - pose.time;
    pose.time = t;
    pose.how = How::Exact;
    pose.motion = motionOf(index);
    if (ahead == Duration::zero())
        return pose;
    pose.how = How::Predicted;
    if (pose.motion && m_treatment.predicts)
        predict(pose, toSeconds(std::min(ahead, m_limits.horizon)));
    if (ahead > m_limits.horizon) {
        pose.validity = Validity::Lost;
        pose.motion.reset();
    }
    return pose;
}

} // namespace carina
