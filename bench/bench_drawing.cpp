// How often the real anatomy set is drawn in a second while it breathes, in a window of 1280x1024:
// opaque in full detail beside a bare OpenGL loop and beside VTK, which draws it still, as it comes
// and without the faces that look away; as it is usually shown, in full detail and with level of
// detail, the latter also with the mouth open, which the throat follows. Seven runs of each, in
// turn, every one a process of its own. Also how long the first frame takes from opening the cache,
// and how much memory it all takes. Needs a display, CARINA_TEST_DATA and python3-vtk9. Prints one
// JSON object.

#include "bench/drawing/bare_loop.h"
#include "engine/core/monotonic_clock.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/scene/view/orbit_camera.h"
#include "widgets/scene/view/scene_view.h"

#include <QApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>

namespace
{

using namespace carina;
using namespace carina::bench;

constexpr int kRuns = 7;
constexpr double kSeconds = 3.0; ///< of measuring in one run
constexpr double kWarmUp = 1.5;  ///< seconds before, in which the level of detail settles
const QString kPython = QStringLiteral("/usr/bin/python3"); ///< for which Debian has VTK
const std::vector<std::string> kOurs{"opaque", "usual", "detail", "opaque-detail", "detail-jaw"};

std::string setFolder()
{
    return qEnvironmentVariable("CARINA_TEST_DATA").toStdString() + "/anatomy";
}

/// The most memory that this process ever held, MB.
double peakMemory_mb()
{
    QFile status{QStringLiteral("/proc/self/status")};
    if (!status.open(QIODevice::ReadOnly))
        return 0.0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmHWM:"))
            return line.simplified().split(' ').at(1).toDouble() / 1000.0;
    return 0.0;
}

/// What this process has used of all processors together.
double processorSeconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

int say(const QJsonObject& object)
{
    std::printf("%s\n", QJsonDocument{object}.toJson(QJsonDocument::Compact).constData());
    return 0;
}

int refuse(const Error& error)
{
    std::fprintf(stderr, "%s\n", error.detail.c_str());
    return 1;
}

QString inWords(const Vec3& v)
{
    return QStringLiteral("%1,%2,%3").arg(v.x()).arg(v.y()).arg(v.z());
}

/// Reads the set into the cache, writes it for the peer, and says from where it is looked at.
int prepare(const std::string& ply)
{
    const auto patient = PatientScene::of(setFolder(), false);
    if (!patient)
        return refuse(patient.error());
    if (const auto written = writePly(*patient, ply); !written)
        return refuse(written.error());
    OrbitCamera camera;
    camera.setBounds(patient->framed());
    camera.setAspect(double(kWidth) / kHeight);
    camera.showFrom(ViewPreset::Front);
    const CameraPose pose = camera.pose();
    return say({{QStringLiteral("eye"), inWords(pose.p_A_eye)},
                {QStringLiteral("target"), inWords(pose.p_A_target)},
                {QStringLiteral("up"), inWords(pose.up_A)}});
}

int bare()
{
    const auto patient = PatientScene::of(setFolder(), true);
    if (!patient)
        return refuse(patient.error());
    const auto rate = bareLoopRate(*patient, kSeconds);
    if (!rate)
        return refuse(rate.error());
    return say({{QStringLiteral("frames_per_s"), *rate}});
}

/// What one run of ours measured.
struct Trial {
    LocalTime opened{};
    std::optional<LocalTime> firstFrame;
    LocalTime measuredFrom{};
    double processorFrom = 0.0;
    int frames = 0;
    std::size_t triangles = 0;
};

int ours(const std::string& mode)
{
    Trial trial;
    trial.opened = monotonicNow();
    const auto patient = PatientScene::of(setFolder(), true);
    if (!patient)
        return refuse(patient.error());
    SceneView view;
    view.setParts(patient->parts());
    if (mode.starts_with("opaque"))
        view.setLooks(patient->solid());
    if (!mode.starts_with("detail"))
        view.setFixedQuality(PictureQuality::Quick); // as the others draw
    if (mode == "opaque" || mode == "usual")
        view.setFixedLevel(0);
    view.setFrameSource([&](int level, LocalTime lit) {
        SceneFrame frame = patient->frameAt(toSeconds(lit - trial.opened), level);
        if (mode == "detail-jaw")
            frame.throat = patient->openThroat();
        return frame;
    });
    view.onFrameDrawn([&](const DrawnFrame& drawn) {
        if (!trial.firstFrame)
            trial.firstFrame = drawn.swapped;
        const double since = toSeconds(drawn.swapped - *trial.firstFrame);
        if (since < kWarmUp) {
            trial.measuredFrom = drawn.swapped;
            trial.processorFrom = processorSeconds();
            return;
        }
        ++trial.frames;
        trial.triangles = drawn.triangles;
        const double measured = toSeconds(drawn.swapped - trial.measuredFrom);
        if (measured < kSeconds || trial.frames < 2)
            return;
        say({{QStringLiteral("frames_per_s"), trial.frames / measured},
             {QStringLiteral("cpu_ms_per_frame"),
              1e3 * (processorSeconds() - trial.processorFrom) / trial.frames},
             {QStringLiteral("triangles"), qint64(trial.triangles)},
             {QStringLiteral("cache_to_first_frame_s"),
              toSeconds(*trial.firstFrame - trial.opened)},
             {QStringLiteral("memory_mb"), peakMemory_mb()}});
        QCoreApplication::exit(0);
    });
    view.resize(kWidth, kHeight);
    view.show();
    const QString picture = qEnvironmentVariable("CARINA_BENCH_PICTURE");
    const int status = QApplication::exec();
    if (!picture.isEmpty())
        view.picture().save(picture);
    return status;
}

/// The last line that a program prints, read as JSON; ends this program where it fails.
QJsonObject answerOf(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start(program, arguments);
    const bool ended = process.waitForFinished(120'000);
    const QByteArray line = process.readAllStandardOutput().trimmed().split('\n').last();
    const QJsonObject answer = QJsonDocument::fromJson(line).object();
    if (!ended || process.exitCode() != 0 || answer.isEmpty()) {
        std::fprintf(stderr, "%s %s failed\n", qPrintable(program),
                     qPrintable(arguments.join(QLatin1Char{' '})));
        std::exit(EXIT_FAILURE);
    }
    return answer;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Answers by what was measured, and of each run.
using Answers = std::map<std::string, std::map<std::string, std::vector<double>>>;

void keep(Answers& answers, const std::string& name, const QJsonObject& answer)
{
    for (auto it = answer.begin(); it != answer.end(); ++it)
        answers[name][it.key().toStdString()].push_back(it.value().toDouble());
}

int measureAll(const QString& self)
{
    const QTemporaryDir scratch;
    qputenv("XDG_CACHE_HOME", scratch.path().toUtf8());
    const QString ply = scratch.filePath(QStringLiteral("patient.ply"));
    const QJsonObject camera = answerOf(self, {QStringLiteral("prepare"), ply});
    const QStringList vtk{QStringLiteral(CARINA_SOURCE_DIR "/bench/drawing/vtk_peer.py"),
                          ply,
                          QString::number(kWidth),
                          QString::number(kHeight),
                          QString::number(kSeconds),
                          camera[QStringLiteral("eye")].toString(),
                          camera[QStringLiteral("target")].toString(),
                          camera[QStringLiteral("up")].toString(),
                          QString::number(OrbitCamera::kVerticalFieldOfView * 180.0 / 3.14159265)};
    Answers answers;
    for (int run = 0; run < kRuns; ++run) {
        keep(answers, "vtk", answerOf(kPython, vtk));
        keep(answers, "vtk-culling", answerOf(kPython, vtk + QStringList{QStringLiteral("cull")}));
        keep(answers, "bare", answerOf(self, {QStringLiteral("bare")}));
        for (const std::string& mode : kOurs)
            keep(answers, mode, answerOf(self, {QString::fromStdString(mode)}));
    }
    QJsonObject report{{QStringLiteral("schema"), QStringLiteral("carina.bench.drawing/1")},
                       {QStringLiteral("runs"), kRuns}};
    for (const auto& [name, figures] : answers) {
        QJsonObject medians;
        for (const auto& [figure, values] : figures)
            medians[QString::fromStdString(figure)] = median(values);
        report[QString::fromStdString(name)] = medians;
    }
    const double opaque = median(answers["opaque"]["frames_per_s"]);
    report[QStringLiteral("opaque_ratio_to_bare")] =
        opaque / median(answers["bare"]["frames_per_s"]);
    report[QStringLiteral("opaque_ratio_to_vtk")] = opaque / median(answers["vtk"]["frames_per_s"]);
    report[QStringLiteral("opaque_ratio_to_vtk_culling")] =
        opaque / median(answers["vtk-culling"]["frames_per_s"]);
    std::printf("%s", QJsonDocument{report}.toJson().constData());
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    const std::string mode = argc > 1 ? argv[1] : "";
    if (mode.empty()) {
        const QCoreApplication application{argc, argv};
        if (qEnvironmentVariableIsEmpty("CARINA_TEST_DATA"))
            return refuse({Errc::FileNotFound, "CARINA_TEST_DATA names no folder"});
        return measureAll(QCoreApplication::applicationFilePath());
    }
    prepareGraphics();
    const QApplication application{argc, argv};
    if (mode == "prepare" && argc > 2)
        return prepare(argv[2]);
    if (mode == "bare")
        return bare();
    return ours(mode);
}
