#include "models/station/standing_report.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr Duration kAgain = std::chrono::seconds{1};
constexpr RegistrationStanding kNoTracker{RegistrationState::NoTracker, StaleReason::None, {}};

bool isUnderWay(const SessionNode& node)
{
    return std::ranges::any_of(node.pending(), [](const FactBody& body) {
        return std::holds_alternative<fact::RegistrationStated>(body);
    });
}

} // namespace

void StandingReport::tell(const std::optional<RegistrationStanding>& standing)
{
    const auto state = m_node.state();
    const auto self = state->participants().find(m_node.self());
    const auto now = m_node.now();
    if (!now || self == state->participants().end())
        return;
    const auto& known = self->second.registration;
    const RegistrationStanding told = standing.value_or(kNoTracker);
    if (known == told || (!standing && !known))
        return;
    if ((m_told == told && *now < m_again) || isUnderWay(m_node))
        return;
    m_told = told;
    m_again = *now + kAgain;
    m_node.propose(kNoStation, fact::RegistrationStated{told});
}

} // namespace carina
