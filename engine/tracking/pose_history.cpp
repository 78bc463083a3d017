#include "engine/tracking/pose_history.h"

#include "engine/geometry/rotation.h"
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
    lost.covariance_O.reset();
    lost.markers.reset();
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

/// How far a pose that is shown is expected to be off, where the object is expected at X_FO after
/// some seconds of a motion.
PoseDeviation deviationOf(const RigidTransform& shown, const RigidTransform& X_FO,
                          const ErrorGrowth& growth, double seconds)
{
    return {metres(std::hypot(ErrorGrowth::rmsAfter(seconds, growth.position),
                              (shown.translation() - X_FO.translation()).norm())),
            radians(std::hypot(ErrorGrowth::rmsAfter(seconds, growth.rotation),
                               angleBetween(shown.rotation(), X_FO.rotation()).si))};
}

} // namespace

void PoseHistory::placeDevice(const DevicePlace& place)
{
    const std::scoped_lock lock{m_mutex};
    if (m_place == place)
        return;
    m_place = place;
    forget(); // from one place to the other nothing has moved
}

std::optional<RigidTransform> PoseHistory::deviceFrame() const
{
    const std::scoped_lock lock{m_mutex};
    return m_place ? std::optional{m_place->X_FD} : std::nullopt;
}

void PoseHistory::treat(const PoseTreatment& treatment)
{
    const std::scoped_lock lock{m_mutex};
    m_treatment = treatment;
}

bool PoseHistory::push(const PoseSample& measured)
{
    if (!isUsable(measured))
        return false;
    const std::scoped_lock lock{m_mutex};
    if (m_entries.capacity() == 0)
        m_entries.set_capacity(m_limits.capacity);
    const PoseSample sample = m_place ? placed(*m_place, measured) : measured;
    const auto place = std::ranges::lower_bound(m_entries, sample.time, {}, timeOf);
    const bool replaces = place != m_entries.end() && timeOf(*place) == sample.time;
    if (m_entries.full() && !replaces && place == m_entries.begin())
        return false;
    const Entry entry = estimated(sample);
    if (replaces) {
        *place = entry;
        return true;
    }
    m_entries.insert(place, entry); // in place of the oldest, when full
    return true;
}

PoseHistory::Entry PoseHistory::estimated(const PoseSample& sample)
{
    Entry entry{sample, ++m_added, sample.X_FO, m_smoothing.smoothed(sample).X_FO};
    if (!m_limits.estimates || sample.motion)
        return entry;
    m_predictor.add(sample);
    const bool isNewest = m_entries.empty() || timeOf(m_entries.back()) < sample.time;
    if (const auto estimate = m_predictor.estimate();
        estimate && isNewest && sample.validity != Validity::Lost) {
        entry.filtered = estimate->X_FO;
        entry.sample.motion = estimate->motion;
    }
    return entry;
}

std::optional<PoseSample> PoseHistory::at(SessionTime t) const
{
    const std::scoped_lock lock{m_mutex};
    return treated(t, {});
}

std::optional<PoseSample> PoseHistory::shownAt(SessionTime t) const
{
    const std::scoped_lock lock{m_mutex};
    return treated(t, m_treatment);
}

std::optional<PoseSample> PoseHistory::treated(SessionTime t, const PoseTreatment& treatment) const
{
    const auto after = std::ranges::upper_bound(m_entries, t, {}, timeOf);
    if (after == m_entries.begin())
        return std::nullopt;
    const auto index = static_cast<std::size_t>(std::prev(after) - m_entries.begin());
    const PoseSample before = measured(index, treatment);
    if (before.validity == Validity::Lost)
        return lostSince(before, t);
    if (after == m_entries.end() || before.time == t)
        return carriedOn(index, t, treatment);
    const PoseSample next = measured(index + 1, treatment);
    if (next.validity == Validity::Lost || next.time - before.time > m_limits.longestGap)
        return lostSince(before, t);
    return between(before, next, t);
}

