#include "models/registration/stylus_watch.h"

#include "engine/geometry/rotation.h"
#include "engine/tracking/markers/tool_error.h"
#include "engine/tracking/reframed.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr std::size_t kSpunPoses = 360; ///< six seconds at 60 Hz
constexpr Duration kSilence = std::chrono::milliseconds{300};
constexpr Duration kMeanOf = std::chrono::seconds{1};
constexpr Duration kTakenOf = std::chrono::milliseconds{250};

/// The mean of poses that differ by no more than noise.
/// @pre there are some
RigidTransform meanOf(const std::vector<PoseSample>& samples)
{
    const Quat q_first = samples.front().X_FO.rotation();
    Vec3 p = Vec3::Zero();
    Vec3 turn = Vec3::Zero();
    for (const PoseSample& sample : samples) {
        p += sample.X_FO.translation() / double(samples.size());
        turn += rotationVector(sample.X_FO.rotation() * q_first.inverse()) / double(samples.size());
    }
    return {rotationFromVector(turn) * q_first, p};
}

} // namespace

StylusWatch::StylusWatch(const Tracker& tracker, ReadSessionClock clock)
    : m_tools{tracker.tools()}, m_clock{std::move(clock)}
{
}

bool StylusWatch::has(ToolRole role) const
{
    return std::ranges::find(m_tools, role, &TrackedTool::role) != m_tools.end();
}

std::string StylusWatch::nameOf(ToolRole role) const
{
    const auto tool = std::ranges::find(m_tools, role, &TrackedTool::role);
    return tool == m_tools.end() ? std::string{} : tool->name;
}

std::optional<TrackedTool> StylusWatch::stylusTool() const
{
    const auto stylus = std::ranges::find(m_tools, ToolRole::Stylus, &TrackedTool::role);
    return stylus == m_tools.end() ? std::nullopt : std::optional{*stylus};
}

std::string StylusWatch::tool() const
{
    const auto stylus = stylusTool();
    return stylus ? stylus->name : std::string{};
}

std::optional<Length> StylusWatch::expectedTipError() const
{
    const auto tool = stylusTool();
    const std::vector<PoseSample> samples = seen(ToolRole::Stylus);
    if (!tool || samples.empty() || !m_p_SQ)
        return std::nullopt;
    const auto error = predictedError(*tool, samples.back());
    return error ? std::optional{error->at(*m_p_SQ)} : std::nullopt;
}

void StylusWatch::watchFor(StylusUse use)
{
    m_use = use;
    if (const auto now = m_clock())
        m_looked = now; // what was seen before tells nothing of this
    m_pivot.restart();
    m_spun.clear();
    m_dwell = {};
    m_p_TQ_taken.reset();
    m_leavesFirst = true;
    if (const auto resting = pointNow())
        leave(resting->point.p_FQ);
    m_swab.clear();
}

StylusNews StylusWatch::look()
{
    StylusNews news;
    for (const PoseSample& sample : seen(ToolRole::Stylus)) {
        if (m_looked && sample.time <= *m_looked)
            continue;
        m_looked = sample.time;
        take(m_use == StylusUse::Touch ? onTouched(sample) : sample, news);
    }
    return news;
}

void StylusWatch::take(const PoseSample& sample, StylusNews& news)
{
    const bool isSeen = sample.validity != Validity::Lost;
    switch (m_use) {
    case StylusUse::Nothing:
        return;
    case StylusUse::Pivot:
        if (auto tip = m_pivot.push(sample.time, sample.X_FO, sample.validity))
            news.tip = std::move(tip);
        return;
    case StylusUse::Spin:
        if (isSeen)
            takeSpun(sample.X_FO, news);
        return;
    case StylusUse::Touch:
        if (m_p_SQ && isSeen)
            takeHeld(sample, sample.X_FO * *m_p_SQ, news);
        return;
    case StylusUse::Swab:
        if (m_p_SQ && isSeen)
            takeSwabbed(sample.X_FO * *m_p_SQ);
        return;
    }
}

/// Where the tip is when it is seen first it may lie, not be held.
void StylusWatch::takeHeld(const PoseSample& sample, const Vec3& p_TQ, StylusNews& news)
{
    if (m_leavesFirst)
        leave(p_TQ);
    const auto point = m_dwell.push(sample.time, p_TQ, sample.validity);
    if (!point)
        return;
    news.touch = StylusTouch{*point, sample.X_FO.rotation(), tipErrorDuring(*point)};
    m_p_TQ_taken = point->p_FQ;
}

void StylusWatch::leave(const Vec3& p_TQ)
{
    m_leavesFirst = false;
    m_dwell.leave(p_TQ);
}

void StylusWatch::takeSpun(const RigidTransform& X_TS, StylusNews& news)
{
    m_spun.push_back(X_TS);
    if (m_spun.size() < kSpunPoses || !m_p_SQ)
        return;
    news.axis =
        calibrateSpin(std::exchange(m_spun, {}), *m_p_SQ)
            .and_then([](const SpinCalibration& spin) -> Result<SpinCalibration> {
                return spin.refusal ? tl::unexpected(*spin.refusal) : Result<SpinCalibration>{spin};
            });
    m_use = StylusUse::Nothing;
}

