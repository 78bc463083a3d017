#include "engine/net/entry/role_proof.h"

#include <QCryptographicHash>
#include <QMessageAuthenticationCode>
#include <sodium.h>

#include <algorithm>

namespace carina
{
namespace
{

using Bytes = std::span<const std::byte>;

constexpr std::string_view kProofLabel = "carina role proof 1";
constexpr std::size_t kProofHead = 4;
constexpr std::size_t kIdDigits = 32;
constexpr std::size_t kMacSize = std::tuple_size_v<AccessKey>;

enum class ProofKind : std::uint8_t { Challenge = 1, Answer = 2, Taken = 3, Refused = 4 };

std::vector<std::byte> begun(ProofKind kind)
{
    return {std::byte{'C'}, std::byte{'P'}, std::byte{1}, static_cast<std::byte>(kind)};
}

/// What follows the head of a datagram of this kind.
std::optional<Bytes> bodyOf(ProofKind kind, Bytes bytes)
{
    const auto head = begun(kind);
    if (bytes.size() < kProofHead || !std::ranges::equal(bytes.first(kProofHead), head))
        return std::nullopt;
    return bytes.subspan(kProofHead);
}

void append(std::vector<std::byte>& bytes, Bytes more)
{
    for (const std::byte b : more)
        bytes.push_back(b);
}

std::string textOf(Bytes bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

AccessKey keyAt(Bytes bytes)
{
    AccessKey key{};
    std::ranges::copy(bytes.first(key.size()), key.begin());
    return key;
}

QByteArray viewed(Bytes bytes)
{
    return QByteArray::fromRawData(reinterpret_cast<const char*>(bytes.data()),
                                   static_cast<qsizetype>(bytes.size()));
}

AccessKey macOf(const PskIdentity& identity, const AccessKey& key, const AccessKey& nonce,
                const CertificateDigest& host)
{
    QMessageAuthenticationCode code{QCryptographicHash::Sha256, viewed(key)};
    code.addData(kProofLabel.data(), static_cast<qsizetype>(kProofLabel.size()));
    code.addData(viewed(nonce));
    code.addData(viewed(host));
    code.addData(QByteArray::fromStdString(toText(identity)));
    const QByteArray mac = code.result();
    return keyAt(std::as_bytes(std::span{mac.data(), kMacSize}));
}

} // namespace

RoleProof proveRole(const PskIdentity& identity, const AccessKey& key, const AccessKey& nonce,
                    const CertificateDigest& host)
{
    return {identity, macOf(identity, key, nonce, host)};
}

bool isProvedBy(const RoleProof& proof, const AccessKey& key, const AccessKey& nonce,
                const CertificateDigest& host)
{
    const AccessKey right = macOf(proof.identity, key, nonce, host);
    return sodium_memcmp(right.data(), proof.mac.data(), right.size()) == 0;
}

std::vector<std::byte> encodeChallenge(const RoleChallenge& challenge)
{
    auto bytes = begun(ProofKind::Challenge);
    append(bytes, std::as_bytes(std::span{challenge.sessionId}));
    append(bytes, challenge.nonce);
    return bytes;
}

std::vector<std::byte> encodeProof(const RoleProof& proof)
{
    auto bytes = begun(ProofKind::Answer);
    append(bytes, proof.mac);
    const std::string identity = toText(proof.identity);
    append(bytes, std::as_bytes(std::span{identity}));
    return bytes;
}

std::vector<std::byte> encodeVerdict(bool taken)
{
    return begun(taken ? ProofKind::Taken : ProofKind::Refused);
}

std::optional<RoleChallenge> decodeChallenge(Bytes bytes)
{
    const auto body = bodyOf(ProofKind::Challenge, bytes);
    if (!body || body->size() != kIdDigits + kMacSize)
        return std::nullopt;
    RoleChallenge challenge{textOf(body->first(kIdDigits)), keyAt(body->subspan(kIdDigits))};
    return isSessionId(challenge.sessionId) ? std::optional{challenge} : std::nullopt;
}

std::optional<RoleProof> decodeProof(Bytes bytes)
{
    const auto body = bodyOf(ProofKind::Answer, bytes);
    if (!body || body->size() < kMacSize)
        return std::nullopt;
    const auto identity = pskIdentity(textOf(body->subspan(kMacSize)));
    return identity ? std::optional{RoleProof{*identity, keyAt(*body)}} : std::nullopt;
}

std::optional<bool> decodeVerdict(Bytes bytes)
{
    for (const bool taken : {true, false})
        if (std::ranges::equal(bytes, encodeVerdict(taken)))
            return taken;
    return std::nullopt;
}

} // namespace carina
