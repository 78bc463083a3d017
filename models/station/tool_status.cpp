#include "models/station/tool_status.h"

#include "engine/tracking/markers/tool_error.h"

#include <QCoreApplication>

#include <algorithm>

namespace carina
{
namespace
{

constexpr Duration kSilent = std::chrono::milliseconds{300};
constexpr Duration kEffectWindow = std::chrono::seconds{4};
constexpr Duration kRateWindow = std::chrono::seconds{1};

QString toolWords(const char* text) { return QCoreApplication::translate("ToolStatus", text); }

QString toolName(const TrackedTool& tool)
{
    const QString name = toolRoleName(tool.role);
    return name.isEmpty() ? QString::fromStdString(tool.name) : name;
}

/// Samples per second within the window before the newest.
double rateOf(const std::vector<PoseSample>& samples)
{
    const SessionTime newest = samples.back().time;
    const auto first = std::ranges::find_if(
        samples, [&](const PoseSample& sample) { return newest - sample.time <= kRateWindow; });
    const auto intervals = std::distance(first, samples.end()) - 1;
    return intervals > 0 ? double(intervals) / toSeconds(newest - first->time) : 0.0;
}

/// Of the newest sample in which it was seen.
std::optional<double> ageOf(const std::vector<PoseSample>& samples, SessionTime now)
{
    const auto seen = std::find_if(samples.rbegin(), samples.rend(), [](const PoseSample& sample) {
        return sample.validity != Validity::Lost;
    });
    if (seen == samples.rend())
        return std::nullopt;
    return toSeconds(std::max(now - seen->time, Duration{})); // it may have come since `now`
}

/// Why a tool has no pose, or one with care; empty where the device tells nothing.
QString reasonOf(ToolSight sight)
{
    switch (sight) {
    case ToolSight::PartlyOutOfVolume:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "partly outside the working volume"));
    case ToolSight::OutOfVolume:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "outside the working volume"));
    case ToolSight::TooFewMarkers:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "too few of its markers are seen"));
    case ToolSight::Interference:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "other infrared light disturbs"));
    case ToolSight::BadFit:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "its markers do not fit its definition"));
    case ToolSight::Failed:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "the tracker reports a fault"));
    case ToolSight::Silent:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "device silent"));
    case ToolSight::Unsaid:
        break;
    }
    return {};
}

QString visibleState(Validity validity, const QString& reason)
{
    if (!reason.isEmpty())
        return reason;
    return validity == Validity::PartlyOccluded
               ? toolWords(QT_TRANSLATE_NOOP("ToolStatus", "partly out of view"))
               : toolWords(QT_TRANSLATE_NOOP("ToolStatus", "visible"));
}

QString neverSeen(const QString& reason)
{
    return reason.isEmpty()
               ? toolWords(QT_TRANSLATE_NOOP("ToolStatus", "never seen"))
               : toolWords(QT_TRANSLATE_NOOP("ToolStatus", "never seen: %1")).arg(reason);
}

/// State, rate, fit and age in a line.
QString visibleText(const ToolStatus& status)
{
    const QString fit =
        status.error_mm
            ? toolWords(QT_TRANSLATE_NOOP("ToolStatus", ", markers fit to %1\u00a0mm (RMS)"))
                  .arg(*status.error_mm, 0, 'f', 2)
            : QString{};
    return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "%1, %2\u00a0Hz%3, %4\u00a0ms old"))
        .arg(status.state)
        .arg(qRound(status.rate_Hz))
        .arg(fit)
        .arg(qRound(1e3 * status.age_s.value_or(0.0)));
}

/// Beside what its markers and its motion make of the pose.
void addExpected(ToolStatus& status, const TrackedTool& tool,
                 const std::vector<PoseSample>& samples)
{
    if (const auto error = predictedError(tool, samples.back())) {
        status.expected_mm = inMillimetres(error->at(Vec3::Zero()));
        status.expected_deg = inDegrees(error->rotation());
    }
    if (const auto ahead = tool.history->at(samples.back().time + kPredictedAhead);
        ahead && ahead->deviation)
        status.deviation_mm = inMillimetres(ahead->deviation->position);
    const PredictionEffect effect = tool.history->effect(kPredictedAhead, kEffectWindow);
    if (effect.predicted.poses == 0)
        return;
    status.predicted_mm = inMillimetres(metres(effect.predicted.position));
    status.held_mm = inMillimetres(metres(effect.held.position));
}

ToolStatus statusOf(const TrackedTool& tool, ToolSight sight, SessionTime now)
{
    const QString reason = reasonOf(sight);
    const QString away = toolWords(QT_TRANSLATE_NOOP("ToolStatus", "out of view"));
    ToolStatus status{.role = tool.role, .name = toolName(tool)};
    status.text = reason.isEmpty() ? away : reason;
    status.state = neverSeen(reason);
    const std::vector<PoseSample> samples = tool.history->samples();
    status.age_s = ageOf(samples, now);
    if (!status.age_s)
        return status;
    const PoseSample& newest = samples.back();
    if (!tool.history->deviceFrame()) // the volume is that of the first device
        status.p_T = newest.X_FO.translation();
    const bool isDelivered = now - newest.time <= kSilent;
    status.rate_Hz = isDelivered ? rateOf(samples) : 0.0;
    if (!isDelivered && sight != ToolSight::Silent)
        status.text = away; // what was said of it is over
    status.state = status.text;
    if (!isDelivered || newest.validity == Validity::Lost || sight == ToolSight::Silent)
        return status;
    status.isVisible = true;
    status.state = visibleState(newest.validity, reason);
    if (newest.error > 0.0) // none is told: markers fit exactly nowhere
        status.error_mm = 1e3 * newest.error;
    addExpected(status, tool, samples);
    status.text = visibleText(status);
    return status;
}

} // namespace

QString toolRoleName(ToolRole role)
{
    switch (role) {
    case ToolRole::Head:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "Headset"));
    case ToolRole::Jaw:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "Chin probe"));
    case ToolRole::Tube:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "Tube"));
    case ToolRole::Stylus:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "Stylus"));
    case ToolRole::Manikin:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "Manikin"));
    case ToolRole::Chest:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "Chest marker"));
    case ToolRole::Hand:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "Hand probe"));
    case ToolRole::Laryngoscope:
        return toolWords(QT_TRANSLATE_NOOP("ToolStatus", "Laryngoscope"));
    case ToolRole::Other:
        break;
    }
    return {};
}

std::vector<ToolStatus> toolStatus(const Tracker& tracker, SessionTime now)
{
    std::vector<ToolStatus> all;
    for (const TrackedTool& tool : tracker.tools())
        all.push_back(statusOf(tool, tracker.sightOf(all.size()), now));
    return all;
}

void treatPoses(const Tracker& tracker, const PoseTreatment& treatment)
{
    for (const TrackedTool& tool : tracker.tools())
        tool.history->treat(treatment);
}

} // namespace carina
