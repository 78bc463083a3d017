#include "apps/lab/attack/attackers/without_effect.h"

#include "apps/lab/attack/attackers/participating.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/sync/strategies/relayed_message.h"

#include <algorithm>
#include <array>

namespace carina::lab
{
namespace
{

/// One of the names.
class SteadySender
{
public:
    SteadySender(const WayIn& way, std::string name) : m_attendee{way, std::move(name)} {}

    void step(LocalTime now)
    {
        const bool isThere = m_attendee.attends() && m_attendee.intruder().station() != kNoStation;
        if (!isThere) {
            m_sentUntil = now;
            return;
        }
        // What a busy processor kept it from sending is not made up for: that would be too fast.
        m_sentUntil = std::max(m_sentUntil, now - kMostBehind);
        for (; m_sentUntil < now; m_sentUntil += kInterval)
            sendNext();
    }
    [[nodiscard]] std::int64_t sent() const { return m_attendee.intruder().sent(); }

private:
    static constexpr Duration kInterval =
        std::chrono::microseconds{560}; ///< 1786 datagrams a second
    static constexpr Duration kMostBehind = std::chrono::milliseconds{20};
    static constexpr ObjectId kForeign{1};

    void sendNext()
    {
        Intruder& intruder = m_attendee.intruder();
        if (++m_number % kKinds == 0)
            intruder.sendBytes(std::array<std::byte, 24>{});
        else
            intruder.send(std::array<WireRecord, 1>{recordOf(m_number % kKinds)});
    }

    [[nodiscard]] WireRecord recordOf(std::uint32_t kind)
    {
        const Intruder& intruder = m_attendee.intruder();
        const Welcome& me = *intruder.welcome();
        const SessionTime now = intruder.sessionNow();
        switch (kind) {
        case 1:
            return StreamGroup{me.participant, me.epoch, intruder.station(), {sampleAt(now)}};
        case 2:
            return ShownPose{kForeign, now, {}};
        case 3:
            return StrategyMessage{m_attendee.intruder().state().strategy().kind,
                                   encodeRelayed({me.participant, ParticipantId{0}, DelayProbe{}})};
        case 4:
            return EventAck{kForeign, 1, 1};
        case 5: // decided already, but for the first
            return toRecord(
                Proposal{m_wish, kNobody, intruder.station(), fact::ObjectWanted{kForeign}});
        case 6:
            return LagNeeded{};
        case 7:
            return m_number % 2 == 0 ? WireRecord{actionAt(now)} : EventBeat{kForeign, 1, 1};
        default:
            return FactAck{};
        }
    }

    [[nodiscard]] StreamCpo sampleAt(SessionTime now)
    {
        StreamCpo sample;
        sample.object = kForeign;
        sample.sequence = static_cast<std::uint16_t>(m_number);
        sample.time = now;
        return sample;
    }
    [[nodiscard]] EventCpo actionAt(SessionTime now) const
    {
        EventCpo action;
        action.object = kForeign;
        action.epoch = 1;
        action.action = m_number;
        action.start = now;
        return action;
    }

    static constexpr std::uint32_t kKinds = 9;

    Attendee m_attendee;
    ProposalId m_wish{m_attendee.random()()};
    LocalTime m_sentUntil{};
    std::uint32_t m_number = 0;
};

class Steady : public Attack
{
public:
    explicit Steady(const Target& target)
    {
        for (int i = 0; i < kNames; ++i)
            m_all.push_back(std::make_unique<SteadySender>(
                wayIn(target, Role::Trainee), target.attacker + " as " + std::to_string(i)));
    }

    void step() override
    {
        const LocalTime now = monotonicNow();
        for (const auto& one : m_all)
            one->step(now);
    }
    [[nodiscard]] std::int64_t sent() const override { return sentByAll(m_all); }

private:
    static constexpr int kNames = 8;
    std::vector<std::unique_ptr<SteadySender>> m_all;
};

class Garbage : public Participating
{
public:
    explicit Garbage(const Target& target) : Participating{target, Role::Observer} {}

protected:
    void flood(Intruder& intruder) override
    {
        for (int i = 0; i < kDatagrams; ++i) {
            std::array<std::byte, 800> bytes{};
            for (std::byte& byte : bytes)
                byte = std::byte(anyNumber());
            intruder.sendBytes(bytes);
        }
    }

private:
    static constexpr int kDatagrams = 10;
};

} // namespace

std::unique_ptr<Attack> beginSteady(const Target& target)
{
    return std::make_unique<Steady>(target);
}

std::unique_ptr<Attack> beginGarbage(const Target& target)
{
    return std::make_unique<Garbage>(target);
}

} // namespace carina::lab
