#pragma once

#include "engine/net/secure/host_transport.h"

#include <QThread>

#include <filesystem>
#include <memory>

namespace carina
{

class SetListener;

/// Serves the anatomy sets that a session uses to clients that authenticate with a key of the
/// session, over TLS on a TCP port and on its own thread, so that the datagrams of the session are
/// not delayed.
class SetServer
{
public:
    static constexpr std::size_t kMostTransfers = 32; ///< at once
    /// Interval in which all transfers together send at most one chunk of 16 KiB: 16.4 MB/s.
    static constexpr std::chrono::milliseconds kPace{1};
    /// A connection without progress for this long is ended.
    static constexpr Duration kPatience = std::chrono::seconds{30};

    /// Whether a station of the session uses the patient with this content hash.
    using IsNamed = std::function<bool(const std::string& contentHash)>;

    /// Binds the port, on loopback or on all addresses of the computer; no client is accepted
    /// before admit.
    /// @param port TCP; 0 takes a free one @param anatomyCache folder with the sets
    /// @returns AddressInUse with the port.
    [[nodiscard]] static Result<std::unique_ptr<SetServer>>
    listen(std::uint16_t port, bool open, const std::filesystem::path& anatomyCache);
    ~SetServer();
    SetServer(const SetServer&) = delete;
    SetServer& operator=(const SetServer&) = delete;

    /// Starts to accept clients whose keys are known. Both callbacks are called on the server's
    /// thread.
    /// @param sessionId sent to every client
    void admit(const std::string& sessionId, HostTransport::KeyOf keyOf, IsNamed isNamed);

    [[nodiscard]] std::uint16_t port() const { return m_port; }

private:
    SetServer() = default;
    /// Runs the task on the server's thread and waits for it.
    void runThere(const std::function<void()>& task);

    QThread m_thread;
    std::unique_ptr<SetListener> m_listener; // lives on the thread
    std::uint16_t m_port = 0;
};

} // namespace carina
