#include "engine/core/monotonic_clock.h"
#include "engine/net/devices/device_log.h"
#include "engine/net/devices/device_replay.h"
#include "engine/net/devices/device_tracker.h"
#include "engine/net/devices/igtl_server.h"
#include "engine/tracking/ndi/ndi_conversation.h"
#include "tests/engine/net/devices/igtl_offers.h"
#include "tests/evaluation/polaris/served_device.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <QTcpServer>
#include <QTemporaryDir>

#include <fstream>

namespace carina::device_log_test
{
namespace
{

constexpr double kTimes_s = 0.002; ///< the log's clock against the samples'

std::optional<SessionTime> sessionNow() { return SessionTime{monotonicNow().time_since_epoch()}; }

Result<TrackerSequence> replayedFile(const std::string& file)
{
    std::ifstream input{file, std::ios::binary};
    return replayedConversation(input, file);
}

std::uint16_t freePortOfTcp()
{
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

TrackerDescription polarisAt(const std::string& address)
{
    const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
    TrackerDescription described;
    described.address = address;
    described.fastestRate = 115200;
    described.tools.push_back(
        {"Blade", ToolRole::Laryngoscope,
         NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "blade")
             .value()});
    return described;
}

/// Tracks until there are some samples. @returns them; as a program that was killed, it does not
/// end the log in any way.
std::vector<PoseSample> samplesLogged(
    const TrackerDescription& description, const std::string& file,
    const std::function<void()>& serve = [] {})
{
    auto log = DeviceLog::create(file, description).value();
    const auto tracker = DeviceTracker::make(description, sessionNow, std::move(log)).value();
    if (!tracker->start())
        return {};
    const auto isEnough = [&] {
        serve();
        return tracker->tools()[0].history->samples().size() > 30;
    };
    if (!QTest::qWaitFor(isEnough, kPatience_ms))
        return {};
    tracker->stop();
    return tracker->tools()[0].history->samples();
}

/// Whether a recording has all these samples, at their times from the first.
bool hasAll(const RecordedTool& tool, const std::vector<PoseSample>& samples)
{
    const auto sameTime = [&](const PoseSample& a, const PoseSample& b) {
        return std::abs(toSeconds((a.time - tool.samples.front().time)
                                  - (b.time - samples.front().time)))
               < kTimes_s;
    };
    return tool.samples.size() >= samples.size()
           && std::equal(samples.begin(), samples.end(), tool.samples.begin(),
                         [&](const PoseSample& a, const PoseSample& b) {
                             return a.X_FO.translation() == b.X_FO.translation()
                                    && a.validity == b.validity && sameTime(b, a);
                         });
}

QByteArray contentOf(const std::string& file)
{
    QFile read{QString::fromStdString(file)};
    return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray{};
}

void cut(const std::string& file, qsizetype length)
{
    QFile cut{QString::fromStdString(file)};
    QVERIFY(cut.resize(length));
}

} // namespace

class DeviceLogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_folder.isValid()); }

    void replaysAPolarisByTheSameClient_data()
    {
        QTest::addColumn<int>("poses");
        QTest::addColumn<bool>("isSerial");
        QTest::newRow("TX") << int(NdiPoseReply::Tx) << true;
        QTest::newRow("BX") << int(NdiPoseReply::Bx) << true;
        QTest::newRow("BX2") << int(NdiPoseReply::Bx2) << true;
        QTest::newRow("BX on the network") << int(NdiPoseReply::Bx) << false;
    }

    void replaysAPolarisByTheSameClient()
    {
        QFETCH(const int, poses);
        QFETCH(const bool, isSerial);
        const std::string link = inFolder("port");
        const std::uint16_t port = freePortOfTcp();
        const ServedDevice device{
            (isSerial ? PolarisLine::terminal(link) : PolarisLine::tcp(port)).value(),
            {.hasRate = isSerial},
            [](const std::string&, LocalTime t) {
                const double x_mm = double(t.time_since_epoch().count() / 1'000'000 % 1000);
                return std::optional{PolarisPose{Quat::Identity(), {x_mm, 0.0, -1500.0}, 0.1}};
            }};
        TrackerDescription described =
            polarisAt(isSerial ? link : "127.0.0.1:" + std::to_string(port));
        described.poses = static_cast<NdiPoseReply>(poses);
        const std::string file = inFolder("polaris.log");
        const auto samples = samplesLogged(described, file);
        QVERIFY(!samples.empty());
        QVERIFY(isConversation(file));
        const auto replayed = replayedFile(file);
        QVERIFY2(replayed.has_value(), replayed ? "" : replayed.error().detail.c_str());
        QCOMPARE(replayed->tools.size(), std::size_t{1});
        QCOMPARE(replayed->tools[0].name, std::string{"Blade"});
        QCOMPARE(replayed->tools[0].role, ToolRole::Laryngoscope);
        QVERIFY(hasAll(replayed->tools[0], samples));
        // The decoder for recorded conversations reads the same file.
        const auto exchanges = readNdiRecordingFile(file);
        QVERIFY(exchanges);
        const NdiConversation decoded = decode(*exchanges);
        QCOMPARE(decoded.checksumErrors, std::size_t{0});
        QVERIFY(decoded.frames.size() >= samples.size());
    }

    void replaysAServerOfOpenIgtLink()
    {
        const auto server = IgtlServer::listen({"127.0.0.1", 0}).value();
        TrackerDescription described;
        described.kind = TrackerKind::OpenIgtLink;
        described.address = "127.0.0.1:" + std::to_string(server->port());
        described.tools.push_back({"The tube", ToolRole::Tube, {}, "Tube"});
        const std::string file = inFolder("server.log");
        int given = 0;
        const auto samples = samplesLogged(described, file, [&] {
            ++given;
            server->give(test::tubeOffer(std::uint64_t(given) << 28U, given));
        });
        QVERIFY(!samples.empty());
        const auto replayed = replayedFile(file);
        QVERIFY2(replayed.has_value(), replayed ? "" : replayed.error().detail.c_str());
        QCOMPARE(replayed->tools[0].name, std::string{"The tube"});
        QVERIFY(hasAll(replayed->tools[0], samples));
    }

    void readsALogUpToWhereTheProgramWasKilled()
    {
        const std::string file = inFolder("server.log");
        const QByteArray whole = contentOf(file);
        QVERIFY(!whole.isEmpty());
        const std::size_t samples = replayedFile(file)->tools[0].samples.size();
        for (qsizetype length = whole.size() - 1; length > whole.size() - 40; --length) {
            cut(file, length);
            const auto replayed = replayedFile(file);
            QVERIFY2(replayed.has_value(), replayed ? "" : replayed.error().detail.c_str());
            QVERIFY(replayed->tools[0].samples.size() + 3 >= samples);
        }
    }

    void refusesADamagedLog_data()
    {
        QTest::addColumn<QByteArray>("text");
        const QByteArray good =
            "# carina.conversation/1 {\"kind\": \"openigtlink\", \"address\": \"a:1\", "
            "\"poses\": \"TRANSFORM\", \"rate\": 60, \"tools\": [{\"name\": \"T\", "
            "\"role\": \"tube\"}]}\n";
        QTest::newRow("no description") << QByteArray{"# carina.conversation/1 \n"};
        QTest::newRow("another kind") << QByteArray{good}.replace("openigtlink", "telepathy");
        QTest::newRow("a negative rate") << QByteArray{good}.replace("60", "-1");
        QTest::newRow("no poses") << good;
        QTest::newRow("a line of another form") << good + "100.0 : (INFO) 1. hello[3] abc\n";
        QTest::newRow("too few bytes") << good + "100.0 : (INFO) 1. receive[4] abc\n";
        QTest::newRow("no time") << good + "x : (INFO) 1. receive[3] abc\n";
        QTest::newRow("a time before 1970") << good + "-1.0 : (INFO) opened\n";
        QTest::newRow("no end of time") << good + "1e300 : (INFO) opened\n";
    }

    void refusesADamagedLog()
    {
        QFETCH(const QByteArray, text);
        const std::string file = inFolder("damaged.log");
        QFile written{QString::fromStdString(file)};
        QVERIFY(written.open(QIODevice::WriteOnly) && written.write(text) == text.size());
        written.close();
        const auto replayed = replayedFile(file);
        QVERIFY(!replayed);
        QCOMPARE(replayed.error().code, Errc::FileMalformed);
    }

    void saysThatItCannotBeWritten()
    {
        const auto log = DeviceLog::create("/nowhere/device.log", polarisAt("/dev/ttyUSB0"));
        QVERIFY(!log);
        QCOMPARE(log.error().code, Errc::FileUnwritable);
    }

private:
    [[nodiscard]] std::string inFolder(const char* name) const
    {
        return m_folder.filePath(QLatin1String{name}).toStdString();
    }

    QTemporaryDir m_folder;
};

CARINA_TEST(DeviceLogTest)

} // namespace carina::device_log_test

#include "tst_device_log.moc"
