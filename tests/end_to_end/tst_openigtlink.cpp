#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/tracking/igtl/igtl_pose.h"
#include "engine/tracking/igtl/igtl_reader.h"
#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QJsonArray>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>

#include <algorithm>
#include <limits>

namespace carina::openigtlink_test
{
namespace
{

constexpr std::size_t kMostKept = 4 * 1024 * 1024;
constexpr double kNearPath_mm = 5.0; ///< between the tube and the path through what was drawn
constexpr double kVolume = 0.1;      ///< of a breath, that ten surfaces a second may miss
constexpr int kBreaths = 2;

#ifdef CARINA_IGTL_PEERS
const QString kReceiver = QStringLiteral(CARINA_IGTL_PEERS "/ReceiveClient");
#else
const QString kReceiver;
#endif

quint16 unusedPort()
{
    QTcpServer probe;
    return probe.listen(QHostAddress::LocalHost) ? probe.serverPort() : quint16{0};
}

/// By the tetrahedra over the polygons, in litres.
double litresOfSurface(const IgtlPolyData& data)
{
    TriangleMesh mesh; // in millimetres
    for (const auto& p : data.points)
        mesh.positions.emplace_back(p[0], p[1], p[2]);
    const auto& numbers = data.cells[kIgtlPolygons].numbers;
    for (std::size_t i = 0; i + 3 < numbers.size(); i += 4)
        mesh.triangles.push_back({numbers[i + 1], numbers[i + 2], numbers[i + 3]});
    return 1e-6 * signedVolume(mesh);
}

/// A client that only listens.
class Listener
{
public:
    explicit Listener(quint16 port)
    {
        m_socket.connectToHost(QHostAddress{QHostAddress::LocalHost}, port);
    }

    void look()
    {
        const QByteArray bytes = m_socket.readAll();
        m_reader.take(std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())}));
        while (const auto message = m_reader.next())
            if (*message)
                take(**message);
            else
                ++damaged;
    }

    int damaged = 0;
    QStringList landmarks{};
    std::vector<Vec3> tube_mm{}; ///< in the axes of 3D Slicer
    std::vector<double> litres{};

private:
    void take(const IgtlMessage& message)
    {
        if (const auto* points = std::get_if<IgtlPoints>(&message.content))
            for (const IgtlPoint& point : points->points)
                landmarks << QString::fromStdString(point.name);
        const auto* transform = std::get_if<IgtlTransform>(&message.content);
        if (transform && message.device == "Tube") {
            const auto X = poseOf(transform->matrix);
            if (X)
                tube_mm.push_back(1e3 * X->translation());
        }
        if (const auto* surface = std::get_if<IgtlPolyData>(&message.content))
            litres.push_back(litresOfSurface(*surface));
    }

    QTcpSocket m_socket;
    IgtlReader m_reader{kMostKept};
};

/// Where the program drew its own tube, in the patient's frame.
std::vector<Vec3> drawnTubes(const Program& program, int tubeKind)
{
    std::vector<Vec3> all;
    for (const QJsonObject& line : program.allShown())
        for (const QJsonValue& frame : line[QStringLiteral("frames")].toArray())
            for (const QJsonValue& object : frame[QStringLiteral("objects")].toArray())
                if (object[QStringLiteral("own")].toBool()
                    && object[QStringLiteral("kind")].toInt() == tubeKind) {
                    const QJsonArray p = object[QStringLiteral("xyz_mm")].toArray();
                    all.push_back({p[0].toDouble(), p[1].toDouble(), p[2].toDouble()});
                }
    return all;
}

/// To the straight lines between points that follow each other: on a busy computer frames are rare,
/// and the tube goes on between them.
double distanceToPath(const Vec3& p, const std::vector<Vec3>& path)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Vec3 along = path[i] - path[i - 1];
        const double length2 = along.squaredNorm();
        const double s =
            length2 > 0.0 ? std::clamp((p - path[i - 1]).dot(along) / length2, 0.0, 1.0) : 0.0;
        least = std::min(least, (p - path[i - 1] - s * along).norm());
    }
    return least;
}

} // namespace

/// A trainee's program that gives what it shows to a client of OpenIGTLink.
class TestOpenigtlink : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void givesPosesLandmarksAndBreathingLungs()
    {
        const QTemporaryDir folder;
        const QString codes = folder.filePath(QStringLiteral("codes"));
        const quint16 port = unusedPort();
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
                         QStringLiteral("--tracker"), QStringLiteral("simulated"),
                         QStringLiteral("--openigtlink"), QString::number(port)},
                        folder.filePath(QStringLiteral("trainee.jsonl"))};
        trainee.start();
        QTRY_VERIFY_WITH_TIMEOUT(!trainee.shown().isEmpty(), kPatience_ms);
        const QJsonObject shown = trainee.shown();
        const double period_s = 60.0 / shown[QStringLiteral("breathing_rate_per_min")].toDouble();
        const double breath_l = 1e-3 * shown[QStringLiteral("tidal_volume_ml")].toDouble();
        QVERIFY(breath_l > 0.0);

        Listener listener{port};
        const auto hasSeenBreaths = [&] {
            listener.look();
            return double(listener.litres.size()) > 10.0 * kBreaths * period_s;
        };
        QTRY_VERIFY_WITH_TIMEOUT(hasSeenBreaths(), kPatience_ms);
        QCOMPARE(listener.damaged, 0);
        QCOMPARE(listener.landmarks.mid(0, 3),
                 (QStringList{QStringLiteral("Incisors"), QStringLiteral("Glottis"),
                              QStringLiteral("Carina")}));
        const auto [least, most] =
            std::minmax_element(listener.litres.begin(), listener.litres.end());
        QVERIFY2(std::abs(*most - *least - breath_l) < kVolume * breath_l,
                 qPrintable(QStringLiteral("%1 of %2 l").arg(*most - *least).arg(breath_l)));
        compareTubes(listener, trainee);
        if (!kReceiver.isEmpty())
            letTheExampleReceive(port);
    }

private:
    /// +x of the patient is to the left, +y to the back; Slicer's are to the right and the front.
    static void compareTubes(const Listener& listener, const Program& trainee)
    {
        const std::vector<Vec3> drawn = drawnTubes(trainee, 2);
        QVERIFY(drawn.size() > 1 && !listener.tube_mm.empty());
        for (const Vec3& p_R : listener.tube_mm) {
            const double away_mm = distanceToPath({-p_R.x(), -p_R.y(), p_R.z()}, drawn);
            QVERIFY2(away_mm < kNearPath_mm, qPrintable(QString::number(away_mm)));
        }
    }

    static void letTheExampleReceive(quint16 port)
    {
        QProcess receiver;
        receiver.setProcessChannelMode(QProcess::MergedChannels);
        receiver.start(kReceiver, {QStringLiteral("127.0.0.1"), QString::number(port)});
        QByteArray printed;
        const auto hasPrinted = [&] {
            printed += receiver.readAll();
            return printed.contains("Receiving TRANSFORM") && printed.contains("Receiving POINT")
                   && printed.contains("Glottis") && printed.contains("POLYDATA");
        };
        QTRY_VERIFY_WITH_TIMEOUT(hasPrinted(), kPatience_ms);
        receiver.kill();
        receiver.waitForFinished();
    }
};

CARINA_TEST(TestOpenigtlink)

} // namespace carina::openigtlink_test

#include "tst_openigtlink.moc"
