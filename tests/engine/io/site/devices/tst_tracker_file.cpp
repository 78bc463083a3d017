#include "engine/io/site/devices/tracker_file.h"

#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>

namespace carina::tracker_file_test
{
namespace
{

const std::string kTools = R"([{"name": "Tube", "role": "tube", "definition": "tube.rom"},
                               {"name": "Chin", "role": "jaw"}])";

/// A folder with a definition, and a description that was written into it.
class Folder
{
public:
    Folder()
    {
        const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
        const auto tube =
            NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "tube");
        const auto& bytes = tube.value().bytes();
        write("tube.rom", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        write("empty.rom", "NDI");
    }

    [[nodiscard]] Result<TrackerDescription> read(const std::string& text) const
    {
        write("tracker.json", text);
        return readTrackerFile(pathOf("tracker.json"));
    }

    [[nodiscard]] Result<TrackerDescription> readWith(const std::string& more,
                                                      const std::string& tools = kTools) const
    {
        return read(R"({"schema": "carina.tracker/1", "kind": "ndi", "address": "/dev/ttyUSB0", )"
                    + more + R"("tools": )" + tools + "}");
    }

    [[nodiscard]] std::string pathOf(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }

private:
    void write(const char* name, const std::string& bytes) const
    {
        std::ofstream{pathOf(name), std::ios::binary} << bytes;
    }

    QTemporaryDir m_folder;
};

} // namespace

class TrackerFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsADescription()
    {
        const Folder folder;
        const auto tracker = folder.readWith(R"("poses": "BX2", "fastest_rate": 115200, )");
        QVERIFY2(tracker, tracker ? "" : tracker.error().detail.c_str());
        QCOMPARE(tracker->address, std::string{"/dev/ttyUSB0"});
        QCOMPARE(tracker->poses, NdiPoseReply::Bx2);
        QCOMPARE(tracker->fastestRate, 115200);
        QCOMPARE(tracker->tools.size(), std::size_t{2});
        QCOMPARE(tracker->tools[0].role, ToolRole::Tube);
        QCOMPARE(tracker->tools[0].definition->partNumber(), std::string{"tube"});
        QCOMPARE(tracker->tools[1].name, std::string{"Chin"});
        QCOMPARE(tracker->tools[1].role, ToolRole::Jaw);
        QVERIFY(!tracker->tools[1].definition);
    }

    void asksForBxAtTheBestRateUnlessToldOtherwise()
    {
        const auto tracker = Folder{}.readWith("");
        QVERIFY(tracker);
        QCOMPARE(tracker->poses, NdiPoseReply::Bx);
        QCOMPARE(tracker->fastestRate, 921600);
    }

    void knowsEveryRole_data()
    {
        QTest::addColumn<ToolRole>("role");
        QTest::newRow("head") << ToolRole::Head;
        QTest::newRow("jaw") << ToolRole::Jaw;
        QTest::newRow("tube") << ToolRole::Tube;
        QTest::newRow("stylus") << ToolRole::Stylus;
        QTest::newRow("manikin") << ToolRole::Manikin;
        QTest::newRow("chest") << ToolRole::Chest;
        QTest::newRow("hand") << ToolRole::Hand;
        QTest::newRow("laryngoscope") << ToolRole::Laryngoscope;
        QTest::newRow("other") << ToolRole::Other;
    }

    void knowsEveryRole()
    {
        QFETCH(const ToolRole, role);
        const auto tracker = Folder{}.readWith(
            "", R"([{"name": "a", "role": ")" + std::string{QTest::currentDataTag()} + R"("}])");
        QVERIFY2(tracker, tracker ? "" : tracker.error().detail.c_str());
        QCOMPARE(tracker->tools[0].role, role);
    }

    void readsWhatItWrote()
    {
        const Folder folder;
        auto described = folder.readWith(R"("poses": "BX2", "fastest_rate": 57600, )");
        QVERIFY(described);
        const QTemporaryDir elsewhere;
        const auto file = elsewhere.filePath(QStringLiteral("bench.json")).toStdString();
        QVERIFY(writeTrackerFile(file, *described));
        QVERIFY(QFile::exists(elsewhere.filePath(QStringLiteral("bench-1.rom"))));
        const auto read = readTrackerFile(file);
        QVERIFY2(read, read ? "" : read.error().detail.c_str());
        QCOMPARE(read->address, described->address);
        QCOMPARE(read->poses, NdiPoseReply::Bx2);
        QCOMPARE(read->fastestRate, 57600);
        QCOMPARE(read->tools.size(), std::size_t{2});
        QCOMPARE(read->tools[0].name, std::string{"Tube"});
        QVERIFY(read->tools[0].definition->bytes() == described->tools[0].definition->bytes());
        QCOMPARE(read->tools[1].role, ToolRole::Jaw);
        QVERIFY(!read->tools[1].definition);
    }

    void saysWhereItCannotWrite()
    {
        const QTemporaryDir folder;
        const auto file = std::filesystem::path{folder.path().toStdString()} / "file";
        std::ofstream{file} << "is no folder";
        const auto written = writeTrackerFile(file / "bench.json", {.address = "host:1"});
        QVERIFY(!written);
        QCOMPARE(written.error().code, Errc::FileUnwritable);
    }

    void readsAServerOfOpenIgtLink()
    {
        const Folder folder;
        const auto tracker = folder.read(R"({"schema": "carina.tracker/1", "kind": "openigtlink",
            "address": "127.0.0.1:18944", "poses": "QTDATA", "rate": 30, "tools": [
            {"name": "Tube", "role": "tube", "device": "TubeToTracker"},
            {"name": "Chin", "role": "jaw"}]})");
        QVERIFY2(tracker, tracker ? "" : tracker.error().detail.c_str());
        QVERIFY(tracker->kind == TrackerKind::OpenIgtLink);
        QVERIFY(tracker->igtlPoses == IgtlPoses::Qtdata);
        QCOMPARE(tracker->rate_hz, 30);
        QCOMPARE(tracker->tools[0].device, std::string{"TubeToTracker"});
        QVERIFY(tracker->tools[1].device.empty());
        const QTemporaryDir elsewhere;
        const auto file = elsewhere.filePath(QStringLiteral("plus.json")).toStdString();
        QVERIFY(writeTrackerFile(file, *tracker));
        const auto again = readTrackerFile(file);
        QVERIFY2(again, again ? "" : again.error().detail.c_str());
        QVERIFY(again->kind == tracker->kind && again->igtlPoses == tracker->igtlPoses);
        QCOMPARE(again->rate_hz, 30);
        QCOMPARE(again->tools[0].device, tracker->tools[0].device);
    }

    void keepsTheFieldsOfItsKindsApart_data()
    {
        QTest::addColumn<QByteArray>("fields");
        QTest::addColumn<QByteArray>("named");
        QTest::newRow("a serial rate")
            << QByteArray{R"("fastest_rate": 9600,)"} << QByteArray{"fastest_rate"};
        QTest::newRow("a command") << QByteArray{R"("poses": "BX",)"} << QByteArray{"poses"};
        QTest::newRow("no rate") << QByteArray{R"("rate": 0,)"} << QByteArray{"rate"};
        QTest::newRow("a high rate") << QByteArray{R"("rate": 1001,)"} << QByteArray{"rate"};
        QTest::newRow("a definition") << QByteArray{} << QByteArray{"definition"};
    }

    void keepsTheFieldsOfItsKindsApart()
    {
        QFETCH(const QByteArray, fields);
        QFETCH(const QByteArray, named);
        const std::string tool = fields.isEmpty() ? R"(, "definition": "tube.rom")" : "";
        const auto tracker = Folder{}.read(
            R"({"schema": "carina.tracker/1", "kind": "openigtlink", "address": "localhost:18944",)"
            + fields.toStdString() + R"("tools": [{"name": "Tube", "role": "tube")" + tool + "}]}");
        QVERIFY(!tracker);
        QCOMPARE(tracker.error().code, Errc::FileMalformed);
        QVERIFY2(QByteArray::fromStdString(tracker.error().detail).contains(named),
                 tracker.error().detail.c_str());
    }

    void namesWhatIsWrong_data()
    {
        QTest::addColumn<QByteArray>("more");
        QTest::addColumn<QByteArray>("tools");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("named");
        const auto row = [](const char* name, const char* more, const char* tools, Errc code,
                            const char* named) {
            QTest::newRow(name) << QByteArray{more} << QByteArray{tools} << int(code)
                                << QByteArray{named};
        };
        const char* tube = R"([{"name": "Tube", "role": "tube"}])";
        row("an unknown field", R"("port": 3, )", tube, Errc::FileMalformed, "port");
        row("unknown poses", R"("poses": "GX", )", tube, Errc::FileMalformed, "poses");
        row("a slow rate", R"("fastest_rate": 300, )", tube, Errc::FileMalformed, "fastest_rate");
        row("no tools", "", "[]", Errc::FileMalformed, "tools");
        row("an unknown role", "", R"([{"name": "a", "role": "nose"}])", Errc::FileMalformed,
            "role");
        row("a name twice", "", R"([{"name": "a", "role": "tube"}, {"name": "a", "role": "head"}])",
            Errc::FileMalformed, "tools[1].name");
        row("a role twice", "", R"([{"name": "a", "role": "tube"}, {"name": "b", "role": "tube"}])",
            Errc::FileMalformed, "tools[1].role");
        row("no definition", "", R"([{"name": "a", "role": "tube", "definition": "no.rom"}])",
            Errc::FileNotFound, "no.rom");
        row("a damaged definition", "",
            R"([{"name": "a", "role": "tube", "definition": "empty.rom"}])", Errc::FileMalformed,
            "empty.rom");
    }

    void namesWhatIsWrong()
    {
        QFETCH(QByteArray, more);
        QFETCH(QByteArray, tools);
        QFETCH(int, code);
        QFETCH(QByteArray, named);
        const auto tracker = Folder{}.readWith(more.toStdString(), tools.toStdString());
        QVERIFY(!tracker);
        QCOMPARE(int(tracker.error().code), code);
        QVERIFY2(QByteArray::fromStdString(tracker.error().detail).contains(named),
                 tracker.error().detail.c_str());
    }

    void refusesAnotherKindOfFile()
    {
        const auto tracker = Folder{}.read(R"({"schema": "carina.site/1"})");
        QVERIFY(!tracker);
        QCOMPARE(tracker.error().code, Errc::UnknownFormat);
    }

    /// A description names only what lies beside it: no file of somebody else's, not even by a
    /// link.
    void takesNoDefinitionFromElsewhere_data()
    {
        QTest::addColumn<QByteArray>("definition");
        QTest::newRow("a path from the root") << QByteArray{"ELSEWHERE/tube.rom"};
        QTest::newRow("upwards") << QByteArray{"../NEIGHBOUR/tube.rom"};
        QTest::newRow("a link") << QByteArray{"link.rom"};
    }

    void takesNoDefinitionFromElsewhere()
    {
        QFETCH(QByteArray, definition);
        const Folder elsewhere;
        const Folder folder;
        const std::filesystem::path other =
            std::filesystem::path{elsewhere.pathOf("tube.rom")}.parent_path();
        std::filesystem::create_symlink(elsewhere.pathOf("tube.rom"), folder.pathOf("link.rom"));
        definition.replace("ELSEWHERE", other.c_str());
        definition.replace("NEIGHBOUR", other.filename().c_str());
        std::string tools = R"([{"name": "a", "role": "tube", "definition": "NAMED"}])";
        tools.replace(tools.find("NAMED"), 5, definition.toStdString());
        const auto tracker = folder.readWith("", tools);
        QVERIFY(!tracker);
        QCOMPARE(tracker.error().code, Errc::FileUnreadable);
        QVERIFY(tracker.error().detail.find("tube.rom") != std::string::npos
                || tracker.error().detail.find("link.rom") != std::string::npos);
    }

    /// As it is started with a description in the present folder.
    void findsADefinitionBesideADescriptionWithoutAFolder()
    {
        const Folder folder;
        QVERIFY(folder.readWith(""));
        const std::filesystem::path before = std::filesystem::current_path();
        std::filesystem::current_path(
            std::filesystem::path{folder.pathOf("tracker.json")}.parent_path());
        const auto tracker = readTrackerFile("tracker.json");
        std::filesystem::current_path(before);
        QVERIFY2(tracker, tracker ? "" : tracker.error().detail.c_str());
    }
};

CARINA_TEST(TrackerFileTest)

} // namespace carina::tracker_file_test

#include "tst_tracker_file.moc"
