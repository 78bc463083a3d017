#pragma once

#include "engine/tracking/igtl/igtl_subscriber.h"

#include <QThread>

#include <atomic>
#include <mutex>

namespace carina
{

/// Where a server of OpenIGTLink listens.
struct IgtlPlace {
    std::string address = "127.0.0.1";
    std::uint16_t port = 18944; ///< 0: a free one

    /// Whether only programs on this computer can reach it.
    [[nodiscard]] bool isLoopback() const;
    /// From "PORT" or "ADDRESS:PORT", an IPv6 address in brackets.
    /// @returns WrongAddress
    [[nodiscard]] static Result<IgtlPlace> read(const std::string& text);
};

/// Gives what it is given to the clients that connect to it, by OpenIGTLink, on a thread of its
/// own. The protocol has neither encryption nor admission: whoever reaches the port reads along.
///
/// Neither the giver nor the other clients ever wait for a client: while more than kMostWaiting
/// bytes wait for it, it is sent nothing, and then the newest; one that takes nothing for ten
/// seconds is disconnected, and so is one that sends something else. Clients beyond the
/// kMostClients are turned away. Nothing that a client sends changes what is given.
class IgtlServer
{
public:
    static constexpr int kMostClients = 16;
    static constexpr std::int64_t kMostWaiting = 256 * 1024;

    /// @returns AddressInUse; WrongAddress where this computer has no such address.
    [[nodiscard]] static Result<std::unique_ptr<IgtlServer>> listen(const IgtlPlace& place);
    ~IgtlServer();
    IgtlServer(const IgtlServer&) = delete;
    IgtlServer& operator=(const IgtlServer&) = delete;

    [[nodiscard]] std::uint16_t port() const { return m_port; }
    /// How many are connected.
    [[nodiscard]] int clients() const { return m_clients; }
    /// Gives this from now on. From any thread; returns at once.
    /// @pre the offer is not null, nor its landmarks.
    void give(std::shared_ptr<const IgtlOffer> offer);

private:
    class Listener;
    struct Client;

    IgtlServer();
    [[nodiscard]] std::shared_ptr<const IgtlOffer> taken();

    std::uint16_t m_port = 0;
    std::atomic<int> m_clients = 0;
    std::mutex m_mutex;
    std::shared_ptr<const IgtlOffer> m_offer;
    bool m_isAnnounced = false; ///< to the thread, which has not yet looked
    QThread m_thread;
    std::unique_ptr<Listener> m_listener; ///< of m_thread, while that runs
};

} // namespace carina
