#pragma once

#include "engine/net/entry/join_code.h"

#include <cstdint>

namespace carina
{

/// An invitation to a session: the address of its host, and the code of a role. As text it is a
/// link that a person forwards, shows as a QR code, or opens:
///
///     carina:join?address=192.168.1.20&port=45000&role=trainee&code=7K3QM-XW2PD
///
/// and for a host with a certificate `&certificate=` and the name to expect in it.
struct JoinLink {
    static constexpr std::string_view kScheme = "carina:";
    static constexpr std::size_t kLongest = 400; ///< characters

    std::string address; ///< IPv4 or IPv6
    std::uint16_t port = 0;
    Role role = Role::Trainee; ///< never Instructor, whose code must not be in a picture on a wall
    JoinCode code;
    std::string certificate{}; ///< a host name or an address; empty: the host has none

    friend bool operator==(const JoinLink&, const JoinLink&) = default;
};

[[nodiscard]] std::string toText(const JoinLink& link);

/// Whether a text is intended as a link, valid or not. Blanks around it are ignored.
[[nodiscard]] bool isMeantAsLink(std::string_view text);

/// Parses a link; its parts may be in any order, each once, and no others. Only the certificate is
/// optional.
/// @returns WrongLink with the fault; the detail quotes nothing of the text.
[[nodiscard]] Result<JoinLink> joinLink(std::string_view text);

} // namespace carina
