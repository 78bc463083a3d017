#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <cstddef>
#include <span>
#include <vector>

namespace carina
{

/// The bytes of a row of hexadecimal pairs; blanks are ignored.
inline std::vector<std::byte> fromHex(const QByteArray& text)
{
    const QByteArray raw = QByteArray::fromHex(text); // which passes over blanks
    const auto bytes = std::as_bytes(std::span{raw.data(), static_cast<std::size_t>(raw.size())});
    return {bytes.begin(), bytes.end()};
}

/// Hexadecimal pairs with a blank between them, for comparison in a test's message.
inline QByteArray toHex(std::span<const std::byte> bytes)
{
    return QByteArrayView{bytes.data(), static_cast<qsizetype>(bytes.size())}.toByteArray().toHex(
        ' ');
}

} // namespace carina
