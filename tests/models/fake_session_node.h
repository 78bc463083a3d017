#pragma once

#include "engine/net/node/session_node.h"
#include "engine/session/session_authority.h"

#include <atomic>
#include <deque>
#include <utility>

namespace carina::test
{

/// A session in virtual time, on one thread and without a network: proposals are judged by the real
/// authority, at once while the host is here and in their order once it is back. Time and links are
/// what a test says they are.
class FakeSessionNode final : public SessionNode
{
public:
    static constexpr StationId kStation{0};
    static constexpr ParticipantId kHost{0};
    static constexpr ParticipantId kInstructor{1};
    static constexpr ParticipantId kTrainee{2};
    static constexpr ParticipantId kObserver{3};
    static constexpr ObjectId kTube{1};    ///< of kTrainee
    static constexpr ObjectId kPatient{2}; ///< once sharePatient() was called

    /// A prepared session with one station and one of everybody, seen by one of them.
    explicit FakeSessionNode(ParticipantId self = kInstructor) : m_self{self}
    {
        m_actions.setSelf(self);
        decide(fact::SessionCreated{"Routine intubation", "00ff"});
        addStation("Station 1");
        decide(fact::ParticipantJoined{{}, Role::Instructor, "Ina"});
        decide(fact::ParticipantJoined{{}, Role::Trainee, "Tom"});
        decide(fact::ParticipantJoined{{}, Role::Observer, "Olga"});
        decide(fact::ObjectShared{{}, kTrainee, ObjectKind::Tube, "tube"});
    }

    // What a test makes happen.

    void advance(Duration time)
    {
        std::atomic_ref{m_now}.store(m_now + time);
        while (!m_onTheWay.empty() && m_onTheWay.front().made + 2 * m_path <= m_now) {
            const Made next = std::move(m_onTheWay.front());
            m_onTheWay.pop_front();
            judge(next.proposal, next.made + m_path);
            announce();
        }
    }
    void loseClock() { m_hasClock = false; }
    /// The host decides by itself, or for somebody else.
    void decide(FactBody body, ParticipantId author = kHost)
    {
        decideAt(kStation, std::move(body), author);
    }
    void decideAt(StationId station, FactBody body, ParticipantId author = kHost)
    {
        judge({nextId(), author, station, std::move(body)});
        announce();
    }
    /// Its number follows that of the station added last; the first is kStation.
    void addStation(const char* name) { decideAt(kNoStation, fact::StationAdded{name}); }
    /// The virtual patient becomes something to act on.
    void sharePatient(ParticipantId owner)
    {
        decide(fact::ObjectShared{{}, owner, ObjectKind::Patient, "Adult"});
    }
    /// Its owner, wherever they are, acts on an object.
    void ownerActs(ObjectId object, const ObjectAction& action)
    {
        SharedActions theirs = m_actions;
        theirs.setSelf(m_authority.state().objects().at(object).owner);
        if (const auto event = theirs.begun(object, action, m_now, local()))
            m_actions.take(*event, m_now, local());
    }
    /// An object of another is seen at rest at a time.
    void sees(ObjectId object, const RigidTransform& X_AO, SessionTime t)
    {
        StreamCpo cpo;
        cpo.object = object;
        cpo.time = t;
        cpo.X_AO = X_AO;
        cpo.motion = StreamMotion{};
        takes(cpo);
    }
    /// A sample of an object of another arrives when it was measured.
    void takes(const StreamCpo& cpo)
    {
        auto& poses = m_poses[cpo.object];
        if (!poses)
            poses = std::make_shared<RemoteObject>();
        poses->take(cpo, cpo.time);
    }
    /// Nothing is heard of anybody's objects for so long.
    void silence(Duration time) { m_silence += time; }
    /// From now on proposals wait.
    void hostGoesAway() { m_hostIsHere = false; }
    void hostComesBack()
    {
        m_hostIsHere = true;
        for (const Proposal& proposal : std::exchange(m_waiting, {}))
            judge(proposal);
        announce();
    }
    /// From now on proposals take so long to the host, facts as long back, and the effect of what
    /// drives a patient waits for them.
    void isFarAway(Duration path) { m_path = path; }
    /// The host takes what is proposed, but this program hears nothing of it.
    void hearsNothing() { m_heard = state(); }
    /// It hears what was answered meanwhile. @pre hearsNothing()
    void hearsAnswers() { m_unanswered.clear(); }
    /// And has caught up: it shows what came of it.
    void hearsFacts() { m_heard.reset(); }
    /// What it is to the host from now on.
    void becomes(ParticipantId self)
    {
        m_self = self;
        m_actions.setSelf(self);
    }
    void isRefused(const Error& why) { m_refusal = why; }
    void announce() const
    {
        if (m_callback)
            m_callback();
    }
    std::vector<LinkReport> linkReports;
    std::vector<PathReport> pathReports;
    std::vector<ObjectReport> reports;
    std::map<ParticipantId, double> frequencies;
    std::optional<HostDoor> hostDoor;
    int proposed = 0; ///< how many proposals came
    struct Published {
        ObjectKind kind;
        std::string name;
        PoseSource newest;
    };
    std::vector<Published> published;         ///< what this program shares
    std::map<ObjectKind, ShapeSource> shapes; ///< how it bends

    // SessionNode.

