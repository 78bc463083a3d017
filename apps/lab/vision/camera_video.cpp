#include "apps/lab/command/patient_options.h"
#include "apps/lab/command/scripted_station.h"
#include "apps/lab/vision/accuracy_figures.h"
#include "apps/lab/vision/camera_uses.h"
#include "apps/lab/vision/video_comparison.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/site/devices/tracker_file.h"
#include "engine/io/site/site_file.h"
#include "engine/session/simulated_station.h"
#include "engine/tracking/tool_role.h"
#include "engine/vision/board_calibration.h"
#include "engine/vision/printed_tools.h"
#include "evaluation/vision/marker_renderer.h"
#include "evaluation/vision/video_writer.h"

#include <QJsonArray>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

namespace carina::lab
{
namespace
{

namespace video_option
{
constexpr Option kSeconds{"seconds", "N", "of the video, 1 to 600 (20)"};
constexpr Option kRate{"rate", "HZ", "pictures a second, 1 to 120 (30)"};
constexpr Option kWidth{"width", "PIXELS", "of the pictures, 160 to 4000 (960); 4:3"};
constexpr Option kBoard{"board", "N",
                        "writes N pictures of the calibration board into DIR/board, 1 to 200"};
constexpr Option kDistance{"distance-mm", "MM",
                           "of the camera from what it looks at, 300 to 1500 (640)"};
constexpr Option kCompare{"compare", "",
                          "reads the video again as the tracker does, and compares with where the "
                          "tools were"};
} // namespace video_option

namespace video_key
{
constexpr Key kFolder{"folder", "DIR as given"};
constexpr Key kPictures{"pictures", "of the video"};
constexpr Key kBoard{"board_pictures", "in DIR/board, for carina-lab camera calibrate"};
constexpr Key kTracker{"tracker", "the description of the tracker, for --tracker"};
constexpr Key kSite{"site", "where the patient lies before the camera, for --site"};
constexpr Key kTruth{"truth", "the poses rendered, in the anatomy frame"};
constexpr Key kCompared{"compared",
                        "with --compare: an object for each tool and distance, to the nearest "
                        "100 mm:"};
constexpr Key kTool{"tool", "its name", 1};
constexpr Key kSchema{"schema", "carina.camera-video/1"};
} // namespace video_key

/// The tools that scripted hands and manikin carry before the camera, with their markers in the
/// frames of the simulated tools. Sheets look up from the lying patient, their upper edge to the
/// head.
std::vector<PrintedTool> shownTools()
{
    Mat3 R_OB;
    R_OB.col(0) = Vec3::UnitX();
    R_OB.col(1) = Vec3::UnitZ();
    R_OB.col(2) = -Vec3::UnitY();
    const RigidTransform X_OB{Quat{R_OB}, Vec3::Zero()};
    std::vector<PrintedTool> shown = printedTools();
    std::erase_if(shown,
                  [](const PrintedTool& tool) { return tool.role == ToolRole::Laryngoscope; });
    for (PrintedTool& tool : shown)
        if (!tool.isSleeve)
            for (BodyMarker& marker : tool.body)
                marker.X_BK = X_OB * marker.X_BK;
    return shown;
}

/// What the camera looks at, metres from the incisors, and from where, in axes of A: to the left of
/// the patient and above the face.
const Vec3 kLooksAt{-0.02, -0.10, -0.06};
const Vec3 kLooksFrom{0.32, -0.55, 0.01};

/// X_AC of a camera at a place in A that looks at another, with the patient's head up.
RigidTransform cameraAt(const Vec3& p_A, const Vec3& p_A_target)
{
    Mat3 R_AC;
    R_AC.col(2) = (p_A - p_A_target).normalized();
    R_AC.col(0) = Vec3::UnitZ().cross(R_AC.col(2)).normalized();
    R_AC.col(1) = R_AC.col(2).cross(R_AC.col(0));
    return {Quat{R_AC}, p_A};
}

CameraModel videoCamera(int width)
{
    const int height = width * 3 / 4;
    return {.width = width,
            .height = height,
            .focal = Vec2::Constant(0.9 * width),
            .centre = {0.5 * (width - 1), 0.5 * (height - 1)},
            .distortion = {0.06, -0.12, 0.001, -0.0015, 0.0}};
}

struct VideoScene {
    std::vector<PrintedTool> tools;
    TrueToolPose truth; ///< in the frame of the simulated station
    RigidTransform X_CT;
    RigidTransform X_AC;
    StationRegistration registration; ///< of the camera
};

/// The scripted hands at a patient's manikin, seen from the camera C at a distance, metres.
Result<VideoScene> sceneOf(const PatientParameters& parameters, double distance)
{
    auto scripted = scriptedStation(parameters);
    if (!scripted)
        return tl::unexpected(scripted.error());
    SimulatedStation& station = scripted->station;
    const Vec3 p_A_target = scripted->airway.p_A_incisors + kLooksAt;
    const RigidTransform X_AC =
        cameraAt(p_A_target + distance * kLooksFrom.normalized(), p_A_target);
    return VideoScene{.tools = shownTools(),
                      .truth = std::move(station.truth),
                      .X_CT = X_AC.inverse() * station.exactly.X_AT,
                      .X_AC = X_AC,
                      .registration = {.X_AT = X_AC,
                                       .X_JA = station.exactly.X_JA,
                                       .X_BA = simulatedBodyProbe().inverse()}};
}

/// Places the bodies as the tools are at a time.
std::vector<PosedBody> placedAt(const VideoScene& scene, SessionTime t)
{
    std::vector<PosedBody> placed;
    for (const PrintedTool& tool : scene.tools)
        if (const auto X_TO = scene.truth(tool.role, t))
            placed.push_back({&tool.body, scene.X_CT * *X_TO});
    return placed;
}

TrackerDescription descriptionOf(const VideoScene& scene, const std::filesystem::path& video,
                                 const CameraModel& camera, int rate)
{
    TrackerDescription described{.address = video.string(),
                                 .kind = TrackerKind::Camera,
                                 .rate_hz = rate,
                                 .camera = camera,
                                 .isLooped = true};
    for (const PrintedTool& tool : scene.tools)
        described.tools.push_back({.name = tool.name,
                                   .role = tool.role,
                                   .body = MarkedBody{kPrintedDictionary, tool.body}});
    return described;
}

/// A site whose manikin is the patient itself, registered without error.
Site siteOf(const VideoScene& scene)
{
    Site site;
    site.step = SiteStep::Overview;
    site.catalogue = LandmarkCatalogue{
        .name = "Rendered",
        .anatomy = {},
        .landmarks = {{"a", Vec3::UnitX()}, {"b", Vec3::UnitY()}, {"c", Vec3::UnitZ()}}};
    site.registration = SiteRegistration{.X_AM = {},
                                         .X_AT = scene.registration.X_AT,
                                         .X_JM = scene.registration.X_JA,
                                         .X_BM = scene.registration.X_BA,
                                         .residuals = {{"a", 0.0}, {"b", 0.0}, {"c", 0.0}}};
    return site;
}

SessionTime timeOf(int picture, int rate)
{
    return SessionTime{fromSeconds(double(picture) / rate)};
}

/// Writes the poses in A of the tools in each picture, a line each.
Result<void> writeTruth(const std::filesystem::path& file, const VideoScene& scene, int pictures,
                        int rate)
{
    QString text = QStringLiteral("time_s,role,x_mm,y_mm,z_mm,q_x,q_y,q_z,q_w\n");
    for (int i = 0; i < pictures; ++i)
        for (const PrintedTool& tool : scene.tools) {
            const auto X_TO = scene.truth(tool.role, timeOf(i, rate));
            if (!X_TO)
                continue;
            const RigidTransform X_AO = scene.X_AC * scene.X_CT * *X_TO;
            text += QStringLiteral("%1,%2")
                        .arg(double(i) / rate)
                        .arg(QLatin1StringView{toolRoleWord(tool.role)});
            for (const double value : Vec3{1e3 * X_AO.translation()})
                text += QStringLiteral(",%1").arg(value, 0, 'f', 4);
            for (const double value : X_AO.rotation().coeffs())
                text += QStringLiteral(",%1").arg(value, 0, 'f', 7);
            text += QLatin1Char{'\n'};
        }
    return writeWholeFile(file, text.toStdString());
}

Result<int> writeVideo(const std::filesystem::path& file, const VideoScene& scene,
                       const CameraModel& camera, int seconds, int rate)
{
    auto video = VideoWriter::open(file, rate, camera.width, camera.height);
    if (!video)
        return tl::unexpected(video.error());
    MarkerRenderer renderer{camera, kPrintedDictionary, {.samples = 3}};
    const int pictures = seconds * rate;
    for (int i = 0; i < pictures; ++i) {
        const auto added = video->add(renderer.draw(placedAt(scene, timeOf(i, rate))));
        if (!added)
            return tl::unexpected(added.error());
    }
    return pictures;
}

/// How the tools are found in the video that was rendered.
Result<QJsonArray> comparedVideo(const std::filesystem::path& video, const VideoScene& scene,
                                 const CameraModel& camera)
{
    WatchedBodies watched{camera, kPrintedDictionary, {}};
    for (const PrintedTool& tool : scene.tools)
        watched.bodies.push_back(tool.body);
    const auto truth = [&scene](std::size_t body, Duration t) -> std::optional<RigidTransform> {
        const auto X_TO = scene.truth(scene.tools[body].role, SessionTime{t});
        return X_TO ? std::optional{scene.X_CT * *X_TO} : std::nullopt;
    };
    return compareVideo(video, watched, truth).map([&](const std::vector<BodyInVideo>& found) {
        QJsonArray all;
        for (const BodyInVideo& at : found) {
            QJsonObject object = accuracyFigures(at.accuracy);
            object[video_key::kTool] = QString::fromStdString(scene.tools[at.body].name);
            all.append(object);
        }
        return all;
    });
}

/// The board all over the picture, tilted to all sides.
Result<void> writeBoards(const std::filesystem::path& folder, const CameraModel& camera, int count)
{
    if (const auto opened = openFolder(folder); !opened)
        return opened;
    const CalibrationBoard board;
    MarkerRenderer renderer{camera, board.dictionary, {}};
    std::mt19937 random{7};
    std::uniform_real_distribution<double> share{-1.0, 1.0};
    const double size = board.square * board.rows;
    for (int i = 0; i < count; ++i) {
        const Vec2 middle =
            camera.centre
            + 0.38 * Vec2{camera.width * share(random), camera.height * share(random)};
        const double away = (1.9 + 0.5 * share(random)) * size;
        const double towards = std::numbers::pi * share(random);
        const Vec3 p_T = away * sightOf(camera, middle).normalized();
        const Vec3 axis{std::cos(towards), std::sin(towards), 0.0};
        const Quat q = Quat::FromTwoVectors(Vec3::UnitZ(), -p_T.normalized())
                       * Quat{Eigen::AngleAxisd{degrees(35.0 * share(random)).si, axis}};
        const GreyPicture picture = renderer.drawBoard({cellsOf(board),
                                                        board.columns * kCellsOfSquare,
                                                        board.square / kCellsOfSquare,
                                                        {q, p_T}});
        const std::string number = std::to_string(1000 + i).substr(1);
        if (const auto wrote = writePicture(folder / (number + ".png"), picture); !wrote)
            return wrote;
    }
    return {};
}

} // namespace

Result<QJsonObject> renderVideo(const Words& words)
{
    const auto seconds = words.whole(video_option::kSeconds, 1, 600, 20);
    const auto rate = words.whole(video_option::kRate, 1, 120, 30);
    const auto width = words.whole(video_option::kWidth, 160, 4000, 960);
    const auto boards = words.whole(video_option::kBoard, 1, 200, 0);
    const auto distance = words.whole(video_option::kDistance, 300, 1500, 640);
    for (const auto* whole : {&seconds, &rate, &width, &boards, &distance})
        if (!*whole)
            return tl::unexpected(whole->error());
    const std::filesystem::path folder{words.files()[1].toStdString()};
    if (const auto opened = openFolder(folder); !opened)
        return tl::unexpected(opened.error());
    const auto scene =
        patientOption(words, BuiltinPatient::TwelveYears).and_then([&](const auto& patient) {
            return sceneOf(patient, 1e-3 * double(*distance));
        });
    if (!scene)
        return tl::unexpected(scene.error());
    const CameraModel camera = videoCamera(int(*width));
    const std::filesystem::path video = folder / "markers.avi";
    const auto pictures = writeVideo(video, *scene, camera, int(*seconds), int(*rate));
    if (!pictures)
        return tl::unexpected(pictures.error());
    if (const auto truth = writeTruth(folder / "truth.csv", *scene, *pictures, int(*rate)); !truth)
        return tl::unexpected(truth.error());
    const auto wrote =
        writeTrackerFile(folder / "tracker.json", descriptionOf(*scene, video, camera, int(*rate)))
            .and_then([&] { return writeSiteFile(folder / "site.json", siteOf(*scene)); });
    if (!wrote)
        return tl::unexpected(wrote.error());
    if (*boards > 0)
        if (const auto drawn = writeBoards(folder / "board", camera, int(*boards)); !drawn)
            return tl::unexpected(drawn.error());
    const auto text = [&](const char* name) {
        return QString::fromStdString((folder / name).string());
    };
    QJsonObject object{{video_key::kSchema, QLatin1StringView{video_key::kSchema.help}},
                       {video_key::kFolder, words.files()[1]},
                       {video_key::kPictures, *pictures},
                       {video_key::kBoard, qint64(*boards)},
                       {video_key::kTracker, text("tracker.json")},
                       {video_key::kSite, text("site.json")},
                       {video_key::kTruth, text("truth.csv")}};
    if (!words.has(video_option::kCompare))
        return object;
    return comparedVideo(video, *scene, camera).map([&](const QJsonArray& compared) {
        object[video_key::kCompared] = compared;
        return object;
    });
}

Use videoUse()
{
    return {.lines = {"video DIR [--patient WHO] [--seconds N] [--rate HZ]",
                      "video DIR [--width PIXELS] [--distance-mm MM] [--board N] [--compare]"},
            .text =
                "Renders scripted hands with the printed markers at the patient's "
                "manikin, as a camera sees them, into DIR/markers.avi. "
                "DIR/tracker.json describes it for --tracker, and DIR/site.json says "
                "where the patient lies: ./carina demo --tracker DIR/tracker.json "
                "--site DIR/site.json. DIR/truth.csv has the tools' poses in each picture, in the "
                "anatomy frame. With --compare it says how far the poses found in the video "
                "are from those rendered.",
            .options = {kPatient, video_option::kSeconds, video_option::kRate, video_option::kWidth,
                        video_option::kDistance, video_option::kBoard, video_option::kCompare},
            .schema = video_key::kSchema,
            .keys = withAccuracyKeys({video_key::kFolder, video_key::kPictures, video_key::kBoard,
                                      video_key::kTracker, video_key::kSite, video_key::kTruth,
                                      video_key::kCompared, video_key::kTool})};
}

} // namespace carina::lab
