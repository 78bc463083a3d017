#include "engine/sync/wire/record_codec.h"

#include "engine/core/expects.h"
#include "engine/sync/wire/cpo_codec.h"
#include "engine/sync/wire/wire_quantities.h"

#include <algorithm>

namespace carina
{
namespace
{

/// The first byte of each record.
enum class RecordKind : std::uint8_t {
    StreamGroup = 1,
    EventCpo,
    Fact,
    Proposal,
    FactAck,
    ProposalRefused,
    Hello,
    Welcome,
    HelloRefused,
    ConnectionUnknown,
    Goodbye,
    EventAck,
    EventBeat,
    StrategyMessage,
    LagNeeded,
    ShownPose,
    ExternalTime,
};

/// Reasons that travel; the first has the number 1 on the wire and stands for all others too.
constexpr std::array kWireReasons{
    Errc::NotPermitted,  Errc::SessionEnded,    Errc::NameTaken,       Errc::OutOfRange,
    Errc::StoreFailed,   Errc::PacketMalformed, Errc::VersionMismatch, Errc::NotFinite,
    Errc::OwnerChanged,  Errc::NameUnclear,     Errc::SessionFull,     Errc::TooMuchSent,
    Errc::Muted,         Errc::Removed,         Errc::Banned,          Errc::SessionLocked,
    Errc::UsedElsewhere, Errc::StationUnknown,  Errc::StationOccupied, Errc::StationCount};

void writeReason(ByteWriter& out, Errc reason)
{
    const auto* found = std::ranges::find(kWireReasons, reason);
    const auto index = found == kWireReasons.end() ? 0 : found - kWireReasons.begin();
    out.number(static_cast<std::uint8_t>(index + 1));
}

Errc readReason(ByteReader& in)
{
    const auto code = in.number<std::uint8_t>();
    const bool known = code >= 1 && code <= kWireReasons.size();
    in.require(known, "reason");
    return known ? kWireReasons[code - 1U] : Errc::PacketMalformed;
}

void writeBody(ByteWriter& out, const std::vector<std::byte>& body)
{
    CARINA_EXPECTS(!body.empty() && body.size() <= kLargestFactBody);
    out.number(static_cast<std::uint16_t>(body.size()));
    out.bytes(body);
}

std::vector<std::byte> readBody(ByteReader& in)
{
    const auto size = in.number<std::uint16_t>();
    in.require(size >= 1 && size <= kLargestFactBody, "body length");
    const auto body = in.bytes(size);
    return {body.begin(), body.end()};
}

void writeText(ByteWriter& out, const std::string& text, std::size_t longest)
{
    CARINA_EXPECTS(text.size() <= longest);
    out.number(static_cast<std::uint8_t>(text.size()));
    out.bytes(std::as_bytes(std::span{text}));
}

std::string readText(ByteReader& in, std::size_t longest, const char* rule)
{
    const auto size = in.number<std::uint8_t>();
    in.require(size <= longest, rule);
    std::string text;
    for (const std::byte b : in.bytes(size))
        text.push_back(static_cast<char>(b));
    return text;
}

HelloRefused readHelloRefused(ByteReader& in)
{
    HelloRefused refused{readReason(in)};
    refused.detail = readText(in, kLongestDetail, "length of a detail");
    return refused;
}

SessionKey readSessionKey(ByteReader& in)
{
    SessionKey key{};
    std::ranges::copy(in.bytes(key.size()), key.begin());
    return key;
}

FactNumber readFactNumber(ByteReader& in) { return {in.number<std::uint64_t>()}; }

void writeProposal(ByteWriter& out, const ProposalRecord& proposal)
{
    out.number(proposal.id.value);
    out.number(proposal.station.value);
    writeBody(out, proposal.body);
}

ProposalRecord readProposal(ByteReader& in)
{
    ProposalRecord proposal;
    proposal.id.value = in.number<std::uint64_t>();
    proposal.author = kNobody;
    proposal.station.value = in.number<std::uint16_t>();
    proposal.body = readBody(in);
    return proposal;
}

FactRecord readFact(ByteReader& in)
{
    FactRecord fact;
    fact.number = readFactNumber(in);
    in.require(fact.number.value >= 1, "fact number");
    fact.proposal.value = in.number<std::uint64_t>();
    fact.author.value = in.number<std::uint16_t>();
    fact.station.value = in.number<std::uint16_t>();
    fact.committed = SessionTime{readWireTime(in)};
    fact.effect = SessionTime{readWireTime(in)};
    fact.body = readBody(in);
    return fact;
}

Hello readHello(ByteReader& in)
{
    Hello hello;
    hello.session = readSessionKey(in);
    hello.lastFact = readFactNumber(in);
    hello.join = readProposal(in);
    hello.station = readText(in, kLongestStationName, "length of a station's name");
    return hello;
}

Welcome readWelcome(ByteReader& in)
{
    Welcome welcome;
    welcome.session = readSessionKey(in);
    welcome.participant.value = in.number<std::uint16_t>();
    welcome.epoch = in.number<std::uint16_t>();
    welcome.lastFact = readFactNumber(in);
    return welcome;
}

/// EventAck and EventBeat: which action.
template <class Named> Named readNamed(ByteReader& in)
{
    Named event;
    event.object.value = in.number<std::uint16_t>();
    event.epoch = in.number<std::uint16_t>();
    event.action = in.number<std::uint32_t>();
    return event;
}

template <class Named> void writeNamed(ByteWriter& out, const Named& event)
{
    out.number(event.object.value);
    out.number(event.epoch);
    out.number(event.action);
}

ProposalRefused readProposalRefused(ByteReader& in)
{
    const ProposalId proposal{in.number<std::uint64_t>()};
    return {proposal, readReason(in)};
}

StrategyMessage readStrategyMessage(ByteReader& in)
{
    const auto strategy = in.number<std::uint8_t>();
    in.require(strategy <= static_cast<std::uint8_t>(StrategyKind::None), "number of a strategy");
    const auto size = in.number<std::uint8_t>();
    in.require(size >= 1 && size <= kLargestStrategyMessage, "length of a strategy's message");
    const auto bytes = in.bytes(size);
    return {StrategyKind{strategy}, {bytes.begin(), bytes.end()}};
}

ShownPose readShownPose(ByteReader& in)
{
    ShownPose shown;
    shown.object.value = in.number<std::uint16_t>();
    shown.at = SessionTime{readWireTime(in)};
    Quat q_AO;
    Vec3 p_AO;
    for (double& component : q_AO.coeffs())
        component = in.realDouble();
    for (double& metres : p_AO)
        metres = in.realDouble();
    // Written so that a NaN fails too.
    in.require(std::abs(q_AO.norm() - 1.0) <= kUnitTolerance, "rotation");
    in.require(p_AO.allFinite(), "position");
    shown.scale = double{in.realFloat()};
    in.require(std::isfinite(shown.scale) && shown.scale > 0.0, "scale");
    if (in.ok())
        shown.X_AO = RigidTransform{q_AO, p_AO};
    return shown;
}

ExternalTimeRecord readExternalTime(ByteReader& in)
{
    const Duration offset = readWireTime(in);
    const Duration error = readWireTime(in);
    in.require(error > Duration{} && error <= kLargestExternalError, "error of a clock");
    return {{offset, error}};
}

/// Writes a record's kind and fields.
class RecordWriter
{
public:
    explicit RecordWriter(ByteWriter& out) : m_out{out} {}

