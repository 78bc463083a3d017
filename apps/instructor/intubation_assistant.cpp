#include "apps/instructor/intubation_assistant.h"

#include "engine/session/body/body_rules.h"
#include "models/physiology/drug_words.h"

#include <utility>
#include <vector>

namespace carina
{
namespace
{

constexpr int kAssistantInterval_ms = 100;

/// Usual for the age, in normal lungs; of ours.
HandBag usualBag(const PatientBuild& build)
{
    constexpr double kGrown_years = 12.0;
    constexpr Frequency kOfGrown = perMinute(12.0);
    constexpr Frequency kOfChild = perMinute(20.0);
    constexpr double kTidal_mlPerKg = 7.0;
    return {build.ageInYears < kGrown_years ? kOfChild : kOfGrown,
            millilitres(kTidal_mlPerKg * lungWeight(build))};
}

} // namespace

IntubationAssistant::IntubationAssistant(SessionNode& node, StationId station,
                                         const program::PlayedIntubation& played)
    : m_node{node}, m_station{station}, m_played{played}
{
    m_looking.callOnTimeout([this] { look(); });
    m_looking.start(kAssistantInterval_ms);
}

const Station* IntubationAssistant::stationIn(const SessionState& state) const
{
    const auto found = state.stations().find(m_station);
    return found == state.stations().end() ? nullptr : &found->second;
}

void IntubationAssistant::look()
{
    const auto now = m_node.now();
    const auto state = m_node.state();
    const Station* at = stationIn(*state);
    if (!now || at == nullptr || state->atWork(m_station) == kNobody
        || state->phaseAt(*now) != SessionPhase::Running)
        return;
    const Duration running = state->runningTime(*now);
    if (!std::exchange(m_hasBegun, true)) {
        holdMask(true);
        m_due[Act::Induce] = running + kPreoxygenation;
    }
    hear(*at, running);
    for (auto due = m_due.begin(); due != m_due.end();) {
        if (due->second > running) {
            ++due;
            continue;
        }
        perform(due->first, *at, *now);
        due = m_due.erase(due);
    }
}

/// What the monitor noted since the last look.
void IntubationAssistant::hear(const Station& station, Duration running)
{
    const TubeTimeline& tube = station.respiration.tube();
    for (const NotedStep& note : tube.notesAfter(m_heard))
        hear(note.event.step, running);
    m_heard = tube.lastNote();
}

void IntubationAssistant::hear(IntubationStep step, Duration running)
{
    switch (step) {
    case IntubationStep::BladeIn:
        m_due.erase(Act::Induce);
        restBag();
        return holdMask(false);
    case IntubationStep::CuffInflated:
        m_due[Act::SqueezeBag] = running + kToBreath;
        return;
    case IntubationStep::CuffDeflated:
    case IntubationStep::TubeOut:
        m_due.erase(Act::SqueezeBag);
        return restBag();
    case IntubationStep::FirstBreath:
        if (m_played.kind == MotionKind::NeckFlexed)
            m_due[Act::FlexNeck] = running + kToFlexion;
        return;
    default:
        return;
    }
}

void IntubationAssistant::perform(Act act, const Station& station, SessionTime now)
{
    const PatientBuild build = station.respiration.settingsAt(now).build;
    switch (act) {
    case Act::Induce:
        induce(build);
        return squeezeBag(build);
    case Act::SqueezeBag:
        return squeezeBag(build);
    case Act::FlexNeck: {
        HeadPosition position = headPositionAt(station, now);
        position.flexion = degrees(parametersOf(m_played)[MotionParameter::Flexion_deg]);
        return m_node.propose(m_station, fact::HeadPositionSet{position, kFlexes});
    }
    }
}

void IntubationAssistant::holdMask(bool held)
{
    m_node.propose(m_station,
                   fact::GasSupplySet{{.inspiredOxygen = kPureOxygen, .maskHeld = held}});
}

void IntubationAssistant::squeezeBag(const PatientBuild& build)
{
    m_isBagSqueezed = true;
    m_node.propose(m_station, fact::BagSqueezed{usualBag(build)});
}

void IntubationAssistant::restBag()
{
    if (std::exchange(m_isBagSqueezed, false))
        m_node.propose(m_station, fact::BagSqueezed{});
}

void IntubationAssistant::induce(const PatientBuild& build)
{
    for (const DrugKind drug : {DrugKind::Fentanyl, DrugKind::Propofol, DrugKind::Rocuronium})
        m_node.propose(m_station,
                       fact::DrugGiven{{drug, usualDose_mgPerKg(drug) * build.weightInKilograms}});
}

} // namespace carina
