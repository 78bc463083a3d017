#include "models/network/network_figures.h"

#include "engine/sync/strategies/view_bound.h"

#include <algorithm>
#include <map>

namespace carina
{
namespace
{

/// An object whose motion is stated exactly: less than this nobody sees.
constexpr SameView kUnseen{0.1, 1.0, 1.0};
using DelaysByPeer = std::map<ParticipantId, Duration>;

std::optional<double> inMs(const std::optional<Duration>& duration)
{
    return duration ? std::optional{1e3 * toSeconds(*duration)} : std::nullopt;
}

std::optional<double> inPercent(const std::optional<double>& share)
{
    return share ? std::optional{100.0 * *share} : std::nullopt;
}

std::optional<double> product(const std::optional<double>& rate,
                              const std::optional<Duration>& time)
{
    return rate && time ? std::optional{*rate * toSeconds(*time)} : std::nullopt;
}

DelaysByPeer meanDelays(const std::vector<PathReport>& paths)
{
    DelaysByPeer delays;
    for (const PathReport& path : paths)
        if (path.meanDelay)
            delays.emplace(path.peer, *path.meanDelay);
    return delays;
}

/// From a participant to whoever hears of it last: this node, which passes it on, or another peer.
std::optional<Duration> longestWayFrom(ParticipantId author, const DelaysByPeer& delays)
{
    const auto own = delays.find(author);
    if (own == delays.end())
        return std::nullopt;
    Duration onwards{};
    for (const auto& [peer, delay] : delays)
        if (peer != author)
            onwards = std::max(onwards, delay);
    return own->second + onwards;
}

/// From this program's participant to whoever hears of it last.
std::optional<Duration> longestWayFromHere(const DelaysByPeer& delays)
{
    std::optional<Duration> longest;
    for (const auto& [peer, delay] : delays)
        longest = std::max(longest.value_or(delay), delay);
    return longest;
}

/// An action is stated exactly, so what is acted on has no tracker's errors.
SameView sameView(const ObjectReport& report, const ObjectFigures& figures,
                  const std::optional<Duration>& delay)
{
    const double limit_deg = figures.limit_deg.value_or(0.0);
    const double limit_mm = figures.limit_mm.value_or(0.0);
    const double percent = std::max(figures.limit_percent.value_or(0.0), kUnseen.percent);
    if (report.limitDeg)
        return {std::max(limit_deg, kUnseen.deg), std::max(limit_mm, kUnseen.mm), percent};
    const Drift bound =
        trackedViewBound({degrees(limit_deg), millimetres(limit_mm)}, delay.value_or(Duration{}));
    return {inDegrees(bound.rotation), inMillimetres(bound.position), percent};
}

ObjectFigures figuresOf(const ObjectReport& report, const SharedObject& object,
                        const DelaysByPeer& delays)
{
    const auto path = delays.find(object.owner);
    const auto delay = path != delays.end() ? std::optional{path->second} : std::nullopt;
    ObjectFigures figures;
    figures.name = QString::fromStdString(object.name);
    figures.drift_deg = report.driftDeg;
    figures.drift_mm = report.driftMm;
    figures.limit_deg = report.limitDeg ? report.limitDeg : product(report.turnDegPerS, delay);
    figures.limit_mm = report.limitMm ? report.limitMm : product(report.moveMmPerS, delay);
    figures.drift_percent = inPercent(report.driftScale);
    figures.limit_percent = inPercent(report.limitScale);
    figures.same = sameView(report, figures, delay);
    return figures;
}

NetworkFigures figuresOf(const PathReport& path)
{
    NetworkFigures figures;
    figures.id = path.peer;
    figures.roundTrip_ms = inMs(path.roundTrip);
    for (const Duration delay : path.delays)
        figures.delays_ms.push_back(1e3 * toSeconds(delay));
    figures.meanDelay_ms = inMs(path.meanDelay);
    figures.sigma_ms = inMs(path.sigma);
    figures.probes_per_s = path.probesPerSecond;
    figures.isOfStrategy = path.isOfStrategy;
    if (path.clockOffset)
        figures.clockOffset_s = toSeconds(*path.clockOffset);
    figures.clockError_ms = inMs(path.clockError);
    figures.clockErrorBound_ms = inMs(path.clockErrorBound);
    figures.external = path.external;
    if (path.loss)
        figures.loss_percent = 100.0 * *path.loss;
    figures.traffic = path.traffic;
    return figures;
}

/// The application analysis of one participant.
/// @param longestWay from them
void addAnalysis(const std::map<ParticipantId, double>& frequencies,
                 const std::optional<Duration>& longestWay, NetworkFigures& figures)
{
    if (const auto frequency = frequencies.find(figures.id); frequency != frequencies.end())
        figures.actions_per_s = frequency->second;
    if (longestWay)
        figures.upshot_per_s = upshotFrequency(*longestWay);
}

} // namespace

std::vector<NetworkFigures> networkFigures(const SessionNode& node)
{
    const auto state = node.state();
    const auto paths = node.paths();
    const std::vector<ObjectReport> reports = node.objectReports();
    const DelaysByPeer delays = meanDelays(*paths);
    const std::map<ParticipantId, double> frequencies = node.actionFrequencies();
    std::vector<NetworkFigures> all;
    for (const PathReport& path : *paths) {
        const auto participant = state->participants().find(path.peer);
        if (participant == state->participants().end())
            continue;
        NetworkFigures figures = figuresOf(path);
        figures.name = QString::fromStdString(participant->second.name);
        addAnalysis(frequencies, longestWayFrom(path.peer, delays), figures);
        for (const ObjectReport& report : reports) {
            const auto object = state->objects().find(report.object);
            if (object != state->objects().end() && object->second.owner == path.peer)
                figures.objects.push_back(figuresOf(report, object->second, delays));
        }
        all.push_back(std::move(figures));
    }
    std::ranges::sort(all, {}, &NetworkFigures::id);
    const auto self = state->participants().find(node.self());
    if (!all.empty() && self != state->participants().end()) {
        NetworkFigures own;
        own.id = self->first;
        own.name = QString::fromStdString(self->second.name);
        own.isOwn = true;
        addAnalysis(frequencies, longestWayFromHere(delays), own);
        all.push_back(std::move(own));
    }
    return all;
}

} // namespace carina
