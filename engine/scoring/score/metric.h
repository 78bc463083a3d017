#pragma once

#include "engine/scoring/course/try_metrics.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace carina
{

/// A number, or a yes or no, that is known of a try. Each has a row in kMetrics.
enum class Metric : std::uint8_t {
    // Times, from the beginning of the try, where nothing else is said
    TimeToView,
    TimeToCords,
    TimeToBreath, ///< the first breath into a lung
    BladeTime,    ///< that the blade was in the mouth
    // The course
    Attempts,
    GlottisSeen, ///< yes: grade 1 or 2
    GlotticOpening,
    InTrachea,       ///< yes: the tube ended in the trachea
    InBronchus,      ///< yes: it ended beyond the carina
    InOesophagus,    ///< yes: it was there, be it for a moment
    OesophagealTime, ///< the longest time until it was taken out again
    Failed,          ///< yes: no tube through the cords within kFailedAfter, or InOesophagus
    DepthError,      ///< of the depth at the teeth from the rule, of either sign
    AboveCarina,
    CuffInflated, ///< yes or no
    PassedShut,   ///< yes: where the virtual airway is shut
    // The patient
    HeadExtension,
    LowestSaturation,
    TimeBelow90,
    IncisorPeak,
    IncisorMean,
    IncisorWarning, ///< time above the first limit of kIncisorLimits
    TonguePeak,
    TongueMean,
    TongueWarning,
    TongueImpulse,
    // The motion
    PlaneTilt, ///< mean square, see PlaneMeter
    HandPath,
    HandAcceleration,
    HandJerk,
    HandSmoothness,
    HeadTravel, ///< up and down
    HeadAcceleration,
    HeadJerk,
    // TryCheck, in its order: yes or no
    Prepared,
    MaskVentilated,
    BladeFromRight,
    PressureAsked,
    Auscultated,
};
inline constexpr Metric kLastMetric = Metric::Auscultated;
inline constexpr std::size_t kMetricCount = std::size_t(kLastMetric) + 1;

/// The unit in which people and files have a metric.
enum class MetricUnit : std::uint8_t {
    YesOrNo,
    Count,
    Seconds,
    Millimetres,
    Centimetres,
    Degrees,
    SquareDegrees,
    PerCent,
    Newtons,
    NewtonSeconds,
    MetresPerSecond2,
    MetresPerSecond3,
    None, ///< a number without a unit
};

/// What a metric is called in files, with its unit, and that unit.
struct MetricEntry {
    Metric metric;
    const char* word;
    MetricUnit unit;
};
/// The entry of a metric.
[[nodiscard]] const MetricEntry& entryOf(Metric metric);
/// The metric with this word; nothing where there is none.
[[nodiscard]] std::optional<Metric> metricOf(std::string_view word);

/// The limit of the published scheme (BMC Med Educ 2014;14:144).
inline constexpr Duration kFailedAfter = std::chrono::seconds{150};

/// The value in the metric's unit, 1 for yes and 0 for no; nothing where it was not measured or the
/// try never came to it.
[[nodiscard]] std::optional<double> valueOf(const TryMetrics& metrics, Metric metric);

/// The moment that a value comes from, or that a yes began; nothing where it belongs to no moment
/// or was not measured.
[[nodiscard]] std::optional<SessionTime> momentOf(const TryMetrics& metrics, Metric metric);

/// Whether a metric has no value because the try never came to it: no time to a view without one,
/// no depth without a tube in the airway.
[[nodiscard]] bool neverCameTo(const TryMetrics& metrics, Metric metric);

/// All metrics that nothing measured, in their order.
[[nodiscard]] std::vector<Metric> notMeasured(const TryMetrics& metrics);

} // namespace carina
