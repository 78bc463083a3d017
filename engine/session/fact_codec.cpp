#include "engine/session/fact_codec.h"

#include "engine/core/expects.h"
#include "engine/session/fact_rules.h"
#include "engine/session/utf8.h"
#include "engine/sync/byte_buffer.h"

#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace carina
{

namespace
{

// The fields of each fact, in the order in which they are written.
template <class Body> constexpr std::tuple<> kFields;
template <>
constexpr std::tuple kFields<fact::SessionCreated>{&fact::SessionCreated::name,
                                                   &fact::SessionCreated::sessionId};
template <> constexpr std::tuple kFields<fact::PhaseChanged>{&fact::PhaseChanged::phase};
template <> constexpr std::tuple kFields<fact::StationAdded>{&fact::StationAdded::name};
template <>
constexpr std::tuple kFields<fact::ParticipantJoined>{&fact::ParticipantJoined::participant,
                                                      &fact::ParticipantJoined::role,
                                                      &fact::ParticipantJoined::name};
template <>
constexpr std::tuple kFields<fact::ParticipantLeft>{&fact::ParticipantLeft::participant};
template <>
constexpr std::tuple kFields<fact::ObjectShared>{
    &fact::ObjectShared::object, &fact::ObjectShared::owner, &fact::ObjectShared::kind,
    &fact::ObjectShared::name};
template <>
constexpr std::tuple kFields<fact::AnatomyChosen>{&fact::AnatomyChosen::contentHash,
                                                  &fact::AnatomyChosen::name};
template <> constexpr std::tuple kFields<fact::BreathingRateSet>{&fact::BreathingRateSet::rate};
template <> constexpr std::tuple kFields<fact::TidalVolumeSet>{&fact::TidalVolumeSet::tidalVolume};
template <>
constexpr std::tuple kFields<fact::InspiratoryFractionSet>{&fact::InspiratoryFractionSet::fraction};

template <>
constexpr std::tuple kFields<fact::ObjectHandedOver>{&fact::ObjectHandedOver::object,
                                                     &fact::ObjectHandedOver::owner,
                                                     &fact::ObjectHandedOver::epoch};

template <>
constexpr std::tuple kFields<fact::ObjectWanted>{&fact::ObjectWanted::object,
                                                 &fact::ObjectWanted::wanted};

template <class Enum> constexpr Enum kLastEnumerator{};
template <> constexpr SessionPhase kLastEnumerator<SessionPhase> = SessionPhase::Ended;
template <> constexpr Role kLastEnumerator<Role> = Role::Observer;
template <> constexpr ObjectKind kLastEnumerator<ObjectKind> = ObjectKind::Patient;

template <class T>
concept Enumeration = std::is_enum_v<T>;

// One pair of overloads per type of field.

template <Enumeration Enum> void putField(ByteWriter& out, Enum value)
{
    out.number(static_cast<std::uint8_t>(value));
}
template <Enumeration Enum> void getField(ByteReader& in, Enum& value)
{
    const auto number = in.number<std::uint8_t>();
    in.require(number <= static_cast<std::uint8_t>(kLastEnumerator<Enum>), "enumerator");
    value = static_cast<Enum>(number);
}

template <class Tag, class Number> void putField(ByteWriter& out, Id<Tag, Number> id)
{
    out.number(id.value);
}
template <class Tag, class Number> void getField(ByteReader& in, Id<Tag, Number>& id)
{
    id.value = in.number<Number>();
}

void putField(ByteWriter& out, std::uint16_t number) { out.number(number); }
void getField(ByteReader& in, std::uint16_t& number) { number = in.number<std::uint16_t>(); }

void putField(ByteWriter& out, bool flag) { out.number(std::uint8_t{flag}); }
void getField(ByteReader& in, bool& flag)
{
    const auto number = in.number<std::uint8_t>();
    in.require(number <= 1, "flag");
    flag = number == 1;
}

void putField(ByteWriter& out, double number) { out.real(number); }
void getField(ByteReader& in, double& number)
{
    number = in.realDouble();
    in.require(std::isfinite(number), "finite number");
}

template <class Dimension> void putField(ByteWriter& out, Quantity<Dimension> quantity)
{
    putField(out, quantity.si);
}
template <class Dimension> void getField(ByteReader& in, Quantity<Dimension>& quantity)
{
    getField(in, quantity.si);
}

void putField(ByteWriter& out, const std::string& text)
{
    CARINA_EXPECTS(text.size() <= std::numeric_limits<std::uint8_t>::max());
    out.number(static_cast<std::uint8_t>(text.size()));
    out.bytes(std::as_bytes(std::span{text}));
}
void getField(ByteReader& in, std::string& text)
{
    for (const std::byte b : in.bytes(in.number<std::uint8_t>()))
        text.push_back(static_cast<char>(b));
    in.require(isUtf8(text), "UTF-8");
}

template <class Body> FactBody readBodyOf(ByteReader& in)
{
    static_assert(std::tuple_size_v<decltype(kFields<Body>)> > 0, "name its fields above");
    Body body;
    std::apply([&](auto... field) { (getField(in, body.*field), ...); }, kFields<Body>);
    return body;
}

/// One reader per alternative of FactBody, in its order.
template <std::size_t... kind> constexpr auto bodyReaders(std::index_sequence<kind...>)
{
    return std::array{&readBodyOf<std::variant_alternative_t<kind, FactBody>>...};
}
constexpr auto kBodyReaders =
    bodyReaders(std::make_index_sequence<std::variant_size_v<FactBody>>{});

} // namespace

std::vector<std::byte> encodeBody(const FactBody& body)
{
    std::vector<std::byte> bytes;
    ByteWriter out{bytes};
    out.number(static_cast<std::uint8_t>(body.index() + 1));
    std::visit(
        [&]<class Body>(const Body& fields) {
            std::apply([&](auto... field) { (putField(out, fields.*field), ...); }, kFields<Body>);
        },
        body);
    return bytes;
}

Result<FactBody> decodeBody(std::span<const std::byte> bytes)
{
    ByteReader in{bytes};
    const std::size_t kind = in.number<std::uint8_t>();
    if (kind < 1 || kind > kBodyReaders.size())
        return fail(Errc::PacketMalformed, "kind of fact " + std::to_string(kind));
    FactBody body = kBodyReaders[kind - 1](in);
    in.require(in.remaining() == 0, "length");
    if (!in.ok())
        return fail(Errc::PacketMalformed,
                    "fact of kind " + std::to_string(kind) + ": " + in.brokenRule());
    return body;
}

FactRecord toRecord(const Fact& fact)
{
    return {fact.number,    fact.proposal, fact.author,          fact.station,
            fact.committed, fact.effect,   encodeBody(fact.body)};
}

Result<Fact> fromRecord(const FactRecord& record)
{
    Result<FactBody> body = decodeBody(record.body);
    if (!body)
        return tl::unexpected(body.error());
    if (const Result<void> values = checkBody(*body); !values)
        return tl::unexpected(values.error());
    return Fact{record.number,    record.proposal, record.author,   record.station,
                record.committed, record.effect,   *std::move(body)};
}

ProposalRecord toRecord(const Proposal& proposal)
{
    return {proposal.id, proposal.author, proposal.station, encodeBody(proposal.body)};
}

Result<Proposal> fromRecord(const ProposalRecord& record)
{
    Result<FactBody> body = decodeBody(record.body);
    if (!body)
        return tl::unexpected(body.error());
    return Proposal{record.id, record.author, record.station, *std::move(body)};
}

} // namespace carina
