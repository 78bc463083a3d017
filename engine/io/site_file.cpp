#include "engine/io/site_file.h"

#include "engine/core/units.h"
#include "engine/io/json_fields.h"
#include "engine/io/landmark_file.h"

#include <QDateTime>

#include <algorithm>
#include <array>
#include <set>

namespace carina
{
namespace
{

const QString kSiteSchema = QStringLiteral("carina.site/1");

constexpr std::array<const char*, 6> kStepWords{"tracker", "stylus", "landmarks",
                                                "touch",   "fit",    "verify"};

QString siteWords(const std::string& text) { return QString::fromStdString(text); }

double jsonLength(double length) { return inMillimetres(metres(length)); }

QJsonObject jsonStylus(const StylusTip& stylus)
{
    return {{QStringLiteral("p_SQ_mm"), jsonPoint(stylus.p_SQ)},
            {QStringLiteral("rms_mm"), jsonLength(stylus.rms)},
            {QStringLiteral("calibrated_at"), siteWords(stylus.calibratedAt)}};
}

QJsonArray jsonTouched(const std::vector<TouchedPoint>& touched)
{
    QJsonArray points;
    for (const TouchedPoint& point : touched)
        points.append(QJsonObject{{QStringLiteral("landmark"), siteWords(point.landmark)},
                                  {QStringLiteral("p_TQ_mm"), jsonPoint(point.p_TQ)},
                                  {QStringLiteral("spread_mm"), jsonLength(point.spread)}});
    return points;
}

QJsonObject jsonRegistration(const SiteRegistration& registration)
{
    QJsonArray residuals;
    for (const LandmarkResidual& residual : registration.residuals)
        residuals.append(QJsonObject{{QStringLiteral("name"), siteWords(residual.landmark)},
                                     {QStringLiteral("mm"), jsonLength(residual.residual)}});
    QJsonObject object{{QStringLiteral("X_AM_mm"), jsonPose(registration.X_AM)},
                       {QStringLiteral("X_AT_mm"), jsonPose(registration.X_AT)},
                       {QStringLiteral("rms_mm"), jsonLength(registration.rms)},
                       {QStringLiteral("residuals_mm"), residuals}};
    if (registration.X_JM)
        object.insert(QStringLiteral("X_JM_mm"), jsonPose(*registration.X_JM));
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

QJsonObject jsonSite(const Site& site)
{
    QJsonObject object{{QStringLiteral("schema"), kSiteSchema},
                       {QStringLiteral("step"),
                        QString::fromLatin1(kStepWords[static_cast<std::size_t>(site.step)])}};
    if (!site.tracker.empty())
        object.insert(QStringLiteral("tracker"), siteWords(site.tracker));
    if (site.stylus)
        object.insert(QStringLiteral("stylus"), jsonStylus(*site.stylus));
    if (site.catalogue)
        object.insert(QStringLiteral("catalogue"), jsonCatalogue(*site.catalogue));
    if (!site.touched.empty())
        object.insert(QStringLiteral("touched"), jsonTouched(site.touched));
    if (site.registration)
        object.insert(QStringLiteral("registration"), jsonRegistration(*site.registration));
    if (site.display)
        object.insert(QStringLiteral("display"), jsonDisplay(*site.display));
    return object;
}

SiteStep readStep(JsonFields& fields)
{
    const std::string word = fields.text("step");
    const auto step = std::ranges::find(kStepWords, word);
    if (step == kStepWords.end()) {
        fields.refuse("step", "\"" + word + "\" is no step");
        return {};
    }
    return static_cast<SiteStep>(step - kStepWords.begin());
}

StylusTip readStylus(JsonFields fields)
{
    fields.allowOnly({"p_SQ_mm", "rms_mm", "calibrated_at"});
    StylusTip stylus{fields.point("p_SQ_mm"), fields.length("rms_mm"),
                     fields.text("calibrated_at")};
    if (!QDateTime::fromString(siteWords(stylus.calibratedAt), Qt::ISODate).isValid())
        fields.refuse("calibrated_at", "a date and time as in ISO 8601 is due");
    return stylus;
}

std::vector<TouchedPoint> readTouched(JsonFields& fields, const LandmarkCatalogue& catalogue)
{
    std::vector<TouchedPoint> touched;
    std::set<std::string> names;
    for (JsonFields& point : fields.objects("touched")) {
        point.allowOnly({"landmark", "p_TQ_mm", "spread_mm"});
        touched.push_back(
            {point.text("landmark"), point.point("p_TQ_mm"), point.length("spread_mm")});
        const std::string& name = touched.back().landmark;
        if (std::ranges::count(catalogue.landmarks, name, &Landmark::name) == 0)
            point.refuse("landmark", "\"" + name + "\" is not in the catalogue");
        if (!names.insert(name).second)
            point.refuse("landmark", "\"" + name + "\" is there twice");
    }
    return touched;
}

SiteRegistration readRegistration(JsonFields fields)
{
    fields.allowOnly({"X_AM_mm", "X_AT_mm", "X_JM_mm", "rms_mm", "residuals_mm"});
    SiteRegistration registration{.X_AM = fields.pose("X_AM_mm"),
                                  .X_AT = fields.pose("X_AT_mm"),
                                  .rms = fields.length("rms_mm")};
    if (fields.has("X_JM_mm"))
        registration.X_JM = fields.pose("X_JM_mm");
    for (JsonFields& residual : fields.objects("residuals_mm")) {
        residual.allowOnly({"name", "mm"});
        registration.residuals.push_back({residual.text("name"), residual.length("mm")});
    }
    return registration;
}

DisplayGeometry readDisplay(JsonFields fields)
{
    fields.allowOnly(
        {"p_HDl_mm", "p_HDr_mm", "p_HQ_screen_centre_mm", "screen_width_mm", "screen_height_mm"});
    const DisplayGeometry display{
        fields.point("p_HDl_mm"), fields.point("p_HDr_mm"), fields.point("p_HQ_screen_centre_mm"),
        fields.length("screen_width_mm"), fields.length("screen_height_mm")};
    if (display.screenWidth <= 0.0)
        fields.refuse("screen_width_mm", "a screen has some width");
    if (display.screenHeight <= 0.0)
        fields.refuse("screen_height_mm", "a screen has some height");
    return display;
}

Result<Site> readSite(const QJsonObject& object, const std::filesystem::path& file)
{
    std::optional<Error> fault;
    JsonFields fields{object, fault};
    fields.allowOnly(
        {"schema", "step", "tracker", "stylus", "catalogue", "touched", "registration", "display"});
    Site site{.step = readStep(fields)};
    if (fields.has("tracker"))
        site.tracker = fields.text("tracker");
    if (fields.has("stylus"))
        site.stylus = readStylus(fields.object("stylus"));
    if (fields.has("catalogue")) {
        JsonFields catalogue = fields.object("catalogue");
        site.catalogue = readCatalogue(catalogue);
    }
    if (fields.has("touched"))
        site.touched = readTouched(fields, site.catalogue.value_or(LandmarkCatalogue{}));
    if (fields.has("registration"))
        site.registration = readRegistration(fields.object("registration"));
    if (fields.has("display"))
        site.display = readDisplay(fields.object("display"));
    if (fault)
        return fail(fault->code, file.string() + ": " + fault->detail);
    return site;
}

} // namespace

Result<Site> readSiteFile(const std::filesystem::path& file)
{
    const Result<QJsonObject> object = readJsonFile(file, kSiteSchema);
    if (!object)
        return tl::unexpected(object.error());
    return readSite(*object, file);
}

Result<void> writeSiteFile(const std::filesystem::path& file, const Site& site)
{
    const QJsonObject object = jsonSite(site);
    if (const Result<Site> readable = readSite(object, file); !readable)
        return tl::unexpected(readable.error());
    return writeJsonFile(file, object);
}

} // namespace carina
