#include "engine/net/node/client_driver.h"

#include "engine/net/entry/token_message.h"
#include "engine/session/facts/fact_codec.h"

#include <QRandomGenerator>

#include <algorithm>

namespace carina
{
namespace
{

constexpr ParticipantId kHostParticipant{0};
/// Shortest interval of showing the state while a long log comes in: each time it is copied.
constexpr Duration kShowInterval = std::chrono::milliseconds{100};
constexpr Duration kTokenRequestInterval = std::chrono::milliseconds{250};

ProposalRecord newProposal(StationId station, FactBody body)
{
    const ProposalId id{QRandomGenerator::system()->generate64()};
    return toRecord(Proposal{id, kNobody, station, std::move(body)});
}

/// Whether a refusal is shown: a person waits for the result, or facts can no longer be stored.
bool isTold(const RefusedProposal& refused)
{
    const auto proposal = fromRecord(refused.proposal);
    return !proposal || !isByItself(proposal->body) || refused.reason == Errc::StoreFailed;
}

LinkState linkState(SyncClient::State state)
{
    switch (state) {
    case SyncClient::State::Connected:
        return LinkState::Connected;
    case SyncClient::State::Connecting:
        return LinkState::Connecting;
    case SyncClient::State::Closed:
        return LinkState::Ended;
    case SyncClient::State::Away:
        break;
    }
    return LinkState::Away;
}

} // namespace

ClientDriver::ClientDriver(const JoinSettings& settings, NodeBoard& board, LocalTime now)
    : m_credentials{settings.role, settings.code,
                    TokenFolder{settings.tokens, settings.role, settings.participantName},
                    settings.derive},
      m_door{settings.address, settings.port, {}},
      m_expectsCertificate{settings.certificate.has_value()},
      m_board{board},
      m_core{newProposal(kNoStation, fact::ParticipantJoined{ParticipantId{}, settings.role,
                                                             settings.participantName}),
             QRandomGenerator::system()->generate(), now, settings.station}
{
    m_credentials.setPlace(settings.address, settings.port);
    show(now);
}

void ClientDriver::connected(PeerAddress host, const Credential&, LocalTime now)
{
    m_host = host;
    m_core.greetNow(now);
    showDoor();
}

void ClientDriver::showDoor()
{
    auto offer = m_credentials.offerAgain();
    // There is no certificate behind that door: only the token's other holder shall be asked.
    if (offer && (offer->identity.who.participant || !m_expectsCertificate))
        m_board.setDoor({m_door.address, m_door.port, *std::move(offer)});
}

void ClientDriver::disconnected(PeerAddress, LocalTime)
{
    // The core hears by itself that nobody answers.
}

void ClientDriver::refused(const Error& why, LocalTime) { m_noEntry = why; }

void ClientDriver::receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now)
{
    if (from != m_host)
        return;
    compareViews(now); // by what was known until now
    if (const auto token = decodeToken(bytes)) {
        m_credentials.keepToken(*token);
        m_tokenReplaced = false;
        showDoor();
    } else {
        m_core.receive(bytes, now);
    }
}

void ClientDriver::propose(StationId station, FactBody body, LocalTime now)
{
    if (!isByItself(body))
        m_refusal.reset();
    m_core.propose(newProposal(station, std::move(body)), now);
}

void ClientDriver::publish(ObjectKind kind, std::string name, PoseSource newest)
{
    m_publications.add(kind, std::move(name), std::move(newest));
}

void ClientDriver::publishShape(ObjectKind kind, ShapeSource shape)
{
    m_publications.bend(kind, std::move(shape));
}

