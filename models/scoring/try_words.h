#pragma once

#include "models/scoring/try_report.h"
#include "models/session/session_summary.h"

#include <QString>
#include <QStringList>

namespace carina
{

/// "✓ In the trachea", "▲ In the right main bronchus", "▲ In the oesophagus, not recognised"; with
/// the confidence where that is low, as IntubationTimeline tells it.
[[nodiscard]] QString outcomeText(const TryMetrics& metrics);
[[nodiscard]] QString metricText(Metric metric);
/// A value with its unit: "12.4 s", "yes".
[[nodiscard]] QString valueText(double value, MetricUnit unit);
[[nodiscard]] QString ruleText(DepthRule rule);
/// One sentence on what to do next.
[[nodiscard]] QString adviceText(Advice advice);

/// The main figures of a try beside its outcome: time, depth, lowest oxygen, view and others, each
/// with its unit; of what was not measured, that.
[[nodiscard]] std::vector<SummaryLine> tryLines(const TryReport& report);
/// Forces and motion as far as they were measured, a force that was too high with a mark.
[[nodiscard]] std::vector<SummaryLine> handlingLines(const TryMetrics& metrics);
/// "40 of 50 points; 50 more could not be judged".
[[nodiscard]] QString scoreText(const Score& score);
/// Each criterion with its mark: points got, or why they were lost and when in the try.
[[nodiscard]] std::vector<SummaryLine> judgementLines(const TryReport& report);
/// The metrics for which the literature has figures, with those of experts and novices and their
/// source.
[[nodiscard]] std::vector<SummaryLine> literatureLines(const TryMetrics& metrics);
/// What nothing measured, in one sentence; empty where all was.
[[nodiscard]] QString notMeasuredText(const TryMetrics& metrics);

} // namespace carina
