#include "apps/lab/soak/soak_script.h"

#include "engine/anatomy/patient/patient_name.h"
#include "engine/session/respiration/introduced_patient.h"

#include <algorithm>
#include <array>

namespace carina::lab
{
namespace
{

bool isIn(const SessionState& state, Role role)
{
    return std::ranges::any_of(state.participants(), [role](const auto& entry) {
        return entry.second.role == role && entry.second.present;
    });
}

} // namespace

SoakScript::SoakScript(const SoakSettings& settings, std::uint16_t port, const JoinCodes& codes)
    : m_settings{settings}, m_port{port}, m_codes{codes}
{
}

Result<std::unique_ptr<SoakScript>> SoakScript::of(const SoakSettings& settings, std::uint16_t port,
                                                   const JoinCodes& codes)
{
    for (const Role role : {Role::Instructor, Role::Observer})
        if (!codes.contains(role))
            return fail(Errc::WrongCode, std::string{roleWord(role)});
    std::unique_ptr<SoakScript> script{new SoakScript{settings, port, codes}};
    auto node = SessionNode::join(script->entry(Role::Instructor, "Second instructor"));
    if (!node)
        return tl::unexpected(node.error());
    script->m_instructor = *std::move(node);
    return script;
}

JoinSettings SoakScript::entry(Role role, const char* name) const
{
    return {.port = m_port,
            .participantName = name,
            .role = role,
            .code = m_codes.at(role),
            .tokens = m_tokens.path().toStdString()};
}

bool SoakScript::isReady() const
{
    const auto now = m_instructor->now();
    const auto state = m_instructor->state();
    return now && m_instructor->self() != kNobody && isIn(*state, Role::Trainee)
           && state->phaseAt(*now) == SessionPhase::Running;
}

std::optional<Error> SoakScript::refusal() const { return m_instructor->refusal(); }

/// Whether the next of so many, evenly spread, is due.
bool SoakScript::isDue(int done, int times, Duration since) const
{
    return done < times && since >= m_settings.length * done / times;
}

void SoakScript::step(Duration since)
{
    if (isDue(m_patients, m_settings.patients, since))
        changePatient();
    if (isDue(m_events, m_settings.events, since))
        changeBreathing();
    if (isDue(m_visits, 2 * m_settings.joins, since))
        comeOrGo();
    if (m_guest && !m_isIn && m_guest->self() != kNobody) {
        m_isIn = true;
        ++m_joins;
    }
}

/// Adult and child in turn.
void SoakScript::changePatient()
{
    const PatientParameters parameters =
        parametersOf(m_patients % 2 == 0 ? BuiltinPatient::Adult : BuiltinPatient::TwelveYears);
    const StationId station = ownStation(*m_instructor);
    m_instructor->propose(station, fact::AnatomyChosen{madeHash(parameters), nameOf(parameters)});
    for (const FactBody& told : introducedPatient(buildOf(dimensionsFor(parameters).value())))
        m_instructor->propose(station, told);
    ++m_patients;
}

void SoakScript::changeBreathing()
{
    const double share = 0.1 * (m_events % 10);
    const std::array<FactBody, 6> events{
        fact::BreathingRateSet{perMinute(12.0 + 10.0 * share)},
        fact::TidalVolumeSet{millilitres(250.0 + 100.0 * share)},
        fact::LungConditionsSet{{{ConditionKind::Asthma, 0.1 + share, ConditionSide::Both}}},
        fact::LungConditionsSet{{}},
        fact::PhaseChanged{SessionPhase::Paused},
        fact::PhaseChanged{SessionPhase::Running}};
    m_instructor->propose(ownStation(*m_instructor),
                          events[static_cast<std::size_t>(m_events) % events.size()]);
    ++m_events;
}

void SoakScript::comeOrGo()
{
    ++m_visits;
    m_isIn = false;
    if (m_guest) {
        m_guest.reset();
        return;
    }
    if (auto node = SessionNode::join(entry(Role::Observer, "Guest")))
        m_guest = *std::move(node);
}

std::uint64_t SoakScript::facts() const { return m_instructor->state()->lastApplied().value; }

void SoakScript::report(SoakFigures& figures) const
{
    figures.patients = m_patients;
    figures.joins = m_joins;
    figures.events = m_events;
    figures.unanswered = static_cast<int>(m_instructor->pending().size());
}

} // namespace carina::lab
