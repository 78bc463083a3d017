#include "engine/session/respiration/respiration_timeline.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{

void RespirationTimeline::decide(SessionTime from)
{
    if (m_decisions.size() == kMostDecisions) {
        m_decisions.erase(m_decisions.begin());
        ++m_forgotten;
    }
    m_decisions.push_back(from);
    while (!m_checkpoints.empty() && m_checkpoints.back().at > from)
        m_checkpoints.pop_back();
    if (m_parts && m_parts->at > from)
        m_parts.reset();
}

void RespirationTimeline::setRate(SessionTime from, Frequency rate)
{
    CARINA_EXPECTS(std::isfinite(rate.si) && rate.si >= 0.0);
    m_rate.set(from, rate);
    decide(from);
}

void RespirationTimeline::setTidalVolume(SessionTime from, Volume tidalVolume)
{
    m_tidalVolume.set(from, tidalVolume);
    decide(from);
}

void RespirationTimeline::setInspiratoryFraction(SessionTime from, double fraction)
{
    CARINA_EXPECTS(fraction >= 0.1 && fraction <= 0.9);
    m_inspiratoryFraction.set(from, fraction);
    decide(from);
}

void RespirationTimeline::setBuild(SessionTime from, const PatientBuild& build)
{
    m_build.set(from, build);
    decide(from);
}

void RespirationTimeline::setConditions(SessionTime from, const LungConditions& conditions)
{
    m_conditions.set(from, conditions);
    decide(from);
}

void RespirationTimeline::setVentilator(SessionTime from, const VentilatorSettings& settings)
{
    m_ventilator.set(from, settings);
    decide(from);
}

void RespirationTimeline::setTube(SessionTime from, const SetTube& tube)
{
    m_tube.setOverride(from, tube);
    decide(from);
}

void RespirationTimeline::noteIntubation(SessionTime from, const IntubationEvent& event,
                                         Length innerDiameter)
{
    m_tube.note(from, event, innerDiameter);
    decide(from);
}

void RespirationTimeline::setCuff(SessionTime from, bool inflated)
{
    m_tube.setCuff(from, inflated);
    decide(from);
}

void RespirationTimeline::setGas(SessionTime from, const GasSupply& gas)
{
    m_gas.set(from, gas);
    decide(from);
}

void RespirationTimeline::give(SessionTime from, const DrugDose& dose)
{
    m_doses.insert(std::ranges::upper_bound(m_doses, from, {}, &GivenDose::from),
                   GivenDose{from, dose});
    decide(from);
}

void RespirationTimeline::setObstruction(SessionTime from, double share)
{
    m_tube.setObstruction(from, share);
    decide(from);
}

void RespirationTimeline::setPosition(SessionTime from, BodyPosition position)
{
    m_position.set(from, position);
    decide(from);
}

void RespirationTimeline::setOwnBreathing(SessionTime from, const OwnBreathing& breathing)
{
    const double before = m_ownBreathing.at(from);
    const double aim = breathing.stopped ? 0.0 : 1.0;
    m_decided.set(from, breathing);
    m_ownBreathing.forgetFrom(from);
    for (Duration passed = kStoppingStep; passed < breathing.over; passed += kStoppingStep) {
        const double share = toSeconds(passed) / toSeconds(breathing.over);
        m_ownBreathing.set(from + passed, before + share * (aim - before));
    }
    m_ownBreathing.set(from + breathing.over, aim);
    decide(from);
}

void RespirationTimeline::setBag(SessionTime from, const HandBag& bag)
{
    m_bag.set(from, bag);
    decide(from);
}

void RespirationTimeline::setRunning(SessionTime from, bool running)
{
    m_running.set(from, running);
    decide(from);
}

void RespirationTimeline::addBreath(const HeardBreath& breath)
{
    const Duration ago = breath.heard - breath.began;
    const bool inOrder = m_breaths.empty() || m_breaths.back().heard <= breath.heard;
    if (!inOrder || ago < Duration{0} || ago > kLongestNews)
        return;
    m_breaths.push_back(breath);
    decide(breath.heard);
}

void RespirationTimeline::addBreathing(SessionTime at, const RespiratoryState& state)
{
    m_parts = CheckpointParts{at, state, std::nullopt};
}

void RespirationTimeline::addCapnograph(SessionTime at, const CapnographState& state)
{
    if (m_parts && m_parts->at == at)
        m_parts->capnograph = state;
}

