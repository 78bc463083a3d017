#include "tests/engine/tracking/ndi/recorded_device.h"
#include "tests/engine/tracking/ndi/written_poses.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <cmath>

namespace carina::ndi_recorded_set_up_test
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kDelay = 1ms;
constexpr double kPlace_mm = 1e-6;
constexpr double kError_mm = 1e-6;
constexpr int kMostSteps = 100; // of 100 ms

std::vector<std::string> commandsOf(const std::vector<NdiExchange>& recording)
{
    std::vector<std::string> commands;
    for (const NdiExchange& each : recording)
        commands.push_back(each.command);
    return commands;
}

/// Of the commands up to the first TSTART those that change the state of the device, and the first
/// look each for ports to be freed and to be initialised. The others only ask: VER, SFLIST and
/// PHINF, of which programs want to know different things, and PHSR after a change. RESET is left
/// out, too: the recordings begin behind a break.
std::vector<std::string> setUpOf(const std::vector<std::string>& commands)
{
    const std::set<std::string> changing{"COMM", "INIT", "PHRQ", "PVWR", "PINIT", "PENA", "TSTART"};
    std::vector<std::string> setUp;
    for (const std::string& command : commands) {
        const std::string name = command.substr(0, command.find(':'));
        const bool isLook = command.starts_with("PHSR:01") || command.starts_with("PHSR:02");
        const bool isFirst = std::ranges::find(setUp, command) == setUp.end();
        if (changing.contains(name) || (isLook && isFirst))
            setUp.push_back(command);
        if (name == "TSTART")
            break;
    }
    return setUp;
}

/// The commands of one tool, in their order. @param handle empty: those of no tool
std::vector<std::string> ofTool(const std::vector<std::string>& setUp, const std::string& handle,
                                const std::set<std::string>& wireless)
{
    const std::set<std::string> namesPort{"PVWR", "PINIT", "PENA"};
    std::vector<std::string> commands;
    for (const std::string& command : setUp) {
        const std::size_t colon = command.find(':');
        const std::string name = command.substr(0, colon);
        const bool asksForHandle = name == "PHRQ";
        const std::string of =
            namesPort.contains(name) ? command.substr(colon + 1, 2) : std::string{};
        if (asksForHandle ? wireless.contains(handle) : of == handle)
            commands.push_back(command);
    }
    return commands;
}

/// What the recorded program wrote into the device.
std::optional<NdiToolDefinition> definitionIn(const std::vector<std::string>& commands)
{
    QByteArray bytes;
    for (const std::string& command : commands)
        if (command.starts_with("PVWR:"))
            bytes += QByteArray::fromHex(QByteArray::fromStdString(command.substr(11, 128)));
    bytes.truncate(qsizetype(NdiToolDefinition::kBytes));
    const auto read = NdiToolDefinition::read(
        std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())}));
    return read ? std::optional{*read} : std::nullopt;
}

/// Handles are given in this order: the wireless tool has the first.
NdiClientSettings settingsFor(const std::vector<std::string>& commands, int wired, int rate)
{
    NdiClientSettings settings{.tools = {}, .poses = NdiPoseReply::Tx, .rates = {rate}};
    if (auto definition = definitionIn(commands))
        settings.tools.push_back({"wireless", std::move(definition)});
    for (int i = 1; i <= wired; ++i)
        settings.tools.push_back({"wired " + std::to_string(i)});
    return settings;
}

/// Readable in a failure.
QByteArray lines(const std::vector<std::string>& commands)
{
    QByteArray text;
    for (const std::string& command : commands)
        text += QByteArray::fromStdString(command).trimmed() + '\n';
    return text;
}

} // namespace

