#include "apps/lab/attack/intruder.h"

#include "engine/session/facts/fact_codec.h"
#include "engine/sync/wire/datagram_codec.h"

namespace carina::lab
{

Intruder::Intruder(const WayIn& way)
    : m_role{way.role},
      m_credentials{way.role, way.code, TokenFolder{{}, way.role, "Intruder"}, way.derive},
      m_transport{QHostAddress{QHostAddress::LocalHost}, way.port, m_credentials, monotonicNow()}
{
    m_pump = std::make_unique<TransportPump>(m_transport, *this);
}

SessionTime Intruder::sessionNow() const
{
    return SessionTime{monotonicNow().time_since_epoch() + m_sessionOffset};
}

/// The epoch is the number of the fact that it joined.
StationId Intruder::station() const
{
    for (const FactRecord& fact : m_facts)
        if (m_welcome && static_cast<std::uint16_t>(fact.number.value) == m_welcome->epoch)
            return fact.station;
    return kNoStation;
}

void Intruder::hello(const std::string& name, ProposalId id, std::uint32_t connection)
{
    m_header.connection = connection;
    m_header.sequence = 0;
    m_header.sender = kNobody;
    const Proposal join{id, kNobody, kNoStation,
                        fact::ParticipantJoined{ParticipantId{}, m_role, name}};
    const WireRecord record = Hello{{}, {}, toRecord(join)};
    send(std::span{&record, 1});
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
    for (const WireRecord& record : datagram->records) {
        if (const auto* welcome = std::get_if<Welcome>(&record)) {
            m_welcome = *welcome;
            m_header.sender = welcome->participant;
        }
        if (const auto* refused = std::get_if<HelloRefused>(&record)) {
            m_helloRefused = refused->reason;
        }
        if (const auto* fact = std::get_if<FactRecord>(&record))
            m_facts.push_back(*fact);
    }
}

void Intruder::disconnected(PeerAddress, LocalTime) { ++m_ended; }

void Intruder::refused(const Error&, LocalTime) {}

} // namespace carina::lab
