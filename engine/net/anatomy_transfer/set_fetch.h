#pragma once

#include "engine/core/result.h"
#include "engine/io/anatomy_set/carried_sets.h"
#include "engine/net/anatomy_transfer/host_door.h"

#include <QThread>

#include <memory>
#include <mutex>
#include <optional>

namespace carina
{

class SetReceiver;

/// Progress of a transfer.
struct FetchStatus {
    enum class State : std::uint8_t {
        Asking,    ///< connecting to the host, or between two attempts
        Receiving, ///< bytes arrive
        Here,      ///< complete and verified, among the carried sets
        Failed,    ///< given up
    };
    State state = State::Asking;
    std::uint64_t received = 0;   ///< bytes, including those of earlier attempts
    CarriedSet set{};             ///< set once the host has offered it
    std::optional<Error> fault{}; ///< why it failed, or why the last attempt did
};

/// Fetches an anatomy set from the host of a session, on its own thread. After a broken connection
/// it tries again and resumes the transfer; so does the next run of a program that was killed. A
/// set that is already among the carried ones is not sent again, but the host is still asked which
/// one it is.
///
/// Fails with SetNotNamed, SetWithdrawn or VersionMismatch when the host refuses; OutOfRange for a
/// set that is too large; WrongCode when the key is rejected three times; FileUnwritable on a full
/// disk; FileMalformed when the received set does not match its offer; PacketMalformed. A host that
/// does not answer gives the fault HostSilent, and is tried again.
class SetFetch
{
public:
    /// Pause between attempts, doubled each time up to kLongestPause.
    static constexpr Duration kFirstPause = std::chrono::milliseconds{100};
    static constexpr Duration kLongestPause = std::chrono::seconds{4};
    /// An attempt ends when no byte arrives for this long.
    static constexpr Duration kPatience = std::chrono::seconds{10};
    /// Rejections of the key after which the fetch fails.
    static constexpr int kRejectionsBelieved = 3;

    /// @param cacheFolder usually AnatomyCache::defaultFolder()
    SetFetch(HostDoor door, std::string contentHash, std::filesystem::path cacheFolder);
    /// Stops the transfer; the part received so far is kept.
    ~SetFetch();
    SetFetch(const SetFetch&) = delete;
    SetFetch& operator=(const SetFetch&) = delete;

    [[nodiscard]] FetchStatus status() const;

private:
    friend class SetReceiver;
    void show(const FetchStatus& status);

    mutable std::mutex m_mutex;
    FetchStatus m_status;
    QThread m_thread;
    std::unique_ptr<SetReceiver> m_receiver; // lives on the thread
};

} // namespace carina
