#include "engine/sync/strategies/probe_trigger.h"
#include "engine/sync/strategies/relay_host.h"
#include "engine/sync/strategies/relayed_participant.h"
#include "engine/sync/strategies/strategies.h"

#include <algorithm>
#include <deque>
#include <map>

namespace carina
{
namespace
{

/// An answer that comes later than this after its probe says nothing about the path.
constexpr Duration kAnswerWithin = std::chrono::seconds{10};

/// The Adaptive Synchronization Algorithm as published (Hamza-Lup, Rolland, Hughes 2004): every
/// participant measures the round trip to every other, its neighbours, end to end over the host,
/// and advances an action that arrives by the one-way delay from its author, taken as half of the
/// newest round trip.
///
/// Deliberately without retransmission, reordering or a common clock.
class AsaParticipant final : public RelayedParticipant
{
public:
    AsaParticipant(const StarSeat& seat, const AsaParameters& asa, bool isAdaptive, LocalTime now)
        : RelayedParticipant{seat.self},
          m_rule{.isAdaptive = isAdaptive,
                 .start = asa.start,
                 .lowest = asa.lowest,
                 .highest = asa.highest,
                 .history = asa.delays,
                 .kept = asa.delays}
    {
        setOthers(seat.others, now);
    }

    void setOthers(std::span<const ParticipantId> others, LocalTime now) override
    {
        std::erase_if(m_neighbours, [&](const auto& neighbour) {
            return std::ranges::find(others, neighbour.first) == others.end();
        });
        // Spread over the first interval, so that probes do not come in volleys.
        for (const ParticipantId id : others) {
            const auto before =
                std::ranges::count_if(others, [&](ParticipantId other) { return other < id; });
            const auto place = static_cast<double>(before + (self() < id ? 2 : 1));
            const Duration wait =
                fromSeconds(place / static_cast<double>(others.size() + 1) / m_rule.start);
            m_neighbours.try_emplace(id, Neighbour{ProbeTrigger{m_rule}, now + wait});
        }
    }

    void advance(LocalTime now) override
    {
        for (auto& [id, neighbour] : m_neighbours) {
            if (now < neighbour.nextProbe)
                continue;
            sendRelayed(id, DelayProbe{now.time_since_epoch()});
            neighbour.asked(now);
            ++m_probes;
            neighbour.lastProbe = now;
            neighbour.nextProbe = now + neighbour.trigger.interval();
        }
    }

    [[nodiscard]] LocalTime nextWake() const override
    {
        LocalTime next = LocalTime::max();
        for (const auto& [id, neighbour] : m_neighbours)
            next = std::min(next, neighbour.nextProbe);
        return next;
    }

    [[nodiscard]] std::uint64_t probesSent() const override { return m_probes; }

    [[nodiscard]] const ProbeTrigger* triggerTo(ParticipantId other) const override
    {
        const auto found = m_neighbours.find(other);
        return found == m_neighbours.end() ? nullptr : &found->second.trigger;
    }

private:
    struct Neighbour {
        ProbeTrigger trigger;
        LocalTime nextProbe;
        LocalTime lastProbe = LocalTime::min();
        Duration oneWayDelay{};
        std::deque<LocalTime> unanswered{}; ///< probes of the last kAnswerWithin, oldest first

        void asked(LocalTime now)
        {
            while (!unanswered.empty() && unanswered.front() < now - kAnswerWithin)
                unanswered.pop_front();
            unanswered.push_back(now);
        }
        /// Whether an answer is one to a probe that waits for it, as it no longer does.
        [[nodiscard]] bool settles(LocalTime probe, LocalTime now)
        {
            const auto found = std::ranges::find(unanswered, probe);
            if (found == unanswered.end() || now - probe > kAnswerWithin)
                return false;
            unanswered.erase(found);
            return true;
        }
    };

    void actionReceived(const EventCpo& action, ParticipantId from, LocalTime now) override
    {
        const auto author = m_neighbours.find(from);
        if (author != m_neighbours.end())
            drawn().begin(action, now - author->second.oneWayDelay);
    }

    void probeReceived(const DelayProbe& probe, ParticipantId from, LocalTime) override
    {
        sendRelayed(from, DelayAnswer{probe.sentAt});
    }

    void answerReceived(const DelayAnswer& answer, ParticipantId from, LocalTime now) override
    {
        const auto found = m_neighbours.find(from);
        const LocalTime probe{answer.sentAt};
        if (found == m_neighbours.end() || !found->second.settles(probe, now))
            return;
        Neighbour& neighbour = found->second;
        neighbour.oneWayDelay = (now - probe) / 2;
        neighbour.trigger.addDelay(neighbour.oneWayDelay);
        neighbour.nextProbe =
            std::min(neighbour.nextProbe, neighbour.lastProbe + neighbour.trigger.interval());
    }

    ProbeTrigger::Rule m_rule;
    std::map<ParticipantId, Neighbour> m_neighbours;
    std::uint64_t m_probes = 0;
};

} // namespace

SyncStrategy asaFixedStrategy()
{
    return {StrategyKind::AsaFixed, "asa-fixed", "ASA as published, the delay probed once a second",
            RelayHost::make,
            [](const StarSeat& seat, const StrategyChoice& choice,
               LocalTime now) -> std::unique_ptr<StarParticipant> {
                return std::make_unique<AsaParticipant>(seat, choice.asa, false, now);
            }};
}

SyncStrategy asaAdaptiveStrategy()
{
    return {StrategyKind::AsaAdaptive, "asa-adaptive",
            "ASA as published, the delay probed more often while it varies", RelayHost::make,
            [](const StarSeat& seat, const StrategyChoice& choice,
               LocalTime now) -> std::unique_ptr<StarParticipant> {
                return std::make_unique<AsaParticipant>(seat, choice.asa, true, now);
            }};
}

} // namespace carina
