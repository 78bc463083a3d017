#pragma once

#include <bitset>
#include <cstdint>
#include <optional>

namespace carina
{

/// How much of what a peer numbered never arrived, over the last kWindow of its numbers. One that
/// arrives late counts as arrived, one that arrives twice counts once.
class LossMeter
{
public:
    static constexpr std::uint32_t kWindow = 256;

    void add(std::uint32_t sequence);
    /// From 0 to 1; 0 before the first number.
    [[nodiscard]] double share() const;

private:
    std::bitset<kWindow> m_arrived; // by number modulo kWindow
    std::optional<std::uint32_t> m_newest;
    std::uint32_t m_span = 0; // numbers in the window
};

} // namespace carina
