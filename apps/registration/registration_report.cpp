#include "apps/registration/registration_report.h"

#include "apps/registration/overlay_error.h"
#include "apps/registration/scripted_hand.h"
#include "engine/tracking/tool_role.h"

#include <QJsonArray>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

QJsonArray pointInMillimetres(const Vec3& p)
{
    return {inMillimetres(metres(p.x())), inMillimetres(metres(p.y())),
            inMillimetres(metres(p.z()))};
}

QJsonArray poseInMillimetres(const RigidTransform& X)
{
    Mat4 m = X.matrix();
    m.topRightCorner<3, 1>() *= 1e3;
    QJsonArray rows;
    for (int row = 0; row < 4; ++row)
        rows.append(QJsonArray{m(row, 0), m(row, 1), m(row, 2), m(row, 3)});
    return rows;
}

QJsonArray landmarksOf(const Site& site)
{
    QJsonArray landmarks;
    for (const Landmark& landmark : site.catalogue->landmarks) {
        QJsonObject entry{{QStringLiteral("name"), QString::fromStdString(landmark.name)},
                          {QStringLiteral("spread_mm"), QJsonValue::Null},
                          {QStringLiteral("residual_mm"), QJsonValue::Null}};
        for (const TouchedPoint& point : site.touched)
            if (point.landmark == landmark.name)
                entry[QStringLiteral("spread_mm")] = inMillimetres(metres(point.spread));
        for (const LandmarkResidual& residual : site.registration->residuals)
            if (residual.landmark == landmark.name)
                entry[QStringLiteral("residual_mm")] = inMillimetres(metres(residual.residual));
        landmarks.append(entry);
    }
    return landmarks;
}

QJsonArray overlayErrors(const Site& site, const AirwayLandmarks& airway,
                         const RigidTransform& X_TA)
{
    std::vector<Landmark> places{{"Carina", airway.p_A_carina},
                                 {"Vocal cords", airway.p_A_glottis},
                                 {"Incisors", airway.p_A_incisors}};
    const auto& landmarks = site.catalogue->landmarks;
    places.insert(places.end(), landmarks.begin(), landmarks.end());
    QJsonArray errors;
    for (const Landmark& place : places) {
        const double error = overlayError(site.registration->X_AT, X_TA, place.p_AQ);
        errors.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(place.name)},
                                  {QStringLiteral("mm"), inMillimetres(metres(error))}});
    }
    return errors;
}

/// The tip of each tool, as it was found and as it is.
QJsonArray toolsOf(const Site& site, const SimulatedTools& truth)
{
    QJsonArray tools;
    for (const SiteTool& tool : site.tools) {
        const Vec3 p_NQ = tool.role == ToolRole::Tube ? truth.X_NE * tipOfTube(truth.tube)
                                                      : truth.X_NL * truth.blade.p_L_tip;
        tools.append(
            QJsonObject{{QStringLiteral("role"), QString::fromLatin1(toolRoleWord(tool.role))},
                        {QStringLiteral("rms_mm"), inMillimetres(metres(tool.rms))},
                        {QStringLiteral("tip_expected_mm"),
                         inMillimetres(metres(std::sqrt(tool.covariance_N.trace())))},
                        {QStringLiteral("tip_error_mm"),
                         inMillimetres(metres((tool.p_NQ_tip() - p_NQ).norm()))}});
    }
    return tools;
}

} // namespace

QJsonObject registrationReport(const Site& site, const AirwayLandmarks& airway,
                               const SimulatedWorkplace& workplace)
{
    QJsonObject report{
        {QStringLiteral("schema"), QStringLiteral("carina.registration/1")},
        {QStringLiteral("landmarks"), landmarksOf(site)},
        {QStringLiteral("rms_mm"), inMillimetres(metres(site.registration->rms))},
        {QStringLiteral("X_AT_mm"), poseInMillimetres(site.registration->X_AT)},
        {QStringLiteral("X_TA_true_mm"), poseInMillimetres(workplace.X_TA)},
        {QStringLiteral("localisation_error_mm_rms"), inMillimetres(kLocalisationError)},
        {QStringLiteral("overlay_error_mm"), overlayErrors(site, airway, workplace.X_TA)},
        {QStringLiteral("tools"), toolsOf(site, workplace.tools)}};
    if (!site.styluses.empty()) {
        const StylusTip& stylus = site.styluses.front();
        report[QStringLiteral("stylus")] =
            QJsonObject{{QStringLiteral("tip_mm"), pointInMillimetres(stylus.p_SQ)},
                        {QStringLiteral("rms_mm"), inMillimetres(metres(stylus.rms))}};
    }
    return report;
}

} // namespace carina
