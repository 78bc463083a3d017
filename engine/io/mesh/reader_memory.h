#pragma once

#include <chrono>
#include <cstdint>

namespace carina
{

/// The memory of all programs that read surfaces for this one: 4 GiB, or half of the computer's
/// memory where that is less. It is given away in equal shares, one to each such program; what
/// needs more gets all of it, alone. May be used by several threads.
class ReaderMemory
{
public:
    /// How many programs may read at once: one for each core, from 4 to 16.
    [[nodiscard]] static unsigned shares();
    /// Bytes of that many shares.
    [[nodiscard]] static std::uint64_t bytesOf(unsigned shares);

    /// Bytes of the longest answer of a program that has so many: it holds the surfaces of a file
    /// and its answer at once, and the answer is no shorter than the surfaces.
    [[nodiscard]] static std::uint64_t longestAnswer(unsigned shares)
    {
        return bytesOf(shares) / 2;
    }

    /// Waits until so many shares are free and takes them.
    /// @returns false where they did not become free within `patience`.
    [[nodiscard]] static bool take(unsigned shares, std::chrono::milliseconds patience);
    static void giveBack(unsigned shares);

    /// Whether somebody waits for all shares: who can do without one for a while gives it back.
    [[nodiscard]] static bool isWantedWhole();
};

} // namespace carina
