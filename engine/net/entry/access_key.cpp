#include "engine/net/entry/access_key.h"

#include "engine/core/expects.h"
#include "engine/net/entry/join_code.h"

#include <QByteArray>
#include <argon2.h>
#include <sodium.h>
#include <sys/mman.h>

#include <algorithm>
#include <span>

namespace carina
{
namespace
{

constexpr std::uint32_t kPasses = 3;
constexpr std::uint32_t kMemory_KiB = 256 << 10;
constexpr std::size_t kPiece = std::size_t{2} << 20; ///< bytes: a large page

// Argon2 works in memory of ours. libsodium asks the system for all of it filled (MAP_POPULATE),
// and returns it in one piece: for a quarter of a second no other thread of the program can ask for
// memory or return some, and the network stands still. Here pages come when they are used and are
// returned in pieces.

int takeMemory(std::uint8_t** memory, std::size_t bytes)
{
    void* taken = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (taken == MAP_FAILED)
        return ARGON2_MEMORY_ALLOCATION_ERROR;
    madvise(taken, bytes, MADV_HUGEPAGE); // quicker, where there are large pages
    *memory = static_cast<std::uint8_t*>(taken);
    return ARGON2_OK;
}

void returnMemory(std::uint8_t* memory, std::size_t bytes)
{
    for (std::size_t done = 0; done < bytes; done += kPiece)
        munmap(memory + done, std::min(kPiece, bytes - done));
}

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
    AccessKey key{};
    std::string typed = code.characters(); // neither it nor the salt is changed
    SessionKey salt = session;
    argon2_context context{};
    context.out = reinterpret_cast<std::uint8_t*>(key.data());
    context.outlen = static_cast<std::uint32_t>(key.size());
    context.pwd = reinterpret_cast<std::uint8_t*>(typed.data());
    context.pwdlen = static_cast<std::uint32_t>(typed.size());
    context.salt = reinterpret_cast<std::uint8_t*>(salt.data());
    context.saltlen = static_cast<std::uint32_t>(salt.size());
    context.t_cost = kPasses;
    context.m_cost = kMemory_KiB;
    context.lanes = 1;
    context.threads = 1;
    context.version = ARGON2_VERSION_13;
    context.allocate_cbk = takeMemory;
    context.free_cbk = returnMemory;
    context.flags = ARGON2_DEFAULT_FLAGS;
    if (argon2id_ctx(&context) != ARGON2_OK)
        return fail(Errc::NotEnoughMemory, "256 MiB");
    return key;
}

} // namespace carina