NodeDriver::Datagrams ClientDriver::advance(LocalTime now)
{
    sendOwnStreams(now);
    compareViews(now);
    if (const auto reading = m_externalClock.read(now))
        m_core.readExternal(*reading, now);
    m_core.advance(now);
    if (m_core.state() == SyncClient::State::Closed && m_core.helloRefused())
        m_credentials.giveUp(*m_core.helloRefused());
    SyncClient::Output output = m_core.take();
    if (output.startedAfresh)
        startAfresh();
    for (const FactRecord& record : output.facts)
        if (!apply(record, now))
            break;
    for (const StreamSample& sample : output.streams)
        m_board.objects.take(sample, m_core.clock().mapping()->at(now));
    for (const ShownPose& shown : output.shown)
        m_views.compare(shown);
    for (const RefusedProposal& refused : output.refused)
        if (isTold(refused))
            m_refusal = Error{refused.reason, {}};
    show(now);
    if (wantsToken() && now >= m_nextTokenRequest) {
        m_nextTokenRequest = now + kTokenRequestInterval;
        output.datagrams.push_back(encodeTokenRequest());
    }
    return addressed(std::move(output.datagrams));
}

LocalTime ClientDriver::nextWake() const
{
    return std::min({m_core.nextWake(), m_publications.nextTick(), m_nextViews,
                     wantsToken() ? m_nextTokenRequest : LocalTime::max(),
                     m_hasNewState ? m_nextShown : LocalTime::max()});
}

bool ClientDriver::wantsToken() const
{
    return m_core.state() == SyncClient::State::Connected
           && (m_tokenReplaced || !m_credentials.hasToken());
}

NodeDriver::Datagrams ClientDriver::close(LocalTime now)
{
    m_core.leave(now);
    return addressed(m_core.take().datagrams);
}

void ClientDriver::act(ObjectId object, const ObjectAction& action, LocalTime now)
{
    m_refusal.reset();
    const auto done = isMuted() ? fail(Errc::Muted) : Result<void>{m_core.act(object, action, now)};
    if (!done)
        m_refusal = done.error();
}

void ClientDriver::sendOwnStreams(LocalTime now)
{
    if (m_core.isCaughtUp())
        for (auto& [station, object] : m_publications.takeUnknown(m_state, m_core.self()))
            m_core.propose(newProposal(station, std::move(object)), now);
    for (const auto& [station, cpo] : m_publications.sample(m_state, m_core.self(), now)) {
        m_core.publish(station, cpo);
        m_board.objects.sent(m_core.self(), cpo);
    }
}

void ClientDriver::compareViews(LocalTime now)
{
    m_nextViews = LocalTime::max();
    const auto& clock = m_core.clock().mapping();
    if (!clock || m_state.objects().empty())
        return;
    for (const ShownPose& own : m_views.advance(m_state, m_core.self(), clock->at(now)))
        m_core.tellShown(own);
    m_nextViews = clock->localAt(m_views.nextDue(clock->at(now)));
}

std::optional<ActedPose> ClientDriver::shownPose(ObjectId object, SessionTime t) const
{
    const LocalTime drawn = m_core.clock().mapping()->localAt(t);
    return shownPoseOf(m_core.actions(), m_board.objects, object, t, drawn);
}

void ClientDriver::startAfresh()
{
    m_state = {};
    m_hasNewState = true;
    m_nextShown = LocalTime::min();
    m_board.objects.clear();
    m_views.clear();
    m_publications.forget();
}

bool ClientDriver::apply(const FactRecord& record, LocalTime now)
{
    const auto fact = fromRecord(record);
    if (!fact) { // no host that judges has such a fact
        m_refusal = fact.error();
        m_core.leave(now);
        return false;
    }
    m_state.apply(*fact);
    m_hasNewState = true;
    noteConduct(fact->body);
    noteStrategy(fact->body, now);
    if (const auto object = objectOf(fact->body); object && m_state.objects().contains(*object))
        share(m_state.objects().at(*object));
    if (mayChangeOwners(fact->body))
        for (const auto& [id, object] : m_state.objects())
            share(object);
    return true;
}

bool ClientDriver::isMuted() const
{
    const auto self = m_state.participants().find(m_core.self());
    return self != m_state.participants().end() && self->second.muted;
}

