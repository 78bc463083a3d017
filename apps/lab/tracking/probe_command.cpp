#include "apps/lab/command/csv_table.h"
#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/tracking/probe_drawing.h"
#include "apps/lab/tracking/probe_solid.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/site/devices/tracker_file.h"
#include "engine/tracking/markers/marker_search.h"
#include "engine/tracking/markers/probe_design.h"

#include <QJsonArray>

namespace carina::lab
{
namespace
{

namespace probe_option
{
constexpr Option kDesign{"design", "", "search a layout on a ball instead of reading one"};
constexpr Option kMarkers{"markers", "N", "of the design, 4 to 20; 20 unless given"};
constexpr Option kRadius{"radius-mm", "MM", "of its ball, 10 to 500; 100 unless given"};
constexpr Option kSeen{"seen", "K", "markers that are to be seen; 6 unless given"};
constexpr Option kShare{"share", "P", "of the directions in which they are; 0.95 unless given"};
constexpr Option kSeed{"seed", "N", "another number gives another layout; 1 unless given"};
constexpr Option kNoise{"noise-mm", "MM",
                        "error of one marker, root mean square length; 0.1 unless given"};
constexpr Option kDepth{"depth-ratio", "X",
                        "how many times larger it is along the line of sight than in each "
                        "direction across, 0.1 to 20; 1 unless given"};
constexpr Option kOutward{
    "outward-mm", "MM", "constant shift of each marker along its normal, -5 to 5; 0 unless given"};
constexpr Option kPoint{"point", "X,Y,Z",
                        "the point of the tool at which the error counts, mm; 0,0,0 unless given"};
constexpr Option kAngle{
    "angle-deg", "DEG",
    "up to which a marker is seen from its normal, 10 to 180, with --rom in whole "
    "degrees; 90, or what the .rom file says, unless given"};
constexpr Option kRom{"rom", "FILE",
                      "write the layout as a tool definition of NDI; of one that was read all but "
                      "the angle stays as it is"};
constexpr Option kSvg{"svg", "FILE", "write a drawing"};
constexpr Option kStl{"stl", "FILE", "write a solid to be printed"};
constexpr Option kSeat{"seat-mm", "MM",
                       "from the seat on the solid to the middle of its marker, 0 to 50; 0 unless "
                       "given"};
} // namespace probe_option

namespace probe_key
{
constexpr Key kSchema{"schema", "carina.probe/1"};
constexpr Key kFile{"file", "FILE as given; null for a design"};
constexpr Key kCount{"marker_count", "of the probe"};
constexpr Key kRadius{"radius_mm", "distance of the farthest marker from the origin"};
constexpr Key kClosest{"closest_markers_mm", "distance of the two that are nearest to each other"};
constexpr Key kNoise{"noise_mm", "as given"};
constexpr Key kRotation{"rotation_rms_deg",
                        "predicted error of the rotation, root mean square over all directions "
                        "from which there is a pose"};
constexpr Key kPosition{"position_rms_mm", "the same of the point"};
constexpr Key kRotation35{"rotation_rms_deg_at_0.35mm", "the same for markers with 0.35 mm"};
constexpr Key kPosition35{"position_rms_mm_at_0.35mm", "the same of the point"};
constexpr Key kPosed{"share_with_pose", "of the directions"};
constexpr Key kIdentified{
    "share_identified", "of the directions in which it is found out, without a known order, which "
                        "marker is which"};
constexpr Key kFewest{"fewest_seen", "markers, in any direction"};
constexpr Key kSeen{"share_with_markers", "[k] is the share of directions in which at least k are "
                                          "seen"};
constexpr Key kMarkers{"markers", "one object for each:"};
constexpr Key kPlace{"p_mm", "[x, y, z] in the frame of the tool", 1};
constexpr Key kNormal{"normal", "where it faces; null where it is seen from everywhere", 1};
} // namespace probe_key

constexpr const char* kProbeReminder = "probe needs FILE, a .rom or .csv file, or --design.";
constexpr int kSearchedDirections = 200; ///< directions in which the order is searched

Result<Vec3> probePoint(const Words& words)
{
    if (!words.has(probe_option::kPoint))
        return Vec3::Zero();
    const QStringList parts = words.text(probe_option::kPoint).split(QLatin1Char{','});
    Vec3 p_mm = Vec3::Zero();
    bool isGood = parts.size() == 3;
    for (int i = 0; isGood && i < 3; ++i)
        p_mm[i] = parts[i].toDouble(&isGood);
    if (!isGood || !p_mm.allFinite() || p_mm.norm() > 2000.0)
        return words.refuse(QStringLiteral("needs --point X,Y,Z in mm."));
    return Vec3{millimetres(1.0).si * p_mm};
}

Result<MarkerNoise> probeNoise(const Words& words)
{
    const auto rms = words.number(probe_option::kNoise, 1e-4, 10.0, 0.1);
    const auto ratio = words.number(probe_option::kDepth, 0.1, 20.0, 1.0);
    const auto outward = words.number(probe_option::kOutward, -5.0, 5.0, 0.0);
    for (const auto* each : {&rms, &ratio, &outward})
        if (!*each)
            return tl::unexpected(each->error());
    return MarkerNoise{millimetres(*rms), *ratio, millimetres(*outward)};
}

Result<Probe> readLayout(const QString& file)
{
    const auto table = CsvTable::read(file, {"x_mm", "y_mm", "z_mm", "nx", "ny", "nz"});
    if (!table)
        return tl::unexpected(table.error());
    Probe probe;
    for (std::size_t row = 0; row < table->rows(); ++row) {
        Eigen::Matrix<double, 6, 1> numbers;
        for (int i = 0; i < 6; ++i) {
            const Result<double> number = table->number(row, std::size_t(i));
            if (!number)
                return tl::unexpected(number.error());
            numbers[i] = *number;
        }
        probe.markers.push_back({millimetres(1.0).si * numbers.head<3>(), numbers.tail<3>()});
    }
    // The same is asked of a layout as of a tool of NDI, which it is to become.
    return NdiToolDefinition::make(NdiToolDefinition::Kind::Reference, probe.markers, {}, {})
        .map([&](const NdiToolDefinition&) { return probe; })
        .map_error([&](const Error& error) {
            return Error{error.code, file.toStdString() + ": " + error.detail};
        });
}

Result<ProbeGoal> probeGoal(const Words& words, const MarkerNoise& noise, const Vec3& p_OQ)
{
    const auto markers = words.whole(probe_option::kMarkers, 4, 20, 20);
    const auto radius = words.number(probe_option::kRadius, 10.0, 500.0, 100.0);
    const auto seen = words.whole(probe_option::kSeen, 3, 20, 6);
    const auto share = words.number(probe_option::kShare, 0.0, 1.0, 0.95);
    const auto seed = words.whole(probe_option::kSeed, 0, 1'000'000, 1);
    const auto angle = words.number(probe_option::kAngle, 10.0, 180.0, 90.0);
    for (const auto* each : {&radius, &share, &angle})
        if (!*each)
            return tl::unexpected(each->error());
    for (const auto* each : {&markers, &seen, &seed})
        if (!*each)
            return tl::unexpected(each->error());
    return ProbeGoal{.markers = int(*markers),
                     .radius = millimetres(*radius),
                     .largestAngle = degrees(*angle),
                     .seen = std::size_t(*seen),
                     .share = *share,
                     .noise = noise,
                     .p_OQ = p_OQ,
                     .seed = std::uint32_t(*seed)};
}

bool isTable(const QString& file)
{
    return file.endsWith(QLatin1String{".csv"}, Qt::CaseInsensitive);
}

/// The layout that is told of, and the definition that it was read from, if it was from one.
struct ChosenProbe {
    Probe probe;
    std::optional<NdiToolDefinition> definition{};
};

Result<ChosenProbe> readProbe(const QString& file)
{
    if (isTable(file))
        return readLayout(file).map([](const Probe& probe) { return ChosenProbe{probe}; });
    return readToolDefinition(file.toStdString()).map([](const NdiToolDefinition& tool) {
        return ChosenProbe{tool.probe(), tool};
    });
}

Result<ChosenProbe> chosenProbe(const Words& words, const MarkerNoise& noise, const Vec3& p_OQ)
{
    if (words.has(probe_option::kDesign) == !words.files().isEmpty())
        return words.refuse(QStringLiteral("needs FILE or --design, and not both."));
    if (words.has(probe_option::kDesign))
        return probeGoal(words, noise, p_OQ).and_then(designProbe).map([](const Probe& probe) {
            return ChosenProbe{probe};
        });
    Result<ChosenProbe> chosen = readProbe(words.files().front());
    if (!chosen || !words.has(probe_option::kAngle))
        return chosen;
    const auto angle = words.number(probe_option::kAngle, 10.0, 180.0);
    if (!angle)
        return tl::unexpected(angle.error());
    chosen->probe.largestAngle = degrees(*angle);
    return chosen;
}

/// The share of the directions in which the markers that are seen are told apart.
double shareIdentified(const Probe& probe)
{
    int found = 0;
    for (const Vec3& d_O : directionsAllRound(kSearchedDirections)) {
        // The tool a metre before the tracker, so that this direction points at it.
        const Quat q_TO = Quat::FromTwoVectors(d_O, Vec3::UnitZ());
        const RigidTransform X_TO{q_TO, Vec3{0.0, 0.0, -1.0}};
        std::vector<Vec3> points;
        for (const std::size_t i : facingMarkers(probe, d_O))
            points.push_back(X_TO * probe.markers[i].p_OQ);
        const auto markers = searchMarkers(probe, points);
        found += markers && markers->size() + 1 >= points.size() ? 1 : 0;
    }
    return double(found) / kSearchedDirections;
}

/// As it was read, but for the angle; or what Carina makes of a layout.
Result<NdiToolDefinition> definitionOf(const ChosenProbe& chosen)
{
    if (!chosen.definition)
        return NdiToolDefinition::make(NdiToolDefinition::Kind::Reference, chosen.probe, "Carina",
                                       "probe");
    NdiToolDefinition::Facts facts = chosen.definition->facts();
    facts.largestMarkerAngle = chosen.probe.largestAngle;
    return chosen.definition->with(facts);
}

Result<void> writeDefinition(const std::string& file, const NdiToolDefinition& tool)
{
    const auto& bytes = tool.bytes();
    return writeWholeFile(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Result<void> writeProbe(const Words& words, const ChosenProbe& chosen)
{
    const Probe& probe = chosen.probe;
    const auto seat = words.number(probe_option::kSeat, 0.0, 50.0, 0.0);
    if (!seat)
        return tl::unexpected(seat.error());
    if (words.has(probe_option::kRom)) {
        const std::string file = words.text(probe_option::kRom).toStdString();
        const auto wrote = definitionOf(chosen).and_then(
            [&](const NdiToolDefinition& tool) { return writeDefinition(file, tool); });
        if (!wrote)
            return wrote;
    }
    const std::string title = std::to_string(probe.markers.size()) + " markers";
    if (words.has(probe_option::kSvg))
        if (const auto wrote = writeWholeFile(words.text(probe_option::kSvg).toStdString(),
                                              drawingOf(probe, title));
            !wrote)
            return wrote;
    if (words.has(probe_option::kStl))
        return writeWholeFile(words.text(probe_option::kStl).toStdString(),
                              stlOf(solidOf(probe, millimetres(*seat)), title));
    return {};
}

QJsonArray placeOf(const Vec3& p) { return {1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z()}; }

QJsonArray markerObjects(const Probe& probe)
{
    QJsonArray markers;
    for (const ToolMarker& marker : probe.markers)
        markers.append(
            QJsonObject{{probe_key::kPlace, placeOf(marker.p_OQ)},
                        {probe_key::kNormal,
                         marker.normal_O.isZero()
                             ? QJsonValue{}
                             : QJsonValue{QJsonArray{marker.normal_O.x(), marker.normal_O.y(),
                                                     marker.normal_O.z()}}}});
    return markers;
}

QJsonObject probeObject(const Probe& probe, const MarkerNoise& noise, const Vec3& p_OQ)
{
    const ProbeSurvey survey = surveyProbe(probe, noise, p_OQ);
    MarkerNoise polaris = noise;
    polaris.rms = kPolarisNoise.rms;
    const ProbeSurvey at35 = surveyProbe(probe, polaris, p_OQ);
    double radius = 0.0;
    for (const ToolMarker& marker : probe.markers)
        radius = std::max(radius, marker.p_OQ.norm());
    QJsonArray shares;
    for (const double share : survey.share)
        shares.append(share);
    return {{probe_key::kSchema, QLatin1StringView{probe_key::kSchema.help}},
            {probe_key::kCount, qint64(probe.markers.size())},
            {probe_key::kRadius, inMillimetres(metres(radius))},
            {probe_key::kClosest, inMillimetres(closestMarkers(probe))},
            {probe_key::kNoise, inMillimetres(noise.rms)},
            {probe_key::kRotation, inDegrees(survey.rotation)},
            {probe_key::kPosition, inMillimetres(survey.position)},
            {probe_key::kRotation35, inDegrees(at35.rotation)},
            {probe_key::kPosition35, inMillimetres(at35.position)},
            {probe_key::kPosed, survey.posed},
            {probe_key::kIdentified, shareIdentified(probe)},
            {probe_key::kFewest, qint64(survey.fewest)},
            {probe_key::kSeen, shares},
            {probe_key::kMarkers, markerObjects(probe)}};
}

Result<QJsonObject> describeProbe(const Words& words)
{
    const Result<MarkerNoise> noise = probeNoise(words);
    if (!noise)
        return tl::unexpected(noise.error());
    const Result<Vec3> p_OQ = probePoint(words);
    if (!p_OQ)
        return tl::unexpected(p_OQ.error());
    const Result<ChosenProbe> layout = chosenProbe(words, *noise, *p_OQ);
    if (!layout)
        return tl::unexpected(layout.error());
    if (const auto wrote = writeProbe(words, *layout); !wrote)
        return tl::unexpected(wrote.error());
    QJsonObject object = probeObject(layout->probe, *noise, *p_OQ);
    object[probe_key::kFile] =
        words.files().isEmpty() ? QJsonValue{} : QJsonValue{words.files().front()};
    return object;
}

} // namespace

Command probeCommand()
{
    using namespace probe_option;
    return {
        .name = "probe",
        .theme = "tracking",
        .summary = "the error of a tool's pose by its markers, and layouts of markers",
        .uses = {{.lines = {"FILE", "--design"},
                  .text = "Predicts how well a tracker sees a tool from all directions, by the "
                          "places of its markers and the error of one marker: to first order "
                          "through the fit by which its pose is computed. The layout is that of "
                          "a tool definition of NDI (.rom), of a table (.csv with the columns "
                          "x_mm, y_mm, z_mm, nx, ny, nz; a normal of zeros is that of a marker "
                          "seen from everywhere), or is searched on a ball. The same command "
                          "line gives the same layout.",
                  .notes = {{"probe --design --rom head.rom --svg head.svg --stl head.stl",
                             "a probe for a head"}},
                  .options = {kDesign, kMarkers, kRadius, kSeen, kShare, kSeed, kNoise, kDepth,
                              kOutward, kPoint, kAngle, kRom, kSvg, kStl, kSeat},
                  .schema = probe_key::kSchema,
                  .keys = {probe_key::kFile, probe_key::kCount, probe_key::kRadius,
                           probe_key::kClosest, probe_key::kNoise, probe_key::kRotation,
                           probe_key::kPosition, probe_key::kRotation35, probe_key::kPosition35,
                           probe_key::kPosed, probe_key::kIdentified, probe_key::kFewest,
                           probe_key::kSeen, probe_key::kMarkers, probe_key::kPlace,
                           probe_key::kNormal}}},
        .mostFiles = 1,
        .reminder = kProbeReminder,
        .experiment = describeProbe};
}

} // namespace carina::lab
