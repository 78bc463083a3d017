#include "engine/net/node/path_report.h"

namespace carina
{

PathReport reportPath(ParticipantId peer, const PeerLink& link, const ProbeTrigger& clocks,
                      const ProbeTrigger* strategys)
{
    PathReport report;
    report.peer = peer;
    report.roundTrip = link.newestRoundTrip();
    report.loss = link.loss();
    report.isOfStrategy = strategys && strategys->history().size() > 0;
    const ProbeTrigger& trigger = report.isOfStrategy ? *strategys : clocks;
    const DelayHistory& history = trigger.history();
    if (history.size() == 0)
        return report;
    report.delays.assign(history.delays().begin(), history.delays().end());
    report.meanDelay = history.mean();
    report.sigma = history.sigma();
    report.probesPerSecond = trigger.rate();
    return report;
}

TrafficReport reportTraffic(const PeerTraffic& traffic, LocalTime now)
{
    return {traffic.bytes.perSecond(now), traffic.samples.perSecond(now), traffic.facts,
            traffic.refused};
}

} // namespace carina
