#pragma once

#include <string>
#include <vector>

namespace carina
{

/// Whether it is an IPv4 or IPv6 address, which a session may be joined at, and nothing besides,
/// not even a blank.
[[nodiscard]] bool isAddress(const std::string& text);

/// Whether it is an address, or may be the name of a host: at most 253 letters, digits, hyphens and
/// dots (RFC 1123).
[[nodiscard]] bool isHostName(const std::string& text);

/// The IPv4 addresses at which other computers reach this one.
[[nodiscard]] std::vector<std::string> ownAddresses();

} // namespace carina
