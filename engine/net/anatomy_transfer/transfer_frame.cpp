#include "engine/net/anatomy_transfer/transfer_frame.h"

#include "engine/core/byte_buffer.h"
#include "engine/core/expects.h"
#include "engine/io/anatomy_set/carried_sets.h"
#include "engine/io/anatomy_set/set_hash.h"

namespace carina::transfer
{
namespace
{

constexpr std::uint16_t kMagic = 0x5343; // "CS"
constexpr std::size_t kHashDigits = 64;

std::span<const std::byte> asBytes(std::string_view text) { return std::as_bytes(std::span{text}); }

std::string readText(ByteReader& reader, std::size_t length)
{
    const auto bytes = reader.bytes(length);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string readHash(ByteReader& reader)
{
    std::string hash = readText(reader, kHashDigits);
    reader.require(isSetHash(hash), "a hash");
    return hash;
}

/// A frame's place in the variant is its kind less 1.
struct WriteBody {
    ByteWriter& writer;

    void operator()(const Want& want) const
    {
        CARINA_EXPECTS(isSetHash(want.contentHash));
        writer.number(kMagic);
        writer.number(want.version);
        writer.bytes(asBytes(want.contentHash));
    }
    void operator()(const Offer& offer) const
    {
        CARINA_EXPECTS(isSetHash(offer.digest)
                       && offer.licence.size() <= CarriedSets::kLongestLicence);
        writer.number(offer.bytes);
        writer.bytes(asBytes(offer.digest));
        writer.number(static_cast<std::uint16_t>(offer.licence.size()));
        writer.bytes(asBytes(offer.licence));
    }
    void operator()(const Refusal& refusal) const
    {
        writer.number(static_cast<std::uint8_t>(refusal.reason));
    }
    void operator()(const Get& get) const { writer.number(get.offset); }
    void operator()(const Chunk& chunk) const
    {
        CARINA_EXPECTS(!chunk.bytes.empty() && chunk.bytes.size() <= kMostBody);
        writer.bytes(chunk.bytes);
    }
};

Want readWant(ByteReader& reader)
{
    reader.require(reader.number<std::uint16_t>() == kMagic, "its first bytes");
    Want want{reader.number<std::uint8_t>(), {}};
    if (want.version == kVersion)
        want.contentHash = readHash(reader);
    else
        reader.bytes(reader.remaining()); // whatever that version says
    return want;
}

Offer readOffer(ByteReader& reader)
{
    Offer offer;
    offer.bytes = reader.number<std::uint64_t>();
    offer.digest = readHash(reader);
    const auto length = reader.number<std::uint16_t>();
    reader.require(length <= CarriedSets::kLongestLicence, "a licence within its limit");
    offer.licence = readText(reader, length);
    return offer;
}

Refusal readRefusal(ByteReader& reader)
{
    const auto reason = reader.number<std::uint8_t>();
    reader.require(reason >= 1 && reason <= static_cast<std::uint8_t>(Reason::Busy),
                   "a known reason");
    return {static_cast<Reason>(reason)};
}

Frame readBody(std::uint8_t kind, ByteReader& reader)
{
    switch (kind) {
    case 1:
        return readWant(reader);
    case 2:
        return readOffer(reader);
    case 3:
        return readRefusal(reader);
    case 4:
        return Get{reader.number<std::uint64_t>()};
    default:
        break;
    }
    reader.require(kind == 5, "a known kind");
    reader.require(reader.remaining() > 0, "a chunk holds something");
    return Chunk{reader.bytes(reader.remaining())};
}

} // namespace

std::vector<std::byte> encode(const Frame& frame)
{
    std::vector<std::byte> body;
    ByteWriter bodyWriter{body};
    std::visit(WriteBody{bodyWriter}, frame);
    std::vector<std::byte> bytes;
    bytes.reserve(kHeaderBytes + body.size());
    ByteWriter writer{bytes};
    writer.number(static_cast<std::uint8_t>(frame.index() + 1));
    writer.number(static_cast<std::uint32_t>(body.size()));
    writer.bytes(body);
    return bytes;
}

Result<std::optional<Frame>> takeFrame(std::span<const std::byte>& bytes)
{
    if (bytes.size() < kHeaderBytes)
        return std::nullopt;
    ByteReader header{bytes};
    const auto kind = header.number<std::uint8_t>();
    const auto length = header.number<std::uint32_t>();
    if (kind < 1 || kind > std::variant_size_v<Frame> || length > kMostBody)
        return fail(Errc::PacketMalformed, "a frame of kind " + std::to_string(kind) + " with "
                                               + std::to_string(length) + " bytes");
    if (header.remaining() < length)
        return std::nullopt;
    ByteReader body{bytes.subspan(kHeaderBytes, length)};
    Frame frame = readBody(kind, body);
    body.require(body.remaining() == 0, "nothing follows");
    if (!body.ok())
        return fail(Errc::PacketMalformed, body.brokenRule());
    bytes = bytes.subspan(kHeaderBytes + length);
    return frame;
}

} // namespace carina::transfer
