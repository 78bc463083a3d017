#include "apps/lab/attack/attackers/gallery.h"

#include "apps/lab/attack/attackers/attendee.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/sync/streams/stream_slots.h"
#include "engine/sync/streams/stream_tick.h"

#include <algorithm>
#include <array>
#include <set>

namespace carina::lab
{
namespace
{

constexpr const char* kExhibit = "Exhibit ";

/// One of the names.
class Exhibitor
{
public:
    Exhibitor(const WayIn& way, std::string name) : m_attendee{way, std::move(name)} {}

    void step(LocalTime now)
    {
        if (!m_attendee.attends() || m_attendee.intruder().station() == kNoStation)
            return;
        if (now >= m_nextShare) {
            m_nextShare = now + kShareAgain;
            share();
        }
        if (m_tick.isDue(now)) {
            m_tick.served(now);
            stream();
        }
    }
    [[nodiscard]] std::int64_t sent() const { return m_attendee.intruder().sent(); }

private:
    /// A proposal that was put off is made again, under the same id, so that it is one fact.
    static constexpr Duration kShareAgain = std::chrono::milliseconds{500};

    static std::vector<ProposalId> drawn(std::mt19937_64& random)
    {
        std::vector<ProposalId> ids;
        for (int i = 0; i < kGalleryObjects; ++i)
            ids.push_back(ProposalId{random()});
        return ids;
    }

    [[nodiscard]] std::vector<ObjectId> own() const
    {
        std::vector<ObjectId> objects;
        for (const auto& [id, object] : m_attendee.intruder().state().objects())
            if (object.owner == m_attendee.intruder().welcome()->participant)
                objects.push_back(id);
        return objects;
    }

    void share()
    {
        Intruder& intruder = m_attendee.intruder();
        if (own().size() >= m_proposals.size())
            return;
        std::vector<WireRecord> records;
        for (std::size_t i = 0; i < m_proposals.size(); ++i) {
            const fact::ObjectShared shared{ObjectId{}, intruder.welcome()->participant,
                                            i % 2 == 0 ? ObjectKind::Jaw : ObjectKind::Stylus,
                                            kExhibit + std::to_string(i)};
            records.emplace_back(
                toRecord(Proposal{m_proposals[i], kNobody, intruder.station(), shared}));
        }
        intruder.send(records);
    }

    void stream()
    {
        Intruder& intruder = m_attendee.intruder();
        const Welcome& me = *intruder.welcome();
        StreamGroup group{me.participant, me.epoch, intruder.station(), {}};
        ++m_sequence;
        for (const ObjectId object : own()) {
            StreamCpo sample;
            sample.object = object;
            sample.sequence = m_sequence;
            sample.time = intruder.sessionNow();
            group.streams.push_back(sample);
        }
        if (!group.streams.empty())
            intruder.send(std::array<WireRecord, 1>{group});
    }

    Attendee m_attendee;
    std::vector<ProposalId> m_proposals = drawn(m_attendee.random());
    StreamTick m_tick;
    LocalTime m_nextShare{};
    std::uint16_t m_sequence = 0;
};

class Gallery : public Attack
{
public:
    explicit Gallery(const Target& target)
        : m_visitor{wayIn(target, Role::Observer), target.attacker + " visiting"}
    {
        for (int i = 0; i < kGalleryNames; ++i)
            m_all.push_back(std::make_unique<Exhibitor>(
                wayIn(target, Role::Trainee), target.attacker + " as " + std::to_string(i)));
        m_visitor.intruder().onRecord([this](const WireRecord& record) { see(record); });
    }

    void step() override
    {
        m_visitor.attends();
        const LocalTime now = monotonicNow();
        for (const auto& one : m_all)
            one->step(now);
    }
    [[nodiscard]] std::int64_t sent() const override { return sentByAll(m_all); }
    [[nodiscard]] std::vector<Measured> measured(Duration) const override
    {
        return {{"objects, of the 128 that it has, of which an observer was sent samples in a "
                 "second",
                 double(std::max(m_most, m_seen.size())), kLeastSeen, kMostSeen}};
    }

private:
    /// Far more than one name may have.
    static constexpr double kLeastSeen = 32.0;
    /// Those of a station, and in a second those of one that comes in the place of another.
    static constexpr double kMostSeen =
        double(StreamSlots::kMostOfStation) + double(kGalleryObjects);
    static constexpr Duration kCountedFor = std::chrono::seconds{1};

    void see(const WireRecord& record)
    {
        const LocalTime now = monotonicNow();
        if (now >= m_nextCount) {
            m_nextCount = now + kCountedFor;
            m_most = std::max(m_most, m_seen.size());
            m_seen.clear();
        }
        const auto* group = std::get_if<StreamGroup>(&record);
        if (group == nullptr)
            return;
        const auto& objects = m_visitor.intruder().state().objects();
        for (const StreamCpo& sample : group->streams) {
            const auto object = objects.find(sample.object);
            if (object != objects.end() && object->second.name.starts_with(kExhibit))
                m_seen.insert(sample.object);
        }
    }

    Attendee m_visitor;
    std::vector<std::unique_ptr<Exhibitor>> m_all;
    std::set<ObjectId> m_seen; ///< since the last count
    std::size_t m_most = 0;
    LocalTime m_nextCount{};
};

} // namespace

std::unique_ptr<Attack> beginGallery(const Target& target)
{
    return std::make_unique<Gallery>(target);
}

} // namespace carina::lab
