#include "engine/io/site/site_json.h"

#include "engine/core/units.h"
#include "engine/io/site/catalogue_json.h"
#include "engine/io/site/devices/device_json.h"
#include "engine/io/site/manikin_json.h"
#include "engine/io/site/site_fields.h"
#include "engine/io/site/tool_json.h"

namespace carina
{
namespace
{

QJsonObject jsonStylus(const StylusTip& stylus)
{
    QJsonObject object{{QStringLiteral("p_SQ_mm"), jsonPoint(stylus.p_SQ)},
                       {QStringLiteral("rms_mm"), jsonLength(stylus.rms)},
                       {QStringLiteral("calibrated_at"), jsonWords(stylus.calibratedAt)},
                       {QStringLiteral("covariance_S_mm2"), jsonTriangle(stylus.covariance_S)},
                       {QStringLiteral("poses"), stylus.poses},
                       {QStringLiteral("outliers"), stylus.outliers}};
    insertText(object, "tool", stylus.tool);
    if (stylus.axis) {
        const Vec3& axis = stylus.axis->axis_S;
        object.insert(
            QStringLiteral("axis"),
            QJsonObject{{QStringLiteral("axis_S"), QJsonArray{axis.x(), axis.y(), axis.z()}},
                        {QStringLiteral("wobble_deg"), inDegrees(stylus.axis->wobble)},
                        {QStringLiteral("calibrated_at"), jsonWords(stylus.axis->calibratedAt)}});
    }
    return object;
}

QJsonObject jsonTouch(const TouchedPoint& point)
{
    const Quat& q = point.q_TS;
    QJsonObject object{{QStringLiteral("landmark"), jsonWords(point.landmark)},
                       {QStringLiteral("p_TQ_mm"), jsonPoint(point.p_TQ)},
                       {QStringLiteral("spread_mm"), jsonLength(point.spread)},
                       {QStringLiteral("q_TS"), QJsonArray{q.x(), q.y(), q.z(), q.w()}}};
    if (point.seenError)
        object.insert(QStringLiteral("seen_error_mm"), jsonLength(*point.seenError));
    if (point.isFitted)
        object.insert(QStringLiteral("fitted"), true);
    insertStale(object, point.stale);
    return object;
}

QJsonObject jsonResidual(const LandmarkResidual& residual)
{
    QJsonObject object{{QStringLiteral("name"), jsonWords(residual.landmark)},
                       {QStringLiteral("mm"), jsonLength(residual.residual)}};
    if (residual.leftOut)
        object.insert(QStringLiteral("left_out_mm"), jsonLength(*residual.leftOut));
    return object;
}

QJsonObject jsonSwab(const SiteSwab& swab)
{
    return {{QStringLiteral("surface"), jsonWords(swab.surface)},
            {QStringLiteral("points"), swab.points},
            {QStringLiteral("outliers"), swab.outliers},
            {QStringLiteral("start_rms_mm"), jsonLength(swab.startRms)},
            {QStringLiteral("rms_mm"), jsonLength(swab.rms)},
            {QStringLiteral("moved_mm"), jsonLength(swab.moved)}};
}

QJsonObject jsonRelay(const SiteRelay& relay)
{
    QJsonObject object{{QStringLiteral("at"), jsonWords(relay.at)},
                       {QStringLiteral("landmarks"), relay.landmarks},
                       {QStringLiteral("rms_mm"), jsonLength(relay.rms)}};
    insertText(object, "operator", relay.operatorName);
    return object;
}

QJsonObject jsonLocalisation(const SiteLocalisation& localisation)
{
    QJsonObject object{{QStringLiteral("rms_mm"), jsonLength(localisation.rms)},
                       {QStringLiteral("degrees_of_freedom"), localisation.degrees}};
    insertText(object, "at", localisation.at);
    insertText(object, "operator", localisation.operatorName);
    return object;
}

template <class Item, class ToJson>
QJsonArray jsonList(const std::vector<Item>& items, const ToJson& toJson)
{
    QJsonArray list;
    for (const Item& item : items)
        list.append(toJson(item));
    return list;
}

QJsonObject jsonRegistration(const SiteRegistration& registration)
{
    QJsonObject object{
        {QStringLiteral("X_AM_mm"), jsonPose(registration.X_AM)},
        {QStringLiteral("X_AT_mm"), jsonPose(registration.X_AT)},
        {QStringLiteral("rms_mm"), jsonLength(registration.rms)},
        {QStringLiteral("residuals_mm"), jsonList(registration.residuals, jsonResidual)},
        {QStringLiteral("covariance_mm_mrad"), jsonTriangle(registration.covariance_A)},
        {QStringLiteral("fle_mm"), jsonLength(registration.fle)},
        {QStringLiteral("degrees_of_freedom"), registration.degrees},
        {QStringLiteral("pooled"), registration.pooled},
        {QStringLiteral("disagreeing"), registration.disagreeing},
        {QStringLiteral("relays"), jsonList(registration.relays, jsonRelay)}};
    if (registration.X_JM)
        object.insert(QStringLiteral("X_JM_mm"), jsonPose(*registration.X_JM));
    if (registration.X_BM)
        object.insert(QStringLiteral("X_BM_mm"), jsonPose(*registration.X_BM));
    if (registration.swab)
        object.insert(QStringLiteral("swab"), jsonSwab(*registration.swab));
    insertText(object, "made_at", registration.madeAt);
    insertText(object, "operator", registration.operatorName);
    insertStale(object, registration.stale);
    return object;
}

QJsonObject jsonVerified(const VerifiedPoint& point)
{
    return {{QStringLiteral("name"), jsonWords(point.name)},
            {QStringLiteral("p_AQ_mm"), jsonPoint(point.p_AQ)},
            {QStringLiteral("p_TQ_mm"), jsonPoint(point.p_TQ)},
            {QStringLiteral("error_mm"), jsonLength(point.error)},
            {QStringLiteral("bound_mm"), jsonLength(point.bound)}};
}

QJsonObject jsonVerification(const SiteVerification& verification)
{
    const auto verdict = static_cast<std::size_t>(verification.verdict);
    QJsonObject object{{QStringLiteral("verdict"), QString::fromLatin1(kVerdictWords[verdict])},
                       {QStringLiteral("points"), jsonList(verification.points, jsonVerified)}};
    insertText(object, "at", verification.at);
    insertText(object, "operator", verification.operatorName);
    insertStale(object, verification.stale);
    return object;
}

QJsonObject jsonDisplay(const DisplayGeometry& display)
{
    return {{QStringLiteral("p_HDl_mm"), jsonPoint(display.p_HDl)},
            {QStringLiteral("p_HDr_mm"), jsonPoint(display.p_HDr)},
            {QStringLiteral("p_HQ_screen_centre_mm"), jsonPoint(display.p_HQ_screenCentre)},
            {QStringLiteral("screen_width_mm"), jsonLength(display.screenWidth)},
            {QStringLiteral("screen_height_mm"), jsonLength(display.screenHeight)}};
}

} // namespace

QJsonObject jsonSite(const Site& site)
{
    QJsonObject object{{QStringLiteral("schema"), kSiteSchema},
                       {QStringLiteral("step"),
                        QString::fromLatin1(kStepWords[static_cast<std::size_t>(site.step)])}};
    insertText(object, "operator", site.operatorName);
    insertText(object, "tracker", site.tracker);
    if (!site.devices.empty())
        object.insert(QStringLiteral("devices"), jsonList(site.devices, jsonDevice));
    if (!site.styluses.empty())
        object.insert(QStringLiteral("styluses"), jsonList(site.styluses, jsonStylus));
    if (!site.tools.empty())
        object.insert(QStringLiteral("tools"), jsonList(site.tools, jsonTool));
    insertText(object, "patient", site.patient);
    if (site.catalogue)
        object.insert(QStringLiteral("catalogue"), jsonCatalogue(*site.catalogue));
    if (!site.touched.empty())
        object.insert(QStringLiteral("touched"), jsonList(site.touched, jsonTouch));
    if (site.registration)
        object.insert(QStringLiteral("registration"), jsonRegistration(*site.registration));
    if (!site.localisations.empty())
        object.insert(QStringLiteral("localisations"),
                      jsonList(site.localisations, jsonLocalisation));
    if (site.relay)
        object.insert(QStringLiteral("relay"), jsonList(*site.relay, jsonTouch));
    if (site.verification)
        object.insert(QStringLiteral("verification"), jsonVerification(*site.verification));
    if (site.display)
        object.insert(QStringLiteral("display"), jsonDisplay(*site.display));
    if (!site.manikin.isEmpty())
        object.insert(QStringLiteral("manikin"), jsonManikin(site.manikin));
    return object;
}

} // namespace carina