void RespirationTimeline::addBody(SessionTime at, const BodyState& state)
{
    if (!m_parts || m_parts->at != at || !m_parts->capnograph)
        return;
    RespirationState whole{at, m_parts->breathing, state};
    whole.body.capnograph = *m_parts->capnograph;
    addCheckpoint(whole);
    m_parts.reset();
}

void RespirationTimeline::addCheckpoint(const RespirationState& checkpoint)
{
    if (!m_checkpoints.empty() && m_checkpoints.back().at >= checkpoint.at)
        return;
    if (m_checkpoints.size() == kMostCheckpoints) {
        m_checkpoints.erase(m_checkpoints.begin());
        forgetBefore(m_checkpoints.front().at);
    }
    m_checkpoints.push_back(checkpoint);
}

/// Nobody goes on from before the first checkpoint, and a change is decided for the present or
/// later.
void RespirationTimeline::forgetBefore(SessionTime t)
{
    m_rate.forgetBefore(t);
    m_tidalVolume.forgetBefore(t);
    m_inspiratoryFraction.forgetBefore(t);
    m_build.forgetBefore(t);
    m_conditions.forgetBefore(t);
    m_ventilator.forgetBefore(t);
    m_tube.forgetBefore(t);
    m_gas.forgetBefore(t);
    m_position.forgetBefore(t);
    m_decided.forgetBefore(t);
    m_ownBreathing.forgetBefore(t);
    m_bag.forgetBefore(t);
    m_running.forgetBefore(t);
    const auto past = std::ranges::lower_bound(m_doses, t, {}, &GivenDose::from) - m_doses.begin();
    const auto beyond = std::ssize(m_doses) - std::ptrdiff_t(kMostDosesTold);
    m_doses.erase(m_doses.begin(), m_doses.begin() + std::clamp(beyond, std::ptrdiff_t{0}, past));
    // Who goes on from there still hears what was heard in the step before.
    m_breaths.erase(m_breaths.begin(),
                    std::ranges::lower_bound(m_breaths, t - kLongestNews, {}, &HeardBreath::heard));
}

RespiratorySettings RespirationTimeline::settingsAt(SessionTime t) const
{
    return {m_build.at(t),
            m_conditions.at(t),
            {}, // see ventilatedThrough
            BreathingPattern{m_rate.at(t), m_tidalVolume.at(t), m_inspiratoryFraction.at(t)},
            m_ventilator.at(t),
            m_position.at(t),
            m_ownBreathing.at(t),
            m_bag.at(t)};
}

std::span<const GivenDose> RespirationTimeline::dosesWithin(SessionTime from,
                                                            SessionTime before) const
{
    const auto first = std::ranges::lower_bound(m_doses, from, {}, &GivenDose::from);
    return {first, std::ranges::lower_bound(first, m_doses.end(), before, {}, &GivenDose::from)};
}

std::span<const HeardBreath> RespirationTimeline::breathsHeard(SessionTime after,
                                                               SessionTime until) const
{
    const auto first = std::ranges::upper_bound(m_breaths, after, {}, &HeardBreath::heard);
    return {first,
            std::ranges::upper_bound(first, m_breaths.end(), until, {}, &HeardBreath::heard)};
}

SessionTime RespirationTimeline::effectSince(std::size_t known) const
{
    if (known < m_forgotten || known > decisions())
        return SessionTime::min();
    const auto added = std::span{m_decisions}.subspan(known - m_forgotten);
    return added.empty() ? SessionTime::max() : *std::ranges::min_element(added);
}

SessionTime RespirationTimeline::changeAfter(SessionTime t) const
{
    const auto dose = std::ranges::upper_bound(m_doses, t, {}, &GivenDose::from);
    return std::min(
        {m_rate.changeAfter(t), m_tidalVolume.changeAfter(t), m_inspiratoryFraction.changeAfter(t),
         m_build.changeAfter(t), m_conditions.changeAfter(t), m_ventilator.changeAfter(t),
         m_tube.changeAfter(t), m_position.changeAfter(t), m_ownBreathing.changeAfter(t),
         m_bag.changeAfter(t), m_running.changeAfter(t), m_gas.changeAfter(t),
         dose == m_doses.end() ? SessionTime::max() : dose->from});
}

const RespirationState* RespirationTimeline::checkpointBefore(SessionTime t) const
{
    const auto after = std::upper_bound(
        m_checkpoints.begin(), m_checkpoints.end(), t,
        [](SessionTime time, const RespirationState& checkpoint) { return time < checkpoint.at; });
    return after == m_checkpoints.begin() ? nullptr : &*std::prev(after);
}

} // namespace carina
