#include "apps/lab/intubation/intubation_trial.h"

#include "apps/lab/intubation/recorded_intubation.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace carina::lab
{
namespace
{

/// Whether a step is told by poses, and has a counterpart in the truth.
bool isPassage(IntubationStep step)
{
    switch (step) {
    case IntubationStep::BladeIn:
    case IntubationStep::BladeOut:
    case IntubationStep::TubePastTeeth:
    case IntubationStep::TubeOut:
        return true;
    default:
        return isOfWay(step);
    }
}

Length movedBy(const RigidTransform& X_AprimeA, const Vec3& p_A)
{
    return metres((X_AprimeA * p_A - p_A).norm());
}

/// As a site tells it: what is drawn, and no less than usual.
PlacementError expectedBy(const ObservationSettings& observation)
{
    const PlacementError usual;
    const double ofAxis = 1.0 / std::sqrt(3.0);
    return {.translation = std::max(usual.translation, ofAxis * observation.registration),
            .rotation = std::max(usual.rotation, ofAxis * observation.registrationTurn)};
}

} // namespace

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

Result<IntubationTrial> runTrial(const IntubationSubject& subject, MotionKind kind,
                                 std::uint32_t seed, const ObservationSettings& observation)
{
    std::mt19937 random = generatorOf(kind, seed);
    const MotionParameters parameters = drawnParameters(kind, random);
    const auto motion = scriptedMotion(kind, parameters, subject.motion, subject.tube,
                                       static_cast<std::uint32_t>(random()), subject.bending);
    if (!motion)
        return tl::unexpected(motion.error());
    const ObservedMotion seen = observed(*motion, observation, SessionTime{}, random);
    const auto headAt = [&motion](Duration t) { return motion->headAt(t); };
    auto watched = watchRecording(subject, recordingOf(seen),
                                  {.blade = motion->blade(),
                                   .commands = motion->commands(),
                                   .headAt = headAt,
                                   .expected = expectedBy(observation),
                                   .begins = SessionTime{}});
    if (!watched)
        return tl::unexpected(watched.error());
    watched->length = motion->length();
    const Vec3 p_A_tip = motion->tipAt(motion->length()).p_A;
    IntubationTrial trial;
    static_cast<WatchedIntubation&>(trial) = *std::move(watched);
    trial.kind = kind;
    trial.seed = seed;
    trial.parameters = parameters;
    trial.truth = truthOf(*motion);
    trial.seen = seen;
    trial.registrationAtTip = movedBy(seen.X_AprimeA, p_A_tip);
    trial.registrationAtTeeth = movedBy(seen.X_AprimeA, subject.motion->airway.p_A_incisors);
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
