#pragma once

#include "engine/net/node/session_node.h"

namespace carina
{

/// Tells the session how far the registration of this program's manikin can be relied on: once this
/// participant is in, after it came in again, and whenever that changes.
class StandingReport
{
public:
    /// @pre node outlives this.
    explicit StandingReport(SessionNode& node) : m_node{node} {}

    /// @param standing nothing without a tracker, which is told where another standing was
    ///
    /// To be called often: it proposes a fact only where the session does not have this standing,
    /// and the same one at most once a second.
    void tell(const std::optional<RegistrationStanding>& standing);

private:
    SessionNode& m_node;
    std::optional<RegistrationStanding> m_told;
    SessionTime m_again{}; ///< from when on the same may be proposed again
};

} // namespace carina
