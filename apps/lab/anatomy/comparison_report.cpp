#include "apps/lab/anatomy/comparison_report.h"

#include "apps/lab/anatomy/anatomy_page.h"

#include <QJsonArray>

#include <cmath>
#include <span>

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
            {anatomy_compare_key::kLimit,
             figure.limit ? QJsonValue{*figure.limit} : QJsonValue{QJsonValue::Null}},
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

QJsonArray rounded(const Vec3& vector)
{
    return {rounded(vector.x()), rounded(vector.y()), rounded(vector.z())};
}

QJsonArray inMillimetres(const Vec3& p_A) { return rounded(Vec3{1e3 * p_A}); }

QJsonArray inMillimetres(std::span<const Vec3> points)
{
    QJsonArray list;
    for (const Vec3& p_A : points)
        list.append(inMillimetres(p_A));
    return list;
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
                             .arg(*figure.limit));
    for (const OrganDistance& organ : comparison.organs)
        if (!organ.met())
            lines.append(QStringLiteral("%1: %2 mm, limit %3 mm")
                             .arg(text(organ.organ))
                             .arg(rounded(organ.mean_mm()))
                             .arg(kLargestMeanDistance_mm));
    for (const SelfIntersection& found : comparison.selfIntersections)
        lines.append(QStringLiteral("%1, level %2: intersects itself in %3 places")
                         .arg(text(found.part))
                         .arg(found.level)
                         .arg(found.pairs));
    return lines;
}

} // namespace

QJsonObject reportOf(const PatientLandmarks& landmarks)
{
    return {{anatomy_compare_key::kIncisors, inMillimetres(landmarks.airway.p_A_incisors)},
            {anatomy_compare_key::kGlottis, inMillimetres(landmarks.airway.p_A_glottis)},
            {anatomy_compare_key::kSternalNotch, inMillimetres(landmarks.ribs.p_A_sternalNotch)},
            {anatomy_compare_key::kXiphoidTip, inMillimetres(landmarks.ribs.p_A_xiphoidTip)},
            {anatomy_compare_key::kRightRibEnds, inMillimetres(landmarks.ribs.p_A_rightEnds)},
            {anatomy_compare_key::kLeftRibEnds, inMillimetres(landmarks.ribs.p_A_leftEnds)},
            {anatomy_compare_key::kIncisorPlane, rounded(landmarks.incisors.normal_A)},
            {anatomy_compare_key::kTracheaAxis, rounded(landmarks.glottis.normal_A)}};
}

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
