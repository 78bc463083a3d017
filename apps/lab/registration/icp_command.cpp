#include "apps/lab/registration/icp_command.h"

#include "apps/lab/command/command_options.h"
#include "apps/lab/command/csv_table.h"
#include "engine/io/files/json_fields.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/mesh/surface_reader.h"
#include "engine/registration/fit/surface_refinement.h"

namespace carina::lab
{
namespace
{

constexpr std::string_view kIcpHelp =
    R"(icp --surface FILE --swab SWAB.csv --start FIT.json
    Refines the pose of the manikin in the anatomy by points that a stylus touched anywhere on a
    surface: iterated closest points from the pose that landmarks gave.
    --surface FILE      the surface that was swabbed, in the anatomy's axes and mm: OBJ, PLY, STL,
                        glTF or GLB; all surfaces of the file together
    --swab SWAB.csv     a line of column names in any order, then one line for each point:
      mx,my,mz          where it was touched on the manikin, mm
    --start FIT.json    what fit printed: its X_AM_mm
    example             mx,my,mz
                        112.2,40.5,-1210.9
                        ... ; carina-lab fit pairs.csv > fit.json
                        carina-lab icp --surface skin.stl --swab swab.csv --start fit.json
    schema              "carina.icp/1"
    X_AM_mm             the pose: four rows of four numbers, its translation in mm
    start_rms_mm        root of the mean squared distance from the surface before, of all points
    rms_mm              the same after, of those not left out; it tells nothing about motions along
                        the surface
    points              read
    outliers            of these, left out
    iterations          steps
    moved_mm            the longest way that a point was moved
    centre_mm           [x, y, z] of the swab's centre in the anatomy
    uncertainty_mm      root of the mean squared error of the pose there, but for loose motions
    loose               motions that the surface does not hold and that stayed as they were; each
                        with shares whose squares add up to 1:
      turn              [x, y, z] along the axis of a turn about the centre
      shift             [x, y, z] of a shift
)";

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
    const Result<std::string> bytes = readWholeFile(file.toStdString());
    if (!bytes)
        return tl::unexpected(bytes.error());
    const Result<QJsonObject> object = jsonObjectIn(*bytes);
    std::optional<Error> fault;
    if (!object)
        fault = object.error();
    const RigidTransform X_AM = JsonFields{object.value_or(QJsonObject{}), fault}.pose("X_AM_mm");
    if (fault)
        return fail(fault->code, file.toStdString() + ": " + fault->detail + '.');
    return X_AM;
}

QJsonObject describeRefinement(const SurfaceRefinement& fit, std::size_t points)
{
    QJsonArray loose;
    for (const SmallMotion& motion : fit.loose)
        loose.append(QJsonObject{{QStringLiteral("turn"), numbersOf(motion.turn_A)},
                                 {QStringLiteral("shift"), numbersOf(motion.shift_A)}});
    return {{QStringLiteral("schema"), QStringLiteral("carina.icp/1")},
            {QStringLiteral("X_AM_mm"), jsonPose(fit.X_AM)},
            {QStringLiteral("start_rms_mm"), inMillimetres(metres(fit.startRms))},
            {QStringLiteral("rms_mm"), inMillimetres(metres(fit.rms))},
            {QStringLiteral("points"), static_cast<qint64>(points)},
            {QStringLiteral("outliers"), fit.outliers},
            {QStringLiteral("iterations"), fit.iterations},
            {QStringLiteral("moved_mm"), inMillimetres(metres(fit.moved))},
            {QStringLiteral("centre_mm"), jsonPoint(fit.p_AC)},
            {QStringLiteral("uncertainty_mm"), inMillimetres(metres(fit.uncertaintyAt(fit.p_AC)))},
            {QStringLiteral("loose"), loose}};
}

Result<QJsonObject> runIcp(const QStringList& arguments)
{
    const QString surface = QStringLiteral("surface");
    const QString swab = QStringLiteral("swab");
    const QString start = QStringLiteral("start");
    QCommandLineParser parser;
    addValueOptions(parser, {"surface", "swab", "start"});
    if (const auto parsed = parseOptions(parser, "icp", arguments); !parsed)
        return tl::unexpected(parsed.error());
    if (!parser.isSet(surface) || !parser.isSet(swab) || !parser.isSet(start))
        return fail(Errc::OutOfRange,
                    "icp needs --surface FILE, --swab SWAB.csv and --start FIT.json.");
    const auto X_AM = readStart(parser.value(start));
    if (!X_AM)
        return tl::unexpected(X_AM.error());
    const auto p_MQ = readSwab(parser.value(swab));
    if (!p_MQ)
        return tl::unexpected(p_MQ.error());
    const auto tree = readSurface(parser.value(surface));
    if (!tree)
        return tl::unexpected(tree.error());
    const auto fit = refineOnSurface(*tree, *p_MQ, *X_AM);
    if (!fit)
        return fail(fit.error().code, parser.value(swab).toStdString()
                                          + " cannot be fitted: " + fit.error().detail + ".");
    return describeRefinement(*fit, p_MQ->size());
}

} // namespace

Command icpCommand() { return {"icp", kIcpHelp, runIcp}; }

} // namespace carina::lab
