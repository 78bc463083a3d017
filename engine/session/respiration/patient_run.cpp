#include "engine/session/respiration/patient_run.h"

#include "engine/physiology/capnograph.h"
#include "engine/session/body/ventilated_through.h"

#include <algorithm>
#include <cmath>

namespace carina
{

namespace
{

constexpr Duration kFoldStep = std::chrono::milliseconds{2};
static_assert(kRespiratoryStep == 2e-3);

/// Before every session.
constexpr SessionTime kBeforeAll = SessionTime{Duration{SessionTime::min().time_since_epoch() / 4}};

double inBodyShares(double share) { return kBodyShare * std::round(share / kBodyShare); }

} // namespace

PatientRun::Settings PatientRun::settingsAt(const RespirationTimeline& timeline, SessionTime t)
{
    const RespiratorySettings set = timeline.settingsAt(t);
    const TubePlace tube = timeline.tubePlaceAt(t);
    const GasSupply gas = timeline.gasAt(t);
    return {ventilatedThrough(set, tube, gas),
            {set.build, set.conditions, tube.seat == TubeSeat::None ? TubePlace{} : tube, gas,
             stomachBreaths(set, tube), timeline.tube().bladeInMouthAt(t)}};
}

PatientRun::PatientRun(const RespirationTimeline& timeline, const RespirationState* checkpoint)
    : m_at{checkpoint ? checkpoint->at : kBeforeAll},
      m_heardTo{m_at},
      m_settings{settingsAt(timeline, m_at)},
      m_body{checkpoint ? BodyFold{m_settings.body, checkpoint->body} : BodyFold{m_settings.body}},
      m_influence{influence()},
      m_fold{checkpoint ? RespiratoryFold{influenced(), checkpoint->state}
                        : RespiratoryFold{influenced()}}
{
    if (checkpoint)
        forgetBreaths();
}

PatientRun::Influence PatientRun::influence() const
{
    const bool isOpen = isThroughCords(m_settings.body.tube.seat);
    return {inBodyShares(m_body.breathingLeft()), isOpen ? 0.0 : inBodyShares(m_body.spasm()),
            coughs() ? inBodyShares(m_body.tone()) : 0.0};
}

bool PatientRun::coughs() const { return m_body.isAnaesthetised() && m_body.coughs(); }

RespiratorySettings PatientRun::influenced() const
{
    RespiratorySettings breathing = m_settings.breathing;
    breathing.ownBreathing *= m_influence.breathingLeft;
    obstruct(breathing.conditions, m_influence.spasm);
    breathing.cough = m_influence.cough;
    return breathing;
}

/// Doses until then are given.
void PatientRun::passTo(const RespirationTimeline& timeline, SessionTime t)
{
    const SessionTime from = m_at;
    m_at = t;
    give(timeline, from);
}

void PatientRun::give(const RespirationTimeline& timeline, SessionTime from)
{
    for (const GivenDose& dose : timeline.dosesWithin(from, m_at))
        m_body.give(dose.dose);
}

/// To the last whole step at or before t; the state stays as it is.
void PatientRun::skipTo(const RespirationTimeline& timeline, SessionTime t)
{
    passTo(timeline, m_at + (t - m_at) / kFoldStep * kFoldStep);
    forgetBreaths();
}

/// The last step began with all that had been heard by then.
void PatientRun::forgetBreaths() { m_heardTo = m_at - kFoldStep; }

void PatientRun::advanceTo(const RespirationTimeline& timeline, SessionTime t)
{
    while (m_at < t) {
        take(timeline);
        const SessionTime change = timeline.changeAfter(m_at);
        if (!timeline.runsAt(m_at)) {
            if (change > t)
                return;
            passTo(timeline, change);
            continue;
        }
        if (const SessionTime end = std::min(change, t); end - m_at > kLongestCatchUp)
            skipTo(timeline, end - kLongestCatchUp);
        while (m_at < change) {
            if (m_at + kFoldStep > t)
                return;
            step(timeline);
        }
    }
    take(timeline); // a checkpoint has all that was decided for then
}

void PatientRun::step(const RespirationTimeline& timeline)
{
    hear(timeline);
    m_fold.step();
    passTo(timeline, m_at + kFoldStep);
    if (m_fold.steps() % kRespiratoryStepsPerBodyStep == 0)
        m_body.step(m_fold);
    followBody();
}

/// A patient who has not breathed yet is met as the settings have it; later a change comes in.
void PatientRun::take(const RespirationTimeline& timeline)
{
    m_settings = settingsAt(timeline, m_at);
    if (!m_fold.hasBegun())
        return meetAnew(timeline);
    m_body.set(m_settings.body);
    m_influence = influence();
    m_fold.set(influenced());
}

void PatientRun::meetAnew(const RespirationTimeline& timeline)
{
    if (m_body.settings() != m_settings.body) {
        m_body = BodyFold{m_settings.body};
        give(timeline, kBeforeAll);
    }
    m_influence = influence();
    if (const RespiratorySettings met = influenced(); m_fold.settings() != met)
        m_fold = RespiratoryFold{met};
}

void PatientRun::followBody()
{
    if (const Influence now = influence(); now != m_influence) {
        m_influence = now;
        m_fold.set(influenced());
    }
}

void PatientRun::hear(const RespirationTimeline& timeline)
{
    for (const HeardBreath& breath : timeline.breathsHeard(m_heardTo, m_at))
        m_fold.trigger(toSeconds(m_at - breath.began));
    m_heardTo = m_at;
}

std::optional<SessionTime> PatientRun::deliveredBreath() const
{
    if (const Frequency blown = m_settings.body.stomachBreaths; blown.si > 0.0) {
        const double phase = m_body.state().capnograph.stomachPhase;
        return phase < kStomachInspiration ? std::nullopt
                                           : std::optional{m_at - fromSeconds(phase / blown.si)};
    }
    const BreathTally& breath = m_fold.breath();
    if (!m_fold.isVentilated() || breath.inspired <= m_fold.system().anatomicalDeadSpace)
        return std::nullopt;
    return m_at - breath.steps * kFoldStep;
}

ChestShape PatientRun::shape() const
{
    return chestShape(m_fold.settings().build, m_fold.system(), m_fold.content(), m_fold.moment());
}

std::array<FactBody, 3> PatientRun::checkpoint() const
{
    fact::BodyCheckpoint body{m_at, m_body.state()};
    fact::CapnographCheckpoint capnograph{m_at, body.state.capnograph};
    body.state.capnograph = {};
    return {fact::RespirationCheckpoint{m_at, m_fold.state()}, capnograph, body};
}

} // namespace carina
