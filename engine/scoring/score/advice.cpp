#include "engine/scoring/score/advice.h"

namespace carina
{
namespace
{

bool isAbove(const TryMetrics& of, Metric metric, double limit)
{
    return valueOf(of, metric).value_or(limit) > limit;
}

bool isBelow(const TryMetrics& of, Metric metric, double limit)
{
    return valueOf(of, metric).value_or(limit) < limit;
}

bool is(const TryMetrics& of, Metric metric) { return isAbove(of, metric, 0.5); }
bool isNot(const TryMetrics& of, Metric metric) { return isBelow(of, metric, 0.5); }

/// How much deeper the tube is than its rule says; 0 where it is not known.
double tooDeep_mm(const TryMetrics& of)
{
    if (!of.depth || !of.depthWanted)
        return 0.0;
    return inMillimetres(of.depth->atTeeth - *of.depthWanted);
}

bool wasAboveWarning(const std::optional<ForceFigures>& force)
{
    return force && force->aboveWarning > Duration{};
}

bool holds(Advice advice, const TryMetrics& of)
{
    const bool inTrachea = is(of, Metric::InTrachea);
    const bool inAirway = inTrachea || is(of, Metric::InBronchus);
    switch (advice) {
    case Advice::TakeTubeOut:
        return of.outcome == TryOutcome::OesophagusUnrecognised;
    case Advice::RecogniseSooner:
        return isAbove(of, Metric::OesophagealTime, toSeconds(kRecognisedAtOnce));
    case Advice::PullTubeBack:
        return is(of, Metric::InBronchus);
    case Advice::VentilateBetween:
        return isAbove(of, Metric::TimeBelow90, 0.0);
    case Advice::SeeGlottisFirst:
        return isNot(of, Metric::GlottisSeen);
    case Advice::ShapeTube:
        return is(of, Metric::GlottisSeen) && !inAirway;
    case Advice::ChangeSomething:
        return isAbove(of, Metric::Attempts, 1.0);
    case Advice::SpareTheTeeth:
        return wasAboveWarning(of.incisors);
    case Advice::AdvanceTube:
        return inTrachea && tooDeep_mm(of) < -kDepthTolerance_mm;
    case Advice::WithdrawTube:
        return inTrachea && tooDeep_mm(of) > kDepthTolerance_mm;
    case Advice::InflateCuff:
        return inAirway && isNot(of, Metric::CuffInflated);
    case Advice::SpareTheTongue:
        return wasAboveWarning(of.tongue);
    case Advice::ExtendHead:
        return isBelow(of, Metric::HeadExtension, kExtendedHead_deg);
    case Advice::HoldBladeUpright:
        return isAbove(of, Metric::PlaneTilt, kSteady_deg2);
    case Advice::BendLess:
        return isAbove(of, Metric::HeadTravel, kCalmHead_cm);
    case Advice::BeQuicker:
        return isAbove(of, Metric::TimeToBreath, kQuick_s);
    case Advice::TryHarderPatient:
    case Advice::TryOtherManikin:
        return inTrachea;
    case Advice::Repeat:
        return true;
    }
    return false;
}

} // namespace

std::vector<Advice> adviceFor(const TryMetrics& metrics)
{
    std::vector<Advice> given;
    for (int i = 0; i <= int(kLastAdvice) && given.size() < kAdviceGiven; ++i)
        if (const auto advice = static_cast<Advice>(i); holds(advice, metrics))
            given.push_back(advice);
    return given;
}

} // namespace carina