/// The client, before devices that answer as those did that other programs brought to tracking and
/// recorded.
class NdiRecordedSetUpTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sendsWhatARecordedProgramSent_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("rate"); // that the recorded program set
        QTest::addColumn<int>("wired");
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("one wired tool, 9600 bits a second")
            << "polaris_stream_07_13_2005.txt" << 9600 << 1 << QByteArray{};
        QTest::newRow("one wired tool, 115200 bits a second")
            << "polaris_stream_03_31_2005_1.txt" << 115200 << 1
            << QByteArray{"Polaris Control Firmware, NDI S/N: P4-00148"};
        QTest::newRow("a wireless tool and two wired ones")
            << "polaris_stream_11_05_2005.txt" << 9600 << 2
            << QByteArray{"Polaris Control Firmware, NDI S/N: P4-03126"};
    }

    /// Byte for byte, with checksum and CR. The order holds within each tool, and of what is of no
    /// tool; with one tool, of all. Which of several tools comes first is free, as each command
    /// names its port: the recorded program defined the wireless one first, the client takes the
    /// wired ones first, when PHSR:02 lists no others.
    void sendsWhatARecordedProgramSent()
    {
        QFETCH(const QString, file);
        QFETCH(const int, rate);
        QFETCH(const int, wired);
        QFETCH(const QByteArray, name);
        const auto path = test::testData("tracker/ndi-recordings/" + file.toStdString());
        if (!path)
            QSKIP("no recordings of a Polaris");
        const auto recording = readNdiRecordingFile(*path);
        QVERIFY2(recording, recording ? "" : recording.error().detail.c_str());
        const auto commands = commandsOf(*recording);
        const auto recorded = setUpOf(commands);
        QVERIFY(!recorded.empty() && recorded.back().starts_with("TSTART:"));

        test::RecordedDevice device{*recording};
        const NdiClientSettings settings = settingsFor(commands, wired, rate);
        const std::size_t tools = settings.tools.size();
        QCOMPARE(tools, device.wireless().size() + std::size_t(wired));
        test::ScriptedLine line{settings, kDelay, [&](const std::string& command, LocalTime) {
                                    return device.answer(command);
                                }};
        line.start();
        std::vector<NdiMeasurement> measured;
        for (int step = 0; step < kMostSteps && device.hasPoses(); ++step)
            for (NdiMeasurement& each : line.run(100ms))
                measured.push_back(std::move(each));

        const auto sent = setUpOf(line.sent());
        const auto& wireless = device.wireless();
        QCOMPARE(lines(ofTool(sent, {}, wireless)), lines(ofTool(recorded, {}, wireless)));
        for (std::size_t tool = 1; tool <= tools; ++tool) {
            const std::string handle = '0' + std::to_string(tool);
            QVERIFY(!ofTool(sent, handle, wireless).empty());
            QCOMPARE(lines(ofTool(sent, handle, wireless)),
                     lines(ofTool(recorded, handle, wireless)));
        }
        QCOMPARE(sent.size(), recorded.size());
        if (tools == 1)
            QCOMPARE(lines(sent), lines(recorded));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.client().trouble(), std::string{});
        QCOMPARE(line.client().damagedReplies(), std::size_t{0});
        const NdiFound found{name.toStdString(), std::size_t(wired)};
        QVERIFY(line.client().found() == found);
        compare(measured, test::posesWrittenIn(QString::fromStdString(*path)));
    }

private:
    /// All poses, in their order.
    static void compare(const std::vector<NdiMeasurement>& measured,
                        const std::vector<test::WrittenPose>& written)
    {
        std::vector<NdiTool> poses;
        for (const NdiMeasurement& each : measured)
            for (const auto& tool : each.tools)
                if (tool && tool->X_TO)
                    poses.push_back(*tool);
        QVERIFY(!written.empty());
        QCOMPARE(poses.size(), written.size());
        for (std::size_t i = 0; i < poses.size(); ++i) {
            QCOMPARE(int(poses[i].handle), written[i].handle);
            QCOMPARE(poses[i].frameNumber, written[i].frame);
            QVERIFY((1e3 * poses[i].X_TO->translation() - written[i].p_mm).norm() < kPlace_mm);
            QVERIFY(std::abs(1e3 * poses[i].error - written[i].error_mm) < kError_mm);
        }
    }
};

CARINA_TEST(NdiRecordedSetUpTest)

} // namespace carina::ndi_recorded_set_up_test

#include "tst_ndi_recorded_set_up.moc"
