#include "engine/scoring/score/rubric.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kPublishedPoints = 10.0;
constexpr double kExtended_deg = 10.0;
constexpr double kAppropriate_mm = 10.0;

bool isWithin(const Criterion& criterion, double value)
{
    return criterion.bound == Bound::AtMost ? value <= criterion.limit : value >= criterion.limit;
}

/// Of a time from the beginning that had a longest limit: when that was over, within the try.
std::optional<SessionTime> momentOfLoss(const TryMetrics& metrics, const Criterion& criterion)
{
    if (criterion.metric > Metric::TimeToBreath || criterion.bound != Bound::AtMost)
        return momentOf(metrics, criterion.metric);
    const std::chrono::duration<double> allowed{criterion.limit};
    const auto time = std::chrono::duration_cast<Duration>(allowed);
    return std::clamp(metrics.pauses.after(metrics.begun, std::max(time, Duration{})),
                      metrics.begun, metrics.ended);
}

Judgement judgementOf(const TryMetrics& metrics, const Criterion& criterion)
{
    Judgement judged{.criterion = criterion, .value = valueOf(metrics, criterion.metric)};
    if (!judged.value && !neverCameTo(metrics, criterion.metric))
        return judged;
    if (judged.value && isWithin(criterion, *judged.value)) {
        judged.verdict = ItemVerdict::Met;
        judged.points = criterion.points;
        return judged;
    }
    judged.verdict = judged.value ? ItemVerdict::Missed : ItemVerdict::Never;
    judged.points = -criterion.penalty;
    judged.moment = momentOfLoss(metrics, criterion);
    return judged;
}

/// An item of the published scheme that is met where its metric is a yes.
Criterion publishedItem(Metric metric) { return {.metric = metric, .points = kPublishedPoints}; }

Criterion publishedPenalty(Metric metric)
{
    return {.metric = metric,
            .bound = Bound::AtMost,
            .limit = 0.0,
            .points = 0.0,
            .penalty = kPublishedPoints};
}

} // namespace

Score scoreOf(const TryMetrics& metrics, const Rubric& rubric)
{
    Score score;
    for (const Criterion& criterion : rubric.criteria) {
        const Judgement judged = judgementOf(metrics, criterion);
        score.ofAll += criterion.points;
        if (judged.verdict != ItemVerdict::NotMeasured)
            score.possible += criterion.points;
        score.points += judged.points;
        score.judgements.push_back(judged);
    }
    return score;
}

Rubric publishedRubric()
{
    Criterion extended = publishedItem(Metric::HeadExtension);
    extended.limit = kExtended_deg;
    Criterion depth = publishedItem(Metric::DepthError);
    depth.bound = Bound::AtMost;
    depth.limit = kAppropriate_mm;
    Criterion time = publishedItem(Metric::TimeToBreath);
    time.bound = Bound::AtMost;
    time.limit = toSeconds(kFailedAfter);
    return {.name = "Progressive evaluation scheme",
            .source = "BMC Med Educ 2014;14:144, table 1",
            .criteria = {publishedItem(Metric::Prepared), publishedItem(Metric::MaskVentilated),
                         extended, publishedItem(Metric::BladeFromRight),
                         publishedItem(Metric::PressureAsked), publishedItem(Metric::GlottisSeen),
                         depth, publishedItem(Metric::CuffInflated),
                         publishedItem(Metric::Auscultated), time,
                         publishedPenalty(Metric::InBronchus), publishedPenalty(Metric::Failed)}};
}

} // namespace carina
