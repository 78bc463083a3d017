#pragma once

#include "engine/net/secure/arrival_queue.h"
#include "engine/tracking/stoppable_thread.h"

#include <functional>
#include <vector>

namespace carina
{

/// Empties a UDP socket where its owner does not: on a thread of its own, that reads what has
/// waited there for kPatience. The system keeps some 500 datagrams of a socket, which a flood of
/// 16,000 a second sends in 30 ms, and drops whichever comes next, of whomever. So whoever has much
/// to do, or waits for a processor, would lose the datagrams of those who send few.
///
/// Where kMany or more waited, it is a flood: for kFlood from then on each is read at once.
class SocketDrain
{
public:
    static constexpr Duration kPatience = std::chrono::milliseconds{4};
    static constexpr int kMany = 32;
    static constexpr Duration kFlood = std::chrono::seconds{1};

    /// @param socket of UDP; stays open as long as this. @param onNews called on the drain's thread
    ///        when it has read something; must not block
    SocketDrain(qintptr socket, std::function<void()> onNews);

    /// No effect where there is no thread for it: the owner then reads alone.
    void start() { static_cast<void>(m_thread.start()); }
    /// What was read since the last call, of each source in its order.
    [[nodiscard]] std::vector<RawDatagram> take();

private:
    void work(const std::stop_token& stopping);
    /// @returns how many it has read
    int drain();

    qintptr m_socket;
    std::function<void()> m_onNews;
    std::mutex m_mutex;
    ArrivalQueue m_read;
    StoppableThread m_thread; // last: uses all of the above
};

} // namespace carina
