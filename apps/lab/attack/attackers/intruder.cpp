#include "apps/lab/attack/attackers/intruder.h"

#include "engine/session/facts/fact_codec.h"
#include "engine/sync/connection/peer_link.h"
#include "engine/sync/wire/datagram_codec.h"

#include <algorithm>
#include <array>

namespace carina::lab
{

Intruder::Intruder(const WayIn& way)
    : m_role{way.role},
      m_credentials{way.role, way.code, TokenFolder{{}, way.role, "Intruder"}, way.derive},
      m_transport{QHostAddress{QHostAddress::LocalHost},
                  way.port,
                  m_credentials,
                  monotonicNow(),
                  {},
                  kDiscoveryPort,
                  way.from}
{
    m_pump = std::make_unique<TransportPump>(m_transport, *this);
}

SessionTime Intruder::sessionNow() const
{
    return SessionTime{monotonicNow().time_since_epoch() + m_sessionOffset};
}

StationId Intruder::station() const
{
    return m_welcome ? m_state.stationOf(m_welcome->participant) : kNoStation;
}

void Intruder::hello(const std::string& name, ProposalId id, std::uint32_t connection, Has has)
{
    m_header.connection = connection;
    m_header.sender = kNobody;
    const bool knows = has == Has::WhatItHeard;
    m_inOrder = knows ? m_state.lastApplied() : FactNumber{};
    const Proposal join{id, kNobody, kNoStation,
                        fact::ParticipantJoined{ParticipantId{}, m_role, name}};
    const WireRecord record = Hello{knows ? m_session : SessionKey{}, m_inOrder, toRecord(join)};
    send(std::span{&record, 1});
}

void Intruder::acknowledge()
{
    const LocalTime now = monotonicNow();
    if (now < std::min(m_acknowledgement.due(), m_nextSign))
        return;
    m_acknowledgement.given();
    m_nextSign = now + kKeepAlive;
    send(std::array<WireRecord, 1>{FactAck{m_inOrder}});
}

void Intruder::leave()
{
    send(std::array<WireRecord, 1>{Goodbye{}});
    m_takesPart = false;
}

void Intruder::send(std::span<const WireRecord> records)
{
    const auto header = [this] {
        ++m_header.sequence;
        m_header.sentAt = monotonicNow().time_since_epoch();
        return m_header;
    };
    for (const auto& datagram : packDatagrams(records, header))
        sendBytes(datagram);
}

void Intruder::sendBytes(std::span<const std::byte> bytes)
{
    if (m_path == 0)
        return;
    m_transport.send(m_path, bytes);
    ++m_sent;
}

void Intruder::connected(PeerAddress peer, const Credential&, LocalTime) { m_path = peer; }

void Intruder::receive(PeerAddress, std::span<const std::byte> bytes, LocalTime now)
{
    const auto datagram = decodeDatagram(bytes);
    if (!datagram)
        return;
    m_sessionOffset = datagram->header.sentAt - now.time_since_epoch();
    m_hostSent = SessionTime{datagram->header.sentAt};
    for (const WireRecord& record : datagram->records) {
        if (const auto* welcome = std::get_if<Welcome>(&record)) {
            m_welcome = *welcome;
            m_takesPart = true;
            m_admitted = datagram->header.connection;
            m_session = welcome->session;
            m_header.sender = welcome->participant;
        }
        const bool isOfThis = datagram->header.connection == m_header.connection;
        if (const auto* refused = std::get_if<HelloRefused>(&record)) {
            m_helloRefused = refused->reason;
            if (isOfThis && m_takesPart) // then only another coming was refused
                m_header.connection = m_admitted;
        }
        if (isOfThis && std::holds_alternative<ConnectionUnknown>(record))
            m_takesPart = false;
        if (const auto* fact = std::get_if<FactRecord>(&record))
            take(*fact);
        m_heard(record);
    }
}

/// One that is not the next in order comes again.
void Intruder::take(const FactRecord& fact)
{
    ++m_factsHeard;
    const bool isNext = fact.number.value == m_inOrder.value + 1;
    m_acknowledgement.arrived(isNext ? 1 : 0, monotonicNow());
    if (isNext)
        m_inOrder = fact.number;
    if (fact.number.value != m_state.lastApplied().value + 1)
        return;
    if (const auto decoded = fromRecord(fact)) {
        m_facts.push_back(fact);
        m_state.apply(*decoded);
    }
}

void Intruder::disconnected(PeerAddress peer, LocalTime)
{
    ++m_ended;
    if (peer != m_path)
        return;
    m_path = 0;
    m_takesPart = false;
}

void Intruder::refused(const Error&, LocalTime) {}

} // namespace carina::lab
