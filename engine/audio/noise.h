#pragma once

#include <cstdint>

namespace carina
{

/// White noise, uniform from -1 to 1, the same on every machine: xorshift64* (Vigna, ACM Trans.
/// Math. Softw. 2016;42:30).
class Noise
{
public:
    /// @pre seed is not 0
    explicit Noise(std::uint64_t seed);

    [[nodiscard]] double next();

private:
    std::uint64_t m_state;
};

} // namespace carina
