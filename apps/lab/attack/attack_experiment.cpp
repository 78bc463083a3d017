#include "apps/lab/attack/attack_experiment.h"

#include "apps/lab/attack/derived_once.h"
#include "apps/lab/attack/guests.h"
#include "apps/lab/attack/honest_people.h"
#include "apps/lab/attack/laid_patients.h"
#include "apps/lab/attack/shown_objects.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/core/monotonic_clock.h"
#include "engine/net/entry/psk_identity.h"

#include <QCoreApplication>
#include <QThread>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

namespace carina::lab
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kNewcomersAfter = 2s; ///< the beginning of an attack
constexpr Duration kNewcomerWaits = 10s;
// Addresses of this computer, which for a host are two places.
constexpr quint32 kHere = 0x7F000001;
constexpr quint32 kOtherAddress = 0x7F000002;
constexpr std::array kNewcomers{Role::Trainee, Role::Observer, Role::Instructor};
/// An attack that is to send more than it can ends without it.
constexpr Duration kLongest = 120s;
constexpr Duration kGuestsComeIn = 3min;
constexpr int kRepeats = 3;    ///< of an attack that left much
constexpr Duration kCalm = 3s; ///< after an attack, in which its traces go
/// In which each program has given back the free pages of its heap (apps/heap).
constexpr Duration kPagesGoBack = 10s;
constexpr Duration kSlice = 100ms;      ///< between two looks at how much was sent
constexpr Duration kMemoryLook = 500ms; ///< between two looks at memory
constexpr double kSettled_kb = 2048.0;  ///< by which memory varies in any case

/// What each program holds, kB; nothing where that could not be measured.
using HeldMemory = std::vector<std::optional<double>>;

