#include "engine/sync/wire/datagram_codec.h"

#include "engine/core/expects.h"
#include "engine/sync/wire/record_codec.h"
#include "engine/sync/wire/wire_quantities.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::uint16_t kMagic = 0x4143; // the bytes "CA"

constexpr std::uint8_t kFromHost = 0x01;
constexpr std::uint8_t kHasEcho = 0x02;
constexpr std::uint8_t kAnswerNow = 0x04;
constexpr std::uint8_t kKnownHeaderFlags = 0x07;

BundleHeader readRestOfHeader(ByteReader& in)
{
    BundleHeader header;
    const auto flags = in.number<std::uint8_t>();
    in.require((flags & ~kKnownHeaderFlags) == 0, "header flags");
    header.fromHost = (flags & kFromHost) != 0;
    header.answerNow = (flags & kAnswerNow) != 0;
    header.connection = in.number<std::uint32_t>();
    header.sequence = in.number<std::uint32_t>();
    header.sender.value = in.number<std::uint16_t>();
    header.sentAt = readWireTime(in);
    const ClockEcho echo{readWireTime(in), Duration{in.number<std::uint32_t>()}};
    if ((flags & kHasEcho) != 0)
        header.echo = echo;
    else
        in.require(echo == ClockEcho{}, "clock echo");
    return header;
}

} // namespace

std::vector<std::byte> encodeHeader(const BundleHeader& header)
{
    std::vector<std::byte> bytes;
    bytes.reserve(kLargestDatagram);
    ByteWriter out{bytes};
    const ClockEcho echo = header.echo.value_or(ClockEcho{});
    CARINA_EXPECTS(echo.hold >= Duration{} && echo.hold <= kLongestHold);
    out.number(kMagic);
    out.number(kProtocolVersion);
    out.number(static_cast<std::uint8_t>((header.fromHost ? kFromHost : 0U)
                                         | (header.echo ? kHasEcho : 0U)
                                         | (header.answerNow ? kAnswerNow : 0U)));
    out.number(header.connection);
    out.number(header.sequence);
    out.number(header.sender.value);
    writeWireTime(out, header.sentAt);
    writeWireTime(out, echo.sentAt);
    out.number(static_cast<std::uint32_t>(echo.hold.count()));
    return bytes;
}

void leaveLater(std::span<std::byte> datagram, Duration by)
{
    ByteReader in{datagram};
    const bool isBundle =
        in.number<std::uint16_t>() == kMagic && in.number<std::uint8_t>() == kProtocolVersion;
    BundleHeader header = readRestOfHeader(in);
    if (!isBundle || !in.ok())
        return;
    header.sentAt += by;
    if (header.echo && (header.echo->hold += by) > kLongestHold)
        header.echo.reset();
    std::ranges::copy(encodeHeader(header), datagram.begin());
}

Result<Datagram> decodeDatagram(std::span<const std::byte> bytes)
{
    ByteReader in{bytes};
    in.require(bytes.size() <= kLargestDatagram, "length");
    in.require(in.number<std::uint16_t>() == kMagic, "magic");
    const auto version = in.number<std::uint8_t>();
    if (in.ok() && version != kProtocolVersion)
        return fail(Errc::VersionMismatch, std::to_string(version));
    Datagram datagram{readRestOfHeader(in), {}};
    while (in.ok() && in.remaining() > 0)
        datagram.records.push_back(readRecord(in));
    if (!in.ok())
        return fail(Errc::PacketMalformed, in.brokenRule());
    return datagram;
}

std::vector<std::vector<std::byte>> packDatagrams(std::span<const WireRecord> records,
                                                  const std::function<BundleHeader()>& nextHeader)
{
    std::vector<std::vector<std::byte>> datagrams{encodeHeader(nextHeader())};
    std::vector<std::byte> bytes;
    for (const WireRecord& record : records) {
        bytes.clear();
        ByteWriter out{bytes};
        writeRecord(out, record);
        if (datagrams.back().size() + bytes.size() > kLargestDatagram)
            datagrams.push_back(encodeHeader(nextHeader()));
        datagrams.back().insert(datagrams.back().end(), bytes.begin(), bytes.end());
    }
    return datagrams;
}

} // namespace carina
