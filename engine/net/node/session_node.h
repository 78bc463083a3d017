#pragma once

#include "engine/core/result.h"
#include "engine/net/anatomy_transfer/host_door.h"
#include "engine/net/entry/access_key.h"
#include "engine/net/entry/join_code.h"
#include "engine/net/node/path_report.h"
#include "engine/net/objects/remote_object.h"
#include "engine/session/facts/fact_store.h"
#include "engine/session/session_state.h"
#include "engine/sync/actions/shared_actions.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace carina
{

enum class LinkState : std::uint8_t {
    Connecting,
    Connected,
    Away,
    Ended, ///< for good: the host removed this program, or its log is impossible (see refusal())
};

/// Measurements of the link to another participant.
struct LinkReport {
    ParticipantId peer;
    LinkState state = LinkState::Connecting;
    Duration roundTrip{};        ///< shortest of the recent ones
    Duration clockUncertainty{}; ///< half of it: upper bound of the offset's error
    Duration sinceLastDatagram{};
};

/// The session clock as this node estimates it.
struct ClockReport {
    Duration offset{};        ///< session time less this program's clock
    double skew = 0.0;        ///< session seconds per second of this program's clock, less 1
    Duration standardError{}; ///< of the offset
    Duration bound{};         ///< upper bound of the offset's error (FittedClock::bound)
    bool isHoldover = false;  ///< no probe arrived recently: the clock continues by its last fit
    std::optional<ExternalVerdict> external{}; ///< of clocks disciplined from outside, if both have
};

/// Measurements of a shared object at this node.
struct ObjectReport {
    ObjectId object;
    Duration age{}; ///< of the newest sample of it, at the time of the report
    /// Between what this node and the object's owner showed at the same session time, a few times a
    /// second; nothing before the first comparison, and for an own object.
    std::optional<double> driftDeg{};
    std::optional<double> driftMm{};
    /// Angular speed, around the time of that comparison, else now; nothing where its owner has
    /// none.
    std::optional<double> turnDegPerS{};
    std::optional<double> moveMmPerS{}; ///< speed of its origin, likewise
    // Of an object that is acted on (see ActionMeter):
    std::optional<double> limitDeg{}; ///< least drift for the delay of the path, at that time: 0
    std::optional<double> limitMm{};  ///< unless an action was under way
    std::optional<Duration> delay{};  ///< of the last action
    /// Of the sizes, the larger by the smaller, less 1.
    std::optional<double> driftScale{};
    std::optional<double> limitScale{};
};

/// The certificate by which a host authenticates, as PEM files.
struct CertificateFiles {
    std::filesystem::path certificate; ///< the host's own first, then the intermediate ones
    std::filesystem::path privateKey;  ///< unencrypted
};

/// What a client requires of the host's certificate.
struct ExpectedHost {
    std::string name{}; ///< in the certificate; empty: the address that is joined
    /// PEM file of trusted authorities; empty: those of the system.
    std::filesystem::path authority{};
};

/// Settings of a node that hosts a session.
struct HostSettings {
    std::string sessionName;
    std::string participantName; ///< of the instructor who hosts
    std::uint16_t port = 0;      ///< UDP, and TCP for anatomy; 0 takes a free one
    bool open = false;           ///< reachable from other computers; else from this one only
    std::string firstStation = "Station 1"; ///< name of the station that a new session begins with
    /// How acted-on objects are kept alike; nothing: as before, by the session clock at first.
    std::optional<StrategyKind> strategy{};
    /// File for codes, keys and tokens, beside the store; empty: in memory only.
    std::filesystem::path secrets{};
    /// Clients must check this certificate; nothing: a code's key authenticates host and guest.
    std::optional<CertificateFiles> certificate{};
    DeriveKey derive = deriveByArgon2id;
    /// Cache from which anatomy sets of the session's stations are served, over TCP at the same
    /// port; empty: none are served, and no TCP port is opened.
    std::filesystem::path anatomyCache{};
};

/// Settings of a node that joins a session.
struct JoinSettings {
    std::uint16_t port = 0; ///< of the host
    std::string participantName;
    Role role = Role::Trainee;
    std::string station{}; ///< its name; empty: where this participant was last, else the first
    std::optional<JoinCode> code{};    ///< required unless there is a token of an earlier admission
    std::filesystem::path tokens{};    ///< folder for tokens; empty: in memory only
    std::string address = "127.0.0.1"; ///< of the host, IPv4 or IPv6
    /// Only a host with such a certificate is joined; nothing: only a host without one.
    std::optional<ExpectedHost> certificate{};
    DeriveKey derive = deriveByArgon2id;
};

/// Returns the newest measured pose of a local object in A; nothing before it was first seen. Must
/// not block.
using PoseSource = std::function<std::optional<PoseSample>()>;
/// Returns how a local object bends, as it is drawn here; nothing where it does not. Must not
/// block.
using ShapeSource = std::function<std::optional<StreamShape>()>;

/// One program's part in a session: runs the deterministic core of engine/sync with an encrypted
/// UDP socket and a clock, on its own thread. All functions may be called from any thread.
class SessionNode
{
public:
    /// Opens a session, or resumes the one in the store with its session time. Name and first
    /// station of a session are those of its first start.
    ///
    /// @pre a QCoreApplication exists.
    /// @returns AddressInUse with the port; OutOfRange for a name that checkBody refuses; errors of
    ///          the store, of the file of secrets, and of HostCertificate::read.
    [[nodiscard]] static Result<std::unique_ptr<SessionNode>>
    host(const HostSettings& settings, std::unique_ptr<FactStore> store);
    /// Joins a session; returns at once, and connects and reconnects in the background.
    ///
    /// @pre a QCoreApplication exists.
    /// @returns OutOfRange for a name, also of a station, that checkBody refuses; WrongAddress;
    ///          errors of reading the authority's file.
    [[nodiscard]] static Result<std::unique_ptr<SessionNode>> join(const JoinSettings& settings);
    virtual ~SessionNode() = default;

    /// The port at which others join; 0 at a node that joined.
    [[nodiscard]] virtual std::uint16_t port() const = 0;
    /// The codes with which others may join; none at a node that joined.
    [[nodiscard]] virtual JoinCodes joinCodes() const = 0;
    /// The name that clients are to expect in this host's certificate; empty where it has none.
    [[nodiscard]] virtual std::string certificateName() const = 0;
    /// Whether programs on other computers can join.
    [[nodiscard]] virtual bool isOpen() const = 0;
    /// Where sets are fetched from the host (SetFetch); nothing at the host, and before it accepted
    /// a key of this node.
    [[nodiscard]] virtual std::optional<HostDoor> door() const = 0;
    /// kNobody until the host has admitted this node.
    [[nodiscard]] virtual ParticipantId self() const = 0;
    /// Session time by the best estimate; nothing until the clock is first set.
    [[nodiscard]] virtual std::optional<SessionTime> now() const = 0;
    /// Session time of a local time, likewise.
    [[nodiscard]] virtual std::optional<SessionTime> sessionTime(LocalTime t) const = 0;
    /// The estimate and its uncertainty; nothing until the clock is first set.
    [[nodiscard]] virtual std::optional<ClockReport> clock() const = 0;
    /// Everything that follows from the facts so far; shared because readers on several threads
    /// keep the snapshot while newer ones replace it.
    [[nodiscard]] virtual std::shared_ptr<const SessionState> state() const = 0;

    /// Proposes a fact; it appears in state() once the host has it on disk. Stored and repeated
    /// while the host is away.
    virtual void propose(StationId station, FactBody body) = 0;
    /// Proposals not yet acknowledged, oldest first.
    [[nodiscard]] virtual std::vector<FactBody> pending() const = 0;

    /// Shares a local object, at the station where this participant is, under the id that the host
    /// assigns to this owner, kind and name.
    /// `newest` is called on the node's thread, 60 times a second, for the newest sample
    /// X_A<object> (with its velocity, where known), which is sent where it is newer than the last.
    virtual void publish(ObjectKind kind, std::string name, PoseSource newest) = 0;
    /// Sends how the local object of a kind bends with its poses from now on, while what `shape`
    /// returns is not older than ShapeView::kLongestGap. It is called on the node's thread for each
    /// sample.
    virtual void publishShape(ObjectKind kind, ShapeSource shape) = 0;
    /// The poses X_A<object> of an object that another participant shares; nullptr for an unknown
    /// or own object, and for one whose owner is not present. Shared because a viewer may use it
    /// while the node removes the object.
    [[nodiscard]] virtual std::shared_ptr<const RemoteObject> object(ObjectId id) const = 0;

    /// Begins an action on an object that this node owns, in force until the next; a rate of 0
    /// stops the object. It is shown here and sent at once, also while the host is away. An object
    /// is shared by proposing fact::ObjectShared or by publish(), and changes its owner by
    /// fact::ObjectHandedOver. A refused action (see SharedActions::begun) is reported in
    /// refusal().
    virtual void act(ObjectId object, const ObjectAction& action) = 0;
    /// The object at session time t as the session's strategy has it, this node's own included;
    /// nothing before the first action on it.
    [[nodiscard]] virtual std::optional<ShownObject> shown(ObjectId object,
                                                           SessionTime t) const = 0;
    /// The newest action on the object, with where and when it began; nothing before the first.
    [[nodiscard]] virtual std::optional<EventCpo> action(ObjectId object) const = 0;

    [[nodiscard]] virtual std::vector<LinkReport> links() const = 0;
    /// Reports on the paths that this node measures, ten times a second: at the host those to all
    /// participants, elsewhere that to the host (without clock values, because the host's clock is
    /// the session clock). Shared because readers on several threads keep the snapshot while newer
    /// ones replace it.
    [[nodiscard]] virtual std::shared_ptr<const std::vector<PathReport>> paths() const = 0;
    /// Why the host does not admit this node, else why it refused the last refused proposal;
    /// nothing if neither happened.
    [[nodiscard]] virtual std::optional<Error> refusal() const = 0;
    [[nodiscard]] virtual std::vector<ObjectReport> objectReports() const = 0;
    /// v_k of each participant whose actions this node knows, per second (ApplicationAnalysis); its
    /// own among them.
    [[nodiscard]] virtual std::map<ParticipantId, double> actionFrequencies() const = 0;

    /// Sets a callback, called on the node's thread after the state, the pending proposals or the
    /// links changed; it must not block.
    virtual void onChange(std::function<void()> callback) = 0;
};

/// The station where this program's participant is; kNoStation before it is admitted.
[[nodiscard]] inline StationId ownStation(const SessionNode& node)
{
    return node.state()->stationOf(node.self());
}

} // namespace carina
