#pragma once

#include "engine/net/entry/join_code.h"

#include <cstdint>

namespace carina
{

/// What leads a guest into a session: where its host is, and the code of the role to come in as. As
/// text it is a link that a person passes on, shows as a QR code, or opens:
///
///     carina:join?address=192.168.1.20&port=45000&role=trainee&code=7K3QM-XW2PD
///
/// and for a host that proves itself by a certificate `&certificate=` and the name to expect in it.
struct JoinLink {
    static constexpr std::string_view kScheme = "carina:";
    static constexpr std::size_t kLongest = 400; ///< characters

    std::string address; ///< IPv4 or IPv6
    std::uint16_t port = 0;
    Role role = Role::Trainee; ///< never an instructor, who is not invited by a picture on a wall
    JoinCode code;
    std::string certificate{}; ///< a host name or an address; empty: the host has none

    friend bool operator==(const JoinLink&, const JoinLink&) = default;
};

[[nodiscard]] std::string toText(const JoinLink& link);

/// Whether a text is meant as a link, right or wrong. Blanks around it do not matter.
[[nodiscard]] bool isMeantAsLink(std::string_view text);

/// Reads a link; its parts may come in any order, each once, and no others. Only the certificate
/// may be missing.
/// @returns WrongLink with what is wrong, in words that repeat nothing of the text.
[[nodiscard]] Result<JoinLink> joinLink(std::string_view text);

} // namespace carina
