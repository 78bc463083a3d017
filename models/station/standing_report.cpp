#include "models/station/standing_report.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr Duration kAgain = std::chrono::seconds{1};

bool isUnderWay(const SessionNode& node)
{
    return std::ranges::any_of(node.pending(), [](const FactBody& body) {
        return std::holds_alternative<fact::RegistrationStated>(body);
    });
}

} // namespace

void StandingReport::tell(const RegistrationStanding& standing)
{
    const auto state = m_node.state();
    const auto self = state->participants().find(m_node.self());
    const auto now = m_node.now();
    if (!now || self == state->participants().end() || self->second.muted
        || self->second.registration == standing)
        return;
    if ((m_told == standing && *now < m_again) || isUnderWay(m_node))
        return;
    m_told = standing;
    m_again = *now + kAgain;
    m_node.propose(kNoStation, fact::RegistrationStated{standing});
}

} // namespace carina
