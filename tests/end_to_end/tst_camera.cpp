#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

namespace carina::camera_test
{
namespace
{

constexpr std::size_t kFrames = 200; ///< that are compared, and those at the ends of the video

constexpr int kTubeKind = 2; ///< of ObjectKind

constexpr double kVideo_s = 5.0; ///< the tube is moved from the third second on
constexpr double kRate_hz = 10.0;
constexpr double kBin_mm = 20.0; ///< of distances from the camera

// Bounds, some 1.5 times what is seen of the program: the tube is 2.2 mm and 0.54 degrees off in
// half of the frames, and 5.1 mm and 1.3 degrees in one of ten. The camera finds it within 1.1 mm
// and 0.12 degrees (`carina-lab camera video DIR --seconds 5 --rate 10 --width 640 --compare`).
// What is more comes of the chest, which the tube is drawn beside: it is found half a degree
// wrong, 1.3 mm at 150 mm from it, and that differs from picture to picture, which is predicted as
// if it were a motion.

constexpr double kHalf_mm = 3.5;
constexpr double kMost_mm = 8.0;
constexpr double kHalf_deg = 0.9;
constexpr double kMost_deg = 2.0;
/// A picture is stamped when it is due, and the tube predicted to the moment of the frame: not late
/// but for a depth that is found 1 mm wrong, 20 ms of its way. Unpredicted, it is later by half of
/// the time between two pictures, 50 ms, and by the time that looking takes.
constexpr double kLate_s = 0.040;

/// Where a tool was at a time, in the anatomy frame.
struct Placed {
    double t_s = 0.0;
    std::array<double, 3> p_mm{};
    std::array<double, 4> q{}; ///< x, y, z, w
};

using Place = std::array<double, 3>;

double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// How far a drawn pose is from the rendered one.
struct Apart {
    Place off_mm{};
    Place speed_mm_s{}; ///< of the rendered one
    double angle_deg = 0.0;
    double away_mm = 0.0; ///< from the camera

