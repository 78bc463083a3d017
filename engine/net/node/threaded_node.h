#pragma once

#include "engine/net/anatomy_transfer/set_server.h"
#include "engine/net/node/node_board.h"
#include "engine/net/node/node_loop.h"

#include <QThread>

#include <deque>
#include <mutex>

namespace carina
{

/// A node with its thread. Reads are served from the board; changes are made on the thread.
class ThreadedNode : public SessionNode
{
public:
    /// Created on the node's thread, because sockets and timers belong to a thread.
    struct Parts {
        std::unique_ptr<NodeDriver> driver;
        std::unique_ptr<SecureTransport> transport; ///< destroyed before the driver
        bool open = false;
        std::unique_ptr<SetServer> sets{}; ///< destroyed first; null at a client
        std::string certificateName{};
    };
    using MakeParts = std::function<Result<Parts>(NodeBoard& board, LocalTime now)>;

    /// @returns the errors of makeParts.
    [[nodiscard]] static Result<std::unique_ptr<SessionNode>> start(const MakeParts& makeParts);
    ~ThreadedNode() override;
    ThreadedNode(const ThreadedNode&) = delete;
    ThreadedNode& operator=(const ThreadedNode&) = delete;

    [[nodiscard]] std::uint16_t port() const override { return m_port; }
    [[nodiscard]] JoinCodes joinCodes() const override { return m_board.joinCodes(); }
    [[nodiscard]] std::string certificateName() const override { return m_certificateName; }
    [[nodiscard]] bool isOpen() const override { return m_open; }
    [[nodiscard]] std::optional<HostDoor> door() const override { return m_board.door(); }
    [[nodiscard]] ParticipantId self() const override;
    [[nodiscard]] std::optional<SessionTime> now() const override;
    [[nodiscard]] std::optional<SessionTime> sessionTime(LocalTime t) const override;
    [[nodiscard]] std::optional<ClockReport> clock() const override;
    [[nodiscard]] std::shared_ptr<const SessionState> state() const override;
    void propose(StationId station, FactBody body) override;
    [[nodiscard]] std::vector<FactBody> pending() const override;
    void publish(ObjectKind kind, std::string name, PoseSource newest) override;
    void publishShape(ObjectKind kind, ShapeSource shape) override;
    [[nodiscard]] std::shared_ptr<const RemoteObject> object(ObjectId id) const override;
    void act(ObjectId object, const ObjectAction& action) override;
    [[nodiscard]] std::optional<ShownObject> shown(ObjectId object, SessionTime t) const override;
    [[nodiscard]] std::optional<EventCpo> action(ObjectId object) const override;
    [[nodiscard]] std::vector<LinkReport> links() const override;
    [[nodiscard]] std::shared_ptr<const std::vector<PathReport>> paths() const override;
    [[nodiscard]] std::optional<Error> refusal() const override;
    [[nodiscard]] std::vector<ObjectReport> objectReports() const override;
    [[nodiscard]] std::map<ParticipantId, double> actionFrequencies() const override;
    void onChange(std::function<void()> callback) override;

private:
    ThreadedNode() = default;

    [[nodiscard]] Result<void> open(const MakeParts& makeParts);
    /// Runs the task on the node's thread and waits for it.
    void runThere(const std::function<void()>& task);

    NodeBoard m_board;
    mutable std::mutex m_mutex;
    std::deque<FactBody> m_onTheWay; ///< proposals that the node's thread is to take
    QThread m_thread;
    std::unique_ptr<NodeLoop> m_loop;
    std::unique_ptr<SetServer> m_sets;
    std::uint16_t m_port = 0;
    bool m_open = false;
    std::string m_certificateName;
};

} // namespace carina
