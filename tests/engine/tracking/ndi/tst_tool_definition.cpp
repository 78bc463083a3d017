#include "engine/tracking/ndi/tool_definition.h"

#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QDir>
#include <QFile>

#include <algorithm>
#include <array>

#include <cmath>

namespace carina::tool_definition_test
{
namespace
{

std::vector<std::byte> bytesOf(const QString& path)
{
    QFile file{path};
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray read = file.readAll();
    const auto bytes = std::as_bytes(std::span{read.constData(), std::size_t(read.size())});
    return {bytes.begin(), bytes.end()};
}

const std::vector<ToolMarker> kMarkers{{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}},
                                       {{0.05, 0.0, 0.0}, {0.0, 0.0, 1.0}},
                                       {{0.0, 0.08, 0.001}, {0.0, 0.0, 1.0}}};

std::vector<std::byte> made()
{
    const auto tool =
        NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, kMarkers, "Carina", "stylus-1");
    return tool ? std::vector<std::byte>{tool->bytes().begin(), tool->bytes().end()}
                : std::vector<std::byte>{};
}

/// With other bytes, and the checksum that fits.
std::vector<std::byte> changed(std::size_t at, std::initializer_list<std::uint8_t> values)
{
    std::vector<std::byte> bytes = made();
    std::ranges::transform(values, bytes.begin() + std::ptrdiff_t(at),
                           [](std::uint8_t value) { return std::byte{value}; });
    std::uint32_t sum = 0;
    for (std::size_t i = 6; i < bytes.size(); ++i)
        sum += std::to_integer<std::uint32_t>(bytes[i]);
    bytes[4] = std::byte(sum & 0xFFU);
    bytes[5] = std::byte((sum >> 8U) & 0xFFU);
    return bytes;
}

Errc errorOf(const Result<NdiToolDefinition>& tool)
{
    return tool ? Errc::Cancelled : tool.error().code;
}

} // namespace

class ToolDefinitionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsWhatItMakes()
    {
        const auto tool = NdiToolDefinition::read(made());
        QVERIFY(tool);
        QCOMPARE(tool->kind(), std::uint8_t{2});
        QCOMPARE(kindName(tool->kind()), std::string{"pointer"});
        QCOMPARE(tool->maker(), std::string{"Carina"});
        QCOMPARE(tool->partNumber(), std::string{"stylus-1"});
        QCOMPARE(tool->fewestMarkers(), 3U);
        QCOMPARE(inMillimetres(tool->largestMarkerError()), 2.0);
        QCOMPARE(inDegrees(tool->largestMarkerAngle()), 90.0);
        const auto markers = tool->markers();
        QCOMPARE(markers.size(), kMarkers.size());
        for (std::size_t i = 0; i < markers.size(); ++i) {
            QVERIFY((markers[i].p_OQ - kMarkers[i].p_OQ).norm() < 1e-8);
            QCOMPARE(markers[i].normal_O, kMarkers[i].normal_O);
        }
    }

    void statesWhatAProbeAsks()
    {
        std::vector<ToolMarker> markers = kMarkers;
        markers.push_back({{0.03, 0.03, 0.03}, {0.0, 0.0, 1.0}});
        const auto makeOf = [&](Angle angle, std::size_t fewest, Length misfit) {
            return NdiToolDefinition::make(NdiToolDefinition::Kind::Reference,
                                           Probe{markers, angle, fewest, misfit}, "", "");
        };
        const auto tool = makeOf(degrees(60.0), 4, millimetres(0.75));
        QVERIFY(tool);
        const Probe probe = tool->probe();
        QVERIFY(std::abs(inDegrees(probe.largestAngle) - 60.0) < 1e-9);
        QCOMPARE(probe.fewest, std::size_t{4});
        QCOMPARE(inMillimetres(probe.largestMisfit), 0.75);
        QVERIFY(NdiToolDefinition::read(tool->bytes()));
        const Length mm = millimetres(1.0);
        QCOMPARE(errorOf(makeOf(degrees(60.5), 4, mm)), Errc::OutOfRange);
        QCOMPARE(errorOf(makeOf(degrees(0.0), 4, mm)), Errc::OutOfRange);
        QCOMPARE(errorOf(makeOf(degrees(181.0), 4, mm)), Errc::OutOfRange);
        QCOMPARE(errorOf(makeOf(degrees(std::nan("")), 4, mm)), Errc::OutOfRange);
        QCOMPARE(errorOf(makeOf(degrees(60.0), 5, mm)), Errc::OutOfRange);
        QCOMPARE(errorOf(makeOf(degrees(60.0), 2, mm)), Errc::OutOfRange);
        QCOMPARE(errorOf(makeOf(degrees(60.0), 4, millimetres(0.0))), Errc::OutOfRange);
        QCOMPARE(errorOf(makeOf(degrees(60.0), 4, millimetres(std::nan("")))), Errc::OutOfRange);
    }

    void changesFactsAndKeepsTheRest()
    {
        // Behind the names are bytes that mean nothing, as in files of others.
        const auto bytes = changed(580, {'U', 'N', 0, 0xD0, 0x21});
        const auto tool = NdiToolDefinition::read(bytes);
        QVERIFY(tool);
        const auto same = tool->with(tool->facts());
        QVERIFY(same);
        QVERIFY(std::ranges::equal(same->bytes(), tool->bytes()));

        NdiToolDefinition::Facts facts = tool->facts();
        facts.kind = 1;
        facts.partNumber = "chin";
        facts.largestMarkerError = millimetres(0.5);
        facts.smallestSpread = millimetres(12.0);
        facts.largestMarkerAngle = degrees(45.0);
        const auto other = tool->with(facts);
        QVERIFY(other);
        const auto read = NdiToolDefinition::read(other->bytes());
        QVERIFY(read);
        QCOMPARE(kindName(read->kind()), std::string{"reference"});
        QCOMPARE(read->maker(), std::string{"UN"});
        QCOMPARE(read->partNumber(), std::string{"chin"});
        QCOMPARE(inMillimetres(read->largestMarkerError()), 0.5);
        QCOMPARE(inMillimetres(read->smallestSpread()), 12.0);
        QVERIFY(std::abs(inDegrees(read->largestMarkerAngle()) - 45.0) < 1e-9);
        // The maker's field as a whole, and all of the markers.
        for (const auto& [from, until] : {std::pair{72, 592}, {612, 752}})
            for (int i = from; i < until; ++i)
                QCOMPARE(other->bytes()[std::size_t(i)], tool->bytes()[std::size_t(i)]);
    }

    void refusesFactsThatAFileCannotState()
    {
        // What a file states already may stay, whatever it is: here a kind without a name.
        const auto tool = NdiToolDefinition::read(changed(15, {7}));
        QVERIFY(tool);
        using Facts = NdiToolDefinition::Facts;
        const auto errorWith = [&](auto change) {
            Facts facts = tool->facts();
            change(facts);
            return errorOf(tool->with(facts));
        };
        QCOMPARE(errorWith([](Facts& facts) { facts.partNumber = "x"; }), Errc::Cancelled);
        QCOMPARE(errorWith([](Facts& facts) { facts.kind = 9; }), Errc::OutOfRange);
        QCOMPARE(errorWith([](Facts& facts) { facts.maker = "thirteen char"; }), Errc::OutOfRange);
        QCOMPARE(errorWith([](Facts& facts) { facts.partNumber = std::string(21, 'x'); }),
                 Errc::OutOfRange);
        QCOMPARE(errorWith([](Facts& facts) { facts.partNumber = "a\tb"; }), Errc::OutOfRange);
        QCOMPARE(errorWith([](Facts& facts) { facts.fewestMarkers = 2; }), Errc::OutOfRange);
        QCOMPARE(errorWith([](Facts& facts) { facts.fewestMarkers = 4; }), Errc::OutOfRange);
        QCOMPARE(errorWith([](Facts& facts) { facts.largestMarkerError = millimetres(101.0); }),
                 Errc::OutOfRange);
        QCOMPARE(errorWith([](Facts& facts) { facts.smallestSpread = millimetres(-1.0); }),
                 Errc::OutOfRange);
        QCOMPARE(errorWith([](Facts& facts) { facts.largestMarkerAngle = degrees(181.0); }),
                 Errc::OutOfRange);
    }

    void namesItsKinds()
    {
        QCOMPARE(kindName(7), std::string{"kind 7"});
        QVERIFY(!kindOfName("kind 7"));
        QCOMPARE(kindOfName("C-arm"), std::optional{std::uint8_t{0xA}});
        QVERIFY(kindNames().starts_with("reference, pointer, "));
    }

    void cutsNamesThatAreTooLong()
    {
        const auto tool =
            NdiToolDefinition::make(NdiToolDefinition::Kind::Reference, kMarkers,
                                    "a maker with a long name", "a part number that is too long");
        QVERIFY(tool);
        QCOMPARE(tool->maker(), std::string{"a maker with"});
        QCOMPARE(tool->partNumber(), std::string{"a part number that i"});
    }

    void refusesWhatIsNoTool()
    {
        using Kind = NdiToolDefinition::Kind;
        const std::span all{kMarkers};
        const auto makeOf = [](std::span<const ToolMarker> markers) {
            return errorOf(NdiToolDefinition::make(Kind::Pointer, markers, "", ""));
        };
        QCOMPARE(makeOf(all.first(2)), Errc::TooFewLandmarks);
        QCOMPARE(makeOf(std::vector<ToolMarker>(21)), Errc::OutOfRange);
        QCOMPARE(makeOf(std::vector<ToolMarker>(3)), Errc::DegenerateLandmarks);
        const std::vector<ToolMarker> line{{{0, 0, 0}}, {{0.1, 0, 0}}, {{0.05, 0.0005, 0}}};
        QCOMPARE(makeOf(line), Errc::DegenerateLandmarks);
        const std::vector<ToolMarker> far{{{0, 0, 0}}, {{0.1, 0, 0}}, {{0, 2.1, 0}}};
        QCOMPARE(makeOf(far), Errc::OutOfRange);
    }

    void refusesDamagedFiles_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const std::vector<std::byte>& bytes, Errc code) {
            QTest::newRow(name) << QByteArray{reinterpret_cast<const char*>(bytes.data()),
                                              qsizetype(bytes.size())}
                                << int(code);
        };
        row("nothing", {}, Errc::FileMalformed);
        std::vector<std::byte> cut = made();
        cut.pop_back();
        row("a byte too few", cut, Errc::FileMalformed);
        std::vector<std::byte> bit = made();
        bit[100] ^= std::byte{1};
        row("a bit", bit, Errc::FileMalformed);
        row("another beginning", changed(0, {'M'}), Errc::FileMalformed);
        row("no markers", changed(28, {0}), Errc::FileMalformed);
        row("21 markers", changed(28, {21}), Errc::FileMalformed);
        row("a marker at a huge number", changed(72 + 3, {0x7F}), Errc::OutOfRange);
        row("a marker far away", changed(84 + 3, {0x47}), Errc::OutOfRange);
        row("no limit for an error", changed(36 + 2, {0xC0, 0x7F}), Errc::NotFinite);
        row("no limit for the spread", changed(64 + 2, {0xC0, 0x7F}), Errc::NotFinite);
    }

    void refusesDamagedFiles()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(int, code);
        QCOMPARE(int(errorOf(NdiToolDefinition::read(
                     std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())})))),
                 code);
    }

    void readsTheFilesOfOthers()
    {
        const auto folder = test::testData("tracker/rom");
        if (!folder)
            QSKIP("no tool definitions");
        const QDir files{QString::fromStdString(*folder)};
        const QStringList names = files.entryList({QStringLiteral("*.rom")});
        QVERIFY(!names.empty());
        for (const QString& name : names) {
            const auto bytes = bytesOf(files.filePath(name));
            const auto tool = NdiToolDefinition::read(bytes);
            QVERIFY2(tool, qPrintable(name));
            QVERIFY(std::ranges::equal(tool->bytes(), bytes));
            QVERIFY(tool->markers().size() >= 3);
        }
    }

    // The pointer of NDI has two markers on its shaft and two beside it.
    void readsThePointerOfNdi()
    {
        const auto file = test::testData("tracker/rom/8700340.rom");
        if (!file)
            QSKIP("no tool definitions");
        const auto tool = NdiToolDefinition::read(bytesOf(QString::fromStdString(*file)));
        QVERIFY(tool);
        QCOMPARE(kindName(tool->kind()), std::string{"pointer"});
        QCOMPARE(tool->partNumber(), std::string{"8700340"});
        QCOMPARE(inMillimetres(tool->largestMarkerError()), 0.75);
        const std::array<Vec3, 4> due_mm{
            {{0.0, 0.0, 0.0}, {0.0, 0.0, 50.0}, {0.0, 25.0, 100.0}, {0.0, -25.0, 135.0}}};
        QCOMPARE(tool->markers().size(), due_mm.size());
        for (std::size_t i = 0; i < due_mm.size(); ++i)
            QVERIFY((1e3 * tool->markers()[i].p_OQ - due_mm[i]).norm() < 1e-3);
    }

    void movesOneMarkerAndKeepsTheRest()
    {
        const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
        const auto tool =
            NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "tube");
        const auto moved = tool.value().withMarker(1, {0.06, -0.01, 0.002});
        QVERIFY(moved);
        QVERIFY((1e3 * moved->markers()[1].p_OQ - Vec3{60.0, -10.0, 2.0}).norm() < 1e-5);
        // Twelve bytes of the place and two of the checksum, which is right.
        std::size_t changed = 0;
        for (std::size_t i = 0; i < NdiToolDefinition::kBytes; ++i)
            changed += moved->bytes()[i] != tool->bytes()[i] ? 1 : 0;
        QVERIFY(changed > 0 && changed <= 14);
        QVERIFY(NdiToolDefinition::read(moved->bytes()));
    }

    void refusesAPlaceThatDeterminesNoPose()
    {
        const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
        const auto tool =
            NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "tube");
        QCOMPARE(tool.value().withMarker(2, {0.1, 0.0, 0.0}).error().code,
                 Errc::DegenerateLandmarks);
        QCOMPARE(tool.value().withMarker(2, {0.0, 2.5, 0.0}).error().code, Errc::OutOfRange);
        QCOMPARE(tool.value().withMarker(2, {0.0, std::nan(""), 0.0}).error().code,
                 Errc::OutOfRange);
    }
};

CARINA_TEST(ToolDefinitionTest)

} // namespace carina::tool_definition_test

#include "tst_tool_definition.moc"
