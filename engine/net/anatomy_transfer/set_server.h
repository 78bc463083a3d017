#pragma once

#include "engine/net/secure/host_transport.h"

#include <QThread>

#include <filesystem>
#include <memory>

namespace carina
{

class SetListener;

/// What a connection has to move, or is ended, whether it asks for nothing or takes little.
struct SetPatience {
    Duration window = std::chrono::seconds{30};
    /// In each window: 17 kB/s, which a link of 140 kbit/s carries. A set that is smaller is sent
    /// within the first one.
    std::uint64_t leastBytes = std::uint64_t{512} << 10U;
};

/// Serves the anatomy sets that a session uses to clients that authenticate with a key of the
/// session, over TLS on a TCP port and on its own thread, so that the datagrams of the session are
/// not delayed.
class SetServer
{
public:
    /// Interval in which all transfers together send at most one chunk of 16 KiB: 16.4 MB/s.
    static constexpr std::chrono::milliseconds kPace{1};
    /// How often it is looked whether those who are sent a set may still have it.
    static constexpr std::chrono::milliseconds kLook{500};

    /// Whether a station of the session uses the patient with this content hash.
    using IsNamed = std::function<bool(const std::string& contentHash)>;
    /// Whether who proved this may have a set: not after it was removed from the session.
    using IsWelcome = std::function<bool(const Credential& who)>;

    /// Binds the port, on loopback or on all addresses of the computer; no client is accepted
    /// before admit.
    /// @param port TCP; 0 takes a free one @param anatomyCache folder with the sets
    /// @returns AddressInUse with the port.
    [[nodiscard]] static Result<std::unique_ptr<SetServer>>
    listen(std::uint16_t port, bool open, const std::filesystem::path& anatomyCache,
           const SetPatience& patience = {});
    ~SetServer();
    SetServer(const SetServer&) = delete;
    SetServer& operator=(const SetServer&) = delete;

    /// Starts to accept clients whose keys are known, as many as placeFor says. A connection ends
    /// once its key is void, or its holder not welcome. The callbacks are called on the server's
    /// thread.
    /// @param sessionId sent to every client @param isWelcome empty: everybody is
    void admit(const std::string& sessionId, HostTransport::KeyOf keyOf, IsNamed isNamed,
               IsWelcome isWelcome = {});

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
