#include "apps/lab/commands.h"
#include "apps/lab/tracking/probe_solid.h"
#include "engine/tracking/ndi/tool_definition.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <cmath>
#include <cstring>
#include <map>

namespace carina::lab::probe_command_test
{
namespace
{

double number(const QJsonObject& object, const char* key)
{
    return object[QLatin1StringView{key}].toDouble(std::nan(""));
}

QByteArray bytesOf(const QString& path)
{
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
}

QStringList designOf(const QStringList& more = {})
{
    return QStringList{QStringLiteral("--design")} + more;
}

} // namespace

class ProbeCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The probe of 2004 was measured with 0.028 degrees and 0.11 mm (Davis, Hamza-Lup, Rolland).
    void designsAProbeForAHead()
    {
        const auto object = probeCommand().run(designOf());
        QVERIFY(object);
        QVERIFY(number(*object, "radius_mm") <= 100.0 + 1e-9);
        QCOMPARE(number(*object, "marker_count"), 20.0);
        QVERIFY(number(*object, "rotation_rms_deg") <= 0.03);
        QVERIFY(number(*object, "position_rms_mm") <= 0.1);
        const QJsonArray shares = (*object)[QLatin1StringView{"share_with_markers"}].toArray();
        QVERIFY(shares[6].toDouble() >= 0.95);
        QVERIFY(number(*object, "closest_markers_mm") > 14.9);
        QVERIFY(number(*object, "share_identified") > 0.95);
        // Noise is propagated linearly.
        QVERIFY(std::abs(number(*object, "rotation_rms_deg_at_0.35mm")
                             / number(*object, "rotation_rms_deg")
                         - 3.5)
                < 1e-6);
    }

    void designsTheSameFromTheSameSeed()
    {
        const QStringList small{QStringLiteral("--markers"),   QStringLiteral("6"),
                                QStringLiteral("--radius-mm"), QStringLiteral("40"),
                                QStringLiteral("--seen"),      QStringLiteral("3")};
        const auto markersOf = [&](const char* seed) {
            const auto object = probeCommand().run(
                designOf(small) + QStringList{QStringLiteral("--seed"), QString::fromLatin1(seed)});
            return object ? (*object)[QLatin1StringView{"markers"}].toArray() : QJsonArray{};
        };
        QCOMPARE(markersOf("3").size(), 6);
        QCOMPARE(markersOf("3"), markersOf("3"));
        QVERIFY(markersOf("3") != markersOf("4"));
    }

    void writesADefinitionThatReadsAsTheSameProbe()
    {
        const QTemporaryDir folder;
        const QString rom = folder.filePath(QStringLiteral("head.rom"));
        const QString svg = folder.filePath(QStringLiteral("head.svg"));
        const auto designed = probeCommand().run(designOf(
            {QStringLiteral("--markers"), QStringLiteral("8"), QStringLiteral("--seen"),
             QStringLiteral("3"), QStringLiteral("--rom"), rom, QStringLiteral("--svg"), svg}));
        QVERIFY(designed);
        const auto read = probeCommand().run({rom});
        QVERIFY(read);
        // Positions are floats there.
        QVERIFY(std::abs(number(*read, "rotation_rms_deg") / number(*designed, "rotation_rms_deg")
                         - 1.0)
                < 1e-5);
        QCOMPARE(romCommand().run({rom})->value(QLatin1StringView{"markers"}).toArray().size(), 8);

        QXmlStreamReader xml{bytesOf(svg)};
        int circles = 0;
        while (!xml.atEnd())
            circles += xml.readNext() == QXmlStreamReader::StartElement
                               && xml.name() == QLatin1String{"circle"}
                           ? 1
                           : 0;
        QVERIFY(!xml.hasError());
        QCOMPARE(circles, 3 * 8); // in three views
    }

    void writesTheAngleThatItPredictedFor()
    {
        const QTemporaryDir folder;
        const QString rom = folder.filePath(QStringLiteral("head.rom"));
        const auto designed = probeCommand().run(
            designOf({QStringLiteral("--markers"), QStringLiteral("8"), QStringLiteral("--seen"),
                      QStringLiteral("3"), QStringLiteral("--angle-deg"), QStringLiteral("60"),
                      QStringLiteral("--rom"), rom}));
        QVERIFY(designed);
        const auto tool = romCommand().run({rom});
        QVERIFY(tool);
        QVERIFY(std::abs(number(*tool, "largest_angle_deg") - 60.0) < 1e-9);
        const auto read = probeCommand().run({rom});
        QVERIFY(read);
        QVERIFY(std::abs(number(*read, "share_with_pose") - number(*designed, "share_with_pose"))
                < 1e-9);
    }

