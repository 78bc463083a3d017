#include "engine/net/node/host_entry.h"

#include "engine/session/facts/fact_codec.h"
#include "engine/session/station_rules.h"

#include <QCryptographicHash>
#include <QRandomGenerator>
#include <QtEndian>

namespace carina
{
namespace
{

constexpr ParticipantId kOfHost{0};

/// The id under which a join enters the log. The one that a program sent stays between it and the
/// host, so that it proves that a later join is of the same run of that program.
ProposalId sealed(ProposalId join)
{
    QCryptographicHash hash{QCryptographicHash::Sha256};
    hash.addData(QByteArrayView{"carina join 1"});
    hash.addData(QByteArray::number(quint64{join.value}));
    return ProposalId{qFromLittleEndian<quint64>(hash.result().constData())};
}

} // namespace

Error removalError(const SessionState& state, const Removal& removal)
{
    return {removal.banned ? Errc::Banned : Errc::Removed, removalText(state, removal)};
}

Result<Proposal> HostEntry::joinOf(const Hello& hello) const
{
    auto proposal = fromRecord(hello.join);
    if (!proposal)
        return proposal;
    const auto wanted = openStationNamed(m_ledger.decided().state(), hello.station);
    if (!hello.station.empty() && !wanted)
        return fail(Errc::StationUnknown, "open: " + openStationNames(m_ledger.decided().state()));
    proposal->station = wanted.value_or(kNoStation);
    return proposal;
}

Result<Identity> HostEntry::identify(PeerAddress from, const Hello& hello,
                                     const std::vector<FactRecord>& log, SessionTime session) const
{
    const auto proposal = joinOf(hello);
    if (!proposal)
        return tl::unexpected(proposal.error());
    const auto* joined = std::get_if<fact::ParticipantJoined>(&proposal->body);
    if (!joined || joined->participant.value != 0)
        return fail(Errc::NotPermitted);
    const Participant& self = m_ledger.stored().state().participants().at(kOfHost);
    if (joined->name == self.name && joined->role == self.role)
        return Identity{kOfHost};
    return m_ledger.decided().judge(*proposal, session, Duration{}).and_then([&](const Fact& fact) {
        const ParticipantId id = std::get<fact::ParticipantJoined>(fact.body).participant;
        return m_access.check(from, joined->role, id, isJoinOf(sealed(hello.join.id), id, log))
            .and_then([&] { return checkReturn(from, id, hello.join.id); })
            .map([&] {
                return Identity{id, m_access.isProven(from)};
            });
    });
}

Result<void> HostEntry::checkReturn(PeerAddress from, ParticipantId id, ProposalId join) const
{
    const SessionState& state = m_ledger.decided().state();
    if (state.isLocked() && !m_access.isProven(from))
        return fail(Errc::SessionLocked);
    const auto known = state.participants().find(id);
    const auto cameIn = m_ledger.decided().settled(sealed(join));
    const bool isOut = cameIn && known != state.participants().end() && known->second.removal
                       && *cameIn < known->second.removal->at;
    return isOut ? tl::unexpected(removalError(state, *known->second.removal)) : Result<void>{};
}

Result<std::optional<Admission>> HostEntry::admit(PeerAddress from, const Hello& hello,
                                                  const std::vector<FactRecord>& log,
                                                  SessionTime session, LocalTime now,
                                                  const Decide& decide)
{
    const auto who = identify(from, hello, log, session);
    auto proposal = joinOf(hello);
    if (!who || !proposal)
        return tl::unexpected(who ? proposal.error() : who.error());
    const SessionState& state = m_ledger.decided().state();
    const auto known = state.participants().find(who->participant);
    const Role role = std::get<fact::ParticipantJoined>(proposal->body).role; // by identify
    const bool isNew = known == state.participants().end();
    const Origins::Comer comer{who->participant, role, m_paths.sourceOf(from)};
    if (!m_origins.mayComeIn(comer, state, session))
        return fail(Errc::SessionFull);
    if (isNew && !takesNewcomer(comer, now)) {
        m_paths.idleFrom(from, now);
        return std::nullopt;
    }
    proposal->id = sealed(proposal->id);
    // A repeat gets the fact it has. Not the same run of a program that was given up meanwhile and
    // comes in a second time, nor another's.
    const bool isPresent = !isNew && known->second.present;
    if (m_ledger.decided().settled(proposal->id)
        && !(isPresent && isJoinOf(proposal->id, who->participant, log)))
        proposal->id = ProposalId{QRandomGenerator::system()->generate64()};
    return decide(*proposal).map([&](FactNumber joined) {
        m_origins.cameIn(comer);
        m_paths.idleFrom(from, now); // should it not be stored
        m_access.admitted(from, who->participant);
        return std::optional{Admission{who->participant, joined}};
    });
}

bool HostEntry::takesNewcomer(const Origins::Comer& comer, LocalTime now)
{
    Newcomers& known = m_newcomers[comer.role];
    return known.ofEach.admits(comer.from, now) && known.ofAll.take(1.0, kNewcomersOfAll, now);
}

bool HostEntry::isJoinOf(ProposalId proposal, ParticipantId participant,
                         const std::vector<FactRecord>& log) const
{
    const auto number = m_ledger.decided().settled(proposal);
    if (!number)
        return false;
    const FactRecord* record =
        number->value <= log.size() ? &log[number->value - 1] : m_ledger.unstored(*number);
    const auto fact = record ? fromRecord(*record) : Result<Fact>{fail(Errc::OutOfRange)};
    const auto* joined = fact ? std::get_if<fact::ParticipantJoined>(&fact->body) : nullptr;
    return joined != nullptr && joined->participant == participant;
}

} // namespace carina
