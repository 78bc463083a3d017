#include "engine/net/secure/dtls_record.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

constexpr std::size_t kRecordHeader = 13;
constexpr std::size_t kHandshakeHeader = 12;
constexpr std::size_t kVersionAndRandom = 2 + 32; // of a ClientHello, before its session id
constexpr std::uint8_t kClientHello = 1;
constexpr std::uint8_t kFatal = 2;
constexpr std::uint8_t kHandshakeFailure = 40;

// The sequence number lies beyond those that a handshake uses, so that no record is taken for a
// repeat of this one.
constexpr std::array<std::uint8_t, 15> kWrongKeyAlert{21, 0xFE, 0xFD, 0, 0, 0, 1, 0,
                                                      0,  0,    0,    0, 2, 2, 51};

std::uint16_t bigEndian(std::uint8_t high, std::uint8_t low)
{
    return static_cast<std::uint16_t>(high << 8 | low);
}

} // namespace

std::optional<DtlsRecord> firstRecord(std::span<const std::uint8_t> datagram)
{
    if (datagram.size() <= kRecordHeader || datagram[0] < 20 || datagram[0] > 23
        || datagram[1] != 0xFE || (datagram[2] != 0xFD && datagram[2] != 0xFF))
        return std::nullopt;
    const DtlsRecord record{static_cast<DtlsRecord::Type>(datagram[0]),
                            bigEndian(datagram[3], datagram[4]),
                            kRecordHeader + bigEndian(datagram[11], datagram[12])};
    return record.size <= datagram.size() ? std::optional{record} : std::nullopt;
}

bool isClientHello(std::span<const std::uint8_t> datagram)
{
    const auto record = firstRecord(datagram);
    return record && record->type == DtlsRecord::Type::Handshake && record->epoch == 0
           && record->size > kRecordHeader && datagram[kRecordHeader] == kClientHello;
}

bool holdsCookie(std::span<const std::uint8_t> clientHello)
{
    const std::size_t sessionId = kRecordHeader + kHandshakeHeader + kVersionAndRandom;
    if (sessionId >= clientHello.size())
        return false;
    const std::size_t cookie = sessionId + 1 + clientHello[sessionId];
    return cookie < clientHello.size() && clientHello[cookie] > 0;
}

bool holdsFinished(std::span<const std::uint8_t> datagram)
{
    while (const auto record = firstRecord(datagram)) {
        if (record->type == DtlsRecord::Type::Handshake && record->epoch > 0)
            return true;
        datagram = datagram.subspan(record->size);
    }
    return false;
}

std::span<const std::uint8_t> wrongKeyAlert() { return kWrongKeyAlert; }

bool isNoCipherAlert(std::span<const std::uint8_t> datagram)
{
    const auto record = firstRecord(datagram);
    return record && record->type == DtlsRecord::Type::Alert && record->epoch == 0
           && record->size == kRecordHeader + 2 && datagram[kRecordHeader] == kFatal
           && datagram[kRecordHeader + 1] == kHandshakeFailure;
}

bool isWrongKeyAlert(std::span<const std::uint8_t> datagram)
{
    return std::ranges::equal(datagram, kWrongKeyAlert);
}

} // namespace carina
