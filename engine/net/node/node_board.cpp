#include "engine/net/node/node_board.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr Duration kPathInterval = std::chrono::milliseconds{100};

bool sameLinks(const std::vector<NodeBoard::Link>& a, const std::vector<NodeBoard::Link>& b)
{
    return &a == &b
           || std::ranges::equal(a, b, [](const NodeBoard::Link& x, const NodeBoard::Link& y) {
                  return x.report.peer == y.report.peer && x.report.state == y.report.state;
              });
}

/// Of the object's speeds when it was compared and before others could have heard of that, the
/// larger: it may have begun to move or have stopped between the two.
void noteSpeedsAt(SessionTime compared, const RemoteObject& object, ObjectReport& report)
{
    report.turnDegPerS.reset();
    report.moveMmPerS.reset();
    for (const SessionTime t : {compared - ShownViews::kMeasuredAfter, compared}) {
        const auto pose = object.at(t);
        if (!pose || !pose->motion || pose->validity == Validity::Lost)
            continue;
        report.turnDegPerS = std::max(report.turnDegPerS.value_or(0.0),
                                      inDegrees(radians(pose->motion->w_FO.norm())));
        report.moveMmPerS = std::max(report.moveMmPerS.value_or(0.0),
                                     inMillimetres(metres(pose->motion->v_FO.norm())));
    }
}

void noteLimit(const Drift& limit, ObjectReport& report)
{
    report.limitDeg = inDegrees(limit.rotation);
    report.limitMm = inMillimetres(limit.position);
    report.limitScale = limit.scale;
}

} // namespace

void NodeBoard::showActions(View& view, const SharedActions& actions) const
{
    view.actions = part(&View::actions);
    if (view.actions->revision() != actions.revision())
        view.actions = std::make_shared<SharedActions>(actions);
}

void NodeBoard::showPaths(View& view, LocalTime now,
                          const std::function<std::vector<PathReport>()>& measure) const
{
    {
        const std::scoped_lock lock{m_mutex};
        view.paths = m_view.paths;
        view.nextPaths = m_view.nextPaths;
    }
    if (now < view.nextPaths)
        return;
    view.paths = std::make_shared<std::vector<PathReport>>(measure());
    view.nextPaths = now + kPathInterval;
}

std::vector<ObjectReport> NodeBoard::objectReports(SessionTime now) const
{
    std::vector<ObjectReport> reports = objects.reports(now);
    const auto shared = part(&View::actions);
    const auto drifts = part(&View::drifts);
    for (const auto& [id, meter] : shared->meters()) {
        auto report = std::ranges::find(reports, id, &ObjectReport::object);
        if (report == reports.end())
            report = reports.insert(reports.end(), ObjectReport{id});
        const auto compared = drifts->find(id);
        noteLimit(compared != drifts->end() ? meter.limitAt(compared->second.at)
                                            : meter.figures().limit,
                  *report);
        report->delay = meter.figures().delay;
    }
    for (ObjectReport& report : reports)
        if (const auto drift = drifts->find(report.object); drift != drifts->end()) {
            report.driftDeg = inDegrees(drift->second.drift.rotation);
            report.driftMm = inMillimetres(drift->second.drift.position);
            if (shared->table().newest(report.object))
                report.driftScale = drift->second.drift.scale;
            if (const auto poses = objects.find(report.object))
                noteSpeedsAt(drift->second.at, *poses, report);
        }
    return reports;
}

std::map<ParticipantId, double> NodeBoard::actionFrequencies(SessionTime now) const
{
    ApplicationAnalysis analysis = objects.analysis();
    analysis.add(part(&View::actions)->analysis());
    const std::size_t shared = std::max<std::size_t>(1, state()->sharedObjects());
    std::map<ParticipantId, double> frequencies;
    for (const ParticipantId k : analysis.participants())
        if (const auto frequency = analysis.actionFrequency(k, shared, now))
            frequencies.emplace(k, *frequency);
    return frequencies;
}

bool NodeBoard::show(View view)
{
    const std::scoped_lock lock{m_mutex};
    const bool changed = view.self != m_view.self || view.state != m_view.state
                         || view.pending != m_view.pending || view.refusal != m_view.refusal
                         || view.clock.has_value() != m_view.clock.has_value()
                         || !sameLinks(*view.links, *m_view.links);
    m_view = std::move(view);
    return changed;
}

void NodeBoard::onChange(std::function<void()> callback)
{
    const std::scoped_lock lock{m_mutex};
    m_callback = std::move(callback);
}

NodeBoard::Link linkReport(ParticipantId peer, LinkState state, const PeerLink& link)
{
    LinkReport report;
    report.peer = peer;
    report.state = state;
    report.roundTrip = link.shortestRoundTrip().value_or(Duration{});
    report.clockUncertainty = report.roundTrip / 2;
    return {report, link.lastHeard()};
}

void NodeBoard::announce() const
{
    std::function<void()> callback;
    {
        const std::scoped_lock lock{m_mutex};
        callback = m_callback;
    }
    if (callback)
        callback();
}

} // namespace carina
