#include "apps/lab/attack/attackers/overloads.h"

#include "apps/lab/attack/attackers/participating.h"
#include "engine/session/facts/fact_codec.h"

#include <array>
#include <utility>

namespace carina::lab
{
namespace
{

class Showing : public Participating
{
public:
    explicit Showing(const Target& target)
        : Participating{target, Role::Trainee},
          m_listener{wayIn(target, Role::Observer), target.attacker + " listening"}
    {
        m_listener.intruder().onRecord([this](const WireRecord& record) {
            const auto* shown = std::get_if<ShownPose>(&record);
            m_passedOn += shown != nullptr && shown->object == m_own ? 1 : 0;
        });
    }

    [[nodiscard]] std::vector<Measured> measured(Duration length) const override
    {
        return {{"poses of its tube in a second that reached an observer",
                 double(m_passedOn) / toSeconds(length), 1.0, kMostPassedOn}};
    }

protected:
    void flood(Intruder& intruder) override
    {
        const LocalTime now = monotonicNow();
        if (!m_listener.attends() || intruder.station() == kNoStation || now < m_next)
            return;
        m_next = now + kInterval;
        m_own = ownOf(intruder);
        if (m_own) {
            intruder.send(std::array<WireRecord, 1>{ShownPose{*m_own, intruder.sessionNow(), {}}});
        } else if (now >= m_nextShare) {
            m_nextShare = now + kShareAgain;
            intruder.send(std::array<WireRecord, 1>{
                toRecord(Proposal{anyId(), kNobody, intruder.station(),
                                  fact::ObjectShared{ObjectId{}, intruder.welcome()->participant,
                                                     ObjectKind::Tube, "Shown tube"}})});
        }
    }

private:
    /// What the host passes on of an object is eight in a second, and a quarter.
    static constexpr double kMostPassedOn = 10.0;
    static constexpr Duration kInterval = std::chrono::milliseconds{1};
    static constexpr Duration kShareAgain = std::chrono::milliseconds{500};

    static std::optional<ObjectId> ownOf(const Intruder& intruder)
    {
        for (const auto& [id, object] : intruder.state().objects())
            if (object.owner == intruder.welcome()->participant)
                return id;
        return std::nullopt;
    }

    Attendee m_listener;
    std::optional<ObjectId> m_own;
    std::int64_t m_passedOn = 0;
    LocalTime m_next{};
    LocalTime m_nextShare{};
};

/// Asks for what another holds, and no more, in turn, as often as one participant may.
class Asking : public Participating
{
public:
    explicit Asking(const Target& target) : Participating{target, Role::Trainee} {}

protected:
    void flood(Intruder& intruder) override
    {
        const LocalTime now = monotonicNow();
        if (now < m_next || intruder.station() == kNoStation)
            return;
        m_next = now + std::chrono::milliseconds{55};
        const WireRecord proposal =
            toRecord(Proposal{anyId(), kNobody, intruder.station(),
                              fact::ObjectWanted{ObjectId{1}, std::exchange(m_wants, !m_wants)}});
        intruder.send(std::span{&proposal, 1});
    }

private:
    LocalTime m_next{};
    bool m_wants = true;
};

class Crowd : public Attack
{
public:
    explicit Crowd(const Target& target)
    {
        for (int i = 0; i < kNames; ++i) {
            Target own = target;
            own.attacker += " as " + std::to_string(i);
            m_all.push_back(std::make_unique<Asking>(own));
        }
    }

    void step() override
    {
        for (const auto& one : m_all)
            one->step();
    }
    [[nodiscard]] std::int64_t sent() const override { return sentByAll(m_all); }

private:
    static constexpr int kNames = 12;
    std::vector<std::unique_ptr<Asking>> m_all;
};

} // namespace

std::unique_ptr<Attack> beginShowing(const Target& target)
{
    return std::make_unique<Showing>(target);
}

std::unique_ptr<Attack> beginCrowd(const Target& target) { return std::make_unique<Crowd>(target); }

} // namespace carina::lab