    [[nodiscard]] double distance_mm() const { return std::sqrt(dot(off_mm, off_mm)); }
};

/// By the chord between the quaternions, which is exact also for small angles.
double angleBetween_deg(const Placed& a, const Placed& b)
{
    double same = 0.0;
    double opposite = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        same += std::pow(a.q[i] - b.q[i], 2);
        opposite += std::pow(a.q[i] + b.q[i], 2);
    }
    const double chord = std::sqrt(std::min(same, opposite));
    return 4.0 * std::asin(std::min(1.0, 0.5 * chord)) * 180.0 / std::numbers::pi;
}

/// The poses of the tube that were rendered.
std::vector<Placed> renderedTube(const QString& truth)
{
    QFile file{truth};
    std::vector<Placed> all;
    if (!file.open(QIODevice::ReadOnly))
        return all;
    for (const QByteArray& line : file.readAll().split('\n')) {
        const QByteArrayList fields = line.split(',');
        if (fields.size() != 9 || fields[1] != "tube")
            continue;
        Placed placed{.t_s = fields[0].toDouble()};
        for (int i = 0; i < 3; ++i)
            placed.p_mm[std::size_t(i)] = fields[2 + i].toDouble();
        for (int i = 0; i < 4; ++i)
            placed.q[std::size_t(i)] = fields[5 + i].toDouble();
        all.push_back(placed);
    }
    return all;
}

/// The poses of its own tube in the frames of a program.
std::vector<Placed> drawnTube(const std::vector<QJsonObject>& journal)
{
    std::vector<Placed> all;
    for (const QJsonObject& line : journal)
        for (const QJsonValue& frame : line[QStringLiteral("frames")].toArray())
            for (const QJsonValue& object : frame[QStringLiteral("objects")].toArray()) {
                if (!object[QStringLiteral("own")].toBool()
                    || object[QStringLiteral("kind")].toInt() != kTubeKind)
                    continue;
                Placed placed{.t_s = 1e-9 * frame[QStringLiteral("session_ns")].toDouble()};
                for (int i = 0; i < 3; ++i)
                    placed.p_mm[std::size_t(i)] = object[QStringLiteral("xyz_mm")][i].toDouble();
                for (int i = 0; i < 4; ++i)
                    placed.q[std::size_t(i)] = object[QStringLiteral("q_xyzw")][i].toDouble();
                all.push_back(placed);
            }
    return all;
}

/// The session times at which the video began, as the journal has them.
std::vector<double> beginnings(const std::vector<QJsonObject>& journal)
{
    std::vector<double> all;
    for (const QJsonObject& line : journal)
        if (const QJsonValue since = line[QStringLiteral("video_since_ns")]; since.isDouble())
            if (const double began = 1e-9 * since.toDouble(); all.empty() || began > all.back())
                all.push_back(began);
    return all;
}

/// Whether the whole video was shown, in frames enough.
bool hasPlayed(const std::vector<QJsonObject>& journal)
{
    const std::vector<Placed> drawn = drawnTube(journal);
    const std::vector<double> began = beginnings(journal);
    return drawn.size() >= kFrames && !began.empty() && drawn.back().t_s > began.front() + kVideo_s;
}

/// Where the camera is in the anatomy frame, by the site.
std::optional<Place> cameraOf(const QString& site)
{
    QFile file{site};
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QJsonValue X_AT = QJsonDocument::fromJson(
        file.readAll())[QStringLiteral("registration")][QStringLiteral("X_AT_mm")];
    if (!X_AT.isArray())
        return std::nullopt;
    return Place{X_AT[0][3].toDouble(), X_AT[1][3].toDouble(), X_AT[2][3].toDouble()};
}

/// Of frames within the video, how far each is from where the tube was rendered, linear between two
/// pictures.
std::vector<Apart> apartFrom(const std::vector<Placed>& rendered, const std::vector<Placed>& drawn,
                             const std::vector<double>& began, const Place& camera)
{
    std::vector<Apart> all;
    for (const Placed& frame : drawn) {
        const auto next = std::ranges::upper_bound(began, frame.t_s);
        if (next == began.begin())
            continue;
        const double t = frame.t_s - *(next - 1);
        const auto after = std::ranges::upper_bound(rendered, t, {}, &Placed::t_s);
        // The first pictures after a jump back, and the last, are predicted from another motion.
        if (t < 0.5 || after == rendered.begin() || after == rendered.end())
            continue;
        const Placed& before = *(after - 1);
        const double period = after->t_s - before.t_s;
        Apart apart;
        Place truth{};
        for (std::size_t i = 0; i < 3; ++i) {
            apart.speed_mm_s[i] = (after->p_mm[i] - before.p_mm[i]) / period;
            truth[i] = before.p_mm[i] + (t - before.t_s) * apart.speed_mm_s[i];
        }
        apart.off_mm = minus(frame.p_mm, truth);
        apart.away_mm = std::sqrt(dot(minus(truth, camera), minus(truth, camera)));
        apart.angle_deg = angleBetween_deg(t - before.t_s > 0.5 * period ? *after : before, frame);
        all.push_back(apart);
    }
    return all;
}

/// The delay of what is drawn that explains most of how far it is off.
double lateness_s(const std::vector<Apart>& all)
{
    double along = 0.0;
    double squares = 0.0;
    for (const Apart& apart : all) {
        along -= dot(apart.off_mm, apart.speed_mm_s);
        squares += dot(apart.speed_mm_s, apart.speed_mm_s);
    }
    return along / squares;
}

double quantile(std::vector<double> values, double share)
{
    std::ranges::sort(values);
    return values[std::size_t(share * double(values.size() - 1))];
}

struct Quantiles {
    double distance_mm = 0.0;
    double angle_deg = 0.0;
};

Quantiles quantiles(const std::vector<Apart>& all, double share)
{
    std::vector<double> distances;
    std::vector<double> angles;
    for (const Apart& apart : all) {
        distances.push_back(apart.distance_mm());
        angles.push_back(apart.angle_deg);
    }
    return {quantile(distances, share), quantile(angles, share)};
}

void report(const char* of, const std::vector<Apart>& all)
{
    if (all.empty())
        return;
    const Quantiles half = quantiles(all, 0.5);
    const Quantiles most = quantiles(all, 0.9);
    qInfo("%s: %zu frames, %.2f mm and %.2f degrees (median), %.2f mm and %.2f degrees (90 %%)", of,
          all.size(), half.distance_mm, half.angle_deg, most.distance_mm, most.angle_deg);
}

/// Of a tube that rests and of one that moves.
void reportByMotion(const std::vector<Apart>& all)
{
    constexpr double kRests_mm_s = 1.0;
    std::vector<Apart> rests;
    std::vector<Apart> moves;
    for (const Apart& apart : all)
        (std::sqrt(dot(apart.speed_mm_s, apart.speed_mm_s)) < kRests_mm_s ? rests : moves)
            .push_back(apart);
    report("at rest", rests);
    report("moved", moves);
}

void reportByDistance(const std::vector<Apart>& all)
{
    std::map<int, std::vector<Apart>> bins;
    for (const Apart& apart : all)
        bins[int(apart.away_mm / kBin_mm)].push_back(apart);
    for (const auto& [bin, within] : bins)
        report(qPrintable(QStringLiteral("%1 to %2 mm from the camera")
                              .arg(bin * kBin_mm)
                              .arg((bin + 1) * kBin_mm)),
               within);
}

} // namespace

