#include "models/station/tool_status.h"

#include <QCoreApplication>

#include <algorithm>

namespace carina
{
namespace
{

constexpr Duration kSilent = std::chrono::milliseconds{300};
constexpr Duration kRateWindow = std::chrono::seconds{1};

QString toolWords(const char* text) { return QCoreApplication::translate("ToolStatus", text); }

QString toolName(const TrackedTool& tool)
{
    switch (tool.role) {
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
    case ToolRole::Other:
        break;
    }
    return QString::fromStdString(tool.name);
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

ToolStatus statusOf(const TrackedTool& tool, SessionTime now)
{
    ToolStatus status{.role = tool.role, .name = toolName(tool)};
    const std::vector<PoseSample> samples = tool.history->samples();
    if (samples.empty() || now - samples.back().time > kSilent
        || samples.back().validity == Validity::Lost) {
        status.text = toolWords(QT_TRANSLATE_NOOP("ToolStatus", "out of view"));
        return status;
    }
    const PoseSample& newest = samples.back();
    status.isVisible = true;
    status.text =
        toolWords(QT_TRANSLATE_NOOP(
                      "ToolStatus",
                      "visible, %1\u00a0Hz, markers fit to %2\u00a0mm (RMS), %3\u00a0ms old"))
            .arg(qRound(rateOf(samples)))
            .arg(1e3 * newest.error, 0, 'f', 2)
            .arg(qRound(1e3 * toSeconds(now - newest.time)));
    return status;
}

} // namespace

std::vector<ToolStatus> toolStatus(const Tracker& tracker, SessionTime now)
{
    std::vector<ToolStatus> all;
    for (const TrackedTool& tool : tracker.tools())
        all.push_back(statusOf(tool, now));
    return all;
}

} // namespace carina
