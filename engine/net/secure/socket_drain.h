#pragma once

#include "engine/net/secure/arrival_queue.h"
#include "engine/tracking/stoppable_thread.h"

#include <functional>
#include <mutex>
#include <optional>
#include <vector>

namespace carina
{

/// Empties a UDP socket where its owner does not: on a thread of its own, that reads what has
/// waited there for kOwnersTurn. The system keeps some hundred to some thousand datagrams of a
/// socket, as it is set up, and in a flood of 16,000 a second drops whichever comes next, of
/// whomever. So whoever has much to do, or waits for a processor, would lose the datagrams of those
/// who send few.
///
/// Where kMany or more waited, it is a flood: for kFlood from then on each is read at once.
class SocketDrain
{
public:
    static constexpr Duration kOwnersTurn = std::chrono::milliseconds{4};
    static constexpr int kMany = 32;
    static constexpr Duration kFlood = std::chrono::seconds{1};
    /// While it is held, the drain reads nothing: what the owner reads comes after what it takes.
    using Hold = std::unique_lock<std::mutex>;

    /// @param socket of UDP; stays open as long as this. @param onNews called on the drain's thread
    ///        when it has read something, once until the next take(); must not block
    SocketDrain(qintptr socket, std::function<void()> onNews);

    /// No effect where there is no thread for it: the owner then reads alone.
    void start() { static_cast<void>(m_thread.start()); }
    [[nodiscard]] Hold hold() { return Hold{m_mutex}; }
    /// What was read since the last call, of each source in its order.
    [[nodiscard]] std::vector<RawDatagram> take(const Hold& hold);
    /// Sources of which each has a place of its own: the others have kMostStrangers together.
    /// @param known sorted
    void setKnown(std::vector<Endpoint> known, const Hold& hold);

private:
    void work(const std::stop_token& stopping);
    /// @returns how many it has read
    int drain();
    /// @returns nothing where none is there; else whether it was kept
    std::optional<bool> readNext();

    qintptr m_socket;
    std::function<void()> m_onNews;
    std::mutex m_mutex; // for what follows
    ArrivalQueue m_read;
    std::vector<Endpoint> m_known;
    bool m_hasTold = false;   // since the last take()
    StoppableThread m_thread; // last: uses all of the above
};

} // namespace carina
