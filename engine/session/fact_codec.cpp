#include "engine/session/fact_codec.h"

#include "engine/core/expects.h"
#include "engine/session/fact_rules.h"
#include "engine/session/utf8.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
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

template <class Enum> constexpr Enum kLastEnumerator{};
template <> constexpr SessionPhase kLastEnumerator<SessionPhase> = SessionPhase::Ended;
template <> constexpr Role kLastEnumerator<Role> = Role::Observer;
template <> constexpr ObjectKind kLastEnumerator<ObjectKind> = ObjectKind::Stylus;

template <class T>
concept Enumeration = std::is_enum_v<T>;

class BodyWriter
{
public:
    template <std::unsigned_integral Number> void put(Number number)
    {
        for (std::size_t i = 0; i < sizeof(Number); ++i)
            m_bytes.push_back(static_cast<std::byte>((number >> (8 * i)) & 0xffu));
    }
    template <Enumeration Enum> void put(Enum value) { put(static_cast<std::uint8_t>(value)); }
    template <class Tag, class Number> void put(Id<Tag, Number> id) { put(id.value); }
    void put(double number) { put(std::bit_cast<std::uint64_t>(number)); }
    template <class Dimension> void put(Quantity<Dimension> quantity) { put(quantity.si); }
    void put(const std::string& text)
    {
        CARINA_EXPECTS(text.size() <= std::numeric_limits<std::uint8_t>::max());
        put(static_cast<std::uint8_t>(text.size()));
        for (char c : text)
            m_bytes.push_back(static_cast<std::byte>(c));
    }

    [[nodiscard]] std::vector<std::byte> take() { return std::move(m_bytes); }

private:
    std::vector<std::byte> m_bytes;
};

/// Reads fields until one is wrong; from then on everything is.
class BodyReader
{
public:
    explicit BodyReader(std::span<const std::byte> bytes) : m_rest{bytes} {}

    template <std::unsigned_integral Number> void get(Number& number)
    {
        const auto bytes = take(sizeof(Number));
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i)
            sum |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
        number = static_cast<Number>(sum);
    }
    template <Enumeration Enum> void get(Enum& value)
    {
        std::uint8_t number = 0;
        get(number);
        require(number <= static_cast<std::uint8_t>(kLastEnumerator<Enum>));
        value = static_cast<Enum>(number);
    }
    template <class Tag, class Number> void get(Id<Tag, Number>& id) { get(id.value); }
    void get(double& number)
    {
        std::uint64_t bits = 0;
        get(bits);
        number = std::bit_cast<double>(bits);
        require(std::isfinite(number));
    }
    template <class Dimension> void get(Quantity<Dimension>& quantity) { get(quantity.si); }
    void get(std::string& text)
    {
        std::uint8_t size = 0;
        get(size);
        for (std::byte b : take(size))
            text.push_back(static_cast<char>(b));
        require(isUtf8(text));
    }

    /// All fields were right and nothing is left.
    [[nodiscard]] bool isWhole() const { return m_right && m_rest.empty(); }

private:
    void require(bool condition) { m_right = m_right && condition; }
    std::span<const std::byte> take(std::size_t size)
    {
        require(size <= m_rest.size());
        if (!m_right)
            return {};
        const auto taken = m_rest.first(size);
        m_rest = m_rest.subspan(size);
        return taken;
    }

    std::span<const std::byte> m_rest;
    bool m_right = true;
};

template <class Body> std::optional<FactBody> readBodyOf(std::span<const std::byte> fields)
{
    Body body;
    BodyReader reader{fields};
    std::apply([&](auto... field) { (reader.get(body.*field), ...); }, kFields<Body>);
    if (!reader.isWhole())
        return std::nullopt;
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
    BodyWriter writer;
    writer.put(static_cast<std::uint8_t>(body.index() + 1));
    std::visit(
        [&]<class Body>(const Body& fields) {
            std::apply([&](auto... field) { (writer.put(fields.*field), ...); }, kFields<Body>);
        },
        body);
    return writer.take();
}

Result<FactBody> decodeBody(std::span<const std::byte> bytes)
{
    if (bytes.empty())
        return fail(Errc::PacketMalformed, "a fact without a kind");
    const auto kind = std::to_integer<std::size_t>(bytes.front());
    if (kind < 1 || kind > kBodyReaders.size())
        return fail(Errc::PacketMalformed, "a fact of unknown kind " + std::to_string(kind));
    std::optional<FactBody> body = kBodyReaders[kind - 1](bytes.subspan(1));
    if (!body)
        return fail(Errc::PacketMalformed, "a fact of kind " + std::to_string(kind));
    return *std::move(body);
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
