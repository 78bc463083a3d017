#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/psk_identity.h"

#include <span>
#include <vector>

namespace carina
{

/// How a client proves its role to a host that authenticated by a certificate: inside the encrypted
/// path, before any other datagram. These datagrams begin with "CP".

/// SHA-256 of a certificate in DER.
using CertificateDigest = std::array<std::byte, 32>;

/// The host's challenge.
struct RoleChallenge {
    std::string sessionId;
    AccessKey nonce{}; ///< random, for this association alone

    friend bool operator==(const RoleChallenge&, const RoleChallenge&) = default;
};

/// A client's answer to the challenge.
struct RoleProof {
    PskIdentity identity;
    AccessKey mac{};

    friend bool operator==(const RoleProof&, const RoleProof&) = default;
};

/// The answer to a challenge. Its mac is the HMAC-SHA-256 (RFC 2104), under the key of the
/// identity, of
///
///     "carina role proof 1" | nonce | digest of the host's certificate | identity
///
/// so that an attacker with another certificate cannot relay the answer to the host.
[[nodiscard]] RoleProof proveRole(const PskIdentity& identity, const AccessKey& key,
                                  const AccessKey& nonce, const CertificateDigest& host);
/// Whether the proof was made with this key; compared in constant time.
[[nodiscard]] bool isProvedBy(const RoleProof& proof, const AccessKey& key, const AccessKey& nonce,
                              const CertificateDigest& host);

[[nodiscard]] std::vector<std::byte> encodeChallenge(const RoleChallenge& challenge);
[[nodiscard]] std::vector<std::byte> encodeProof(const RoleProof& proof);
/// Whether the host accepts the proof.
[[nodiscard]] std::vector<std::byte> encodeVerdict(bool taken);

// Nothing for any other datagram.
[[nodiscard]] std::optional<RoleChallenge> decodeChallenge(std::span<const std::byte> bytes);
[[nodiscard]] std::optional<RoleProof> decodeProof(std::span<const std::byte> bytes);
[[nodiscard]] std::optional<bool> decodeVerdict(std::span<const std::byte> bytes);

} // namespace carina
