#pragma once

#include <QHostAddress>

#include <vector>

namespace carina
{

/// The addresses that questions of discovery go to: the loopback network's, and one for each IPv4
/// network that this computer is in.
[[nodiscard]] std::vector<QHostAddress> broadcastAddresses();

} // namespace carina
