#pragma once

#include <string>
#include <vector>

namespace carina
{

/// Whether it is an IPv4 or IPv6 address, which a session may be joined at.
[[nodiscard]] bool isAddress(const std::string& text);

/// The IPv4 addresses at which other computers reach this one.
[[nodiscard]] std::vector<std::string> ownAddresses();

} // namespace carina