std::optional<double> lesserOf(const std::optional<double>& a, const std::optional<double>& b)
{
    return a && b ? std::optional{std::min(*a, *b)} : std::nullopt;
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
            if (!choose(kind->strategy))
                return fail(Errc::HostSilent, "the strategy was not chosen");
            all.push_back(attack(*kind, std::string{"Intruder "} + kind->name));
            for (int time = 1; time <= kRepeats && !holdsMemory(all.back()); ++time)
                repeat(all.back(), time);
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
            return fail(Errc::HostSilent, "the trainee's tube was not seen: is the computer busy?");
        return deriveKeys()
            .and_then([this] { return layAnotherAndBack(); })
            .and_then([this] { return comeInGuests(); })
            .map([this] { m_honest.emplace(*m_node, honestOnes()); })
            .map([this] { seeWhatIsUsual(); });
    }

    /// Of all roles, before anything is measured. The instructor stays.
    Result<void> deriveKeys()
    {
        for (const Role role : kNewcomers) {
            auto first = join(role, "First " + std::string{roleWord(role)});
            if (!first)
                return tl::unexpected(first.error());
            if (!waitFor([&] { return (*first)->self() != kNobody; }))
                return fail(Errc::HostSilent, "a newcomer did not come in");
            if (role == Role::Instructor)
                m_instructor = *std::move(first);
        }
        return {};
    }

    /// So that all that a change of patients needs for the first time is in memory already.
    Result<void> layAnotherAndBack()
    {
        const LaidPatients first{*m_node};
        layInHaste();
        changeAirway({{AirwayEventKind::TongueOedema, 0.5}});
        if (!waitFor([&] { return !first.areLaid(*m_node); }))
            return fail(Errc::HostSilent, "no other patient was laid");
        workFor(kCalm, [] {});
        changeAirway({});
        first.layAgain(*m_instructor);
        if (!waitFor([&] { return first.areLaid(*m_node); }))
            return fail(Errc::HostSilent, "the patient was not laid again");
        workFor(kCalm, [] {});
        return {};
    }

    /// One patient before the last is made, as an attacker does; an adult in the end.
    void layInHaste()
    {
        constexpr int kTimes = 4;
        for (int i = 0; i < kTimes; ++i)
            for (const BuiltinPatient who : {BuiltinPatient::TwelveYears, BuiltinPatient::Adult}) {
                const PatientParameters patient = parametersOf(who);
                for (const auto state = m_node->state();
                     const auto& [station, laid] : state->stations())
                    m_instructor->propose(station,
                                          fact::AnatomyChosen{madeHash(patient), nameOf(patient)});
            }
    }

    /// The first time the programs make a shader for it, and keep it.
    void changeAirway(const AirwayEvents& events)
    {
        for (const auto state = m_node->state(); const auto& [station, laid] : state->stations())
            m_instructor->propose(station, fact::AirwayEventsSet{events, {}});
    }

    Result<void> comeInGuests()
    {
        if (m_settings.guests == 0)
            return {};
        m_guests.emplace(m_session->port(), m_session->codes(), m_settings.guests);
        const LocalTime end = monotonicNow() + kGuestsComeIn;
        while (!m_guests->areIn()) {
            if (m_guests->hasEnded() || monotonicNow() > end)
                return fail(Errc::HostSilent, "not all guests came in");
            workFor(kSlice, [] {});
        }
        // The trainee, the observer and the instructor, too.
        const auto all = std::size_t(m_settings.guests) + 3;
        if (!waitFor([&] { return honestOnes().size() == all; }))
            return fail(Errc::HostSilent, "not all guests were seen");
        return {};
    }

    void seeWhatIsUsual()
    {
        static_cast<void>(m_witness->take());
        workFor(ShownPlaces::kPeriod + ShownPlaces::kArrived, [] {});
        m_usual = m_witness->take().places;
    }

    [[nodiscard]] std::vector<ParticipantId> honestOnes() const
    {
        std::vector<ParticipantId> all{m_node->self(), m_instructor->self()};
        std::set<std::string> names{StartedSession::kTrainee};
        for (int i = 0; i < m_settings.guests; ++i)
            names.insert(Guests::nameOf(i));
        for (const auto state = m_node->state();
             const auto& [id, participant] : state->participants())
            if (names.contains(participant.name))
                all.push_back(id);
        return all;
    }

    [[nodiscard]] bool choose(StrategyKind strategy)
    {
        const auto isChosen = [&] { return m_node->state()->strategy().kind == strategy; };
        if (!isChosen())
            m_instructor->propose(kNoStation, fact::StrategyChosen{{.kind = strategy}});
        return waitFor(isChosen);
    }

    [[nodiscard]] std::int64_t facts() const
    {
        return static_cast<std::int64_t>(m_node->state()->lastApplied().value);
    }

    [[nodiscard]] HeldMemory memory_kb() const
    {
        HeldMemory memory;
        for (const auto& program : m_session->programs()) {
            const auto footprint = program->footprint();
            memory.push_back(footprint ? std::optional{footprint->memory_kb} : std::nullopt);
        }
        return memory;
    }

    /// The least that each program holds, while the event loop works for a time.
    [[nodiscard]] HeldMemory leastMemoryIn(Duration length) const
    {
        HeldMemory least = memory_kb();
        for (const LocalTime end = monotonicNow() + length; monotonicNow() < end;) {
            workFor(std::min<Duration>(kMemoryLook, end - monotonicNow()), [] {});
            std::ranges::transform(least, memory_kb(), least.begin(), lesserOf);
        }
        return least;
    }

    AttackFigures attack(const AttackKind& kind, const std::string& attacker)
    {
        AttackFigures figures{.kind = &kind, .guests = m_settings.guests, .usual = m_usual};
        const std::int64_t factsBefore = facts();
        static_cast<void>(m_witness->take());
        const HeldMemory memoryBefore = leastMemoryIn(m_settings.length);
        figures.before = m_witness->take();

        const ShownObjects shownBefore{*m_node};
        const LaidPatients patientsBefore{*m_node};
        static_cast<void>(m_honest->takeMissed());
        auto attack =
            kind.begin({m_session->port(), m_session->codes(), m_derive, StartedSession::kTrainee,
                        attacker, QHostAddress{kind.isElsewhere ? kOtherAddress : kHere}});
        const LocalTime began = monotonicNow();
        const auto step = [&] {
            attack->step();
            m_honest->look();
        };
        workFor(kNewcomersAfter, step);
        for (const Role role : kNewcomers)
            if (role != kind.spoils)
                figures.joined[role] = newcomer(role, step);
        workFor(began + m_settings.length - monotonicNow(), step);
        while (double(attack->sent()) < kind.leastSent && monotonicNow() < began + kLongest)
            workFor(kSlice, step);
        figures.length = monotonicNow() - began;
        figures.during = m_witness->take();
        figures.sent = attack->sent();
        figures.isTakenForAnother = attack->isTakenForAnother();
        figures.patientsLaid = attack->patientsLaid();
        figures.paths = attack->mostPaths();
        figures.measured = attack->measured(figures.length);
        figures.moved = shownBefore.moved(*m_node);
        figures.putOut = m_honest->takeMissed();
        attack.reset();
        patientsBefore.layAgain(*m_instructor);
        static_cast<void>(waitFor([&] { return patientsBefore.areLaid(*m_node); }));
        return afterwards(std::move(figures), factsBefore, memoryBefore);
    }

    /// Whether an attack that left much leaves as much each time. By somebody else: who has the
    /// same name draws the same ids, and the host takes their proposals for repeats.
    void repeat(AttackFigures& first, int time)
    {
        AttackFigures again =
            attack(*first.kind, "Intruder " + std::to_string(time) + " " + first.kind->name);
        if (holdsOwn(again))
            first.memoryAgain_kb = std::move(again.memory_kb);
    }

    /// @pre the attack has ended
    AttackFigures afterwards(AttackFigures figures, std::int64_t factsBefore,
                             const HeldMemory& memoryBefore)
    {
        workFor(kCalm, [] {});
        figures.facts = facts() - factsBefore;
        figures.memory_kb = memoryAbove_kb(memoryBefore);
        return figures;
    }

    /// The least that the programs hold more than before, until the free pages of their heaps have
    /// gone back to the system, which each does from time to time.
    HeldMemory memoryAbove_kb(const HeldMemory& before)
    {
        HeldMemory above(before.size(), std::numeric_limits<double>::infinity());
        const LocalTime until = monotonicNow() + kPagesGoBack;
        const auto isMuch = [](const std::optional<double>& each) { return each > kSettled_kb; };
        while (std::ranges::any_of(above, isMuch) && monotonicNow() < until) {
            const HeldMemory after = leastMemoryIn(kMemoryLook);
            for (std::size_t i = 0; i < above.size(); ++i)
                above[i] = after[i] && before[i] ? lesserOf(above[i], *after[i] - *before[i])
                                                 : std::nullopt;
        }
        return above;
    }

    /// @returns how long it took to come in
    std::optional<Duration> newcomer(Role role, const std::function<void()>& step)
    {
        const LocalTime began = monotonicNow();
        const auto node = join(role, "Newcomer " + std::to_string(++m_newcomers));
        while (node && monotonicNow() < began + kNewcomerWaits) {
            if ((*node)->self() != kNobody)
                return monotonicNow() - began;
            workFor(1ms, step);
        }
        return std::nullopt;
    }

    AttackSettings m_settings;
    DeriveKey m_derive = derivedOnce();
    std::unique_ptr<StartedSession> m_session;
    std::unique_ptr<SessionNode> m_node;
    std::unique_ptr<SessionNode> m_instructor;
    std::unique_ptr<Witness> m_witness;
    ShownPlaces m_usual;
    std::optional<Guests> m_guests;
    std::optional<HonestPeople> m_honest;
    int m_newcomers = 0;
};

} // namespace

Result<std::vector<AttackFigures>> attackSession(const AttackSettings& settings)
{
    return Besieged{settings}.run();
}

} // namespace carina::lab
