#include "apps/lab/attack/attackers/foreign_actions.h"

#include "apps/lab/attack/attackers/attendee.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/sync/strategies/relayed_message.h"

#include <array>
#include <limits>

namespace carina::lab
{
namespace
{

/// Above the numbers of those who have just begun to act.
constexpr std::uint32_t kLeastNumber = 1'000'000;
const Vec3 kElsewhere{0.1, 0.2, 0.3}; ///< in A, metres: nobody has an object just there

class ForeignActions : public Attack
{
public:
    enum class By : std::uint8_t { Actions, Messages };

    ForeignActions(const Target& target, By by)
        : m_by{by},
          m_actor{wayIn(target, Role::Trainee), target.attacker},
          m_listener{wayIn(target, Role::Observer), target.attacker + " listening"}
    {
        m_listener.intruder().onRecord([this](const WireRecord& record) { hear(record); });
    }

    void step() override
    {
        const bool isHeard = m_listener.attends();
        if (!m_actor.attends() || !isHeard || m_actor.intruder().station() == kNoStation)
            return;
        const LocalTime now = monotonicNow();
        if (now >= m_nextShare) {
            m_nextShare = now + std::chrono::seconds{1}; // until it is shared
            share();
        }
        if (now >= m_nextActions)
            m_nextActions = now + act() * kActionInterval;
    }
    [[nodiscard]] std::int64_t sent() const override { return m_actor.intruder().sent(); }
    [[nodiscard]] std::vector<Measured> measured(Duration) const override
    {
        return {
            {"actions on objects of others that reached an observer", double(m_foreign), 0.0, 0.0},
            {"actions on its own object that reached the observer", double(m_own), 1.0,
             std::numeric_limits<double>::infinity()}};
    }

private:
    /// Actions and heartbeats keep within the budget of a trainee, who stays for the whole attack.
    static constexpr Duration kActionInterval = std::chrono::milliseconds{6};

    [[nodiscard]] ParticipantId self() const { return m_actor.intruder().welcome()->participant; }

    void share()
    {
        for (const auto& [id, object] : m_actor.intruder().state().objects())
            if (object.owner == self())
                return;
        const Proposal own{ProposalId{m_actor.random()()}, kNobody, m_actor.intruder().station(),
                           fact::ObjectShared{ObjectId{}, self(), ObjectKind::Tube, "Own tube"}};
        m_actor.intruder().send(std::array<WireRecord, 1>{toRecord(own)});
    }

    /// @returns on how many objects it acted
    int act()
    {
        std::vector<WireRecord> records;
        int count = 0;
        for (const auto& [id, object] : m_actor.intruder().state().objects()) {
            ++count;
            EventCpo event;
            event.object = id;
            event.epoch = object.epoch;
            event.action = m_first + m_actions++;
            event.start = m_actor.intruder().sessionNow();
            event.p_AO = kElsewhere;
            if (m_by == By::Messages) {
                records.emplace_back(StrategyMessage{m_actor.intruder().state().strategy().kind,
                                                     encodeRelayed({self(), kAllOthers, event})});
                continue;
            }
            records.emplace_back(event);
            records.emplace_back(EventBeat{id, event.epoch, event.action});
        }
        m_actor.intruder().send(records);
        return count;
    }

    void hear(const WireRecord& record)
    {
        if (const auto* event = std::get_if<EventCpo>(&record))
            count(*event);
        if (const auto* message = std::get_if<StrategyMessage>(&record)) {
            const auto relayed = decodeRelayed(message->bytes);
            if (const auto* event = relayed ? std::get_if<EventCpo>(&relayed->content) : nullptr)
                count(*event);
        }
    }
    void count(const EventCpo& event)
    {
        const auto& objects = m_listener.intruder().state().objects();
        const auto object = objects.find(event.object);
        const bool isOfThis = event.action - m_first < m_actions; // modulo 2^32
        if (!isOfThis || object == objects.end() || !m_actor.intruder().welcome())
            return;
        ++(object->second.owner == self() ? m_own : m_foreign);
    }

    By m_by;
    Attendee m_actor;
    Attendee m_listener;
    LocalTime m_nextShare{};
    LocalTime m_nextActions{};
    /// By this the actions are known again, also beside those that an earlier attack has left.
    std::uint32_t m_first = kLeastNumber + static_cast<std::uint32_t>(m_actor.random()() >> 33U);
    std::uint32_t m_actions = 0;
    std::int64_t m_own = 0;
    std::int64_t m_foreign = 0;
};

} // namespace

std::unique_ptr<Attack> beginForeignActions(const Target& target)
{
    return std::make_unique<ForeignActions>(target, ForeignActions::By::Actions);
}

std::unique_ptr<Attack> beginForeignMessages(const Target& target)
{
    return std::make_unique<ForeignActions>(target, ForeignActions::By::Messages);
}

} // namespace carina::lab
