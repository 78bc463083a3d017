#include "tests/evaluation/polaris/recorded_polaris.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

namespace carina::recorded_conversations_test
{
namespace
{

using namespace std::chrono_literals;
using test::bare;

/// The simulated device, which sees the tools that the recorded one saw.
class RecordedPolaris
{
public:
    explicit RecordedPolaris(PolarisDevice::Settings settings)
        : m_device{seeing(std::move(settings)),
                   [this](const std::string&, LocalTime) { return poseOfNext(); }}
    {
    }

    /// The answer to a command, as the recorded one saw it.
    [[nodiscard]] std::string answer(const std::string& command, const test::PoseShape& seen)
    {
        m_now += 100ms;
        m_seen = seen;
        m_asked = 0;
        putTools();
        const std::string bytes = command + '\r';
        const auto replies = m_device.take(std::as_bytes(std::span{bytes}), m_device.rate(), m_now);
        return replies.size() == 1 ? replies[0].bytes : std::string{};
    }
    [[nodiscard]] std::string reset() { return bare(m_device.reset(m_now).bytes); }

private:
    [[nodiscard]] PolarisDevice::Settings seeing(PolarisDevice::Settings settings)
    {
        settings.strays = [this](LocalTime) {
            return std::vector<Vec3>(m_seen.strays, Vec3::Zero());
        };
        return settings;
    }
    /// Where the recorded one said that they are.
    void putTools()
    {
        auto place = m_seen.places.begin();
        for (const auto& [handle, port] : m_device.ports().all())
            if (port.isEnabled && place != m_seen.places.end())
                m_device.faults().places[port.tool] = *place++;
    }
    /// It is asked for in the order of the handles.
    [[nodiscard]] std::optional<PolarisPose> poseOfNext()
    {
        const std::size_t tool = m_asked++;
        const bool isSeen = tool < m_seen.isSeen.size() && m_seen.isSeen[tool];
        return isSeen ? std::optional{PolarisPose{}} : std::nullopt;
    }

    LocalTime m_now{10s};
    test::PoseShape m_seen;
    std::size_t m_asked = 0;
    PolarisDevice m_device;
};

/// Where an answer differs from what was recorded; empty where nowhere.
std::string difference(RecordedPolaris& device, const NdiExchange& recorded)
{
    const std::string command = bare(recorded.command);
    const bool isPoses = test::asksForPoses(command);
    const bool isBinary = command.starts_with("BX:"); // what looks like a line's end is none
    const std::string wanted = isBinary ? recorded.reply : bare(recorded.reply);
    const test::PoseShape seen = isPoses ? test::shapeOf(command, wanted) : test::PoseShape{};
    const std::string whole = device.answer(command, seen);
    const std::string answered = isBinary ? whole : bare(whole);
    const bool isSame =
        isPoses ? test::shapeOf(command, answered).text == seen.text : answered == wanted;
    if (isSame)
        return {};
    return "line " + std::to_string(recorded.line) + ", " + command.substr(0, 20) + ": "
           + (isPoses ? test::shapeOf(command, answered).text + " for " + seen.text
                      : answered + " for " + wanted);
}

} // namespace

/// The simulated device given the commands of real sessions.
class RecordedConversationsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void answersAsTheRealOneDid_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("fewest");
        const auto row = [](const char* name, const char* file, int fewest) {
            QTest::newRow(name) << QString::fromLatin1(file) << fewest;
        };
        row("one wired tool", "polaris_stream_03_31_2005_1.txt", 1000);
        row("from TSTART to PHF", "polaris_stream_07_13_2005.txt", 25);
        row("a tool that warns, diagnosis", "polaris_stream_08_18_2005.bin", 190);
        row("BX and TX", "polaris_stream_08_31_2005_NDICommandInterpreter.bin", 340);
        row("the same with its times", "polaris_stream_08_31_2005_NDICommandInterpreter.txt", 340);
        row("three tools", "polaris_stream_11_05_2005.txt", 50);
    }

    void answersAsTheRealOneDid()
    {
        QFETCH(const QString, file);
        QFETCH(const int, fewest);
        const auto path = test::testData("tracker/ndi-recordings/" + file.toStdString());
        if (!path)
            QSKIP("the recorded conversations are not here");
        const auto conversation = readNdiRecordingFile(*path);
        QVERIFY2(conversation, conversation ? "" : conversation.error().detail.c_str());
        RecordedPolaris device{test::recordedDevice(*conversation)};
        int compared = 0;
        for (const NdiExchange& each : *conversation) {
            if (bare(each.reply).empty())
                continue;
            if (bare(each.command).empty()) {
                QCOMPARE(device.reset(), bare(each.reply));
                continue;
            }
            const std::string differs = difference(device, each);
            QVERIFY2(differs.empty(), differs.c_str());
            ++compared;
        }
        QVERIFY2(compared >= fewest, qPrintable(QString::number(compared)));
    }
};

CARINA_TEST(RecordedConversationsTest)

} // namespace carina::recorded_conversations_test

#include "tst_recorded_conversations.moc"
