#include "apps/lab/anatomy/comparison_report.h"

#include "apps/lab/anatomy/anatomy_page.h"

#include <QJsonArray>

#include <cmath>

namespace carina::lab
{
namespace
{

double rounded(double value) { return std::round(1e3 * value) / 1e3; }

QString text(const std::string& words) { return QString::fromStdString(words); }

QJsonObject objectOf(const Deviation& figure)
{
    return {{anatomy_compare_key::kFigure, text(figure.name)},
            {anatomy_compare_key::kGenerated, rounded(figure.generated)},
            {anatomy_compare_key::kReal, rounded(figure.real)},
            {anatomy_compare_key::kDeviation, rounded(figure.deviation())},
            {anatomy_compare_key::kLimit, figure.limit},
            {anatomy_compare_key::kRelative, figure.relative},
            {anatomy_compare_key::kFigureMet, figure.met()}};
}

QJsonObject objectOf(const OrganDistance& organ)
{
    return {{anatomy_compare_key::kOrgan, text(organ.organ)},
            {anatomy_compare_key::kToSet, rounded(organ.toReal_mm)},
            {anatomy_compare_key::kFromSet, rounded(organ.fromReal_mm)},
            {anatomy_compare_key::kMean, rounded(organ.mean_mm())},
            {anatomy_compare_key::kOneWay, organ.oneWay},
            {anatomy_compare_key::kOrganMet, organ.met()}};
}

QJsonArray listOf(const std::vector<std::string>& names)
{
    QJsonArray list;
    for (const std::string& name : names)
        list.append(text(name));
    return list;
}

QJsonArray unmet(const AnatomyComparison& comparison)
{
    QJsonArray lines;
    for (const Deviation& figure : comparison.figures)
        if (!figure.met())
            lines.append(QStringLiteral("%1: %2, limit %3")
                             .arg(text(figure.name))
                             .arg(rounded(figure.deviation()))
                             .arg(figure.limit));
    for (const OrganDistance& organ : comparison.organs)
        if (!organ.met())
            lines.append(QStringLiteral("%1: %2 mm, limit %3 mm")
                             .arg(text(organ.organ))
                             .arg(rounded(organ.mean_mm()))
                             .arg(kLargestMeanDistance_mm));
    for (const SelfIntersection& found : comparison.selfIntersections)
        lines.append(QStringLiteral("%1, level %2: runs through itself in %3 places")
                         .arg(text(found.part))
                         .arg(found.level)
                         .arg(found.pairs));
    return lines;
}

} // namespace

QJsonArray listOf(const std::vector<SelfIntersection>& found)
{
    QJsonArray list;
    for (const SelfIntersection& part : found)
        list.append(QJsonObject{{anatomy_compare_key::kPart, text(part.part)},
                                {anatomy_compare_key::kLevel, qint64(part.level)},
                                {anatomy_compare_key::kPairs, qint64(part.pairs)}});
    return list;
}

QJsonObject reportOf(const AnatomyComparison& comparison)
{
    QJsonArray figures;
    for (const Deviation& figure : comparison.figures)
        figures.append(objectOf(figure));
    QJsonArray organs;
    for (const OrganDistance& organ : comparison.organs)
        organs.append(objectOf(organ));
    return {{anatomy_compare_key::kAirwayScale, rounded(comparison.airwayScale)},
            {anatomy_compare_key::kChestScale, rounded(comparison.chestScale)},
            {anatomy_compare_key::kFigures, figures},
            {anatomy_compare_key::kOrgans, organs},
            {anatomy_compare_key::kNotInSet, listOf(comparison.notInSet)},
            {anatomy_compare_key::kNotInPatient, listOf(comparison.notInPatient)},
            {anatomy_compare_key::kSelfIntersections, listOf(comparison.selfIntersections)},
            {anatomy_compare_key::kMet, comparison.met()},
            {anatomy_compare_key::kUnmet, unmet(comparison)}};
}

} // namespace carina::lab
