#pragma once

#include <bitset>
#include <cstdint>
#include <optional>

namespace carina
{

/// The share of datagrams that did not arrive, told by the gaps in their sequence numbers.
///
/// Of the last kWindow numbers up to the newest that arrived, those that are missing count as lost;
/// one that was only overtaken counts again once it is there, and a copy changes nothing.
class LossWindow
{
public:
    static constexpr std::uint32_t kWindow = 1024;
    /// Fewer numbers than this say nothing.
    static constexpr std::uint32_t kLeast = 100;

    void arrived(std::uint32_t sequence);

    /// From 0 to 1; nothing before kLeast numbers were sent.
    [[nodiscard]] std::optional<double> loss() const;

private:
    void goOnTo(std::uint32_t sequence);

    std::bitset<kWindow> m_arrived; // by sequence modulo kWindow
    std::uint32_t m_newest = 0;
    std::uint32_t m_sent = 0; // of the window, so far
};

} // namespace carina