void StylusWatch::takeSwabbed(const Vec3& p_TQ)
{
    if (m_swab.size() >= kMostSwabPoints)
        return;
    if (m_swab.empty() || (p_TQ - m_swab.back()).norm() >= kSwabStep.si)
        m_swab.push_back(p_TQ);
}

double StylusWatch::progress() const
{
    switch (m_use) {
    case StylusUse::Pivot:
        return m_pivot.progress().share;
    case StylusUse::Spin:
        return double(m_spun.size()) / double(kSpunPoses);
    case StylusUse::Touch:
        return m_dwell.progress();
    case StylusUse::Nothing:
    case StylusUse::Swab:
        break;
    }
    return 0.0;
}

std::optional<StylusTouch> StylusWatch::takePoint()
{
    auto touch = pointNow();
    if (touch) {
        touch->seenError = tipErrorDuring(touch->point);
        m_p_TQ_taken = touch->point.p_FQ;
        leave(touch->point.p_FQ);
    }
    return touch;
}

bool StylusWatch::restsWhereTaken() const
{
    const auto now = m_p_TQ_taken ? pointNow() : std::nullopt;
    return now && (now->point.p_FQ - *m_p_TQ_taken).norm() <= DwellDetector::Settings{}.leave.si;
}

std::optional<StylusTouch> StylusWatch::pointNow() const
{
    std::vector<PoseSample> samples = latest(ToolRole::Stylus, kTakenOf);
    std::ranges::transform(samples, samples.begin(),
                           [this](const PoseSample& sample) { return onTouched(sample); });
    std::erase_if(samples, [](const PoseSample& s) { return s.validity == Validity::Lost; });
    if (samples.empty() || !m_p_SQ)
        return std::nullopt;
    StylusTouch touch{.point = {.samples = int(samples.size()),
                                .from = samples.front().time,
                                .until = samples.back().time},
                      .q_TS = samples.back().X_FO.rotation()};
    for (const PoseSample& sample : samples)
        touch.point.p_FQ += sample.X_FO * *m_p_SQ / double(samples.size());
    for (const PoseSample& sample : samples)
        touch.point.spread =
            std::max(touch.point.spread, (sample.X_FO * *m_p_SQ - touch.point.p_FQ).norm());
    return touch;
}

/// Of one pose, since those of a tool at rest share much of their errors.
std::optional<Length> StylusWatch::tipErrorDuring(const DwellPoint& point) const
{
    const auto tool = stylusTool();
    if (!tool || !m_p_SQ || m_touched)
        return std::nullopt;
    double squares = 0.0;
    int known = 0;
    for (const PoseSample& sample : seen(ToolRole::Stylus)) {
        if (sample.time < point.from || sample.time > point.until)
            continue;
        if (const auto error = predictedError(*tool, sample)) {
            squares += std::pow(error->at(*m_p_SQ).si, 2);
            ++known;
        }
    }
    return known > 0 ? std::optional{metres(std::sqrt(squares / known))} : std::nullopt;
}

PoseSample StylusWatch::onTouched(const PoseSample& X_TS) const
{
    if (!m_touched)
        return X_TS;
    const auto tool = std::ranges::find(m_tools, *m_touched, &TrackedTool::role);
    const auto X_TN = tool == m_tools.end() ? std::nullopt : tool->history->at(X_TS.time);
    if (X_TN && X_TN->validity != Validity::Lost)
        return seenFrom(*X_TN, X_TS);
    PoseSample lost = X_TS;
    lost.validity = Validity::Lost;
    return lost;
}

std::optional<RigidTransform> StylusWatch::stylus() const
{
    const std::vector<PoseSample> samples = seen(ToolRole::Stylus);
    if (samples.empty() || samples.back().validity == Validity::Lost)
        return std::nullopt;
    return samples.back().X_FO;
}

std::optional<RigidTransform> StylusWatch::probe(ToolRole role) const
{
    const std::vector<PoseSample> samples = latest(role, kMeanOf);
    return samples.empty() ? std::nullopt : std::optional{meanOf(samples)};
}

std::vector<PoseSample> StylusWatch::latest(ToolRole role, Duration time) const
{
    std::vector<PoseSample> samples = seen(role);
    if (samples.empty())
        return samples;
    const SessionTime from = samples.back().time - time;
    std::erase_if(samples, [from](const PoseSample& sample) {
        return sample.validity == Validity::Lost || sample.time < from;
    });
    return samples;
}

std::vector<PoseSample> StylusWatch::seen(ToolRole role) const
{
    const auto now = m_clock();
    const auto tool = std::ranges::find(m_tools, role, &TrackedTool::role);
    if (!now || tool == m_tools.end())
        return {};
    std::vector<PoseSample> samples = tool->history->samples();
    if (samples.empty() || *now - samples.back().time > kSilence)
        return {};
    return samples;
}

} // namespace carina
