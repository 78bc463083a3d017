#include "apps/lab/attack/attackers/together.h"

#include "engine/core/monotonic_clock.h"

#include <algorithm>
#include <iterator>

namespace carina::lab
{
namespace
{

class Together : public Attack
{
public:
    explicit Together(const Target& target)
    {
        int number = 0;
        for (const AttackKind& single : attackKinds()) {
            if (!actsBesideOthers(single))
                continue;
            Target own = target;
            own.attacker += ' ' + std::to_string(number++);
            m_attacks.push_back(single.begin(own));
            m_keepsOut.push_back(single.keepsOut);
        }
    }

    void step() override
    {
        const bool allBegin = monotonicNow() >= m_allFrom;
        for (std::size_t i = 0; i < m_attacks.size(); ++i)
            if (allBegin || !m_keepsOut[i])
                m_attacks[i]->step();
    }
    [[nodiscard]] std::int64_t sent() const override
    {
        std::int64_t sum = 0;
        for (const auto& attack : m_attacks)
            sum += attack->sent();
        return sum;
    }
    [[nodiscard]] bool isTakenForAnother() const override
    {
        return std::ranges::any_of(m_attacks,
                                   [](const auto& attack) { return attack->isTakenForAnother(); });
    }
    [[nodiscard]] std::int64_t patientsLaid() const override
    {
        std::int64_t sum = 0;
        for (const auto& attack : m_attacks)
            sum += attack->patientsLaid();
        return sum;
    }
    [[nodiscard]] std::int64_t mostPaths() const override
    {
        std::int64_t sum = 0;
        for (const auto& attack : m_attacks)
            sum += attack->mostPaths();
        return sum;
    }
    [[nodiscard]] std::vector<Measured> measured(Duration length) const override
    {
        const auto acted = std::ranges::count_if(
            m_attacks, [](const auto& attack) { return attack->sent() >= kLeastOfEach; });
        std::vector<Measured> all{{"attackers that sent or opened at least ten",
                                   static_cast<double>(acted), double(kAttackersAtOnce),
                                   double(kAttackersAtOnce)}};
        for (const auto& attack : m_attacks)
            std::ranges::copy(attack->measured(length), std::back_inserter(all));
        return all;
    }

private:
    /// In which the others come in, who would have to wait behind the handshakes and names of
    /// these, or find the places of their address taken by them.
    static constexpr Duration kHeadStart = std::chrono::milliseconds{1500};
    static constexpr std::int64_t kLeastOfEach = 10;

    std::vector<std::unique_ptr<Attack>> m_attacks;
    std::vector<bool> m_keepsOut; // of each
    LocalTime m_allFrom = monotonicNow() + kHeadStart;
};

} // namespace

std::unique_ptr<Attack> beginTogether(const Target& target)
{
    return std::make_unique<Together>(target);
}

} // namespace carina::lab
