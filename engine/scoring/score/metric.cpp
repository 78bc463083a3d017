#include "engine/scoring/score/metric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace carina
{
namespace
{

constexpr std::array<MetricEntry, kMetricCount> kMetrics{{
    {Metric::TimeToView, "time_to_view_s", MetricUnit::Seconds},
    {Metric::TimeToCords, "time_to_cords_s", MetricUnit::Seconds},
    {Metric::TimeToBreath, "time_to_breath_s", MetricUnit::Seconds},
    {Metric::BladeTime, "blade_time_s", MetricUnit::Seconds},
    {Metric::Attempts, "attempts", MetricUnit::Count},
    {Metric::GlottisSeen, "glottis_seen", MetricUnit::YesOrNo},
    {Metric::GlotticOpening, "glottic_opening_percent", MetricUnit::PerCent},
    {Metric::InTrachea, "in_trachea", MetricUnit::YesOrNo},
    {Metric::InBronchus, "in_bronchus", MetricUnit::YesOrNo},
    {Metric::InOesophagus, "in_oesophagus", MetricUnit::YesOrNo},
    {Metric::OesophagealTime, "oesophageal_time_s", MetricUnit::Seconds},
    {Metric::Failed, "failed", MetricUnit::YesOrNo},
    {Metric::DepthError, "depth_error_mm", MetricUnit::Millimetres},
    {Metric::AboveCarina, "above_carina_mm", MetricUnit::Millimetres},
    {Metric::CuffInflated, "cuff_inflated", MetricUnit::YesOrNo},
    {Metric::PassedShut, "passed_shut", MetricUnit::YesOrNo},
    {Metric::HeadExtension, "head_extension_deg", MetricUnit::Degrees},
    {Metric::LowestSaturation, "lowest_saturation_percent", MetricUnit::PerCent},
    {Metric::TimeBelow90, "time_below_90_percent_s", MetricUnit::Seconds},
    {Metric::IncisorPeak, "incisor_peak_n", MetricUnit::Newtons},
    {Metric::IncisorMean, "incisor_mean_n", MetricUnit::Newtons},
    {Metric::IncisorWarning, "incisor_warning_s", MetricUnit::Seconds},
    {Metric::TonguePeak, "tongue_peak_n", MetricUnit::Newtons},
    {Metric::TongueMean, "tongue_mean_n", MetricUnit::Newtons},
    {Metric::TongueWarning, "tongue_warning_s", MetricUnit::Seconds},
    {Metric::TongueImpulse, "tongue_impulse_ns", MetricUnit::NewtonSeconds},
    {Metric::PlaneTilt, "plane_tilt_deg2", MetricUnit::SquareDegrees},
    {Metric::HandPath, "hand_path_cm", MetricUnit::Centimetres},
    {Metric::HandAcceleration, "hand_acceleration_m_s2", MetricUnit::MetresPerSecond2},
    {Metric::HandJerk, "hand_jerk_m_s3", MetricUnit::MetresPerSecond3},
    {Metric::HandSmoothness, "hand_smoothness", MetricUnit::None},
    {Metric::HeadTravel, "head_travel_cm", MetricUnit::Centimetres},
    {Metric::HeadAcceleration, "head_acceleration_m_s2", MetricUnit::MetresPerSecond2},
    {Metric::HeadJerk, "head_jerk_m_s3", MetricUnit::MetresPerSecond3},
    {Metric::Prepared, "prepared", MetricUnit::YesOrNo},
    {Metric::MaskVentilated, "mask_ventilated", MetricUnit::YesOrNo},
    {Metric::BladeFromRight, "blade_from_right", MetricUnit::YesOrNo},
    {Metric::PressureAsked, "pressure_asked", MetricUnit::YesOrNo},
    {Metric::Auscultated, "auscultated", MetricUnit::YesOrNo},
}};
static_assert(
    [] {
        for (std::size_t i = 0; i < kMetricCount; ++i)
            if (kMetrics[i].metric != static_cast<Metric>(i))
                return false;
        return true;
    }(),
    "each metric has its row, in the order of the enumeration");

using Value = std::optional<double>;

Value yes(bool is) { return is ? 1.0 : 0.0; }

Value inSeconds(Duration time) { return toSeconds(time); }

double perCent(double share) { return 100.0 * share; }

double inCentimetres(Length length) { return 0.1 * inMillimetres(length); }

double squareDegrees(double squareRadians)
{
    return squareRadians * inDegrees(radians(1.0)) * inDegrees(radians(1.0));
}

Value sinceBegin(const TryMetrics& of, const std::optional<SessionTime>& moment)
{
    return moment ? inSeconds(of.sinceBegun(*moment)) : std::nullopt;
}

Duration lengthOf(const TryMetrics& of, const OesophagealStay& stay)
{
    return of.pauses.between(stay.in, stay.out.value_or(of.ended));
}

/// The longest one; the end of the list where there is none.
auto longestStay(const TryMetrics& of)
{
    return std::ranges::max_element(
        of.oesophagus, {}, [&of](const OesophagealStay& stay) { return lengthOf(of, stay); });
}

bool isLate(const TryMetrics& of)
{
    return !of.throughCords || of.sinceBegun(*of.throughCords) > kFailedAfter;
}

bool hadReadView(const TryMetrics& of) { return of.hadBlade && (of.isViewRead || of.view); }

bool hasTubeInAirway(const TryMetrics& of) { return of.outcome <= TryOutcome::LeftMain; }

bool isBeyondCarina(const TryMetrics& of)
{
    return of.outcome == TryOutcome::RightMain || of.outcome == TryOutcome::LeftMain;
}

Value courseValue(const TryMetrics& of, Metric metric)
{
    switch (metric) {
    case Metric::TimeToView:
        return sinceBegin(of, of.view);
    case Metric::TimeToCords:
        return sinceBegin(of, of.throughCords);
    case Metric::TimeToBreath:
        return sinceBegin(of, of.firstBreath);
    case Metric::BladeTime:
        return of.hadBlade ? inSeconds(of.bladeTime) : std::nullopt;
    case Metric::Attempts:
        return double(of.attempts.size());
    case Metric::GlottisSeen:
        return hadReadView(of) ? yes(of.view.has_value()) : std::nullopt;
    case Metric::GlotticOpening:
        return of.glotticOpening ? Value{perCent(*of.glotticOpening)} : std::nullopt;
    case Metric::InTrachea:
        return yes(of.outcome == TryOutcome::Trachea);
    case Metric::InBronchus:
        return yes(isBeyondCarina(of));
    case Metric::InOesophagus:
        return yes(!of.oesophagus.empty());
    case Metric::OesophagealTime:
        return inSeconds(of.oesophagus.empty() ? Duration{} : lengthOf(of, *longestStay(of)));
    case Metric::Failed:
        return yes(isLate(of) || !of.oesophagus.empty());
    case Metric::CuffInflated:
        return yes(of.cuffInflated.has_value());
    case Metric::PassedShut:
        return yes(of.passedShut.has_value());
    case Metric::DepthError:
        if (!of.depth || !of.depthWanted)
            return std::nullopt;
        return std::abs(inMillimetres(of.depth->atTeeth - *of.depthWanted));
    case Metric::AboveCarina:
        return of.depth && !of.isTold ? Value{inMillimetres(of.depth->aboveCarina)} : std::nullopt;
    default:
        return std::nullopt;
    }
}

Value forceValue(const ForceFigures& of, Metric metric)
{
    switch (metric) {
    case Metric::IncisorPeak:
    case Metric::TonguePeak:
        return inNewtons(of.peak);
    case Metric::IncisorMean:
    case Metric::TongueMean:
        return inNewtons(of.mean);
    case Metric::IncisorWarning:
    case Metric::TongueWarning:
        return inSeconds(of.aboveWarning);
    case Metric::TongueImpulse:
        return of.impulse;
    default:
        return std::nullopt;
    }
}

Value motionValue(const MotionFigures& of, Metric metric)
{
    switch (metric) {
    case Metric::HandPath:
        return inCentimetres(of.path);
    case Metric::HandAcceleration:
    case Metric::HeadAcceleration:
        return of.meanAcceleration;
    case Metric::HandJerk:
    case Metric::HeadJerk:
        return of.meanJerk;
    case Metric::HandSmoothness:
        return of.smoothness;
    case Metric::HeadTravel:
        return inCentimetres(of.verticalTravel);
    default:
        return std::nullopt;
    }
}

const std::optional<ForceFigures>& forceOf(const TryMetrics& of, Metric metric)
{
    return metric < Metric::TonguePeak ? of.incisors : of.tongue;
}

const std::optional<MotionFigures>& motionOf(const TryMetrics& of, Metric metric)
{
    return metric < Metric::HeadTravel ? of.hand : of.head;
}

const std::optional<bool>& checkOf(const TryMetrics& of, Metric metric)
{
    return of.checks.at(std::size_t(metric) - std::size_t(Metric::Prepared));
}

bool isForce(Metric metric)
{
    return metric >= Metric::IncisorPeak && metric <= Metric::TongueImpulse;
}

bool isMotion(Metric metric) { return metric >= Metric::HandPath && metric <= Metric::HeadJerk; }

bool isCheck(Metric metric) { return metric >= Metric::Prepared; }

Value patientValue(const TryMetrics& of, Metric metric)
{
    switch (metric) {
    case Metric::HeadExtension:
        return of.headExtension ? Value{inDegrees(*of.headExtension)} : std::nullopt;
    case Metric::LowestSaturation:
        return of.oxygen ? Value{perCent(of.oxygen->lowest)} : std::nullopt;
    case Metric::TimeBelow90:
        return of.oxygen ? inSeconds(of.oxygen->below) : std::nullopt;
    case Metric::PlaneTilt:
        return of.plane ? Value{squareDegrees(of.plane->squaredTilt)} : std::nullopt;
    default:
        return courseValue(of, metric);
    }
}

/// The second attempt is the one too many.
std::optional<SessionTime> secondAttempt(const TryMetrics& of)
{
    return of.attempts.size() > 1 ? std::optional{of.attempts[1]} : std::nullopt;
}

std::optional<SessionTime> momentOfCourse(const TryMetrics& of, Metric metric)
{
    switch (metric) {
    case Metric::TimeToView:
    case Metric::GlottisSeen:
    case Metric::GlotticOpening:
        return of.view;
    case Metric::TimeToCords:
    case Metric::InTrachea:
        return of.throughCords;
    case Metric::TimeToBreath:
        return of.firstBreath;
    case Metric::Attempts:
        return secondAttempt(of);
    case Metric::InOesophagus:
    case Metric::OesophagealTime:
        return of.oesophagus.empty() ? std::nullopt : std::optional{longestStay(of)->in};
    case Metric::Failed:
        if (!of.oesophagus.empty())
            return of.oesophagus.front().in;
        return isLate(of)
                   ? std::optional{std::min(of.pauses.after(of.begun, kFailedAfter), of.ended)}
                   : std::nullopt;
    case Metric::InBronchus:
        return isBeyondCarina(of) && of.depth ? std::optional{of.depth->at} : std::nullopt;
    case Metric::DepthError:
    case Metric::AboveCarina:
        return of.depth ? std::optional{of.depth->at} : std::nullopt;
    case Metric::CuffInflated:
        return of.cuffInflated;
    case Metric::PassedShut:
        return of.passedShut;
    default:
        return std::nullopt;
    }
}

} // namespace

const MetricEntry& entryOf(Metric metric) { return kMetrics.at(std::size_t(metric)); }

std::optional<Metric> metricOf(std::string_view word)
{
    const auto found = std::ranges::find(
        kMetrics, word, [](const MetricEntry& entry) { return std::string_view{entry.word}; });
    return found == kMetrics.end() ? std::nullopt : std::optional{found->metric};
}

std::optional<double> valueOf(const TryMetrics& metrics, Metric metric)
{
    if (isForce(metric)) {
        const std::optional<ForceFigures>& force = forceOf(metrics, metric);
        return force ? forceValue(*force, metric) : std::nullopt;
    }
    if (isMotion(metric)) {
        const std::optional<MotionFigures>& motion = motionOf(metrics, metric);
        return motion ? motionValue(*motion, metric) : std::nullopt;
    }
    if (isCheck(metric)) {
        const std::optional<bool>& check = checkOf(metrics, metric);
        return check ? yes(*check) : std::nullopt;
    }
    return patientValue(metrics, metric);
}

std::optional<SessionTime> momentOf(const TryMetrics& metrics, Metric metric)
{
    if (!valueOf(metrics, metric))
        return std::nullopt;
    if (isForce(metric))
        return forceOf(metrics, metric)->peakAt;
    if (metric == Metric::HandJerk || metric == Metric::HeadJerk)
        return motionOf(metrics, metric)->jerkiest;
    if (metric == Metric::LowestSaturation)
        return metrics.oxygen->lowestAt;
    if (metric == Metric::TimeBelow90)
        return metrics.oxygen->fellBelow;
    return momentOfCourse(metrics, metric);
}

bool neverCameTo(const TryMetrics& metrics, Metric metric)
{
    switch (metric) {
    case Metric::TimeToView:
    case Metric::GlotticOpening:
        return hadReadView(metrics) && !metrics.view;
    case Metric::TimeToCords:
        return !metrics.throughCords;
    case Metric::TimeToBreath:
        return !metrics.firstBreath;
    case Metric::DepthError:
    case Metric::AboveCarina:
        return !hasTubeInAirway(metrics);
    default:
        return false;
    }
}

std::vector<Metric> notMeasured(const TryMetrics& metrics)
{
    std::vector<Metric> missing;
    for (const MetricEntry& entry : kMetrics)
        if (!valueOf(metrics, entry.metric) && !neverCameTo(metrics, entry.metric))
            missing.push_back(entry.metric);
    return missing;
}

} // namespace carina