PredictionEffect PoseHistory::effect(Duration ahead, Duration within) const
{
    const std::scoped_lock lock{m_mutex};
    PredictionEffect effect;
    for (std::size_t i = m_entries.size(); i-- > 0;) {
        const PoseSample& sample = m_entries[i].sample;
        if (timeOf(m_entries.back()) - sample.time > within)
            break;
        if (sample.validity == Validity::Lost || !sample.motion)
            continue;
        const auto truth = treated(sample.time + ahead, {});
        if (!truth || truth->how == How::Predicted)
            continue;
        effect.held.add(sample.X_FO, truth->X_FO);
        effect.predicted.add(carriedOn(i, truth->time, {}).X_FO, truth->X_FO);
    }
    return {effect.held.root(), effect.predicted.root()};
}

std::optional<PoseSample> PoseHistory::newest() const
{
    const std::scoped_lock lock{m_mutex};
    if (m_entries.empty())
        return std::nullopt;
    return m_entries.back().sample;
}

std::vector<PoseSample> PoseHistory::samples() const { return since(0).samples; }

PoseHistory::Added PoseHistory::since(std::uint64_t cursor) const
{
    const std::scoped_lock lock{m_mutex};
    Added added{{}, m_added};
    // The new ones are the last, except where one came late.
    std::uint64_t missing = m_added - std::min(cursor, m_added);
    for (auto entry = m_entries.rbegin(); entry != m_entries.rend() && missing > 0; ++entry) {
        if (entry->number <= cursor)
            continue;
        added.samples.push_back(entry->sample);
        --missing;
    }
    std::ranges::reverse(added.samples);
    return added;
}

std::uint64_t PoseHistory::end() const
{
    const std::scoped_lock lock{m_mutex};
    return m_added;
}

void PoseHistory::clear()
{
    const std::scoped_lock lock{m_mutex};
    forget();
}

void PoseHistory::forget()
{
    m_entries.set_capacity(0);
    m_predictor = {};
    m_smoothing = {};
}

/// The sample as it came, or smoothed.
PoseSample PoseHistory::measured(std::size_t index, const PoseTreatment& treatment) const
{
    PoseSample sample = m_entries[index].sample;
    if (treatment.smooths)
        sample.X_FO = m_entries[index].smoothed;
    return sample;
}

std::optional<Motion> PoseHistory::motionOf(std::size_t index) const
{
    const PoseSample& sample = m_entries[index].sample;
    if (sample.motion)
        return sample.motion;
    for (std::size_t i = index; i-- > 0;) {
        if (sample.time - timeOf(m_entries[i]) > m_limits.longestGap)
            return std::nullopt;
        if (m_entries[i].sample.validity != Validity::Lost)
            return motionBetween(m_entries[i].sample, sample);
    }
    return std::nullopt;
}

PoseSample PoseHistory::carriedOn(std::size_t index, SessionTime t,
                                  const PoseTreatment& treatment) const
{
    PoseSample pose = measured(index, treatment);
    const Duration ahead = t - pose.time;
    pose.time = t;
    pose.how = How::Exact;
    pose.motion = motionOf(index);
    if (ahead == Duration::zero())
        return pose;
    pose.how = How::Predicted;
    pose.covariance_O.reset();
    pose.markers.reset();
    if (pose.motion)
        predict(pose, m_entries[index].filtered, ahead, treatment);
    if (ahead > m_limits.horizon) {
        pose.validity = Validity::Lost;
        pose.motion.reset();
    }
    return pose;
}

/// Moves a measured pose on by its motion, of an object that was at X_FO.
void PoseHistory::predict(PoseSample& pose, const RigidTransform& X_FO, Duration ahead,
                          const PoseTreatment& treatment) const
{
    const Motion measured = *pose.motion;
    if (treatment.predicts)
        pose.X_FO = movedOn(treatment.smooths ? pose.X_FO : X_FO, *pose.motion,
                            toSeconds(std::min(ahead, m_limits.horizon)));
    if (measured.growth) {
        Motion motion = measured;
        const RigidTransform expected = movedOn(X_FO, motion, toSeconds(ahead));
        pose.deviation = deviationOf(pose.X_FO, expected, *measured.growth, toSeconds(ahead));
    }
    pose.motion->growth.reset(); // it counts from the newest sample
}

} // namespace carina
