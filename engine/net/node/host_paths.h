#pragma once

#include "engine/net/entry/psk_identity.h"
#include "engine/net/entry/source_limiter.h"
#include "engine/sync/actions/host_actions.h"
#include "engine/sync/connection/peer_budget.h"
#include "engine/sync/connection/peer_link.h"

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace carina
{

/// The encrypted paths to a host: ends those over which nobody takes part, and limits what is heard
/// over each before the budget of a participant counts.
class HostPaths
{
public:
    /// A path over which nobody takes part is ended after this time.
    static constexpr Duration kHelloWithin = std::chrono::seconds{2};
    /// Such paths of one address with one credential, a role's code or a participant's token: the
    /// one that has been idle longest is ended for a new one, so that who has one code cannot keep
    /// out people elsewhere, nor those who have another.
    static constexpr std::size_t kMostIdleOfCode = 64;
    static constexpr std::size_t kMostIdleOfToken = 4;
    /// Of all credentials: with these, and one for each participant who may be present, the
    /// transport never has as many as it takes.
    static constexpr std::size_t kMostIdle = 896;
    /// Datagrams over such a path in a second; twice as many at once. It is ended beyond: a program
    /// that comes in, or is told that its connection is not known, sends few.
    static constexpr double kIdleDatagrams = 40.0;
    /// Hellos over a path in a second that are judged; twice as many at once.
    static constexpr double kHellos = 10.0;
    /// How often it is looked which paths are in use.
    static constexpr Duration kLook = std::chrono::milliseconds{100};
    /// Requests for a token in a second that are answered; twice as many at once.
    static constexpr double kTokenRequests = 8.0;

    using PathTest = std::function<bool(PeerAddress)>;
    /// @param isInUse whether a participant is connected over a path
    /// @param isArriving whether one waits over it until their joining is stored
    explicit HostPaths(
        PathTest isInUse, PathTest isArriving = [](PeerAddress) { return false; })
        : m_isInUse{std::move(isInUse)}, m_isArriving{std::move(isArriving)}
    {
    }

    void connected(PeerAddress path, const Credential& who, const SourcePrefix& from,
                   LocalTime now);
    void disconnected(PeerAddress path) { m_paths.erase(path); }
    /// A path counts as idle from now on, not from before: its participant is to ask again.
    void idleFrom(PeerAddress path, LocalTime now);

    /// Whether a datagram over a path is heard; the path is ended where it is one too many and
    /// nobody takes part over it.
    [[nodiscard]] bool hears(PeerAddress path, LocalTime now);
    /// What those share who come from one address in one role; null for a path that is not known.
    [[nodiscard]] std::shared_ptr<SharedBudget> sharedBudget(PeerAddress path);
    /// The address that a path is from; zeros for a path that is not known.
    [[nodiscard]] SourcePrefix sourceOf(PeerAddress path) const;
    [[nodiscard]] bool hearsHello(PeerAddress path, LocalTime now);
    [[nodiscard]] bool hearsTokenRequest(PeerAddress path, LocalTime now);

    void advance(LocalTime now);
    [[nodiscard]] LocalTime nextWake() const { return m_nextLook; }
    /// The paths to be closed.
    [[nodiscard]] std::vector<PeerAddress> takeEnded() { return std::exchange(m_ended, {}); }

private:
    struct Path {
        Credential who;
        SourcePrefix from;
        LocalTime idleSince{}; ///< nobody has taken part over it from then on
        bool isEnded = false;  ///< it is to be closed, and not heard meanwhile
        TokenBucket datagrams{};
        TokenBucket hellos{};
        TokenBucket tokenRequests{};
    };

    [[nodiscard]] bool isIdle(PeerAddress path) const
    {
        return !m_isInUse(path) && !m_isArriving(path);
    }
    /// Makes room for one more path of this credential and address.
    void endOldestIdle(const Credential& who, const SourcePrefix& from);
    void end(PeerAddress address, Path& path);

    PathTest m_isInUse;
    PathTest m_isArriving;
    std::map<PeerAddress, Path> m_paths;
    std::map<std::pair<SourcePrefix, Role>, std::shared_ptr<SharedBudget>> m_shared;
    std::vector<PeerAddress> m_ended;
    LocalTime m_nextLook = LocalTime::max();
};

} // namespace carina
