#include "engine/io/site/tool_json.h"

#include "engine/io/site/site_fields.h"
#include "engine/tracking/tool_role.h"

#include <cmath>

namespace carina
{
namespace
{

constexpr std::array kSiteToolWords{"tube", "laryngoscope"};
constexpr std::array kSiteToolRoles{ToolRole::Tube, ToolRole::Laryngoscope};
constexpr Length kLongestTool = metres(1.0);
constexpr double kStrongestBend = 100.0; ///< 1/m

QJsonObject jsonTubeRest(const TubeRest& tube)
{
    return {{QStringLiteral("length_mm"), inMillimetres(tube.length)},
            {QStringLiteral("bends_per_m"), QJsonArray{tube.bends[0], tube.bends[1]}},
            {QStringLiteral("outer_diameter_mm"), inMillimetres(tube.outerDiameter)}};
}

QJsonObject jsonBlade(const BladeShape& blade)
{
    return {{QStringLiteral("heel_width_mm"), inMillimetres(blade.heelWidth)},
            {QStringLiteral("handle_mm"), inMillimetres(blade.handle)},
            {QStringLiteral("p_L_tip_mm"), jsonPoint(blade.p_L_tip)},
            {QStringLiteral("p_L_half_mm"), jsonPoint(blade.p_L_half)}};
}

/// A length of something that a hand holds.
Length readSize(JsonFields& fields, const char* key)
{
    const Length size = metres(fields.length(key));
    if (!(size > metres(0.0) && size <= kLongestTool))
        fields.refuse(key, "above 0 and at most 1000 is expected");
    return size;
}

TubeRest readTubeRest(JsonFields fields)
{
    fields.allowOnly({"length_mm", "bends_per_m", "outer_diameter_mm"});
    TubeRest tube{.length = readSize(fields, "length_mm"),
                  .outerDiameter = readSize(fields, "outer_diameter_mm")};
    const std::vector<double> bends = fields.numbers("bends_per_m", 2);
    tube.bends = {bends[0], bends[1]};
    if (std::abs(bends[0]) > kStrongestBend || std::abs(bends[1]) > kStrongestBend)
        fields.refuse("bends_per_m", "no tube is bent so much");
    if (4.0 * tube.outerDiameter > tube.length)
        fields.refuse("outer_diameter_mm", "no tube is so thick");
    return tube;
}

BladeShape readBlade(JsonFields fields)
{
    fields.allowOnly({"heel_width_mm", "handle_mm", "p_L_tip_mm", "p_L_half_mm"});
    const BladeShape blade{.heelWidth = readSize(fields, "heel_width_mm"),
                           .handle = readSize(fields, "handle_mm"),
                           .p_L_tip = fields.point("p_L_tip_mm"),
                           .p_L_half = fields.point("p_L_half_mm")};
    if (!(blade.p_L_tip.z() < 0.0 && blade.p_L_tip.norm() <= kLongestTool.si))
        fields.refuse("p_L_tip_mm", "a blade points along -z");
    if (blade.p_L_half.norm() > kLongestTool.si)
        fields.refuse("p_L_half_mm", "it is on the blade");
    return blade;
}

SiteToolCheck readCheck(JsonFields fields)
{
    fields.allowOnly({"at", "error_mm", "bound_mm"});
    return {.tip = {metres(fields.length("error_mm")), metres(fields.length("bound_mm"))},
            .at = readTime(fields, "at")};
}

} // namespace

QJsonObject jsonTool(const SiteTool& tool)
{
    QJsonObject object{{QStringLiteral("role"), QString::fromLatin1(toolRoleWord(tool.role))},
                       {QStringLiteral("X_NO_mm"), jsonPose(tool.X_NO)},
                       {QStringLiteral("rms_mm"), jsonLength(tool.rms)},
                       {QStringLiteral("fle_mm"), jsonLength(tool.fle)},
                       {QStringLiteral("degrees_of_freedom"), tool.degrees},
                       {QStringLiteral("covariance_N_mm2"), jsonTriangle(tool.covariance_N)},
                       {QStringLiteral("touches"), tool.touches},
                       {QStringLiteral("calibrated_at"), jsonWords(tool.calibratedAt)}};
    insertText(object, "tool", tool.tool);
    insertText(object, "operator", tool.operatorName);
    if (tool.tube)
        object.insert(QStringLiteral("tube"), jsonTubeRest(*tool.tube));
    if (tool.blade)
        object.insert(QStringLiteral("blade"), jsonBlade(*tool.blade));
    if (tool.check)
        object.insert(
            QStringLiteral("check"),
            QJsonObject{{QStringLiteral("at"), jsonWords(tool.check->at)},
                        {QStringLiteral("error_mm"), inMillimetres(tool.check->tip.error)},
                        {QStringLiteral("bound_mm"), inMillimetres(tool.check->tip.bound)}});
    insertStale(object, tool.stale);
    return object;
}

SiteTool readTool(JsonFields& fields)
{
    fields.allowOnly({"role", "tool", "X_NO_mm", "tube", "blade", "rms_mm", "fle_mm",
                      "degrees_of_freedom", "covariance_N_mm2", "touches", "calibrated_at",
                      "operator", "check", "stale"});
    SiteTool tool{.role = kSiteToolRoles[fields.oneOf("role", kSiteToolWords)],
                  .tool = readText(fields, "tool"),
                  .X_NO = fields.pose("X_NO_mm"),
                  .rms = fields.length("rms_mm"),
                  .fle = fields.length("fle_mm"),
                  .degrees = double(fields.count("degrees_of_freedom")),
                  .covariance_N = readCovariance<3>(fields, "covariance_N_mm2"),
                  .touches = fields.count("touches"),
                  .calibratedAt = readTime(fields, "calibrated_at"),
                  .operatorName = readText(fields, "operator"),
                  .stale = readStale(fields)};
    if (!(tool.degrees > 0.0))
        fields.refuse("degrees_of_freedom", "one or more are expected");
    if (tool.role == ToolRole::Tube)
        tool.tube = readTubeRest(fields.object("tube"));
    else
        tool.blade = readBlade(fields.object("blade"));
    if (fields.has(tool.tube ? "blade" : "tube"))
        fields.refuse("role", "it has the shape of another tool");
    if (fields.has("check"))
        tool.check = readCheck(fields.object("check"));
    return tool;
}

} // namespace carina
