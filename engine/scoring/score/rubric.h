#pragma once

#include "engine/scoring/score/metric.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// On which side of its limit a metric is good.
enum class Bound : std::uint8_t { AtMost, AtLeast };

/// One item of a rubric: a metric within a limit gives points, one beyond takes away a penalty.
struct Criterion {
    std::string name{}; ///< as its author calls it; may be empty, and the metric then says it
    Metric metric = Metric::InTrachea;
    Bound bound = Bound::AtLeast;
    double limit = 1.0; ///< in the metric's unit; 1 is yes
    double points = 1.0;
    double penalty = 0.0; ///< not negative

    friend bool operator==(const Criterion&, const Criterion&) = default;
};

struct Rubric {
    std::string name{};
    std::string source{}; ///< where it is published, or whose it is
    std::vector<Criterion> criteria{};

    friend bool operator==(const Rubric&, const Rubric&) = default;
};

enum class ItemVerdict : std::uint8_t {
    Met,
    Missed,      ///< the value is beyond the limit
    Never,       ///< the try never came to it, and so lost the points
    NotMeasured, ///< does not count, neither for points nor for those that can be had
};

/// How one criterion was judged.
struct Judgement {
    Criterion criterion{};
    ItemVerdict verdict = ItemVerdict::NotMeasured;
    std::optional<double> value{};
    double points = 0.0; ///< those got; negative for a penalty
    /// Of lost points, the moment they are linked to; nothing where it is the whole try.
    std::optional<SessionTime> moment{};

    friend bool operator==(const Judgement&, const Judgement&) = default;
};

/// How a try was judged by a rubric.
struct Score {
    std::vector<Judgement> judgements{}; ///< in the order of the criteria
    double points = 0.0;                 ///< penalties included; may be negative
    double possible = 0.0;               ///< of the criteria that could be judged
    double ofAll = 0.0;                  ///< of all criteria

    friend bool operator==(const Score&, const Score&) = default;
};

/// Judges each criterion on its own. Points lost by a time that was too long are linked to the
/// moment when the limit was passed, others to the moment of their metric (momentOf).
[[nodiscard]] Score scoreOf(const TryMetrics& metrics, const Rubric& rubric);

/// The evaluation scheme of BMC Med Educ 2014;14:144, table 1: ten items of ten points each, and
/// two penalties of ten. Of the metrics used for them these are of ours: the head counts as
/// extended from 10 degrees on, the depth as appropriate within 10 mm of the scenario's rule, the
/// cuff as soon as it is inflated, because its pressure is not measured. The time ends with the
/// first breath into a lung where theirs ends with the first normal wave of the capnogram.
[[nodiscard]] Rubric publishedRubric();

} // namespace carina
