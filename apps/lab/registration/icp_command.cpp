#include "apps/lab/command/csv_table.h"
#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/registration/fit_page.h"
#include "engine/io/files/json_fields.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/mesh/surface_reader.h"
#include "engine/registration/fit/surface_refinement.h"

namespace carina::lab
{
namespace
{

namespace icp_option
{
constexpr Option kSurface{"surface", "FILE",
                          "the surface that was touched, in the axes of the anatomy and mm: OBJ, "
                          "PLY, STL, glTF or GLB; all surfaces of the file together"};
constexpr Option kSwab{"swab", "SWAB.csv", "the touched points"};
constexpr Option kStart{"start", "FIT.json", "the output of fit; its X_AM_mm is the initial pose"};
} // namespace icp_option

namespace icp_key
{
constexpr Key kSchema{"schema", "carina.icp/1"};
constexpr Key kPose{fit_key::kPose.name,
                    "the pose: four rows of four numbers, its translation in mm"};
constexpr Key kStartRms{"start_rms_mm",
                        "root mean square distance of all points from the surface before"};
constexpr Key kRms{"rms_mm", "the same afterwards, of the points that were not left out; it does "
                             "not show errors along the surface"};
constexpr Key kPoints{"points", "that were read"};
constexpr Key kOutliers{"outliers", "of these, left out"};
constexpr Key kIterations{"iterations", "number of iterations"};
constexpr Key kMoved{"moved_mm", "greatest distance by which a point was moved"};
constexpr Key kCentre{"centre_mm", "[x, y, z] of the centre of the points in the anatomy"};
constexpr Key kUncertainty{
    "uncertainty_mm", "root mean square error of the pose at that centre, without loose motions"};
constexpr Key kLoose{"loose",
                     "motions that the surface does not determine, and that were left as they "
                     "were; the squares of the six shares of each add up to 1:"};
constexpr Key kTurn{"turn", "[x, y, z] along the axis of a turn about the centre", 1};
constexpr Key kShift{"shift", "[x, y, z] of a shift", 1};
} // namespace icp_key

QJsonArray numbersOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Result<SurfaceTree> readSurface(const QString& file)
{
    SurfaceReader reader;
    const Result<MeshFile> read = reader.read(file.toStdString());
    if (!read)
        return tl::unexpected(read.error());
    TriangleMesh whole;
    for (const NamedSurface& surface : read->surfaces)
        append(whole, surface.mesh);
    for (Vec3f& p : whole.positions)
        p *= static_cast<float>(millimetres(1.0).si);
    return SurfaceTree{whole};
}

Result<std::vector<Vec3>> readSwab(const QString& file)
{
    const auto table = CsvTable::read(file, {"mx", "my", "mz"});
    if (!table)
        return tl::unexpected(table.error());
    std::vector<Vec3> p_MQ;
    for (std::size_t row = 0; row < table->rows(); ++row) {
        Vec3 p_mm;
        for (std::size_t i = 0; i < 3; ++i) {
            const Result<double> number = table->number(row, i);
            if (!number)
                return tl::unexpected(number.error());
            p_mm[Eigen::Index(i)] = *number;
        }
        p_MQ.push_back(millimetres(1.0).si * p_mm);
    }
    return p_MQ;
}

Result<RigidTransform> readStart(const QString& file)
{
    const Result<std::string> bytes = readWholeFile(file.toStdString(), kDescriptionLimit);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const Result<QJsonObject> object = jsonObjectIn(*bytes);
    std::optional<Error> fault;
    if (!object)
        fault = object.error();
    const RigidTransform X_AM =
        JsonFields{object.value_or(QJsonObject{}), fault}.pose(fit_key::kPose.name);
    if (fault)
        return fail(fault->code, file.toStdString() + ": " + fault->detail + '.');
    return X_AM;
}

QJsonObject describeRefinement(const SurfaceRefinement& fit, std::size_t points)
{
    QJsonArray loose;
    for (const SmallMotion& motion : fit.loose)
        loose.append(QJsonObject{{icp_key::kTurn, numbersOf(motion.turn_A)},
                                 {icp_key::kShift, numbersOf(motion.shift_A)}});
    return {{icp_key::kSchema, QLatin1StringView{icp_key::kSchema.help}},
            {icp_key::kPose, jsonPose(fit.X_AM)},
            {icp_key::kStartRms, inMillimetres(metres(fit.startRms))},
            {icp_key::kRms, inMillimetres(metres(fit.rms))},
            {icp_key::kPoints, static_cast<qint64>(points)},
            {icp_key::kOutliers, fit.outliers},
            {icp_key::kIterations, fit.iterations},
            {icp_key::kMoved, inMillimetres(metres(fit.moved))},
            {icp_key::kCentre, jsonPoint(fit.p_AC)},
            {icp_key::kUncertainty, inMillimetres(metres(fit.uncertaintyAt(fit.p_AC)))},
            {icp_key::kLoose, loose}};
}

Result<QJsonObject> runIcp(const Words& words)
{
    if (!words.has(icp_option::kSurface) || !words.has(icp_option::kSwab)
        || !words.has(icp_option::kStart))
        return words.refuse(
            QStringLiteral("needs --surface FILE, --swab SWAB.csv and --start FIT.json."));
    const auto X_AM = readStart(words.text(icp_option::kStart));
    if (!X_AM)
        return tl::unexpected(X_AM.error());
    const QString swab = words.text(icp_option::kSwab);
    const auto p_MQ = readSwab(swab);
    if (!p_MQ)
        return tl::unexpected(p_MQ.error());
    const auto tree = readSurface(words.text(icp_option::kSurface));
    if (!tree)
        return tl::unexpected(tree.error());
    const auto fit = refineOnSurface(*tree, *p_MQ, *X_AM);
    if (!fit)
        return fail(fit.error().code,
                    swab.toStdString() + " cannot be fitted: " + fit.error().detail + ".");
    return describeRefinement(*fit, p_MQ->size());
}

std::vector<Note> icpNotes()
{
    return {{"SWAB.csv", "a line of column names in any order, then one line for each point:"},
            {"  mx,my,mz", "where it was touched on the manikin, mm"},
            {"example", "mx,my,mz"},
            {"", "112.2,40.5,-1210.9"},
            {"", "... ; carina-lab fit pairs.csv > fit.json"},
            {"", "carina-lab icp --surface skin.stl --swab swab.csv --start fit.json"}};
}

} // namespace

Command icpCommand()
{
    return {.name = "icp",
            .theme = "registration",
            .summary = "refines that pose with points touched anywhere on a surface",
            .uses = {{.lines = {"--surface FILE --swab SWAB.csv --start FIT.json"},
                      .text = "Refines the pose of the manikin in the anatomy with points that a "
                              "stylus touched anywhere on a surface, by the iterative closest "
                              "point method (ICP) from the pose that the landmarks gave.",
                      .notes = icpNotes(),
                      .options = {icp_option::kSurface, icp_option::kSwab, icp_option::kStart},
                      .schema = icp_key::kSchema,
                      .keys = {icp_key::kPose, icp_key::kStartRms, icp_key::kRms, icp_key::kPoints,
                               icp_key::kOutliers, icp_key::kIterations, icp_key::kMoved,
                               icp_key::kCentre, icp_key::kUncertainty, icp_key::kLoose,
                               icp_key::kTurn, icp_key::kShift}}},
            .experiment = runIcp};
}

} // namespace carina::lab
