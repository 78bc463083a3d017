#pragma once

#include "engine/core/byte_buffer.h"
#include "engine/io/anatomy_set/set_codec.h"

#include <QCryptographicHash>

namespace carina::fuzz
{

/// What stands before the payload of an anatomy set: magic, version, length and checksum.
inline constexpr std::size_t kSealBytes = 8 + 4 + 8 + 32;

/// Any bytes as the payload of a set whose length and checksum fit, as its host can make them fit.
inline std::vector<std::byte> setUnderSeal(std::span<const std::byte> payload)
{
    static const std::vector<std::byte> none = encodeSet({});
    std::vector<std::byte> bytes{none.begin(), none.begin() + 12};
    ByteWriter writer{bytes};
    writer.number(static_cast<std::uint64_t>(payload.size()));
    QCryptographicHash hash{QCryptographicHash::Blake2b_256};
    hash.addData(QByteArrayView{payload.data(), static_cast<qsizetype>(payload.size())});
    const QByteArray checksum = hash.result();
    writer.bytes(std::as_bytes(std::span{checksum.constData(), std::size_t{32}}));
    writer.bytes(payload);
    return bytes;
}

} // namespace carina::fuzz
