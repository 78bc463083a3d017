#include "engine/net/entry/access_key.h"

#include "engine/core/expects.h"
#include "engine/net/entry/join_code.h"

#include <QByteArray>
#include <sodium.h>

#include <algorithm>
#include <span>

namespace carina
{
namespace
{

static_assert(std::tuple_size_v<SessionKey> == crypto_pwhash_SALTBYTES);

void needSodium()
{
    static const bool ready = sodium_init() >= 0;
    CARINA_EXPECTS(ready);
}

} // namespace

AccessKey randomKey()
{
    needSodium();
    AccessKey key{};
    randombytes_buf(key.data(), key.size());
    return key;
}

std::string toHex(const AccessKey& key)
{
    const auto size = static_cast<qsizetype>(key.size());
    return QByteArray{reinterpret_cast<const char*>(key.data()), size}.toHex().toStdString();
}

std::optional<AccessKey> keyFromHex(const std::string& hex)
{
    const QByteArray bytes = QByteArray::fromHex(QByteArray::fromStdString(hex));
    AccessKey key{};
    if (bytes.size() != static_cast<qsizetype>(key.size()))
        return std::nullopt;
    std::ranges::copy(std::as_bytes(std::span{bytes.data(), key.size()}), key.begin());
    // fromHex passes over what is no digit.
    return toHex(key) == hex ? std::optional{key} : std::nullopt;
}

Result<AccessKey> deriveByArgon2id(const JoinCode& code, const SessionKey& session)
{
    needSodium();
    AccessKey key{};
    const std::string& typed = code.characters();
    const int status = crypto_pwhash(
        reinterpret_cast<unsigned char*>(key.data()), key.size(), typed.data(), typed.size(),
        reinterpret_cast<const unsigned char*>(session.data()), crypto_pwhash_OPSLIMIT_MODERATE,
        crypto_pwhash_MEMLIMIT_MODERATE, crypto_pwhash_ALG_ARGON2ID13);
    if (status != 0)
        return fail(Errc::NotEnoughMemory, "256 MiB");
    return key;
}

} // namespace carina
