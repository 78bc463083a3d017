#include "apps/lab/attack/attackers/returning.h"

#include "apps/lab/attack/attackers/attendee.h"
#include "engine/session/facts/fact_codec.h"

#include <algorithm>
#include <array>
#include <deque>
#include <utility>

namespace carina::lab
{
namespace
{

/// A trainee asks for an object of another, or no more: in turn a fact each time.
WireRecord wish(Attendee& author, ProposalId id, bool wants)
{
    return toRecord(
        Proposal{id, kNobody, author.intruder().station(), fact::ObjectWanted{ObjectId{1}, wants}});
}

/// One of the many names.
class Guise
{
public:
    Guise(const WayIn& way, std::string name) : m_attendee{way, std::move(name)} {}

    /// Takes part, and repeats its proposals as a program does that waits for their facts.
    void appear(LocalTime now)
    {
        if (!m_attendee.attends() || m_attendee.intruder().station() == kNoStation)
            return;
        if (m_wishes.empty())
            for (int i = 0; i < kWishes; ++i)
                m_wishes.push_back(wish(m_attendee, ProposalId{m_attendee.random()()}, i % 2 == 0));
        if (now < m_next)
            return;
        m_next = now + kRepeat;
        m_attendee.intruder().send(m_wishes);
    }
    void vanish()
    {
        m_attendee.leave();
        m_wishes.clear();
    }
    [[nodiscard]] std::int64_t sent() const { return m_attendee.intruder().sent(); }

private:
    /// In a turn of all the names, as its own budget of 20 a second has.
    static constexpr int kWishes = 34;
    static constexpr Duration kRepeat = std::chrono::milliseconds{50};

    Attendee m_attendee;
    std::vector<WireRecord> m_wishes;
    LocalTime m_next{};
};

class Turns : public Attack
{
public:
    explicit Turns(const Target& target)
    {
        for (std::size_t i = 0; i < kNames; ++i)
            m_all.push_back(std::make_unique<Guise>(wayIn(target, Role::Trainee),
                                                    target.attacker + " as " + std::to_string(i)));
    }

    void step() override
    {
        const LocalTime now = monotonicNow();
        if (now >= m_turnEnds) {
            m_turnEnds = now + kTurn;
            for (std::size_t i = 0; i < kPresent; ++i)
                m_all[m_first + i]->vanish();
            m_first = (m_first + kPresent) % kNames;
        }
        for (std::size_t i = 0; i < kPresent; ++i)
            m_all[m_first + i]->appear(now);
    }
    [[nodiscard]] std::int64_t sent() const override { return sentByAll(m_all); }

private:
    static constexpr std::size_t kNames = 24;
    static constexpr std::size_t kPresent = 4; ///< at a time: a divisor of kNames
    static constexpr Duration kTurn = std::chrono::milliseconds{300};

    std::vector<std::unique_ptr<Guise>> m_all;
    std::size_t m_first = 0; ///< of those who are present
    LocalTime m_turnEnds{};
};

class Hungry : public Attack
{
public:
    explicit Hungry(const Target& target)
        : m_attendee{wayIn(target, Role::Trainee), target.attacker}
    {
    }

    void step() override
    {
        if (!m_attendee.attends() || m_attendee.intruder().station() == kNoStation)
            return;
        const LocalTime now = monotonicNow();
        if (now >= m_nextWish) {
            m_nextWish = now + kWish;
            m_attendee.intruder().send(std::array<WireRecord, 1>{wish(
                m_attendee, ProposalId{m_attendee.random()()}, std::exchange(m_wants, !m_wants))});
        }
        if (now >= m_nextHello) {
            m_nextHello = now + kHello;
            m_attendee.helloWithNothing();
        }
    }
    [[nodiscard]] std::int64_t sent() const override { return m_attendee.intruder().sent(); }
    [[nodiscard]] std::vector<Measured> measured(Duration length) const override
    {
        const Intruder& intruder = m_attendee.intruder();
        const double log = double(std::max<std::size_t>(1, intruder.facts().size()));
        return {{"times that it was sent as many facts as the log has",
                 double(intruder.factsHeard()) / log, 0.5,
                 1.0 + kSavedComings + kComingsPerS * toSeconds(length)}};
    }

private:
    // What a trainee may come in again, which is its budget.
    static constexpr double kComingsPerS = 2.0;
    static constexpr double kSavedComings = 4.0;
    static constexpr Duration kHello = std::chrono::milliseconds{150};
    static constexpr Duration kWish = std::chrono::milliseconds{55};

    Attendee m_attendee;
    bool m_wants = true;
    LocalTime m_nextWish{};
    LocalTime m_nextHello{};
};

class Names : public Attack
{
public:
    explicit Names(const Target& target)
        : m_way{wayIn(target, Role::Trainee)}, m_name{target.attacker}
    {
    }

    void step() override
    {
        const LocalTime now = monotonicNow();
        if (now >= m_next && m_names < kNewNames) {
            m_next = now + kInterval;
            makeRoom();
            m_present.push_back(
                std::make_unique<Attendee>(m_way, m_name + ' ' + std::to_string(m_names++)));
        }
        for (const auto& one : m_present)
            one->attends();
    }
    [[nodiscard]] std::int64_t sent() const override
    {
        std::int64_t sum = m_sentByGone;
        for (const auto& one : m_present)
            sum += one->intruder().sent();
        return sum;
    }
    [[nodiscard]] std::vector<Measured> measured(Duration length) const override
    {
        static_cast<void>(length);
        const auto in = std::ranges::count_if(m_present, wasIn);
        return {{"names under which it came in", double(m_goneWhoWereIn + in), kLeastNames,
                 double(kNewNames)}};
    }

private:
    /// More than the host lets in of an address, of those who are new.
    static constexpr Duration kInterval = std::chrono::milliseconds{20};
    static constexpr std::size_t kPresent = 64;
    /// What the host lets in at once, and some.
    static constexpr double kLeastNames = 100.0;

    static bool wasIn(const std::unique_ptr<Attendee>& one)
    {
        return one->intruder().welcome().has_value();
    }
    void makeRoom()
    {
        if (m_present.size() < kPresent)
            return;
        const std::unique_ptr<Attendee> oldest = std::move(m_present.front());
        m_present.pop_front();
        oldest->leave();
        m_sentByGone += oldest->intruder().sent();
        m_goneWhoWereIn += wasIn(oldest) ? 1 : 0;
    }

    WayIn m_way;
    std::string m_name;
    std::deque<std::unique_ptr<Attendee>> m_present;
    int m_names = 0;
    std::int64_t m_goneWhoWereIn = 0;
    std::int64_t m_sentByGone = 0;
    LocalTime m_next{};
};

} // namespace

std::unique_ptr<Attack> beginTurns(const Target& target) { return std::make_unique<Turns>(target); }

std::unique_ptr<Attack> beginHungry(const Target& target)
{
    return std::make_unique<Hungry>(target);
}

std::unique_ptr<Attack> beginNames(const Target& target) { return std::make_unique<Names>(target); }

} // namespace carina::lab
