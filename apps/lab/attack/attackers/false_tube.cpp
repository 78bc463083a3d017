#include "apps/lab/attack/attackers/false_tube.h"

#include "apps/lab/attack/attackers/false_samples.h"
#include "apps/lab/attack/attackers/participating.h"
#include "engine/session/facts/fact_codec.h"

#include <array>
#include <utility>

namespace carina::lab
{
namespace
{

class FalseTube : public Participating
{
public:
    explicit FalseTube(const Target& target)
        : Participating{target, Role::Trainee},
          m_victim{target.victim},
          m_listener{wayIn(target, Role::Observer), target.attacker + " listening"}
    {
        m_listener.intruder().onRecord([this](const WireRecord& record) {
            if (const auto* group = std::get_if<StreamGroup>(&record))
                hear(*group);
        });
    }

    [[nodiscard]] std::vector<Measured> measured(Duration length) const override
    {
        return m_seen.measured(length);
    }

protected:
    void flood(Intruder& intruder) override
    {
        const bool isHeard = m_listener.attends();
        const LocalTime now = monotonicNow();
        if (!isHeard || !intruder.takesPart() || intruder.station() == kNoStation
            || now < m_nextSamples)
            return;
        findObjects(intruder);
        if (!m_own && now >= m_nextShare) {
            m_nextShare = now + kShareAgain;
            share(intruder);
        }
        const SessionTime time = intruder.sessionNow();
        std::size_t sent = stream(intruder, time);
        sent += stream(intruder, time + kAhead); // the newer, which would go out in its place
        streamAsVictim(intruder, time);
        m_nextSamples = now + static_cast<int>(sent) * kSampleInterval;
    }

private:
    /// More than is waited for a tick of the streams, and for an attacker's thread.
    static constexpr Duration kAhead = std::chrono::milliseconds{200};
    /// Keeps within the samples of a trainee, who stays for the whole attack.
    static constexpr Duration kSampleInterval = std::chrono::microseconds{1250};
    static constexpr Duration kShareAgain = std::chrono::milliseconds{500};
    static constexpr std::uint16_t kLater = 100; ///< than the victim's own samples

    void findObjects(const Intruder& intruder)
    {
        m_others.clear();
        for (const auto& [id, object] : intruder.state().objects()) {
            const bool isOwn = object.owner == intruder.welcome()->participant;
            if (isOwn && !m_own)
                m_own = id;
            if (!isOwn && m_others.size() + 1 < kStreamsPerGroup)
                m_others.push_back(id);
        }
    }

    /// Under one id, so that it is one fact.
    void share(Intruder& intruder)
    {
        intruder.send(std::array<WireRecord, 1>{
            toRecord(Proposal{m_shareId, kNobody, intruder.station(),
                              fact::ObjectShared{ObjectId{}, intruder.welcome()->participant,
                                                 ObjectKind::Tube, "Tube"}})});
    }

    /// As its own object, and as all others. @returns how many samples
    std::size_t stream(Intruder& intruder, SessionTime time)
    {
        const Welcome& me = *intruder.welcome();
        ++m_sequence;
        StreamGroup group{me.participant, me.epoch, intruder.station(), {}};
        if (m_own)
            group.streams.push_back(FalseSamples::sample(*m_own, m_sequence, time));
        for (const ObjectId object : m_others)
            group.streams.push_back(FalseSamples::sample(object, m_sequence, time));
        if (!group.streams.empty())
            intruder.send(std::array<WireRecord, 1>{group});
        return group.streams.size();
    }

    /// What the victim sent last, but for the place.
    void streamAsVictim(Intruder& intruder, SessionTime time)
    {
        if (!m_victims)
            return;
        for (StreamCpo& each : m_victims->streams)
            each = FalseSamples::sample(each.object,
                                        static_cast<std::uint16_t>(each.sequence + kLater), time);
        intruder.send(std::array<WireRecord, 1>{*std::exchange(m_victims, std::nullopt)});
    }

    void hear(const StreamGroup& group)
    {
        const Intruder& listener = m_listener.intruder();
        m_seen.see(group, m_own, listener.hostSent());
        const auto owner = listener.state().participants().find(group.owner);
        if (owner != listener.state().participants().end() && owner->second.name == m_victim)
            m_victims = group;
    }

    std::string m_victim;
    Attendee m_listener;
    FalseSamples m_seen;
    ProposalId m_shareId = anyId();
    std::optional<ObjectId> m_own;
    std::vector<ObjectId> m_others;
    std::optional<StreamGroup> m_victims; ///< the newest that the listener was sent
    std::uint16_t m_sequence = 0;
    LocalTime m_nextShare{};
    LocalTime m_nextSamples{};
};

} // namespace

std::unique_ptr<Attack> beginFalseTube(const Target& target)
{
    return std::make_unique<FalseTube>(target);
}

} // namespace carina::lab
