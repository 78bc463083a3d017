#include "apps/lab/intubation/intubation_trial.h"

#include "apps/lab/intubation/watched_airway.h"
#include "engine/airway/monitor/rest_watch.h"
#include "engine/tracking/pose_history.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace carina::lab
{
namespace
{

std::optional<IntubationStep> toldBy(MotionAct act)
{
    switch (act) {
    case MotionAct::CuffInflated:
        return IntubationStep::CuffInflated;
    case MotionAct::CuffDeflated:
        return IntubationStep::CuffDeflated;
    case MotionAct::StyletOut:
        return IntubationStep::StyletOut;
    case MotionAct::BreathsBegin:
        return IntubationStep::FirstBreath;
    case MotionAct::BreathsEnd:
        break;
    }
    return std::nullopt;
}

/// Whether a step is told by poses, and has a counterpart in the truth.
bool isPassage(IntubationStep step)
{
    switch (step) {
    case IntubationStep::BladeIn:
    case IntubationStep::BladeOut:
    case IntubationStep::TubePastTeeth:
    case IntubationStep::TubeOut:
    case IntubationStep::ThroughCords:
    case IntubationStep::BackAboveCords:
    case IntubationStep::InOesophagus:
    case IntubationStep::OutOfOesophagus:
    case IntubationStep::PastCarina:
    case IntubationStep::BackAboveCarina:
        return true;
    default:
        return false;
    }
}

/// Histories of three tools as a station has them, the monitor that reads them, and what of it is
/// measured.
class TrialChain
{
public:
    TrialChain(const IntubationSubject& subject, const IntubationMotion& motion,
               IntubationTrial& trial)
        : m_motion{motion}, m_trial{trial}, m_airway{subject, motion.blade()}
    {
    }

    void take(const PoseSample& tube, const PoseSample& laryngoscope, const PoseSample& jaw)
    {
        m_tube.push(tube);
        m_laryngoscope.push(laryngoscope);
        m_jaw.push(jaw);
        tellUntil(tube.time);
        const auto X_AE = m_tube.at(tube.time);
        const auto X_AL = m_laryngoscope.at(tube.time);
        const auto X_AJ = m_jaw.at(tube.time);
        if (!X_AE || !X_AL || !X_AJ)
            return;
        const HeadPosition head = m_motion.at(tube.time - kTrialStart).head;
        for (const IntubationEvent& event :
             m_monitor.take(m_airway.take({*X_AE, *X_AL, *X_AJ, head})))
            note(tube.time, event);
        if (const auto rest = m_rest.take(m_monitor))
            note(tube.time, *rest);
        measure(*X_AL, head);
    }
    void finish()
    {
        tellUntil(SessionTime::max());
        m_trial.course = m_monitor.course();
    }

private:
    /// What people say by their controls until then.
    void tellUntil(SessionTime t)
    {
        const std::vector<MotionCommand>& commands = m_motion.commands();
        for (; m_told < commands.size(); ++m_told) {
            const SessionTime at = kTrialStart + commands[m_told].at;
            if (at > t)
                return;
            if (const auto step = toldBy(commands[m_told].act))
                note(at, m_monitor.told(*step, at));
        }
    }
    void note(SessionTime now, const IntubationEvent& event)
    {
        m_rest.note(event);
        m_trial.noted.push_back({now, event});
        m_trial.measured.add(event);
    }
    void measure(const PoseSample& X_AL, const HeadPosition& head)
    {
        m_trial.measured.addBlade(X_AL);
        m_trial.measured.addHeadExtension(head.extension);
        if (X_AL.validity == Validity::Lost)
            return;
        const BladeEffort& effort = m_airway.effort();
        m_trial.measured.addForces(X_AL.time, effort.teeth, effort.contact.tongue);
    }

    const IntubationMotion& m_motion;
    IntubationTrial& m_trial;
    WatchedAirway m_airway;
    IntubationMonitor m_monitor;
    RestWatch m_rest;
    PoseHistory m_tube;
    PoseHistory m_laryngoscope;
    PoseHistory m_jaw;
    std::size_t m_told = 0;
};

Length registrationShareOf(const IntubationMotion& motion, const RigidTransform& X_AprimeA)
{
    const Vec3 p_A_tip = motion.tipAt(motion.length()).p_A;
    return metres((X_AprimeA * p_A_tip - p_A_tip).norm());
}

} // namespace

TubeSeat seatOf(TrueSeat truth)
{
    switch (truth) {
    case TrueSeat::Outside:
        break;
    case TrueSeat::Trachea:
        return TubeSeat::Trachea;
    case TrueSeat::RightMain:
        return TubeSeat::RightMain;
    case TrueSeat::LeftMain:
        return TubeSeat::LeftMain;
    case TrueSeat::Oesophagus:
        return TubeSeat::Oesophagus;
    }
    return TubeSeat::None;
}

IntubationStep stepOf(TrueStep truth)
{
    switch (truth) {
    case TrueStep::BladeIn:
        break;
    case TrueStep::BladeOut:
        return IntubationStep::BladeOut;
    case TrueStep::TubePastTeeth:
        return IntubationStep::TubePastTeeth;
    case TrueStep::TubeOut:
        return IntubationStep::TubeOut;
    case TrueStep::ThroughCords:
        return IntubationStep::ThroughCords;
    case TrueStep::BackAboveCords:
        return IntubationStep::BackAboveCords;
    case TrueStep::InOesophagus:
        return IntubationStep::InOesophagus;
    case TrueStep::OutOfOesophagus:
        return IntubationStep::OutOfOesophagus;
    case TrueStep::PastCarina:
        return IntubationStep::PastCarina;
    case TrueStep::BackAboveCarina:
        return IntubationStep::BackAboveCarina;
    case TrueStep::CuffInflated:
        return IntubationStep::CuffInflated;
    case TrueStep::CuffDeflated:
        return IntubationStep::CuffDeflated;
    case TrueStep::StyletOut:
        return IntubationStep::StyletOut;
    case TrueStep::FirstBreath:
        return IntubationStep::FirstBreath;
    }
    return IntubationStep::BladeIn;
}

bool IntubationTrial::isWrong() const { return course.seat != seatOf(truth.outcome); }

std::vector<IntubationEvent> IntubationTrial::byTime() const
{
    std::vector<IntubationEvent> events;
    for (const NotedStep& step : noted)
        events.push_back(step.event);
    std::ranges::stable_sort(events, {}, &IntubationEvent::at);
    return events;
}

Result<IntubationTrial> runTrial(const IntubationSubject& subject, MotionKind kind,
                                 std::uint32_t seed, const ObservationSettings& observation)
{
    std::mt19937 random = generatorOf(kind, seed);
    IntubationTrial trial;
    trial.kind = kind;
    trial.seed = seed;
    trial.parameters = drawnParameters(kind, random);
    const auto motion = scriptedMotion(kind, trial.parameters, subject.motion, subject.tube,
                                       static_cast<std::uint32_t>(random()));
    if (!motion)
        return tl::unexpected(motion.error());
    trial.truth = truthOf(*motion);
    trial.length = motion->length();
    const ObservedMotion seen = observed(*motion, observation, kTrialStart, random);
    trial.registrationShare = registrationShareOf(*motion, seen.X_AprimeA);
    trial.commands = motion->commands();
    TrialChain chain{subject, *motion, trial};
    // A tool that was lost from the first exposure on has fewer samples than the others.
    const std::size_t samples =
        std::min({seen.tube.size(), seen.laryngoscope.size(), seen.jaw.size()});
    const auto last = [samples](const std::vector<PoseSample>& all, std::size_t i) {
        return all[all.size() - samples + i];
    };
    for (std::size_t i = 0; i < samples; ++i)
        chain.take(last(seen.tube, i), last(seen.laryngoscope, i), last(seen.jaw, i));
    chain.finish();
    return trial;
}

StepErrors stepErrors(const IntubationTrial& trial)
{
    StepErrors result;
    std::vector<IntubationEvent> left;
    std::ranges::copy_if(trial.byTime(), std::back_inserter(left),
                         [](const IntubationEvent& event) { return isPassage(event.step); });
    for (const TrueEvent& happened : trial.truth.events) {
        if (!isPassage(stepOf(happened.step)))
            continue;
        const auto errorOf = [&](const IntubationEvent& noted) {
            return noted.at - (kTrialStart + happened.at);
        };
        const auto noted = std::ranges::find_if(left, [&](const IntubationEvent& event) {
            return event.step == stepOf(happened.step)
                   && std::chrono::abs(errorOf(event)) < kSameEvent;
        });
        if (noted == left.end()) {
            result.missed.push_back(happened.step);
            continue;
        }
        result.times.push_back(errorOf(*noted));
        left.erase(noted);
    }
    for (const IntubationEvent& event : left)
        result.invented.push_back(event.step);
    return result;
}

} // namespace carina::lab
