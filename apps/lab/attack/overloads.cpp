#include "apps/lab/attack/overloads.h"

#include "apps/lab/attack/participating.h"
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
    explicit Showing(const Target& target) : Participating{target, Role::Trainee} {}

protected:
    void flood(Intruder& intruder) override
    {
        if (!m_shared && intruder.station() != kNoStation) {
            m_shared = true;
            const WireRecord proposal =
                toRecord(Proposal{ProposalId{m_random()}, kNobody, intruder.station(),
                                  fact::ObjectShared{ObjectId{}, intruder.welcome()->participant,
                                                     ObjectKind::Tube, "Shown tube"}});
            intruder.send(std::span{&proposal, 1});
        }
        std::vector<WireRecord> shown;
        for (std::uint16_t object = 1; object <= kObjects; ++object)
            shown.emplace_back(ShownPose{ObjectId{object}, intruder.sessionNow(), {}});
        intruder.send(shown);
    }

private:
    static constexpr std::uint16_t kObjects = 10; ///< one is its own
    bool m_shared = false;
};

/// Asks for what another holds, as often as one participant may.
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
        const WireRecord proposal = toRecord(Proposal{
            ProposalId{m_random()}, kNobody, intruder.station(), fact::ObjectWanted{ObjectId{1}}});
        intruder.send(std::span{&proposal, 1});
    }

private:
    LocalTime m_next{};
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
    [[nodiscard]] std::int64_t sent() const override
    {
        std::int64_t sum = 0;
        for (const auto& one : m_all)
            sum += one->sent();
        return sum;
    }

private:
    static constexpr int kNames = 12;
    std::vector<std::unique_ptr<Asking>> m_all;
};

class Strangers : public Attack
{
public:
    explicit Strangers(const Target& target) : m_way{wayIn(target, Role::Observer)} {}

    void step() override
    {
        for (std::unique_ptr<Intruder>& path : m_paths) {
            if (path && path->ended() > 0)
                m_before += std::exchange(path, nullptr)->sent();
            if (!path)
                path = std::make_unique<Intruder>(m_way);
            if (path->isIn())
                path->send(std::array<WireRecord, 1>{FactAck{}});
        }
    }
    [[nodiscard]] std::int64_t sent() const override
    {
        std::int64_t sum = m_before;
        for (const auto& path : m_paths)
            sum += path ? path->sent() : 0;
        return sum;
    }

private:
    static constexpr std::size_t kPaths = 16;
    WayIn m_way;
    std::array<std::unique_ptr<Intruder>, kPaths> m_paths;
    std::int64_t m_before = 0; ///< over paths that were ended
};

} // namespace

std::unique_ptr<Attack> beginShowing(const Target& target)
{
    return std::make_unique<Showing>(target);
}

std::unique_ptr<Attack> beginCrowd(const Target& target) { return std::make_unique<Crowd>(target); }

std::unique_ptr<Attack> beginStrangers(const Target& target)
{
    return std::make_unique<Strangers>(target);
}

} // namespace carina::lab