    void operator()(const StreamGroup& group)
    {
        kind(RecordKind::StreamGroup);
        writeStreamGroup(m_out, group);
    }
    void operator()(const EventCpo& event)
    {
        kind(RecordKind::EventCpo);
        writeEventCpo(m_out, event);
    }
    void operator()(const FactRecord& fact)
    {
        kind(RecordKind::Fact);
        m_out.number(fact.number.value);
        m_out.number(fact.proposal.value);
        m_out.number(fact.author.value);
        m_out.number(fact.station.value);
        writeWireTime(m_out, fact.committed.time_since_epoch());
        writeWireTime(m_out, fact.effect.time_since_epoch());
        writeBody(m_out, fact.body);
    }
    void operator()(const ProposalRecord& proposal)
    {
        kind(RecordKind::Proposal);
        writeProposal(m_out, proposal);
    }
    void operator()(const FactAck& ack)
    {
        kind(RecordKind::FactAck);
        m_out.number(ack.last.value);
    }
    void operator()(const ProposalRefused& refused)
    {
        kind(RecordKind::ProposalRefused);
        m_out.number(refused.proposal.value);
        writeReason(m_out, refused.reason);
    }
    void operator()(const Hello& hello)
    {
        kind(RecordKind::Hello);
        m_out.bytes(hello.session);
        m_out.number(hello.lastFact.value);
        writeProposal(m_out, hello.join);
        writeText(m_out, hello.station, kLongestStationName);
    }
    void operator()(const Welcome& welcome)
    {
        kind(RecordKind::Welcome);
        m_out.bytes(welcome.session);
        m_out.number(welcome.participant.value);
        m_out.number(welcome.epoch);
        m_out.number(welcome.lastFact.value);
    }
    void operator()(const HelloRefused& refused)
    {
        kind(RecordKind::HelloRefused);
        writeReason(m_out, refused.reason);
        writeText(m_out, refused.detail, kLongestDetail);
    }
    void operator()(const ConnectionUnknown&) { kind(RecordKind::ConnectionUnknown); }
    void operator()(const Goodbye&) { kind(RecordKind::Goodbye); }
    void operator()(const EventAck& ack)
    {
        kind(RecordKind::EventAck);
        writeNamed(m_out, ack);
    }
    void operator()(const EventBeat& beat)
    {
        kind(RecordKind::EventBeat);
        writeNamed(m_out, beat);
    }
    void operator()(const ExternalTimeRecord& record)
    {
        CARINA_EXPECTS(record.time.error > Duration{}
                       && record.time.error <= kLargestExternalError);
        kind(RecordKind::ExternalTime);
        writeWireTime(m_out, record.time.offset);
        writeWireTime(m_out, record.time.error);
    }
    void operator()(const StrategyMessage& message)
    {
        CARINA_EXPECTS(!message.bytes.empty() && message.bytes.size() <= kLargestStrategyMessage);
        kind(RecordKind::StrategyMessage);
        m_out.number(static_cast<std::uint8_t>(message.strategy));
        m_out.number(static_cast<std::uint8_t>(message.bytes.size()));
        m_out.bytes(message.bytes);
    }
    void operator()(const ShownPose& shown)
    {
        kind(RecordKind::ShownPose);
        m_out.number(shown.object.value);
        writeWireTime(m_out, shown.at.time_since_epoch());
        for (const double component : shown.X_AO.rotation().coeffs())
            m_out.real(component);
        for (const double metres : shown.X_AO.translation())
            m_out.real(metres);
        m_out.real(static_cast<float>(shown.scale));
    }
    void operator()(const LagNeeded& needed)
    {
        kind(RecordKind::LagNeeded);
        m_out.number(static_cast<std::uint32_t>(needed.lag.count()));
    }

private:
    void kind(RecordKind kind) { m_out.number(static_cast<std::uint8_t>(kind)); }

