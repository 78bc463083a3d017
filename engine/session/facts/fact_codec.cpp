#include "engine/session/facts/fact_codec.h"

#include "engine/core/byte_buffer.h"
#include "engine/core/expects.h"
#include "engine/session/facts/fact_fields.h"
#include "engine/session/facts/fact_rules.h"
#include "engine/session/facts/utf8.h"
#include "engine/sync/wire/wire_quantities.h"

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

template <class T>
concept Enumeration = std::is_enum_v<T>;
template <class T>
concept OfFields =
    std::is_empty_v<T> ||(std::tuple_size_v<std::remove_cvref_t<decltype(kFields<T>)>> > 0);

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

void putField(ByteWriter& out, std::int64_t number) { out.number(number); }
void getField(ByteReader& in, std::int64_t& number) { number = in.number<std::int64_t>(); }

void putField(ByteWriter& out, SessionTime time) { writeWireTime(out, time.time_since_epoch()); }
void getField(ByteReader& in, SessionTime& time) { time = SessionTime{readWireTime(in)}; }

void putField(ByteWriter& out, Duration duration) { writeWireTime(out, duration); }
void getField(ByteReader& in, Duration& duration) { duration = readWireTime(in); }

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

// What is made of parts has them one after the other.
template <OfFields Whole> void putField(ByteWriter& out, const Whole& whole);
template <OfFields Whole> void getField(ByteReader& in, Whole& whole);

template <class Part, std::size_t count>
void putField(ByteWriter& out, const std::array<Part, count>& parts)
{
    for (const Part& part : parts)
        putField(out, part);
}
template <class Part, std::size_t count>
void getField(ByteReader& in, std::array<Part, count>& parts)
{
    for (Part& part : parts)
        getField(in, part);
}

// A list is preceded by how many there are.
template <class Part>
void putList(ByteWriter& out, const std::vector<Part>& parts, std::size_t most)
{
    CARINA_EXPECTS(parts.size() <= most);
    out.number(static_cast<std::uint8_t>(parts.size()));
    for (const Part& part : parts)
        putField(out, part);
}
template <class Part>
void getList(ByteReader& in, std::vector<Part>& parts, std::size_t most, const char* rule)
{
    const auto count = in.number<std::uint8_t>();
    in.require(count <= most, rule);
    for (std::size_t i = 0; in.ok() && i < count; ++i)
        getField(in, parts.emplace_back());
}

void putField(ByteWriter& out, const LungConditions& conditions)
{
    putList(out, conditions, kMostConditions);
}
void getField(ByteReader& in, LungConditions& conditions)
{
    getList(in, conditions, kMostConditions, "number of conditions");
}

void putField(ByteWriter& out, const LessonLooks& looks) { putList(out, looks, kMostLessonLooks); }
void getField(ByteReader& in, LessonLooks& looks)
{
    getList(in, looks, kMostLessonLooks, "number of looks");
}

void putField(ByteWriter& out, const AirwayEvents& events)
{
    putList(out, events, kAirwayEventKinds);
}
void getField(ByteReader& in, AirwayEvents& events)
{
    getList(in, events, kAirwayEventKinds, "number of airway events");
}

template <OfFields Whole> void putField(ByteWriter& out, const Whole& whole)
{
    std::apply([&](auto... field) { (putField(out, whole.*field), ...); }, kFields<Whole>);
}
template <OfFields Whole> void getField(ByteReader& in, Whole& whole)
{
    std::apply([&](auto... field) { (getField(in, whole.*field), ...); }, kFields<Whole>);
}

template <class Body> FactBody readBodyOf(ByteReader& in)
{
    static_assert(OfFields<Body>, "name its fields in fact_fields.h");
    Body body;
    getField(in, body);
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
    std::visit([&out](const auto& fields) { putField(out, fields); }, body);
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
