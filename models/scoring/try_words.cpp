#include "models/scoring/try_words.h"

#include "engine/scoring/score/literature.h"
#include "models/intubation/intubation_timeline.h"

#include <QCoreApplication>

#include <cmath>

namespace carina
{
namespace
{

QString tryWords(const char* text) { return QCoreApplication::translate("Try", text); }

/// In the form for so many points. Parts of a point take the plural.
QString pointWords(const char* text, double points)
{
    const double count = std::abs(points);
    return QCoreApplication::translate("Try", text, nullptr,
                                       count == std::floor(count) ? int(count) : 2);
}

/// "2:05 min" of the try.
QString momentText(const TryMetrics& metrics, SessionTime moment)
{
    const auto seconds =
        std::chrono::floor<std::chrono::seconds>(metrics.sinceBegun(moment)).count();
    return tryWords(QT_TRANSLATE_NOOP("Try", "%1:%2\u00a0min"))
        .arg(seconds / 60)
        .arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

/// To the millimetre, in the unit of the marks on a tube.
QString centimetresText(Length length)
{
    return tryWords(QT_TRANSLATE_NOOP("Try", "%1\u00a0cm"))
        .arg(0.1 * inMillimetres(length), 0, 'f', 1);
}

/// Of what the try never came to.
QString neverText(Metric metric)
{
    const MetricUnit unit = entryOf(metric).unit;
    const bool isLength = unit == MetricUnit::Millimetres || unit == MetricUnit::Centimetres;
    return isLength ? tryWords(QT_TRANSLATE_NOOP("Try", "none: no tube in the airway"))
                    : tryWords(QT_TRANSLATE_NOOP("Try", "never"));
}

/// A saturation is told by the whole per cent that it reached: 89.7 % is below 90 %.
QString shownText(double value, Metric metric)
{
    constexpr double kRounding = 1e-9;
    return valueText(metric == Metric::LowestSaturation ? std::floor(value + kRounding) : value,
                     entryOf(metric).unit);
}

QString measuredText(const TryMetrics& metrics, Metric metric)
{
    if (const std::optional<double> value = valueOf(metrics, metric))
        return shownText(*value, metric);
    return neverCameTo(metrics, metric) ? neverText(metric)
                                        : tryWords(QT_TRANSLATE_NOOP("Try", "not measured"));
}

SummaryLine measured(const TryMetrics& metrics, Metric metric)
{
    return {metricText(metric), measuredText(metrics, metric)};
}

QString depthText(const TryReport& report)
{
    const TryMetrics& metrics = report.metrics;
    if (!metrics.depth)
        return measuredText(metrics, Metric::DepthError);
    const QString depth =
        asSureAs(centimetresText(metrics.depth->atTeeth), metrics.depth->confidence);
    if (!metrics.depthWanted)
        return depth;
    return tryWords(QT_TRANSLATE_NOOP("Try", "%1; %2 by the rule %3"))
        .arg(depth, centimetresText(*metrics.depthWanted), ruleText(report.rule));
}

/// A tip that is too deep is told by how far it is beyond.
SummaryLine carinaLine(const TryMetrics& metrics)
{
    if (!metrics.depth || metrics.isTold || metrics.depth->aboveCarina.si >= 0.0)
        return measured(metrics, Metric::AboveCarina);
    return {
        tryWords(QT_TRANSLATE_NOOP("Try", "Tip beyond the carina")),
        tryWords(QT_TRANSLATE_NOOP("Try", "▲ %1"))
            .arg(valueText(-inMillimetres(metrics.depth->aboveCarina), MetricUnit::Millimetres))};
}

QString viewText(const TryMetrics& metrics)
{
    const QString seen = measuredText(metrics, Metric::GlotticOpening);
    return metrics.view ? tryWords(QT_TRANSLATE_NOOP("Try", "%1 of the glottis, after %2"))
                              .arg(seen, measuredText(metrics, Metric::TimeToView))
                        : seen;
}

QString oxygenText(const TryMetrics& metrics)
{
    const QString lowest = measuredText(metrics, Metric::LowestSaturation);
    if (!metrics.oxygen)
        return lowest;
    const QString moment = momentText(metrics, metrics.oxygen->lowestAt);
    if (!metrics.oxygen->fellBelow)
        return tryWords(QT_TRANSLATE_NOOP("Try", "%1, at %2; never below 90\u00a0%"))
            .arg(lowest, moment);
    return tryWords(QT_TRANSLATE_NOOP("Try", "▲ %1, at %2; below 90\u00a0% for %3"))
        .arg(lowest, moment, measuredText(metrics, Metric::TimeBelow90));
}

QString pointsText(double points) { return QString::number(points, 'g', 4); }

QString limitText(const Criterion& criterion)
{
    const MetricUnit unit = entryOf(criterion.metric).unit;
    const QString limit = valueText(criterion.limit, unit);
    if (unit == MetricUnit::YesOrNo)
        return limit;
    return (criterion.bound == Bound::AtMost ? tryWords(QT_TRANSLATE_NOOP("Try", "at most %1"))
                                             : tryWords(QT_TRANSLATE_NOOP("Try", "at least %1")))
        .arg(limit);
}

/// Why the points are lost: "12.4 s, expected: at most 10.0 s; 0:10 min into the try".
QString reasonText(const Judgement& judged, const TryMetrics& metrics)
{
    const QString value = judged.value ? shownText(*judged.value, judged.criterion.metric)
                                       : neverText(judged.criterion.metric);
    const QString reason = tryWords(QT_TRANSLATE_NOOP("Try", "%1, expected: %2"))
                               .arg(value, limitText(judged.criterion));
    if (!judged.moment)
        return reason;
    return tryWords(QT_TRANSLATE_NOOP("Try", "%1; %2 into the try"))
        .arg(reason, momentText(metrics, *judged.moment));
}

QString judgementText(const Judgement& judged, const TryMetrics& metrics)
{
    const QString got = pointsText(judged.points);
    const QString possible = pointsText(judged.criterion.points);
    const bool isPenalty = judged.criterion.points == 0.0;
    switch (judged.verdict) {
    case ItemVerdict::Met:
        return isPenalty ? tryWords(QT_TRANSLATE_NOOP("Try", "✓ no penalty"))
                         : pointWords(QT_TRANSLATE_N_NOOP("Try", "✓ %1 of %2 points"),
                                      judged.criterion.points)
                               .arg(got, possible);
    case ItemVerdict::Missed:
    case ItemVerdict::Never:
        return (isPenalty ? pointWords(QT_TRANSLATE_N_NOOP("Try", "▲ %1 points: %2"), judged.points)
                                .arg(got)
                          : pointWords(QT_TRANSLATE_N_NOOP("Try", "▲ %1 of %2 points: %3"),
                                       judged.criterion.points)
                                .arg(got, possible))
            .arg(reasonText(judged, metrics));
    case ItemVerdict::NotMeasured:
        return tryWords(QT_TRANSLATE_NOOP("Try", "○ not measured, does not count"));
    }
    return {};
}

QString groupText(const GroupFigure& figure, MetricUnit unit)
{
    const QString mean = valueText(figure.mean, unit);
    return figure.deviation ? tryWords(QT_TRANSLATE_NOOP("Try", "%1 (SD %2)"))
                                  .arg(mean, valueText(*figure.deviation, unit))
                            : mean;
}

/// "▲ 45 N, 12 N on average; above 20 N for 3.1 s; above 40 N for 0.4 s".
QString forceText(const ForceFigures& force, const ForceLimits& limits)
{
    const auto newtonsText = [](Force of) { return valueText(inNewtons(of), MetricUnit::Newtons); };
    QString text = tryWords(QT_TRANSLATE_NOOP("Try", "%1, %2 on average"))
                       .arg(newtonsText(force.peak), newtonsText(force.mean));
    const auto addAbove = [&](Duration time, Force limit) {
        if (time > Duration{})
            text =
                tryWords(QT_TRANSLATE_NOOP("Try", "%1; above %2 for %3"))
                    .arg(text, newtonsText(limit), valueText(toSeconds(time), MetricUnit::Seconds));
    };
    addAbove(force.aboveWarning, limits.warning);
    addAbove(force.aboveFault, limits.fault);
    return force.aboveWarning > Duration{} ? tryWords(QT_TRANSLATE_NOOP("Try", "▲ %1")).arg(text)
                                           : text;
}

QString placeText(TryOutcome outcome)
{
    switch (outcome) {
    case TryOutcome::Trachea:
        return tryWords(QT_TRANSLATE_NOOP("Try", "✓ In the trachea"));
    case TryOutcome::RightMain:
        return tryWords(QT_TRANSLATE_NOOP("Try", "▲ In the right main bronchus"));
    case TryOutcome::LeftMain:
        return tryWords(QT_TRANSLATE_NOOP("Try", "▲ In the left main bronchus"));
    case TryOutcome::OesophagusUnrecognised:
        return tryWords(QT_TRANSLATE_NOOP("Try", "▲ In the oesophagus, not recognised"));
    case TryOutcome::OesophagusRecognised:
        return tryWords(
            QT_TRANSLATE_NOOP("Try", "▲ In the oesophagus, recognised; no tube in place"));
    case TryOutcome::Abandoned:
        return tryWords(QT_TRANSLATE_NOOP("Try", "■ Given up: no tube in place"));
    }
    return {};
}

} // namespace

QString outcomeText(const TryMetrics& metrics)
{
    const QString place = asSureAs(placeText(metrics.outcome), metrics.confidence);
    return metrics.isTold
               ? tryWords(QT_TRANSLATE_NOOP("Try", "%1, as an instructor set it")).arg(place)
               : place;
}

QString ruleText(DepthRule rule)
{
    switch (rule) {
    case DepthRule::TenthOfHeight:
        return tryWords(QT_TRANSLATE_NOOP("Try", "0.10 × height + 5\u00a0cm"));
    case DepthRule::EighthOfHeight:
        return tryWords(QT_TRANSLATE_NOOP("Try", "height / 8 + 3.4\u00a0cm"));
    case DepthRule::ThreeDiameters:
        return tryWords(QT_TRANSLATE_NOOP("Try", "3 × inner diameter"));
    case DepthRule::HalfOfAge:
        return tryWords(QT_TRANSLATE_NOOP("Try", "age / 2 + 12\u00a0cm"));
    case DepthRule::WomanTwentyOneManTwentyThree:
        return tryWords(QT_TRANSLATE_NOOP("Try", "21\u00a0cm for women, 23\u00a0cm for men"));
    }
    return {};
}

std::vector<SummaryLine> tryLines(const TryReport& report)
{
    const TryMetrics& metrics = report.metrics;
    std::vector<SummaryLine> lines{
        measured(metrics, Metric::TimeToBreath),
        {tryWords(QT_TRANSLATE_NOOP("Try", "Depth at the teeth")), depthText(report)},
        carinaLine(metrics),
        {metricText(Metric::LowestSaturation), oxygenText(metrics)},
        {tryWords(QT_TRANSLATE_NOOP("Try", "View")), viewText(metrics)},
        measured(metrics, Metric::Attempts)};
    if (!metrics.oesophagus.empty())
        lines.push_back(measured(metrics, Metric::OesophagealTime));
    if (metrics.passedShut)
        lines.push_back(measured(metrics, Metric::PassedShut));
    return lines;
}

std::vector<SummaryLine> handlingLines(const TryMetrics& metrics)
{
    std::vector<SummaryLine> lines;
    if (metrics.incisors)
        lines.push_back(
            {metricText(Metric::IncisorPeak), forceText(*metrics.incisors, kIncisorLimits)});
    if (metrics.tongue)
        lines.push_back(
            {metricText(Metric::TonguePeak), forceText(*metrics.tongue, kTongueLimits)});
    for (const Metric metric : {Metric::TongueImpulse, Metric::PlaneTilt, Metric::HandPath,
                                Metric::HandAcceleration, Metric::HandJerk, Metric::HandSmoothness,
                                Metric::HeadTravel, Metric::HeadAcceleration, Metric::HeadJerk})
        if (valueOf(metrics, metric))
            lines.push_back(measured(metrics, metric));
    return lines;
}

QString scoreText(const Score& score)
{
    const QString points = pointWords(QT_TRANSLATE_N_NOOP("Try", "%1 of %2 points"), score.possible)
                               .arg(pointsText(score.points), pointsText(score.possible));
    if (score.possible >= score.ofAll)
        return points;
    return tryWords(QT_TRANSLATE_NOOP("Try", "%1; %2 more could not be judged"))
        .arg(points, pointsText(score.ofAll - score.possible));
}

std::vector<SummaryLine> judgementLines(const TryReport& report)
{
    std::vector<SummaryLine> lines;
    for (const Judgement& judged : report.score.judgements) {
        const std::string& name = judged.criterion.name;
        lines.push_back(
            {name.empty() ? metricText(judged.criterion.metric) : QString::fromStdString(name),
             judgementText(judged, report.metrics)});
    }
    return lines;
}

std::vector<SummaryLine> literatureLines(const TryMetrics& metrics)
{
    std::vector<SummaryLine> lines;
    for (const LiteratureFigure& figure : kLiteratureFigures) {
        const MetricUnit unit = entryOf(figure.metric).unit;
        lines.push_back(
            {metricText(figure.metric),
             tryWords(QT_TRANSLATE_NOOP("Try", "you %1, experts %2, novices %3 (%4)"))
                 .arg(measuredText(metrics, figure.metric), groupText(figure.expert, unit),
                      groupText(figure.novice, unit), QString::fromUtf8(figure.source))});
    }
    return lines;
}

QString notMeasuredText(const TryMetrics& metrics)
{
    QStringList missing;
    for (const Metric metric : notMeasured(metrics))
        missing += metricText(metric);
    return missing.isEmpty() ? QString{}
                             : tryWords(QT_TRANSLATE_NOOP("Try", "Not measured: %1."))
                                   .arg(missing.join(QStringLiteral("; ")));
}

} // namespace carina