    [[nodiscard]] std::uint16_t port() const override { return 0; }
    [[nodiscard]] JoinCodes joinCodes() const override
    {
        return {{Role::Instructor, JoinCode::parse("AAAAA-11111").value()},
                {Role::Trainee, JoinCode::parse("BBBBB-22222").value()},
                {Role::Observer, JoinCode::parse("CCCCC-33333").value()}};
    }
    [[nodiscard]] std::string certificateName() const override { return {}; }
    [[nodiscard]] bool isOpen() const override { return false; }
    [[nodiscard]] std::optional<HostDoor> door() const override { return hostDoor; }
    [[nodiscard]] ParticipantId self() const override { return m_self; }
    [[nodiscard]] std::optional<SessionTime> now() const override
    {
        return m_hasClock ? std::optional{std::atomic_ref{m_now}.load()} : std::nullopt;
    }
    [[nodiscard]] std::optional<SessionTime> sessionTime(LocalTime t) const override
    {
        return m_hasClock ? std::optional{SessionTime{t.time_since_epoch()}} : std::nullopt;
    }
    [[nodiscard]] std::optional<ClockReport> clock() const override
    {
        return m_hasClock ? std::optional{ClockReport{}} : std::nullopt;
    }
    [[nodiscard]] std::shared_ptr<const SessionState> state() const override
    {
        return m_heard ? m_heard : std::make_shared<SessionState>(m_authority.state());
    }
    void propose(StationId station, FactBody body) override
    {
        ++proposed;
        const Proposal proposal{nextId(), m_self, station, std::move(body)};
        if (m_heard)
            m_unanswered.push_back(proposal.body);
        if (!m_hostIsHere)
            m_waiting.push_back(proposal);
        else if (m_path > Duration{})
            m_onTheWay.push_back({proposal, m_now});
        else
            judge(proposal);
        announce();
    }
    [[nodiscard]] std::vector<FactBody> pending() const override
    {
        std::vector<FactBody> bodies = m_unanswered;
        for (const Proposal& proposal : m_waiting)
            bodies.push_back(proposal.body);
        for (const Made& made : m_onTheWay)
            bodies.push_back(made.proposal.body);
        return bodies;
    }
    void publish(ObjectKind kind, std::string name, PoseSource newest) override
    {
        published.push_back({kind, std::move(name), std::move(newest)});
    }
    void publishShape(ObjectKind kind, ShapeSource shape) override
    {
        shapes.insert_or_assign(kind, std::move(shape));
    }
    [[nodiscard]] std::shared_ptr<const RemoteObject> object(ObjectId id) const override
    {
        const auto poses = m_poses.find(id);
        return poses == m_poses.end() ? nullptr : poses->second;
    }
    [[nodiscard]] std::optional<EventCpo> action(ObjectId object) const override
    {
        const EventCpo* newest = m_actions.table().newest(object);
        return newest ? std::optional{*newest} : std::nullopt;
    }
    void act(ObjectId object, const ObjectAction& action) override
    {
        const auto event = m_actions.begun(object, action, m_now, local());
        if (event)
            m_actions.take(*event, m_now, local());
        m_refusal = event ? std::nullopt : std::optional{event.error()};
    }
    [[nodiscard]] std::optional<ShownObject> shown(ObjectId object, SessionTime t) const override
    {
        return m_actions.shown(object, t, local(), local());
    }
    [[nodiscard]] std::vector<LinkReport> links() const override { return linkReports; }
    [[nodiscard]] std::shared_ptr<const std::vector<PathReport>> paths() const override
    {
        return std::make_shared<std::vector<PathReport>>(pathReports);
    }
    [[nodiscard]] std::optional<Error> refusal() const override { return m_refusal; }
    [[nodiscard]] std::vector<ObjectReport> objectReports() const override { return reports; }
    [[nodiscard]] std::map<ParticipantId, double> actionFrequencies() const override
    {
        return frequencies;
    }
    void onChange(std::function<void()> callback) override { m_callback = std::move(callback); }

private:
    ProposalId nextId() { return ProposalId{++m_proposals}; }
    struct Made {
        Proposal proposal;
        SessionTime made{};
    };
    void judge(const Proposal& proposal) { judge(proposal, m_now); }
    void judge(const Proposal& proposal, SessionTime at)
    {
        const Result<Fact> fact = m_authority.judge(proposal, at, m_path);
        if (fact)
            m_authority.commit(*fact);
        for (const auto& [id, object] : m_authority.state().objects())
            share(object);
        m_refusal = fact ? std::nullopt : std::optional{fact.error()};
    }

    /// As the host does it: what goes on goes on in the name of a new owner.
    void share(const SharedObject& object)
    {
        if (!m_actions.share(object.id, {object.owner, object.epoch, object.inPlace}))
            return;
        if (const EventCpo* last = m_actions.table().newest(object.id))
            m_actions.take(*m_actions.continued(*last), m_now, local());
    }
    /// Objects were heard of when they were last acted on, but for silence().
    [[nodiscard]] LocalTime local() const { return LocalTime{m_silence}; }

    ParticipantId m_self;
    mutable SessionTime m_now{std::chrono::seconds{1000}}; ///< a tracker reads it on its thread
    bool m_hasClock = true;
    bool m_hostIsHere = true;
    std::uint64_t m_proposals = 0;
    SessionAuthority m_authority{{}};
    SharedActions m_actions;
    Duration m_silence{};
    std::vector<Proposal> m_waiting;
    Duration m_path{};
    std::deque<Made> m_onTheWay;
    std::shared_ptr<const SessionState> m_heard; ///< the last one, while nothing is heard
    std::vector<FactBody> m_unanswered;          ///< proposed since then
    std::optional<Error> m_refusal;
    std::function<void()> m_callback;
    std::map<ObjectId, std::shared_ptr<RemoteObject>> m_poses; ///< of others
};

} // namespace carina::test
