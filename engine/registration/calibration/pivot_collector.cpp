#include "engine/registration/calibration/pivot_collector.h"

#include "engine/geometry/fit/point_check.h"
#include "engine/geometry/rotation.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr Angle kCounts = degrees(1.0);
constexpr Duration kBetweenLooks = std::chrono::milliseconds{250};
constexpr std::size_t kMostCounted = 3000;

TurnCoverage coverageOf(std::span<const RigidTransform> X_TS)
{
    std::vector<TurnedPose> poses;
    for (const RigidTransform& pose : X_TS)
        poses.push_back({pose.rotation().toRotationMatrix(), pose.translation()});
    return meansOf(poses).coverage();
}

} // namespace

std::optional<PivotCalibration> PivotCollector::push(SessionTime time, const RigidTransform& X_TS,
                                                     Validity validity)
{
    if (m_progress.stage == PivotStage::Done || validity == Validity::Lost
        || !checkPoint(X_TS.translation(), "a pose") || (m_last && time <= *m_last))
        return std::nullopt;
    m_last = time;
    keepLatest(time, X_TS);
    if (m_progress.stage == PivotStage::Waiting) {
        if (isSwung())
            begin(time);
        return std::nullopt;
    }
    if (angleBetween(X_TS.rotation(), m_counted.back().rotation()) >= kCounts) {
        if (m_counted.size() == kMostCounted)
            m_counted.erase(m_counted.begin());
        m_counted.push_back(X_TS);
    }
    if (time - m_evaluated < kBetweenLooks)
        return std::nullopt;
    m_evaluated = time;
    return evaluate(time);
}

void PivotCollector::restart()
{
    m_progress = {};
    m_latest.clear();
    m_counted.clear();
}

void PivotCollector::keepLatest(SessionTime time, const RigidTransform& X_TS)
{
    std::erase_if(m_latest,
                  [&](const Timed& pose) { return time - pose.time > m_settings.window; });
    m_latest.push_back({time, X_TS});
}

/// The window is at least 90 % full, some direction turned, and the point of the stylus that moved
/// least has a small RMS distance from its mean and lies within reach.
bool PivotCollector::isSwung() const
{
    if (m_latest.size() < kFewestPoses
        || 10 * (m_latest.back().time - m_latest.front().time) < 9 * m_settings.window)
        return false;
    std::vector<TurnedPose> poses;
    for (const Timed& pose : m_latest)
        poses.push_back({pose.X_TS.rotation().toRotationMatrix(), pose.X_TS.translation()});
    const PoseMeans means = meansOf(poses);
    if (means.coverage().turns[2] < m_settings.start)
        return false;
    const Vec3 p_SQ = means.turn.ldlt().solve(means.shift);
    const Vec3 p_TQ = means.R * p_SQ + means.p;
    double squares = 0.0;
    for (const TurnedPose& pose : poses)
        squares += (pose.R_TS * p_SQ + pose.p_TS - p_TQ).squaredNorm();
    const double rms = std::sqrt(squares / double(poses.size()));
    return rms <= m_settings.calibration.largestRms.si && p_SQ.norm() <= m_settings.reach.si;
}

void PivotCollector::begin(SessionTime time)
{
    m_progress.stage = PivotStage::Swinging;
    m_since = m_latest.front().time;
    m_evaluated = time;
    m_counted = {m_latest.front().X_TS};
    for (const Timed& pose : m_latest)
        if (angleBetween(pose.X_TS.rotation(), m_counted.back().rotation()) >= kCounts)
            m_counted.push_back(pose.X_TS);
}

bool PivotCollector::hasLeft(const PivotCalibration& pivot) const
{
    const auto away = std::ranges::count_if(m_latest, [&](const Timed& pose) {
        return (pose.X_TS * pivot.p_SQ - pivot.p_TQ).norm()
               > m_settings.calibration.outlierLimit.si;
    });
    return 2 * away > std::ssize(m_latest);
}

std::optional<PivotCalibration> PivotCollector::evaluate(SessionTime time)
{
    const Result<PivotCalibration> pivot = calibratePivot(m_counted, m_settings.calibration);
    const bool hasMoved =
        pivot ? pivot->refusal || hasLeft(*pivot) : pivot.error().code == Errc::ToolMoved;
    if (hasMoved) {
        restart();
        m_progress.need = PivotNeed::Stillness;
        return std::nullopt;
    }
    const Angle due = m_settings.calibration.leastTurn;
    m_progress.poses = static_cast<int>(m_counted.size());
    m_progress.coverage = coverageOf(m_counted);
    m_progress.uncertainty = pivot ? std::optional{pivot->uncertainty()} : std::nullopt;
    const double turned = std::min(m_progress.coverage.turns[0] / due, 1.0);
    const double lasted = std::min(toSeconds(time - m_since) / toSeconds(m_settings.shortest), 1.0);
    const double certain =
        pivot ? std::min(std::pow(m_settings.certainty.si / pivot->uncertainty(), 2), 1.0) : 0.0;
    m_progress.share = (turned + lasted + certain) / 3.0;
    m_progress.need = m_progress.coverage.turns[1] < due ? PivotNeed::Motion
                      : turned < 1.0                     ? PivotNeed::Directions
                                                         : PivotNeed::Poses;
    if (!pivot || lasted < 1.0 || certain < 1.0)
        return std::nullopt;
    m_progress.stage = PivotStage::Done;
    m_progress.need = PivotNeed::Nothing;
    return *pivot;
}

} // namespace carina
