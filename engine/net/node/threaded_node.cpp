#include "engine/net/node/threaded_node.h"

#include "engine/core/monotonic_clock.h"
#include "engine/core/prompt_thread.h"

#include <algorithm>

namespace carina
{

Result<std::unique_ptr<SessionNode>> ThreadedNode::start(const MakeParts& makeParts)
{
    std::unique_ptr<ThreadedNode> node{new ThreadedNode};
    node->m_thread.setObjectName(QStringLiteral("carina-node"));
    startPromptly([&] { node->m_thread.start(); });
    node->m_loop = std::make_unique<NodeLoop>();
    node->m_loop->moveToThread(&node->m_thread);
    if (const auto opened = node->open(makeParts); !opened)
        return tl::unexpected(opened.error());
    return node;
}

Result<void> ThreadedNode::open(const MakeParts& makeParts)
{
    Result<void> opened;
    runThere([&] {
        auto parts = makeParts(m_board, monotonicNow());
        if (!parts) {
            opened = tl::unexpected(parts.error());
            return;
        }
        m_port = parts->transport->port();
        m_open = parts->open;
        m_sets = std::move(parts->sets);
        m_certificateName = parts->certificateName;
        m_loop->drive(std::move(parts->driver), std::move(parts->transport));
    });
    return opened;
}

ThreadedNode::~ThreadedNode()
{
    m_board.onChange({});
    m_sets.reset(); // asks the driver for keys
    runThere([this] {
        m_loop->close();
        m_loop.reset();
    });
    m_thread.quit();
    m_thread.wait();
}

void ThreadedNode::runThere(const std::function<void()>& task)
{
    QMetaObject::invokeMethod(m_loop.get(), task, Qt::BlockingQueuedConnection);
}

ParticipantId ThreadedNode::self() const { return m_board.part(&NodeBoard::View::self); }

std::optional<SessionTime> ThreadedNode::now() const { return sessionTime(monotonicNow()); }

std::optional<SessionTime> ThreadedNode::sessionTime(LocalTime t) const
{
    const auto clock = m_board.clock();
    return clock ? std::optional{clock->at(t)} : std::nullopt;
}

std::optional<ClockReport> ThreadedNode::clock() const
{
    return m_board.part(&NodeBoard::View::clockReport);
}

std::shared_ptr<const SessionState> ThreadedNode::state() const { return m_board.state(); }

void ThreadedNode::propose(StationId station, FactBody body)
{
    const std::scoped_lock lock{m_mutex}; // in the order in which they are taken
    m_onTheWay.push_back(body);
    QMetaObject::invokeMethod(
        m_loop.get(),
        [this, station, body = std::move(body)] {
            m_loop->driver().propose(station, body, monotonicNow());
            m_loop->serve();
            const std::scoped_lock taken{m_mutex};
            m_onTheWay.pop_front(); // the board has it
        },
        Qt::QueuedConnection);
}

std::vector<FactBody> ThreadedNode::pending() const
{
    std::vector<FactBody> later;
    {
        const std::scoped_lock lock{m_mutex};
        later.assign(m_onTheWay.begin(), m_onTheWay.end());
    }
    std::vector<FactBody> all = *m_board.part(&NodeBoard::View::pending);
    for (FactBody& body : later)
        if (std::ranges::find(all, body) == all.end()) // it arrived in between
            all.push_back(std::move(body));
    return all;
}

void ThreadedNode::publish(ObjectKind kind, std::string name, PoseSource newest)
{
    QMetaObject::invokeMethod(
        m_loop.get(),
        [this, kind, name = std::move(name), newest = std::move(newest)] {
            m_loop->driver().publish(kind, name, newest);
            m_loop->serve();
        },
        Qt::QueuedConnection);
}

void ThreadedNode::publishShape(ObjectKind kind, ShapeSource shape)
{
    QMetaObject::invokeMethod(
        m_loop.get(),
        [this, kind, shape = std::move(shape)] { m_loop->driver().publishShape(kind, shape); },
        Qt::QueuedConnection);
}

std::shared_ptr<const RemoteObject> ThreadedNode::object(ObjectId id) const
{
    return m_board.objects.find(id);
}

void ThreadedNode::act(ObjectId object, const ObjectAction& action)
{
    QMetaObject::invokeMethod(
        m_loop.get(),
        [this, object, action] {
            m_loop->driver().act(object, action, monotonicNow());
            m_loop->serve();
        },
        Qt::QueuedConnection);
}

std::optional<ShownObject> ThreadedNode::shown(ObjectId object, SessionTime t) const
{
    const auto clock = m_board.clock();
    return clock ? m_board.part(&NodeBoard::View::actions)
                       ->shown(object, t, clock->localAt(t), monotonicNow())
                 : std::nullopt;
}

std::optional<EventCpo> ThreadedNode::action(ObjectId object) const
{
    const auto actions = m_board.part(&NodeBoard::View::actions);
    const EventCpo* newest = actions->table().newest(object);
    return newest ? std::optional{*newest} : std::nullopt;
}

std::vector<LinkReport> ThreadedNode::links() const
{
    const LocalTime now = monotonicNow();
    std::vector<LinkReport> reports;
    const auto links = m_board.part(&NodeBoard::View::links);
    for (const NodeBoard::Link& link : *links) {
        reports.push_back(link.report);
        reports.back().sinceLastDatagram = now - link.lastHeard;
    }
    return reports;
}

std::shared_ptr<const std::vector<PathReport>> ThreadedNode::paths() const
{
    return m_board.part(&NodeBoard::View::paths);
}

std::optional<Error> ThreadedNode::refusal() const
{
    return m_board.part(&NodeBoard::View::refusal);
}

std::vector<ObjectReport> ThreadedNode::objectReports() const
{
    const auto time = now();
    return time ? m_board.objectReports(*time) : std::vector<ObjectReport>{};
}

std::map<ParticipantId, double> ThreadedNode::actionFrequencies() const
{
    const auto time = now();
    return time ? m_board.actionFrequencies(*time) : std::map<ParticipantId, double>{};
}

void ThreadedNode::onChange(std::function<void()> callback)
{
    m_board.onChange(std::move(callback));
}

} // namespace carina
