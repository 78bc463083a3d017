#pragma once

#include "engine/net/secure/host_transport.h"

#include <QThread>

#include <filesystem>
#include <memory>

namespace carina
{

class SetListener;

/// Hands the anatomy sets that a session names to those who prove a key of the session, over TLS on
/// a TCP port and on a thread of its own: the datagrams of the session wait for nothing here.
class SetServer
{
public:
    static constexpr std::size_t kMostTransfers = 32; ///< at once
    /// All of them together send no more than one chunk of 16 KiB in each of these: 16.4 MB/s.
    static constexpr std::chrono::milliseconds kPace{1};
    /// A connection on which nothing moves for so long is ended.
    static constexpr Duration kPatience = std::chrono::seconds{30};

    /// Whether a station of the session has the patient with this content hash.
    using IsNamed = std::function<bool(const std::string& contentHash)>;

    /// Binds the port, on loopback or on all of the computer's addresses; nobody is let in before
    /// admit.
    /// @param port TCP; 0 takes a free one @param anatomyCache that the sets are in
    /// @returns AddressInUse with the port.
    [[nodiscard]] static Result<std::unique_ptr<SetServer>>
    listen(std::uint16_t port, bool open, const std::filesystem::path& anatomyCache);
    ~SetServer();
    SetServer(const SetServer&) = delete;
    SetServer& operator=(const SetServer&) = delete;

    /// Lets those in whose keys are known. Both are asked on the server's thread.
    /// @param sessionId told to everyone who asks
    void admit(const std::string& sessionId, HostTransport::KeyOf keyOf, IsNamed isNamed);

    [[nodiscard]] std::uint16_t port() const { return m_port; }

private:
    SetServer() = default;
    /// Runs on the server's thread, before this returns.
    void runThere(const std::function<void()>& task);

    QThread m_thread;
    std::unique_ptr<SetListener> m_listener; // lives on the thread
    std::uint16_t m_port = 0;
};

} // namespace carina