    ByteWriter& m_out;
};

} // namespace

void writeRecord(ByteWriter& out, const WireRecord& record)
{
    std::visit(RecordWriter{out}, record);
}

WireRecord readRecord(ByteReader& in)
{
    switch (static_cast<RecordKind>(in.number<std::uint8_t>())) {
    case RecordKind::StreamGroup:
        return readStreamGroup(in);
    case RecordKind::EventCpo:
        return readEventCpo(in);
    case RecordKind::Fact:
        return readFact(in);
    case RecordKind::Proposal:
        return readProposal(in);
    case RecordKind::FactAck:
        return FactAck{readFactNumber(in)};
    case RecordKind::ProposalRefused:
        return readProposalRefused(in);
    case RecordKind::Hello:
        return readHello(in);
    case RecordKind::Welcome:
        return readWelcome(in);
    case RecordKind::HelloRefused:
        return readHelloRefused(in);
    case RecordKind::ConnectionUnknown:
        return ConnectionUnknown{};
    case RecordKind::Goodbye:
        return Goodbye{};
    case RecordKind::EventAck:
        return readNamed<EventAck>(in);
    case RecordKind::EventBeat:
        return readNamed<EventBeat>(in);
    case RecordKind::StrategyMessage:
        return readStrategyMessage(in);
    case RecordKind::ShownPose:
        return readShownPose(in);
    case RecordKind::LagNeeded:
        return LagNeeded{Duration{in.number<std::uint32_t>()}};
    case RecordKind::ExternalTime:
        return readExternalTime(in);
    }
    in.require(false, "record kind");
    return Goodbye{};
}

} // namespace carina
