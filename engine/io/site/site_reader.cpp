#include "engine/core/units.h"
#include "engine/io/site/catalogue_json.h"
#include "engine/io/site/devices/device_json.h"
#include "engine/io/site/manikin_json.h"
#include "engine/io/site/site_fields.h"
#include "engine/io/site/tool_json.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace carina
{
namespace
{

constexpr double kUnitTolerance = 1e-6; ///< of a direction and a quaternion that a person wrote

StylusAxis readAxis(JsonFields fields)
{
    fields.allowOnly({"axis_S", "wobble_deg", "calibrated_at"});
    const std::vector<double> axis = fields.numbers("axis_S", 3);
    const Vec3 axis_S{axis[0], axis[1], axis[2]};
    if (std::abs(axis_S.norm() - 1.0) > kUnitTolerance)
        fields.refuse("axis_S", "a direction of length 1 is expected");
    const double wobble_deg = fields.amount("wobble_deg");
    return {axis_S, degrees(wobble_deg), readTime(fields, "calibrated_at")};
}

StylusTip readStylus(JsonFields fields)
{
    fields.allowOnly({"tool", "p_SQ_mm", "rms_mm", "calibrated_at", "covariance_S_mm2", "poses",
                      "outliers", "axis"});
    StylusTip stylus{.p_SQ = fields.point("p_SQ_mm"),
                     .rms = fields.length("rms_mm"),
                     .calibratedAt = readTime(fields, "calibrated_at"),
                     .tool = readText(fields, "tool"),
                     .covariance_S = readCovariance<3>(fields, "covariance_S_mm2")};
    if (fields.has("poses"))
        stylus.poses = fields.count("poses");
    if (fields.has("outliers"))
        stylus.outliers = fields.count("outliers");
    if (fields.has("axis"))
        stylus.axis = readAxis(fields.object("axis"));
    return stylus;
}

std::vector<StylusTip> readStyluses(JsonFields& fields)
{
    std::vector<StylusTip> styluses;
    if (fields.has("stylus")) // of the version before
        styluses.push_back(readStylus(fields.object("stylus")));
    if (!fields.has("styluses"))
        return styluses;
    for (JsonFields& each : fields.objects("styluses")) {
        StylusTip stylus = readStylus(each);
        if (std::ranges::count(styluses, stylus.tool, &StylusTip::tool) > 0)
            each.refuse("tool", "\"" + stylus.tool + "\" is there twice");
        styluses.push_back(std::move(stylus));
    }
    return styluses;
}

std::vector<SiteTool> readSiteTools(JsonFields& fields)
{
    std::vector<SiteTool> tools;
    for (JsonFields& each : fields.objects("tools")) {
        SiteTool tool = readTool(each);
        if (toolOfRole(tools, tool.role))
            each.refuse("role", "it is there twice");
        tools.push_back(std::move(tool));
    }
    return tools;
}

Quat readTurn(JsonFields& fields, const char* key)
{
    if (!fields.has(key))
        return Quat::Identity();
    const std::vector<double> q = fields.numbers(key, 4);
    const Quat turn{q[3], q[0], q[1], q[2]};
    if (std::abs(turn.norm() - 1.0) > kUnitTolerance) {
        fields.refuse(key, "a quaternion of length 1 is expected");
        return Quat::Identity();
    }
    return turn.normalized();
}

std::vector<TouchedPoint> readTouched(JsonFields& fields, const char* key,
                                      const LandmarkCatalogue& catalogue)
{
    std::vector<TouchedPoint> touched;
    std::set<std::string> names;
    for (JsonFields& point : fields.objects(key)) {
        point.allowOnly(
            {"landmark", "p_TQ_mm", "spread_mm", "q_TS", "seen_error_mm", "fitted", "stale"});
        touched.push_back({.landmark = point.text("landmark"),
                           .p_TQ = point.point("p_TQ_mm"),
                           .spread = point.length("spread_mm"),
                           .q_TS = readTurn(point, "q_TS"),
                           .isFitted = point.has("fitted") && point.truth("fitted"),
                           .stale = readStale(point)});
        if (point.has("seen_error_mm"))
            touched.back().seenError = point.length("seen_error_mm");
        const std::string& name = touched.back().landmark;
        if (std::ranges::count(catalogue.landmarks, name, &Landmark::name) == 0)
            point.refuse("landmark", "\"" + name + "\" is not in the catalogue");
        if (!names.insert(name).second)
            point.refuse("landmark", "\"" + name + "\" is there twice");
    }
    return touched;
}

SiteSwab readSwab(JsonFields fields)
{
    fields.allowOnly({"surface", "points", "outliers", "start_rms_mm", "rms_mm", "moved_mm"});
    return {.surface = fields.text("surface"),
            .points = fields.count("points"),
            .outliers = fields.count("outliers"),
            .startRms = fields.length("start_rms_mm"),
            .rms = fields.length("rms_mm"),
            .moved = fields.length("moved_mm")};
}

std::vector<LandmarkResidual> readResiduals(JsonFields& fields)
{
    std::vector<LandmarkResidual> residuals;
    for (JsonFields& each : fields.objects("residuals_mm")) {
        each.allowOnly({"name", "mm", "left_out_mm"});
        LandmarkResidual residual{.landmark = each.text("name"), .residual = each.length("mm")};
        if (each.has("left_out_mm"))
            residual.leftOut = each.length("left_out_mm");
        residuals.push_back(std::move(residual));
    }
    return residuals;
}

std::vector<SiteRelay> readRelays(JsonFields& fields)
{
    std::vector<SiteRelay> relays;
    for (JsonFields& relay : fields.objects("relays")) {
        relay.allowOnly({"at", "operator", "landmarks", "rms_mm"});
        relays.push_back({.at = readTime(relay, "at"),
                          .operatorName = readText(relay, "operator"),
                          .landmarks = relay.count("landmarks"),
                          .rms = relay.length("rms_mm")});
    }
    return relays;
}

/// What the version before did not have.
void readMoreOf(SiteRegistration& registration, JsonFields& fields)
{
    for (const auto& [key, pose] :
         {std::pair{"X_JM_mm", &registration.X_JM}, std::pair{"X_BM_mm", &registration.X_BM}})
        if (fields.has(key))
            *pose = fields.pose(key);
    registration.covariance_A = readCovariance<6>(fields, "covariance_mm_mrad");
    if (fields.has("fle_mm"))
        registration.fle = fields.length("fle_mm");
    if (fields.has("degrees_of_freedom"))
        registration.degrees = fields.count("degrees_of_freedom");
    if (fields.has("pooled"))
        registration.pooled = fields.count("pooled");
    if (fields.has("disagreeing"))
        registration.disagreeing = fields.count("disagreeing");
    if (registration.degrees > 0.0 && !(registration.fle > 0.0))
        fields.refuse("fle_mm", "an error estimated from residuals is above 0");
    if (fields.has("made_at"))
        registration.madeAt = readTime(fields, "made_at");
    if (fields.has("swab"))
        registration.swab = readSwab(fields.object("swab"));
    if (fields.has("relays"))
        registration.relays = readRelays(fields);
    registration.operatorName = readText(fields, "operator");
    registration.stale = readStale(fields);
}

SiteRegistration readRegistration(JsonFields fields)
{
    fields.allowOnly({"X_AM_mm", "X_AT_mm", "X_JM_mm", "X_BM_mm", "rms_mm", "residuals_mm",
                      "covariance_mm_mrad", "fle_mm", "degrees_of_freedom", "pooled", "disagreeing",
                      "made_at", "operator", "swab", "relays", "stale"});
    SiteRegistration registration{.X_AM = fields.pose("X_AM_mm"),
                                  .X_AT = fields.pose("X_AT_mm"),
                                  .rms = fields.length("rms_mm"),
                                  .residuals = readResiduals(fields)};
    readMoreOf(registration, fields);
    return registration;
}

std::vector<SiteLocalisation> readLocalisations(JsonFields& fields)
{
    std::vector<SiteLocalisation> localisations;
    for (JsonFields& each : fields.objects("localisations")) {
        each.allowOnly({"rms_mm", "degrees_of_freedom", "at", "operator"});
        SiteLocalisation localisation{.rms = each.length("rms_mm"),
                                      .degrees = double(each.count("degrees_of_freedom"))};
        if (!(localisation.rms > 0.0))
            each.refuse("rms_mm", "an error estimated from residuals is above 0");
        if (!(localisation.degrees > 0.0))
            each.refuse("degrees_of_freedom", "one or more are expected");
        if (each.has("at"))
            localisation.at = readTime(each, "at");
        localisation.operatorName = readText(each, "operator");
        localisations.push_back(std::move(localisation));
    }
    return localisations;
}

SiteVerification readVerification(JsonFields fields)
{
    fields.allowOnly({"verdict", "at", "operator", "points", "stale"});
    SiteVerification verification{.verdict =
                                      static_cast<Verdict>(fields.oneOf("verdict", kVerdictWords)),
                                  .operatorName = readText(fields, "operator"),
                                  .stale = readStale(fields)};
    if (verification.verdict != Verdict::Open)
        verification.at = readTime(fields, "at");
    std::set<std::string> names;
    for (JsonFields& point : fields.objects("points")) {
        point.allowOnly({"name", "p_AQ_mm", "p_TQ_mm", "error_mm", "bound_mm"});
        verification.points.push_back({.name = point.text("name"),
                                       .p_AQ = point.point("p_AQ_mm"),
                                       .p_TQ = point.point("p_TQ_mm"),
                                       .error = point.length("error_mm"),
                                       .bound = point.length("bound_mm")});
        const std::string& name = verification.points.back().name;
        if (!names.insert(name).second)
            point.refuse("name", "\"" + name + "\" is there twice");
    }
    return verification;
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

} // namespace

Site readSite(JsonFields& fields)
{
    fields.allowOnly({"schema", "step", "operator", "tracker", "devices", "stylus", "styluses",
                      "tools", "patient", "catalogue", "touched", "registration", "localisations",
                      "relay", "verification", "display", "manikin"});
    Site site{.step = static_cast<SiteStep>(fields.oneOf("step", kStepWords)),
              .operatorName = readText(fields, "operator"),
              .tracker = readText(fields, "tracker"),
              .styluses = readStyluses(fields),
              .patient = readText(fields, "patient")};
    if (fields.has("devices"))
        site.devices = readDevices(fields);
    if (fields.has("tools"))
        site.tools = readSiteTools(fields);
    if (fields.has("catalogue")) {
        JsonFields object = fields.object("catalogue");
        site.catalogue = readCatalogue(object);
    }
    const LandmarkCatalogue catalogue = site.catalogue.value_or(LandmarkCatalogue{});
    if (fields.has("touched"))
        site.touched = readTouched(fields, "touched", catalogue);
    if (fields.has("registration"))
        site.registration = readRegistration(fields.object("registration"));
    if (fields.has("localisations"))
        site.localisations = readLocalisations(fields);
    if (fields.has("relay")) {
        site.relay = readTouched(fields, "relay", catalogue);
        if (!site.registration)
            fields.refuse("relay", "only a registered manikin is laid anew");
    }
    if (fields.has("verification"))
        site.verification = readVerification(fields.object("verification"));
    if (fields.has("display"))
        site.display = readDisplay(fields.object("display"));
    if (fields.has("manikin")) {
        JsonFields object = fields.object("manikin");
        site.manikin = readManikin(object);
    }
    return site;
}

} // namespace carina
