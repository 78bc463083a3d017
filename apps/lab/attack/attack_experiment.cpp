#include "apps/lab/attack/attack_experiment.h"

#include "engine/core/monotonic_clock.h"

#include <QCoreApplication>
#include <QThread>

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>

namespace carina::lab
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kNewcomerAfter = 2s; ///< the beginning of an attack
constexpr Duration kNewcomerWaits = 10s;
constexpr int kOfFive = 5;     ///< guests, one is an observer
constexpr Duration kCalm = 3s; ///< after an attack, in which its traces go
/// In which each program has given back the free pages of its heap (program::HeapPages).
constexpr Duration kPagesGoBack = 22s;
constexpr Duration kMemoryLook = 500ms; ///< between two looks at memory
constexpr double kSettled_kb = 2048.0;  ///< by which memory varies in any case

/// Derives each key once, so that the time of a join is that of joining.
DeriveKey derivingOnce()
{
    struct Known {
        std::mutex mutex;
        std::map<std::string, AccessKey> keys;
    };
    return [known = std::make_shared<Known>()](const JoinCode& code,
                                               const SessionKey& session) -> Result<AccessKey> {
        const std::lock_guard lock{known->mutex};
        if (const auto key = known->keys.find(code.text()); key != known->keys.end())
            return key->second;
        return deriveByArgon2id(code, session).map([&](const AccessKey& key) {
            return known->keys.emplace(code.text(), key).first->second;
        });
    };
}

/// Works the event loop, and what else there is to do, for a time.
void workFor(Duration length, const std::function<void()>& step)
{
    const LocalTime end = monotonicNow() + length;
    while (monotonicNow() < end) {
        step();
        QCoreApplication::processEvents();
        QThread::usleep(200);
    }
}

class Besieged
{
public:
    explicit Besieged(const AttackSettings& settings) : m_settings{settings} {}

    Result<std::vector<AttackFigures>> run()
    {
        if (const auto in = comeIn(); !in)
            return tl::unexpected(in.error());
        std::vector<AttackFigures> all;
        for (const AttackKind* kind : m_settings.kinds) {
            m_settings.begins(*kind);
            all.push_back(attack(*kind));
            if (const auto fault = m_session->fault())
                return tl::unexpected(*fault);
        }
        return all;
    }

private:
    [[nodiscard]] Result<std::unique_ptr<SessionNode>> join(Role role, const std::string& name)
    {
        return SessionNode::join({.port = m_session->port(),
                                  .participantName = name,
                                  .role = role,
                                  .code = m_session->codes().at(role),
                                  .derive = m_derive});
    }

    Result<void> comeIn()
    {
        auto session = StartedSession::start(m_settings.programs);
        if (!session)
            return tl::unexpected(session.error());
        m_session = *std::move(session);
        auto node = join(Role::Observer, "Witness");
        if (!node)
            return tl::unexpected(node.error());
        m_node = *std::move(node);
        m_witness = std::make_unique<Witness>(*m_node, StartedSession::kTrainee);
        if (!waitFor([this] { return m_witness->sees(); }))
            return fail(Errc::HostSilent, "the trainee's tube was not seen");
        // Both codes' keys are derived before anything is measured.
        auto first = join(Role::Trainee, "First newcomer");
        if (!first)
            return tl::unexpected(first.error());
        if (!waitFor([&] { return (*first)->self() != kNobody; }))
            return fail(Errc::HostSilent, "a newcomer did not come in");
        return comeInGuests();
    }

    Result<void> comeInGuests()
    {
        for (int i = 0; i < m_settings.guests; ++i) {
            const Role role = i % kOfFive == 0 ? Role::Observer : Role::Trainee;
            auto guest = join(role, "Guest " + std::to_string(i));
            if (!guest)
                return tl::unexpected(guest.error());
            m_guests.push_back(*std::move(guest));
            if (!waitFor([&] { return m_guests.back()->self() != kNobody; }))
                return fail(Errc::HostSilent, "guest " + std::to_string(i) + " did not come in");
        }
        return {};
    }

    [[nodiscard]] std::int64_t facts() const
    {
        return static_cast<std::int64_t>(m_node->state()->lastApplied().value);
    }

    [[nodiscard]] std::vector<double> memory_kb() const
    {
        std::vector<double> memory;
        for (const auto& program : m_session->programs())
            memory.push_back(program->footprint().value_or(Footprint{}).memory_kb);
        return memory;
    }

    /// The least that each program holds, while the event loop works for a time.
    [[nodiscard]] std::vector<double> leastMemoryIn(Duration length) const
    {
        std::vector<double> least = memory_kb();
        for (const LocalTime end = monotonicNow() + length; monotonicNow() < end;) {
            workFor(std::min<Duration>(kMemoryLook, end - monotonicNow()), [] {});
            std::ranges::transform(least, memory_kb(), least.begin(), std::ranges::min);
        }
        return least;
    }

    AttackFigures attack(const AttackKind& kind)
    {
        AttackFigures figures{.kind = &kind};
        const std::int64_t factsBefore = facts();
        static_cast<void>(m_witness->take());
        const std::vector<double> memoryBefore = leastMemoryIn(m_settings.length);
        figures.before = m_witness->take();

        auto attack = kind.begin({m_session->port(), m_session->codes(), m_derive,
                                  StartedSession::kTrainee, std::string{"Intruder "} + kind.name});
        const LocalTime began = monotonicNow();
        workFor(kNewcomerAfter, [&] { attack->step(); });
        figures.joined = newcomer(*attack);
        workFor(began + m_settings.length - monotonicNow(), [&] { attack->step(); });
        figures.during = m_witness->take();
        figures.sent = attack->sent();
        figures.isTakenForAnother = attack->isTakenForAnother();
        attack.reset();

        workFor(kCalm, [] {});
        figures.facts = facts() - factsBefore;
        figures.memory_kb = memoryAbove_kb(memoryBefore);
        return figures;
    }

    /// The least that the programs hold more than before, until the free pages of their heaps have
    /// gone back to the system, which each does from time to time.
    std::vector<double> memoryAbove_kb(const std::vector<double>& before)
    {
        std::vector<double> above(before.size(), std::numeric_limits<double>::infinity());
        const LocalTime until = monotonicNow() + kPagesGoBack;
        while (std::ranges::max(above) > kSettled_kb && monotonicNow() < until) {
            const std::vector<double> after = leastMemoryIn(kMemoryLook);
            for (std::size_t i = 0; i < above.size(); ++i)
                above[i] = std::min(above[i], after[i] - before[i]);
        }
        return above;
    }

    /// @returns how long it took to come in
    std::optional<Duration> newcomer(Attack& attack)
    {
        const LocalTime began = monotonicNow();
        const auto node = join(Role::Trainee, "Newcomer " + std::to_string(++m_newcomers));
        while (node && monotonicNow() < began + kNewcomerWaits) {
            if ((*node)->self() != kNobody)
                return monotonicNow() - began;
            workFor(1ms, [&] { attack.step(); });
        }
        return std::nullopt;
    }

    AttackSettings m_settings;
    DeriveKey m_derive = derivingOnce();
    std::unique_ptr<StartedSession> m_session;
    std::unique_ptr<SessionNode> m_node;
    std::unique_ptr<Witness> m_witness;
    std::vector<std::unique_ptr<SessionNode>> m_guests;
    int m_newcomers = 0;
};

} // namespace

Result<std::vector<AttackFigures>> attackSession(const AttackSettings& settings)
{
    return Besieged{settings}.run();
}

} // namespace carina::lab
