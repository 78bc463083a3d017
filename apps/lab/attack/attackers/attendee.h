#pragma once

#include "apps/lab/attack/attackers/intruder.h"

#include <memory>
#include <numeric>
#include <random>
#include <vector>

namespace carina::lab
{

/// Draws at random, differently for each name: two attackers who drew the same ids would be one to
/// the host, which takes what it has decided for a repeat, whoever sends it.
[[nodiscard]] std::mt19937_64 randomOf(const std::string& name);

/// What several who attack together sent.
template <class One> std::int64_t sentByAll(const std::vector<std::unique_ptr<One>>& all)
{
    return std::accumulate(all.begin(), all.end(), std::int64_t{0},
                           [](std::int64_t sum, const auto& one) { return sum + one->sent(); });
}

/// One who takes part under a name: comes in, and again where the host ended its path.
class Attendee
{
public:
    Attendee(const WayIn& way, std::string name);

    /// To be called in each turn in which it is to be there. @returns whether it takes part
    bool attends();
    /// Says Hello once more as the same run of a program that has nothing of the log.
    /// @pre it takes part
    void helloWithNothing();
    /// Says Goodbye, if it takes part.
    void leave();

    [[nodiscard]] Intruder& intruder() { return m_intruder; }
    [[nodiscard]] const Intruder& intruder() const { return m_intruder; }
    [[nodiscard]] std::mt19937_64& random() { return m_random; }

private:
    std::string m_name;
    std::mt19937_64 m_random;
    Intruder m_intruder;
    ProposalId m_join; // of this run, as a program's that asks until it is in
    bool m_isNewRun = true;
    std::uint32_t m_connection = 1;
    LocalTime m_nextHello{};
};

} // namespace carina::lab
