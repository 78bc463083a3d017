#include "tests/engine/tracking/ndi/ndi_samples.h"
#include "tests/engine/tracking/ndi/scripted_line.h"
#include "tests/support/test_class.h"

namespace carina::ndi_pacing_test
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kAtOnce = 100us;     // a reply of a device on the network
constexpr Duration kPeriod{16'666'667}; // between two exposures
constexpr int kMostAsks = 251;          // a second, where nothing is new: one each 4 ms
constexpr int kExposures = 60;          // a second
constexpr Duration kLatest = 5ms;       // from an exposure until it is known

/// Replies to BX at a time; all are of handle 1, or of none.
using PoseScript = std::function<std::string(LocalTime now)>;

std::string poseOf(std::uint32_t frame)
{
    return test::binaryReply(
        test::WireBytes{}.u8(1).u8(1).u8(1).bytes(test::wirePose()).u32(0x31).u32(frame).u16(0));
}

std::string sixtyFrames(LocalTime now)
{
    return poseOf(std::uint32_t(now.time_since_epoch() / kPeriod));
}

std::string oneFrame(LocalTime) { return poseOf(7); }

std::string noTool(LocalTime) { return test::binaryReply(test::WireBytes{}.u8(0).u16(0)); }

std::string noPoses(LocalTime) { return test::textReply("0"); }

/// A device with one tool in its first port.
test::ScriptedLine::Answer answering(PoseScript poses)
{
    return [poses = std::move(poses)](const std::string& command, LocalTime now) {
        const auto begins = [&](const char* name) { return command.starts_with(name); };
        if (begins("BX:"))
            return poses(now);
        if (command.empty() || begins("RESET:"))
            return test::textReply("RESET");
        if (begins("PHSR:02"))
            return test::textReply("0101001");
        if (begins("PHSR:"))
            return test::textReply("00");
        return test::textReply(begins("PHINF:") ? "P4-00000010100" : "OKAY");
    };
}

/// A client that tracks.
class PacedLine
{
public:
    PacedLine(bool isSerial, PoseScript poses)
        : m_line{{.tools = {{"probe"}}, .isSerial = isSerial, .rates = {9600}},
                 kAtOnce,
                 answering(std::move(poses))}
    {
        m_line.start();
        static_cast<void>(m_line.run(1s));
    }

    [[nodiscard]] bool isTracking()
    {
        return m_line.client().phase() == NdiClient::Phase::Tracking;
    }
    /// @returns the measurements of a second
    std::vector<NdiMeasurement> runASecond() { return m_line.run(1s); }
    /// How often it has asked for poses.
    [[nodiscard]] int asks() const
    {
        return int(std::ranges::count_if(
            m_line.sent(), [](const std::string& each) { return each.starts_with("BX:"); }));
    }

private:
    test::ScriptedLine m_line;
};

} // namespace

/// A device at a serial port is paced by its line; one on the network answers at once.
class NdiPacingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatTellsNothingNewIsNotAskedWithoutPause_data()
    {
        QTest::addColumn<PoseScript>("poses");
        QTest::newRow("the same frame again and again") << PoseScript{oneFrame};
        QTest::newRow("no tool") << PoseScript{noTool};
        QTest::newRow("what is no pose") << PoseScript{noPoses};
    }

    void whatTellsNothingNewIsNotAskedWithoutPause()
    {
        QFETCH(const PoseScript, poses);
        PacedLine line{false, poses};
        QVERIFY(line.isTracking());
        const int before = line.asks();
        static_cast<void>(line.runASecond());
        const int asks = line.asks() - before;
        QVERIFY2(asks <= kMostAsks, qPrintable(QString::number(asks)));
        QVERIFY2(asks > kExposures, qPrintable(QString::number(asks))); // what is new is not missed
        QVERIFY(line.isTracking());
    }

    void everyExposureIsKnownSoon()
    {
        PacedLine line{false, sixtyFrames};
        QVERIFY(line.isTracking());
        const int before = line.asks();
        const auto measured = line.runASecond();
        QVERIFY(int(measured.size()) >= kExposures - 1);
        for (const NdiMeasurement& each : measured) {
            const auto& probe = each.tools[0];
            QVERIFY(probe && probe->X_TO);
            const LocalTime exposed{probe->frameNumber * kPeriod};
            QVERIFY(each.exposed >= exposed && each.exposed - exposed <= kLatest);
        }
        // Behind a new exposure it is asked for the next one at once.
        const int asks = line.asks() - before;
        QVERIFY2(asks <= kMostAsks + kExposures, qPrintable(QString::number(asks)));
    }

    void aSerialLineIsAskedAtOnce()
    {
        PacedLine line{true, oneFrame};
        QVERIFY(line.isTracking());
        const int before = line.asks();
        static_cast<void>(line.runASecond());
        QVERIFY(line.asks() - before >= 1s / kAtOnce - 1);
    }
};

CARINA_TEST(NdiPacingTest)

} // namespace carina::ndi_pacing_test

#include "tst_ndi_pacing.moc"
