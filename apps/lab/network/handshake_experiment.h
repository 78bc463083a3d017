#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"

#include <QtGlobal>

#include <vector>

namespace carina::lab
{

/// Clients that come into a session one after the other, over a path that loses datagrams.
struct HandshakeSettings {
    int joins = 60;
    Duration roundTrip = std::chrono::milliseconds{40};
    double loss = 0.1; ///< share of the datagrams lost, each way
    std::uint32_t seed = 1;
};

struct HandshakeFigures {
    std::vector<Duration>
        taken;              ///< from a client's first hello until its path is encrypted, sorted
    int tries = 0;          ///< handshakes begun, of all clients together
    Duration sendCost{};    ///< processor time for encrypting and sending one 481-byte datagram
    Duration passCost{};    ///< for all of its way: sent, received and decrypted
    qsizetype overhead = 0; ///< bytes that a datagram is longer by
};

/// @returns AddressInUse without a free port.
[[nodiscard]] Result<HandshakeFigures> measureHandshakes(const HandshakeSettings& settings);

} // namespace carina::lab
