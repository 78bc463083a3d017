#include "engine/net/entry/session_identity.h"

#include <QByteArray>
#include <QRandomGenerator>

#include <algorithm>
#include <span>

namespace carina
{

std::string newSessionId()
{
    SessionKey bits{};
    for (std::byte& b : bits)
        b = static_cast<std::byte>(QRandomGenerator::system()->generate());
    return QByteArray{reinterpret_cast<const char*>(bits.data()), bits.size()}
        .toHex()
        .toStdString();
}

SessionKey sessionKey(const std::string& sessionId)
{
    const QByteArray bits = QByteArray::fromHex(QByteArray::fromStdString(sessionId));
    SessionKey key{};
    const auto bytes = std::as_bytes(std::span{bits.data(), static_cast<std::size_t>(bits.size())});
    std::ranges::copy(bytes.first(std::min(bytes.size(), key.size())), key.begin());
    return key;
}

} // namespace carina
