#pragma once

#include "engine/core/result.h"
#include "engine/io/anatomy_set/carried_sets.h"
#include "engine/net/carriage/host_door.h"

#include <QThread>

#include <memory>
#include <mutex>
#include <optional>

namespace carina
{

class SetReceiver;

/// How far a set has come.
struct FetchStatus {
    enum class State : std::uint8_t {
        Asking,    ///< on the way to the host, or between two tries
        Receiving, ///< bytes come
        Here,      ///< it lies among the carried sets, whole and as promised
        Failed,    ///< it will not come
    };
    State state = State::Asking;
    std::uint64_t received = 0;   ///< bytes, those of earlier tries included
    CarriedSet set{};             ///< once the host has offered it
    std::optional<Error> fault{}; ///< why it failed, or why the last try did
};

/// Fetches an anatomy set from the host of a session, on a thread of its own. A connection that
/// breaks is tried again, and goes on where it broke off; so does the next run of a program that
/// was killed. A set that is among the carried ones already is not sent again, but the host still
/// says which it is.
///
/// Fails with SetNotNamed, SetWithdrawn or VersionMismatch when the host refuses; OutOfRange for a
/// set that is too long; WrongCode when the key is turned down three times; FileUnwritable on a
/// full disk; FileMalformed when what came is not what was promised; PacketMalformed. A host that
/// does not answer is the fault HostSilent, and asked again.
class SetFetch
{
public:
    static constexpr Duration kFirstPause = std::chrono::milliseconds{100}; ///< doubled each time
    static constexpr Duration kLongestPause = std::chrono::seconds{4};
    /// Without a byte for so long a try is given up.
    static constexpr Duration kPatience = std::chrono::seconds{10};
    static constexpr int kRejectionsBelieved = 3;

    /// @param cacheFolder usually AnatomyCache::defaultFolder()
    SetFetch(HostDoor door, std::string contentHash, std::filesystem::path cacheFolder);
    /// Stops it; what is there stays for the next time.
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