    /// A pointer of which four markers are asked for, and 0.75 mm; whose is told by the file.
    void keepsWhatADefinitionStates()
    {
        const QTemporaryDir folder;
        const std::vector<ToolMarker> markers{
            {{0, 0, 0}}, {{0, 0, 0.05}}, {{0, 0.025, 0.1}}, {{0, -0.025, 0.135}}};
        const auto tool = NdiToolDefinition::make(
            NdiToolDefinition::Kind::Pointer,
            Probe{.markers = markers, .fewest = 4, .largestMisfit = millimetres(0.75)}, "NDI",
            "8700340");
        QVERIFY(tool);
        const QString given = folder.filePath(QStringLiteral("given.rom"));
        QFile file{given};
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(reinterpret_cast<const char*>(tool->bytes().data()),
                   qint64(tool->bytes().size()));
        file.close();
        const QString saved = folder.filePath(QStringLiteral("saved.rom"));
        QVERIFY(probeCommand().run({given, QStringLiteral("--rom"), saved}));
        QCOMPARE(bytesOf(saved), bytesOf(given));

        QVERIFY(probeCommand().run({given, QStringLiteral("--angle-deg"), QStringLiteral("60"),
                                    QStringLiteral("--rom"), saved}));
        auto due = romCommand().run({given});
        auto is = romCommand().run({saved});
        QVERIFY(due && is);
        QVERIFY(std::abs(number(*is, "largest_angle_deg") - 60.0) < 1e-9);
        for (const char* other : {"file", "largest_angle_deg"}) {
            due->remove(QLatin1StringView{other});
            is->remove(QLatin1StringView{other});
        }
        QCOMPARE(*is, *due);
    }

    void readsALayoutFromATable()
    {
        const QTemporaryDir folder;
        const QString csv = folder.filePath(QStringLiteral("square.csv"));
        QFile file{csv};
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("x_mm,y_mm,z_mm,nx,ny,nz\n50,0,0,0,0,0\n0,50,0,0,0,0\n-50,0,0,0,0,0\n"
                   "0,-50,0,0,0,0\n");
        file.close();
        const auto object =
            probeCommand().run({csv, QStringLiteral("--noise-mm"), QStringLiteral("0.3")});
        QVERIFY(object);
        QVERIFY(std::abs(number(*object, "position_rms_mm") - 0.15) < 1e-6); // e / sqrt(4)
        QCOMPARE(number(*object, "share_with_pose"), 1.0);
        QCOMPARE(number(*object, "share_identified"), 0.0); // it is a square
    }

    void makesASolidThatIsClosed()
    {
        Probe probe;
        for (const Vec3& d : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-1, -1, 0}})
            probe.markers.push_back({0.03 * d.normalized(), d.normalized()});
        const TriangleMesh solid = solidOf(probe, millimetres(2.0));
        QVERIFY(!solid.empty());
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const Triangle& triangle : solid.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                ++edges[{triangle[i], triangle[(i + 1) % 3]}];
        for (const auto& [edge, count] : edges) {
            const auto back = edges.find({edge.second, edge.first});
            QVERIFY(back != edges.end() && back->second == count);
        }
        // More than the ball about the middle, less than a ball around all.
        QVERIFY(signedVolume(solid) > 3e-6);
        QVERIFY(signedVolume(solid) < 1.4e-4);

        const std::string stl = stlOf(solid, "test");
        QCOMPARE(stl.size(), 84 + 50 * solid.triangles.size());
        std::uint32_t count = 0;
        std::memcpy(&count, stl.data() + 80, sizeof count);
        QCOMPARE(std::size_t{count}, solid.triangles.size());
    }

    void refusesWhatItCannotUse()
    {
        QVERIFY(!probeCommand().run({}));
        QVERIFY(!probeCommand().run(designOf({QStringLiteral("file.rom")})));
        QVERIFY(!probeCommand().run({QStringLiteral("nowhere.rom")}));
        QVERIFY(!probeCommand().run(designOf({QStringLiteral("--markers"), QStringLiteral("3")})));
        QVERIFY(!probeCommand().run(designOf({QStringLiteral("--point"), QStringLiteral("1,2")})));
        // A definition has whole degrees.
        const QTemporaryDir folder;
        QVERIFY(!probeCommand().run(
            designOf({QStringLiteral("--markers"), QStringLiteral("8"), QStringLiteral("--seen"),
                      QStringLiteral("3"), QStringLiteral("--angle-deg"), QStringLiteral("60.5"),
                      QStringLiteral("--rom"), folder.filePath(QStringLiteral("half.rom"))})));
    }
};

CARINA_TEST(ProbeCommandTest)

} // namespace carina::lab::probe_command_test

#include "tst_probe_command.moc"
