#include "models/vitals/station_vitals.h"

#include "engine/anatomy/patient/patient_build.h"
#include "engine/physiology/capnograph.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace carina
{
namespace
{

constexpr VolumeFlow kMostBlown = StomachSound::kFullFlow;

/// How many times the flow of a patient is that of a grown person who breathes alike. Quiet flows
/// go with the oxygen that is used, and so with the weight to the power of 0.75 (Brody).
double ofGrownFlow(const PatientBuild& build)
{
    constexpr double kGrown_kg = 70.0;
    return std::pow(kGrown_kg / usualWeight(build), 0.75);
}

const Station* stationIn(const SessionState& state, StationId id)
{
    const auto found = state.stations().find(id);
    return found == state.stations().end() ? nullptr : &found->second;
}

/// How much a side wheezes, by the worst that narrows its airways. What obstructs both is in
/// trachea or larynx, and does not wheeze over the lungs.
double narrowness(const LungConditions& conditions, ConditionSide side)
{
    double worst = 0.0;
    for (const LungCondition& condition : conditions) {
        const bool isObstructed =
            condition.kind == ConditionKind::Obstruction && condition.side == side;
        const bool isNarrow =
            condition.kind == ConditionKind::Asthma || condition.kind == ConditionKind::Copd;
        const bool isHere = condition.side == ConditionSide::Both || condition.side == side;
        if (isObstructed || (isNarrow && isHere))
            worst = std::max(worst, condition.severity);
    }
    return worst;
}

/// Half a sine while a breath is blown into the oesophagus (of ours).
VolumeFlow intoStomach(const BodyFold& body)
{
    const double phase = body.state().capnograph.stomachPhase;
    if (body.settings().stomachBreaths.si <= 0.0 || phase >= kStomachInspiration)
        return {};
    return std::sin(std::numbers::pi * phase / kStomachInspiration) * kMostBlown;
}

} // namespace

StationVitals::StationVitals(SessionModel& session, StationId station, KeptSounds kept,
                             QObject* parent)
    : QObject{parent},
      m_session{session},
      m_station{station},
      m_age_years{decidedAge_years()},
      m_model{sources(), m_age_years, std::move(kept)}
{
    connect(&m_session, &SessionModel::changed, this, &StationVitals::followAge);
}

VitalsSources StationVitals::sources()
{
    return {.now = [this] { return m_session.node().now(); },
            .vitals =
                [this](SessionTime t) {
                    const PatientRun* run = runAt(t);
                    return run ? std::optional{run->vitals()} : std::nullopt;
                },
            .breath = [this](SessionTime t) { return flowsAt(t); },
            .stethoscope = [this](SessionTime) { return m_hears ? m_hears() : std::nullopt; }};
}

void StationVitals::setStation(StationId station)
{
    if (std::exchange(m_station, station) == station)
        return;
    m_patient = {};
    m_age_years = decidedAge_years();
    m_model.startAfresh(m_age_years);
}

/// The limits of the alarms go by it: another patient may have been laid.
void StationVitals::followAge()
{
    const double age_years = decidedAge_years();
    if (std::exchange(m_age_years, age_years) != age_years)
        m_model.startAfresh(age_years);
}

/// As it was decided last: no signal comes when that takes effect.
double StationVitals::decidedAge_years() const
{
    const auto state = m_session.node().state();
    const Station* station = stationIn(*state, m_station);
    return station ? station->respiration.settingsAt(SessionTime::max()).build.ageInYears
                   : PatientBuild{}.ageInYears;
}

/// Valid until the next call; null where no patient breathes.
const PatientRun* StationVitals::runAt(SessionTime t)
{
    const auto state = m_session.node().state();
    const Station* station = stationIn(*state, m_station);
    if (!station || !station->respiration.runsAt(t))
        return nullptr;
    return &m_patient.at(station->respiration, t);
}

std::optional<BreathFlows> StationVitals::flowsAt(SessionTime t)
{
    const PatientRun* run = runAt(t);
    if (!run)
        return std::nullopt;
    const auto state = m_session.node().state();
    // As they are set: those of the fold have a kinked tube or shut cords among them.
    const LungConditions conditions =
        stationIn(*state, m_station)->respiration.settingsAt(t).conditions;
    const auto& intoLung = run->fold().moment().intoLung;
    const double heard = ofGrownFlow(run->fold().settings().build);
    return BreathFlows{.right = heard * intoLung[0],
                       .left = heard * intoLung[1],
                       .stomach = intoStomach(run->body()),
                       .rightObstruction = narrowness(conditions, ConditionSide::Right),
                       .leftObstruction = narrowness(conditions, ConditionSide::Left)};
}

} // namespace carina