void ClientDriver::noteConduct(const FactBody& body)
{
    const auto* muted = std::get_if<fact::ParticipantMuted>(&body);
    const auto* replaced = std::get_if<fact::TokenReplaced>(&body);
    if (replaced && replaced->participant == m_core.self())
        m_tokenReplaced = true;
    if (!muted || muted->participant != m_core.self() || muted->muted)
        return;
    if (m_refusal && m_refusal->code == Errc::Muted)
        m_refusal.reset();
    m_publications.forget(); // what was refused is proposed again
}

void ClientDriver::noteStrategy(const FactBody& body, LocalTime now)
{
    if (std::holds_alternative<fact::StrategyChosen>(body))
        m_core.setStrategy(m_state.strategy(), now);
    if (!changesPresence(body))
        return;
    std::vector<ParticipantId> others;
    for (const auto& [id, participant] : m_state.participants())
        if (participant.present && id != m_core.self())
            others.push_back(id);
    m_core.setOthers(std::move(others), now);
}

void ClientDriver::share(const SharedObject& object)
{
    m_core.share(object.id, {object.owner, object.epoch, object.inPlace});
    if (object.owner == m_core.self() || !m_state.isPresent(object.owner))
        m_board.objects.remove(object.id);
    else
        m_board.objects.add(object.id, object.owner, object.station);
}

NodeDriver::Datagrams ClientDriver::addressed(std::vector<std::vector<std::byte>> datagrams) const
{
    Datagrams result;
    for (auto& bytes : datagrams)
        result.push_back({m_host, std::move(bytes)});
    return result;
}

std::optional<ClockReport> ClientDriver::clockReport(LocalTime now) const
{
    const FittedClock& clock = m_core.clock();
    if (!clock.mapping())
        return std::nullopt;
    return ClockReport{clock.mapping()->at(now).time_since_epoch() - now.time_since_epoch(),
                       clock.skew(),
                       fromSeconds(clock.uncertainty(now)),
                       clock.bound(now),
                       clock.stateAt(now) == FittedClock::State::Holdover,
                       clock.external()};
}

std::shared_ptr<const std::vector<FactBody>> ClientDriver::pending()
{
    const auto& waiting = m_core.waiting();
    if (std::ranges::equal(waiting, m_shownWaiting, {}, &ProposalRecord::id))
        return m_shownPending;
    m_shownWaiting.clear();
    std::vector<FactBody> bodies;
    for (const ProposalRecord& record : waiting) {
        m_shownWaiting.push_back(record.id);
        if (auto body = decodeBody(record.body))
            bodies.push_back(*std::move(body));
    }
    m_shownPending = std::make_shared<std::vector<FactBody>>(std::move(bodies));
    return m_shownPending;
}

void ClientDriver::show(LocalTime now)
{
    if (m_hasNewState && (m_core.isCaughtUp() || now >= m_nextShown)) {
        m_shownState = std::make_shared<SessionState>(m_state);
        m_hasNewState = false;
        m_nextShown = now + kShowInterval;
    }
    NodeBoard::View view;
    view.self = m_core.self();
    view.clock = m_core.clock().mapping();
    view.state = m_shownState;
    m_board.showActions(view, m_core.actions());
    view.drifts = m_views.drifts();
    view.pending = pending();
    view.clockReport = clockReport(now);
    view.links = std::make_shared<std::vector<NodeBoard::Link>>(
        1, linkReport(kHostParticipant, linkState(m_core.state()), m_core.link()));
    m_board.showPaths(view, now, [&] {
        return std::vector{reportPath(kHostParticipant, m_core.link(), m_core.clock().trigger(),
                                      m_core.strategyTriggerTo(kHostParticipant))};
    });
    view.refusal = m_refusal;
    if (const auto refused = m_core.helloRefused())
        view.refusal = *refused;
    if (m_noEntry)
        view.refusal = m_noEntry;
    if (m_board.show(std::move(view)))
        m_board.announce();
}

} // namespace carina
