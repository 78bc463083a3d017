#include "apps/lab/anatomy/comparison_report.h"

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
    return {{QStringLiteral("name"), text(figure.name)},
            {QStringLiteral("generated"), rounded(figure.generated)},
            {QStringLiteral("set"), rounded(figure.real)},
            {QStringLiteral("deviation"), rounded(figure.deviation())},
            {QStringLiteral("limit"), figure.limit},
            {QStringLiteral("relative"), figure.relative},
            {QStringLiteral("met"), figure.met()}};
}

QJsonObject objectOf(const OrganDistance& organ)
{
    return {{QStringLiteral("organ"), text(organ.organ)},
            {QStringLiteral("to_set_mm"), rounded(organ.toReal_mm)},
            {QStringLiteral("from_set_mm"), rounded(organ.fromReal_mm)},
            {QStringLiteral("mean_mm"), rounded(organ.mean_mm())},
            {QStringLiteral("one_way"), organ.oneWay},
            {QStringLiteral("met"), organ.met()}};
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
        list.append(QJsonObject{{QStringLiteral("part"), text(part.part)},
                                {QStringLiteral("level"), qint64(part.level)},
                                {QStringLiteral("pairs"), qint64(part.pairs)}});
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
    return {{QStringLiteral("airway_scale"), rounded(comparison.airwayScale)},
            {QStringLiteral("chest_scale"), rounded(comparison.chestScale)},
            {QStringLiteral("figures"), figures},
            {QStringLiteral("organs"), organs},
            {QStringLiteral("not_in_set"), listOf(comparison.notInSet)},
            {QStringLiteral("not_in_patient"), listOf(comparison.notInPatient)},
            {QStringLiteral("self_intersections"), listOf(comparison.selfIntersections)},
            {QStringLiteral("met"), comparison.met()},
            {QStringLiteral("unmet"), unmet(comparison)}};
}

} // namespace carina::lab
