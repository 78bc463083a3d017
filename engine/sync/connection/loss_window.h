#pragma once

#include <bitset>
#include <cstdint>
#include <optional>

namespace carina
{

/// Datagram loss, from gaps in the sequence numbers.
///
/// Of the last kWindow sequence numbers up to the newest received, those missing count as lost. A
/// datagram that arrives late no longer counts as lost; a duplicate changes nothing.
class LossWindow
{
public:
    static constexpr std::uint32_t kWindow = 1024;
    /// Sequence numbers that are needed for an estimate.
    static constexpr std::uint32_t kLeast = 100;

    void arrived(std::uint32_t sequence);

    /// Share lost, 0 to 1; nothing before kLeast sequence numbers.
    [[nodiscard]] std::optional<double> loss() const;

private:
    void goOnTo(std::uint32_t sequence);

    std::bitset<kWindow> m_arrived; // by sequence modulo kWindow
    std::uint32_t m_newest = 0;
    std::uint32_t m_sent = 0; // sequence numbers in the window so far
};

} // namespace carina
