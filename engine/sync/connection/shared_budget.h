#pragma once

#include "engine/sync/connection/token_bucket.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace carina
{

/// What the host takes in a second from all participants who come from one place in one role.
struct SharedLimits {
    double datagrams = 0.0;
    double bytes = 0.0;
    double proposals = 0.0;
    double events = 0.0; ///< starts, changes and beats of actions, each of which goes to all others
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

    /// What one participant has used of its share. It fills only while the participant is present,
    /// so that those who come and go in turn have no more together than one who stays.
    class Share
    {
    public:
        /// @param fair of the budget that it is a share of from now on
        void comes(LocalTime fair) { m_offset = fair - std::exchange(m_gone, {}).value_or(fair); }
        void goes(LocalTime fair)
        {
            if (!m_gone)
                m_gone = fair - m_offset;
        }

    private:
        friend SharedBudget;

        [[nodiscard]] LocalTime present(LocalTime fair) const
        {
            return m_gone.value_or(fair - m_offset);
        }

        TokenBucket m_datagrams;
        TokenBucket m_bytes;
        TokenBucket m_proposals;
        TokenBucket m_events;
        Duration m_offset{};
        std::optional<LocalTime> m_gone = LocalTime{}; ///< its present() when it went
    };

    explicit SharedBudget(const SharedLimits& limits) : m_limits{limits} {}

    /// How many are present from now on.
    void setMembers(std::size_t members, LocalTime now);
    [[nodiscard]] std::size_t members() const { return m_members; }
    /// A clock that goes as fast as the share of one who is present fills, in seconds of the limit:
    /// with four members at a quarter of the speed of time.
    [[nodiscard]] LocalTime fair(LocalTime now);

    [[nodiscard]] bool takesDatagram(Share& share, std::size_t bytes, LocalTime now);
    [[nodiscard]] bool takesProposals(Share& share, double count, LocalTime now);
    [[nodiscard]] bool takesEvent(Share& share, LocalTime now);

private:
    /// Of the share, which holds `capacity`, or else of the pot.
    [[nodiscard]] bool takes(TokenBucket& share, double capacity, LocalTime present,
                             TokenBucket& pot, double amount, double perSecond,
                             LocalTime now) const;

    SharedLimits m_limits;
    TokenBucket m_datagrams;
    TokenBucket m_bytes;
    TokenBucket m_proposals;
    TokenBucket m_events;
    std::size_t m_members = 1;
    LocalTime m_fair{};
    std::optional<LocalTime> m_fairAt;
};

} // namespace carina
