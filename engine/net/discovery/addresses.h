#pragma once

#include <string>
#include <vector>

namespace carina
{

/// Whether the text is exactly an IPv4 or IPv6 address at which a session may be joined, without
/// blanks.
[[nodiscard]] bool isAddress(const std::string& text);

/// Whether the text is an address or a valid host name: at most 253 letters, digits, hyphens and
/// dots (RFC 1123).
[[nodiscard]] bool isHostName(const std::string& text);

/// The IPv4 addresses at which other computers can reach this one.
[[nodiscard]] std::vector<std::string> ownAddresses();

} // namespace carina
