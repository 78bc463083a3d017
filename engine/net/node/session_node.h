#pragma once

#include "engine/core/result.h"
#include "engine/net/carriage/host_door.h"
#include "engine/net/entry/access_key.h"
#include "engine/net/entry/join_code.h"
#include "engine/net/node/path_report.h"
#include "engine/net/objects/remote_object.h"
#include "engine/session/facts/fact_store.h"
#include "engine/session/session_state.h"
#include "engine/sync/actions/shared_actions.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace carina
{

enum class LinkState : std::uint8_t { Connecting, Connected, Away };

/// The link to another participant, measured.
struct LinkReport {
    ParticipantId peer;
    LinkState state = LinkState::Connecting;
    Duration roundTrip{};        ///< smallest of the recent ones
    Duration clockUncertainty{}; ///< half of it: the bound of the offset's error
    Duration sinceLastDatagram{};
};

/// The session clock as this node knows it.
struct ClockReport {
    Duration offset{};        ///< session time less this program's clock
    double skew = 0.0;        ///< session seconds per second of this program's clock, less 1
    Duration standardError{}; ///< of the offset
    Duration bound{};         ///< half the shortest round trip: no path makes the error larger
    bool isHoldover = false;  ///< heard nothing for so long that it goes on by itself
};

/// A shared object as this node sees it.
struct ObjectReport {
    ObjectId object;
    Duration age{};        ///< of the newest sample of it, at the time of the report
    double driftDeg = 0.0; ///< how far the last update moved what this node drew then
    double driftMm = 0.0;
    std::optional<double> turnDegPerS{}; ///< how fast it turns, where its owner knows
    std::optional<double> moveMmPerS{};  ///< how fast its origin moves, likewise
    std::optional<double> actionsPerS{}; ///< v_k, as they arrive here (ApplicationAnalysis)
    // Of the last action on an object that is acted on (see ActionMeter):
    std::optional<double> limitDeg{}; ///< what it had to move the object, for the delay of the path
    std::optional<double> limitMm{};
    std::optional<Duration> delay{};
};

/// By what a host proves itself to those who expect it: PEM files.
struct CertificateFiles {
    std::filesystem::path certificate; ///< the host's own first, then those above it
    std::filesystem::path privateKey;  ///< without a password
};

/// What a client wants of the host's certificate.
struct ExpectedHost {
    std::string name{};                ///< that it is for; empty: the address that is joined
    std::filesystem::path authority{}; ///< PEM: whom to trust; empty: as the system does
};

struct HostSettings {
    std::string sessionName;
    std::string participantName; ///< of the instructor who hosts
    std::uint16_t port = 0;      ///< UDP, and TCP for anatomy; 0 takes a free one
    bool open = false;           ///< to other computers; else only this one can reach the session
    /// Codes, keys and tokens are kept in it, beside the store; empty: in memory only.
    std::filesystem::path secrets{};
    /// Nobody comes in without checking it; nothing: a code's key proves host and guest at once.
    std::optional<CertificateFiles> certificate{};
    DeriveKey derive = deriveByArgon2id;
    /// Anatomy sets that stations of the session have are handed out of it, over TCP at the same
    /// port; empty: none are, and nothing listens there.
    std::filesystem::path anatomyCache{};
};

struct JoinSettings {
    std::uint16_t port = 0; ///< of the host
    std::string participantName;
    Role role = Role::Trainee;
    StationId station;
    std::optional<JoinCode> code{};    ///< needed where there is no token of an earlier admission
    std::filesystem::path tokens{};    ///< folder that keeps them; empty: in memory only
    std::string address = "127.0.0.1"; ///< of the host, IPv4 or IPv6
    /// No host without a certificate that does is joined; nothing: none with one is.
    std::optional<ExpectedHost> certificate{};
    DeriveKey derive = deriveByArgon2id;
};

/// The newest measured pose of a local object in A; nothing while it was never seen. Must return at
/// once.
using PoseSource = std::function<std::optional<PoseSample>()>;

/// One program's part in a session: pumps the deterministic core of engine/sync with an encrypted
/// UDP socket and a clock, on a thread of its own. All functions may be called from any thread.
class SessionNode
{
public:
    /// Opens a session, or resumes the one the store holds, with its session time. The name and
    /// station of a session are those of its first start.
    ///
    /// @pre a QCoreApplication exists.
    /// @returns AddressInUse with the port; OutOfRange for a name that checkBody refuses; what the
    ///          store or the file of secrets objects to; what HostCertificate::read does.
    [[nodiscard]] static Result<std::unique_ptr<SessionNode>>
    host(const HostSettings& settings, std::unique_ptr<FactStore> store);
    /// Joins; returns at once and connects, and reconnects, by itself.
    ///
    /// @pre a QCoreApplication exists.
    /// @returns OutOfRange for a name that checkBody refuses; WrongAddress; what reading the
    ///          authority's file does.
    [[nodiscard]] static Result<std::unique_ptr<SessionNode>> join(const JoinSettings& settings);
    virtual ~SessionNode() = default;

    /// That others join at; 0 at a node that joined.
    [[nodiscard]] virtual std::uint16_t port() const = 0;
    /// By which others may come in; none at a node that joined.
    [[nodiscard]] virtual JoinCodes joinCodes() const = 0;
    /// The name that guests are to expect in this host's certificate; empty where it has none.
    [[nodiscard]] virtual std::string certificateName() const = 0;
    /// Programs on other computers can come in too.
    [[nodiscard]] virtual bool isOpen() const = 0;
    /// Where sets are fetched from the host (SetFetch); nothing at the host, and until it took a
    /// key of this node.
    [[nodiscard]] virtual std::optional<HostDoor> door() const = 0;
    /// kNobody until the host has admitted this node.
    [[nodiscard]] virtual ParticipantId self() const = 0;
    /// The session clock's best estimate; nothing until the clock is first set.
    [[nodiscard]] virtual std::optional<SessionTime> now() const = 0;
    /// Session time of a local time by the same estimate.
    [[nodiscard]] virtual std::optional<SessionTime> sessionTime(LocalTime t) const = 0;
    /// How well it is known; nothing until the clock is first set.
    [[nodiscard]] virtual std::optional<ClockReport> clock() const = 0;
    /// Everything that follows from the facts so far; shared because readers on several threads
    /// keep the snapshot while newer ones replace it.
    [[nodiscard]] virtual std::shared_ptr<const SessionState> state() const = 0;

    /// Proposes a fact; it appears in state() once the host has it on disk. Kept and repeated while
    /// the host is away.
    virtual void propose(StationId station, FactBody body) = 0;
    /// Proposals not yet acknowledged, oldest first.
    [[nodiscard]] virtual std::vector<FactBody> pending() const = 0;

    /// Shares a local object under the id that the host gives to this owner, kind and name: asks
    /// `newest` on the node's thread, 60 times a second, for the newest sample X_A<object> (with
    /// its motion, where known) and sends it where it is newer than the last one sent.
    virtual void publish(StationId station, ObjectKind kind, std::string name,
                         PoseSource newest) = 0;
    /// The poses X_A<object> of an object that another participant shares; nullptr for an unknown
    /// or own one. Shared because a viewer may ask while the node takes the object out.
    [[nodiscard]] virtual std::shared_ptr<const RemoteObject> object(ObjectId id) const = 0;

    /// Takes an action on an object that this node owns, from now on and until the next; 0 stops
    /// it. Shown here and sent at once; goes on while the host is away. An object is shared by
    /// proposing fact::ObjectShared or publish(), and changes its owner by fact::ObjectHandedOver.
    /// What is refused (see SharedActions::begun) is in refusal().
    virtual void act(ObjectId object, const ObjectAction& action) = 0;
    /// The object at session time t as the action in force has it, this node's own included;
    /// nothing before the first action on it.
    [[nodiscard]] virtual std::optional<ShownObject> shown(ObjectId object,
                                                           SessionTime t) const = 0;
    /// The newest action on the object, with where and when it began; nothing before the first.
    [[nodiscard]] virtual std::optional<EventCpo> action(ObjectId object) const = 0;

    [[nodiscard]] virtual std::vector<LinkReport> links() const = 0;
    /// Of the paths that this node measures, ten times a second: the host's to everybody, all
    /// others' to the host, whose clock is the session's and stays out of it. Shared because
    /// readers on several threads keep the snapshot while newer ones replace it.
    [[nodiscard]] virtual std::shared_ptr<const std::vector<PathReport>> paths() const = 0;
    /// Why the host does not admit this node, else why it refused the last proposal it refused;
    /// nothing while all is well.
    [[nodiscard]] virtual std::optional<Error> refusal() const = 0;
    [[nodiscard]] virtual std::vector<ObjectReport> objectReports() const = 0;

    /// Called on the node's thread after the state, the pending proposals or the links changed;
    /// must return at once.
    virtual void onChange(std::function<void()> callback) = 0;
};

} // namespace carina
