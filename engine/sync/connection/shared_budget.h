#pragma once

#include "engine/sync/connection/token_bucket.h"

#include <cstddef>

namespace carina
{

/// What the host takes in a second from all participants who come from one place in one role.
struct SharedLimits {
    double datagrams = 0.0;
    double bytes = 0.0;
    double proposals = 0.0;
};

/// The budget of all participants who come from one place in one role, so that one person under
/// many names has not as many budgets, while a class behind one address is not hurt: each has an
/// equal share to itself, and what it needs beyond comes from a pot of the same size that all
/// share.
class SharedBudget
{
public:
    /// Facts that each may have saved up: to come in and share what it holds.
    static constexpr double kSavedProposals = 8.0;

    /// What one participant has used of its share.
    struct Share {
        TokenBucket datagrams;
        TokenBucket bytes;
        TokenBucket proposals;
    };

    explicit SharedBudget(const SharedLimits& limits) : m_limits{limits} {}

    /// How many are present.
    void setMembers(std::size_t members) { m_members = members; }
    [[nodiscard]] std::size_t members() const { return m_members; }

    [[nodiscard]] bool takesDatagram(Share& share, std::size_t bytes, LocalTime now);
    [[nodiscard]] bool takesProposals(Share& share, double count, LocalTime now);

private:
    [[nodiscard]] bool takes(TokenBucket& share, TokenBucket& pot, double amount, double perSecond,
                             double saved, LocalTime now) const;

    SharedLimits m_limits;
    TokenBucket m_datagrams;
    TokenBucket m_bytes;
    TokenBucket m_proposals;
    std::size_t m_members = 1;
};

} // namespace carina
