#include "apps/lab/render_command.h"

#include "apps/lab/geometry_check.h"
#include "engine/anatomy/builtin_patient.h"

#include <QCommandLineParser>

#include <cmath>

namespace carina::lab
{
namespace
{

Result<GeometryTrial> trialOf(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.addOption(QCommandLineOption{QStringLiteral("check-geometry")});
    parser.addOption(QCommandLineOption{QStringLiteral("seed"), {}, QStringLiteral("K")});
    if (!parser.parse(QStringList{QStringLiteral("render")} + arguments)
        || !parser.positionalArguments().isEmpty()
        || !parser.isSet(QStringLiteral("check-geometry")))
        return fail(Errc::OutOfRange, "render takes --check-geometry [--seed K].");
    GeometryTrial trial;
    if (parser.isSet(QStringLiteral("seed"))) {
        bool isNumber = false;
        trial.seed = parser.value(QStringLiteral("seed")).toUInt(&isNumber);
        if (!isNumber)
            return fail(Errc::OutOfRange, "render needs --seed with a whole number from 0 on.");
    }
    return trial;
}

Result<QJsonObject> renderChecked(const QStringList& arguments)
{
    const auto trial = trialOf(arguments);
    if (!trial)
        return tl::unexpected(trial.error());
    const auto patient = builtinPatient(BuiltinPatient::TwelveYears);
    if (!patient)
        return tl::unexpected(patient.error());
    const auto errors = checkGeometry(patient->landmarks, *trial);
    if (!errors)
        return tl::unexpected(errors.error());
    return QJsonObject{{QStringLiteral("schema"), QStringLiteral("carina.render/1")},
                       {QStringLiteral("poses"), trial->poses},
                       {QStringLiteral("geometries"), trial->geometries},
                       {QStringLiteral("seed"), qint64(trial->seed)},
                       {QStringLiteral("spheres_measured"), errors->measured},
                       {QStringLiteral("left_out_at_edge"), errors->outside},
                       {QStringLiteral("left_out_touching"), errors->touching},
                       {QStringLiteral("not_visible"), errors->notDrawn},
                       {QStringLiteral("smallest_sphere_px"), errors->smallestBall_px},
                       {QStringLiteral("max_projection_error_px"), errors->largest_px},
                       {QStringLiteral("mean_projection_error_px"), errors->mean_px}};
}

constexpr std::string_view kRenderHelp = R"(render --check-geometry [--seed K]
    Draws small spheres at the carina, the glottis, the incisors, both bases of the lungs and to
    either side of the built-in child's head as a headset shows them, side by side, for 50 poses of
    the head with each of 20 geometries of eyes and screen, reads the picture back, and compares the
    middle of each sphere's pixels in each eye with where the line from the eye to the sphere meets
    the screen. K picks other poses and geometries (1). Needs a display. schema carina.render/1
      poses, geometries, seed   what was drawn
      spheres_measured          once for each sphere, pose, geometry and eye
      left_out_at_edge          not measured: outside the picture or cut by its edge
      left_out_touching         not measured: touching another sphere in the picture
      not_visible               should have been seen, and no pixel shows them
      smallest_sphere_px        pixels of the smallest sphere measured
      max_projection_error_px, mean_projection_error_px
                                distance from where the sphere should be seen
)";

} // namespace

Command renderCommand() { return {"render", kRenderHelp, renderChecked}; }

} // namespace carina::lab
