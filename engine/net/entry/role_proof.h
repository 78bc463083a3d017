#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/psk_identity.h"

#include <span>
#include <vector>

namespace carina
{

/// How a client proves its role where the host has proved itself by a certificate: inside the
/// encrypted path, before anything else travels in it. The datagrams begin with "CP".

/// SHA-256 of a certificate as it travels (DER).
using CertificateDigest = std::array<std::byte, 32>;

/// The host's question.
struct RoleChallenge {
    std::string sessionId;
    AccessKey nonce{}; ///< random, for this path alone

    friend bool operator==(const RoleChallenge&, const RoleChallenge&) = default;
};

/// A client's answer.
struct RoleProof {
    PskIdentity identity;
    AccessKey mac{};

    friend bool operator==(const RoleProof&, const RoleProof&) = default;
};

/// The mac is HMAC-SHA-256 (RFC 2104) under the key of the identity of
///
///     "carina role proof 1" | nonce | digest of the host's certificate | identity
///
/// so that whoever presents another certificate than the host's own cannot pass the answer on.
[[nodiscard]] RoleProof proveRole(const PskIdentity& identity, const AccessKey& key,
                                  const AccessKey& nonce, const CertificateDigest& host);
/// Whether it was made with this key. Takes as long for a wrong answer as for the right one.
[[nodiscard]] bool isProvedBy(const RoleProof& proof, const AccessKey& key, const AccessKey& nonce,
                              const CertificateDigest& host);

[[nodiscard]] std::vector<std::byte> encodeChallenge(const RoleChallenge& challenge);
[[nodiscard]] std::vector<std::byte> encodeProof(const RoleProof& proof);
/// Whether the host takes the proof.
[[nodiscard]] std::vector<std::byte> encodeVerdict(bool taken);

// Nothing for any other datagram.
[[nodiscard]] std::optional<RoleChallenge> decodeChallenge(std::span<const std::byte> bytes);
[[nodiscard]] std::optional<RoleProof> decodeProof(std::span<const std::byte> bytes);
[[nodiscard]] std::optional<bool> decodeVerdict(std::span<const std::byte> bytes);

} // namespace carina