/// A trainee whose tracker is a video of markers.
class TestCamera : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tracksTheToolsOfAVideo()
    {
        const QTemporaryDir folder;
        QProcess rendering;
        rendering.start(QStringLiteral(CARINA_LAB),
                        {QStringLiteral("camera"), QStringLiteral("video"), folder.path(),
                         QStringLiteral("--seconds"), QString::number(kVideo_s),
                         QStringLiteral("--rate"), QString::number(kRate_hz),
                         QStringLiteral("--width"), QStringLiteral("640")});
        QVERIFY(rendering.waitForFinished(kPatience_ms) && rendering.exitCode() == 0);

        const QString codes = folder.filePath(QStringLiteral("codes"));
        Program instructor{QStringLiteral(CARINA_INSTRUCTOR),
                           {QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--data"),
                            folder.filePath(QStringLiteral("host")), QStringLiteral("--codes"),
                            codes, QStringLiteral("--start")},
                           folder.filePath(QStringLiteral("instructor.jsonl"))};
        instructor.start();
        QTRY_VERIFY_WITH_TIMEOUT(!instructor.shown().isEmpty(), kPatience_ms);
        Program trainee{QStringLiteral(CARINA_TRAINEE),
                        {QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--as"),
                         QStringLiteral("Trainee"), QStringLiteral("--code-file"), codes,
                         QStringLiteral("--data"), folder.filePath(QStringLiteral("trainee")),
                         QStringLiteral("--site"), folder.filePath(QStringLiteral("site.json")),
                         QStringLiteral("--tracker"),
                         folder.filePath(QStringLiteral("tracker.json"))},
                        folder.filePath(QStringLiteral("trainee.jsonl"))};
        trainee.start();
        QTRY_VERIFY_WITH_TIMEOUT(hasPlayed(trainee.allShown()), kPatience_ms);

        const std::vector<Placed> rendered =
            renderedTube(folder.filePath(QStringLiteral("truth.csv")));
        const auto camera = cameraOf(folder.filePath(QStringLiteral("site.json")));
        QVERIFY(camera);
        const std::vector<QJsonObject> journal = trainee.allShown();
        const std::vector<double> began = beginnings(journal);
        QVERIFY(!began.empty());
        const std::vector<Apart> apart = apartFrom(rendered, drawnTube(journal), began, *camera);
        QVERIFY(apart.size() >= kFrames / 4);
        const double late = lateness_s(apart);
        report("all", apart);
        reportByMotion(apart);
        reportByDistance(apart);
        qInfo("drawn %.0f ms late", 1e3 * late);
        QVERIFY(quantiles(apart, 0.5).distance_mm < kHalf_mm);
        QVERIFY(quantiles(apart, 0.9).distance_mm < kMost_mm);
        QVERIFY(quantiles(apart, 0.5).angle_deg < kHalf_deg);
        QVERIFY(quantiles(apart, 0.9).angle_deg < kMost_deg);
        QVERIFY(std::abs(late) < kLate_s);
    }
};

CARINA_TEST(TestCamera)

} // namespace carina::camera_test

#include "tst_camera.moc"
