#include "evaluation/intubation/motion_truth.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace carina
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kScan = 20ms;
constexpr Duration kTruthWithin = 100us;
constexpr Duration kNotAway = 250ms;

/// Above 0 on the far side of something.
using Signed = std::function<double(Duration)>;

struct SignChange {
    Duration at{};
    bool isIn = false; ///< to above 0
};

Duration changeBetween(const Signed& value, Duration least, Duration most)
{
    const bool wasIn = value(least) > 0.0;
    while (most - least > kTruthWithin) {
        const Duration middle = least + (most - least) / 2;
        ((value(middle) > 0.0) == wasIn ? least : most) = middle;
    }
    return most;
}

std::vector<SignChange> changesOf(const Signed& value, Duration length)
{
    std::vector<SignChange> changes;
    bool isIn = value(Duration{}) > 0.0;
    for (Duration t = kScan; t <= length; t += kScan) {
        if ((value(t) > 0.0) == isIn)
            continue;
        isIn = !isIn;
        const Duration at = changeBetween(value, t - kScan, t);
        if (!changes.empty() && at - changes.back().at < kNotAway)
            changes.pop_back();
        else
            changes.push_back({at, isIn});
    }
    return changes;
}

bool passesCarina(TipTarget target)
{
    return target != TipTarget::Oesophagus && target != TipTarget::Arytenoid;
}

double beyondGate(const IntubationMotion& motion, const TrueTip& tip)
{
    return tip.along - motion.patient().way(tip.target).gate;
}

double beyondCarina(const IntubationMotion& motion, const TrueTip& tip)
{
    return tip.along - motion.patient().way(tip.target).carina;
}

TrueSeat seatOf(const IntubationMotion& motion, Duration t)
{
    const TrueTip tip = motion.tipAt(t);
    if (tip.target == TipTarget::Arytenoid || beyondGate(motion, tip) <= 0.0)
        return TrueSeat::Outside;
    if (tip.target == TipTarget::Oesophagus)
        return TrueSeat::Oesophagus;
    if (beyondCarina(motion, tip) <= 0.0)
        return TrueSeat::Trachea;
    return tip.target == TipTarget::LeftMain ? TrueSeat::LeftMain : TrueSeat::RightMain;
}

/// Adds the passages of a signed distance as steps, with where the tip is right after each.
void addPassages(MotionTruth& truth, const IntubationMotion& motion, const Signed& value,
                 TrueStep in, TrueStep out)
{
    for (const SignChange& change : changesOf(value, motion.length()))
        truth.events.push_back(
            {change.isIn ? in : out, change.at, seatOf(motion, change.at + kTruthWithin)});
}

/// The distance beyond the gate of a way, on some targets; -1 on the others.
Signed beyondGateOf(const IntubationMotion& motion, bool isOesophagus)
{
    return [&motion, isOesophagus](Duration t) {
        const TrueTip tip = motion.tipAt(t);
        const bool isThere =
            isOesophagus ? tip.target == TipTarget::Oesophagus : passesCarina(tip.target);
        return isThere ? beyondGate(motion, tip) : -1.0;
    };
}

std::optional<TrueStep> stepOf(MotionAct act)
{
    switch (act) {
    case MotionAct::CuffInflated:
        return TrueStep::CuffInflated;
    case MotionAct::CuffDeflated:
        return TrueStep::CuffDeflated;
    case MotionAct::StyletOut:
        return TrueStep::StyletOut;
    case MotionAct::BreathsBegin:
        return TrueStep::FirstBreath;
    case MotionAct::BreathsEnd:
        break;
    }
    return std::nullopt;
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

MotionTruth truthOf(const IntubationMotion& motion)
{
    MotionTruth truth;
    addPassages(
        truth, motion, [&](Duration t) { return motion.bladePastTeeth(t).si; }, TrueStep::BladeIn,
        TrueStep::BladeOut);
    addPassages(
        truth, motion,
        [&](Duration t) {
            const TrueTip tip = motion.tipAt(t);
            return tip.along - motion.patient().way(tip.target).teeth;
        },
        TrueStep::TubePastTeeth, TrueStep::TubeOut);
    addPassages(truth, motion, beyondGateOf(motion, false), TrueStep::ThroughCords,
                TrueStep::BackAboveCords);
    addPassages(truth, motion, beyondGateOf(motion, true), TrueStep::InOesophagus,
                TrueStep::OutOfOesophagus);
    addPassages(
        truth, motion,
        [&](Duration t) {
            const TrueTip tip = motion.tipAt(t);
            return passesCarina(tip.target) ? beyondCarina(motion, tip) : -1.0;
        },
        TrueStep::PastCarina, TrueStep::BackAboveCarina);
    for (const MotionCommand& command : motion.commands())
        if (const auto step = stepOf(command.act))
            truth.events.push_back({*step, command.at, seatOf(motion, command.at)});
    std::ranges::stable_sort(truth.events, {}, &TrueEvent::at);
    truth.attempts =
        static_cast<int>(std::ranges::count(truth.events, TrueStep::BladeIn, &TrueEvent::step));
    truth.outcome = seatOf(motion, motion.length());
    truth.depthAtTeeth = motion.depthAtTeeth(motion.length());
    if (passesCarina(motion.tipAt(motion.length()).target))
        truth.tipAboveCarina = motion.tipAboveCarina(motion.length());
    return truth;
}

} // namespace carina
