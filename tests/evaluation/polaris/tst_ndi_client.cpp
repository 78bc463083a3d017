#include "engine/tracking/ndi/ndi_client.h"

#include "evaluation/polaris/polaris_device.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::ndi_client_test
{
namespace
{

using namespace std::chrono_literals;

constexpr double kTextPosition = 6e-6; // m: half of the last digit of TX, and what follows from it
constexpr double kBinaryPosition = 1e-7;

NdiWantedTool wireless(const std::string& name)
{
    const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
    return {
        name,
        NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", name).value()};
}

/// Moves along x at 100 mm/s, half a metre before the origin of T, and turns about z.
PolarisPose truth(LocalTime t)
{
    const double s = toSeconds(t.time_since_epoch());
    return {Quat{Eigen::AngleAxisd{0.5 * s, Vec3::UnitZ()}}, Vec3{100.0 * s, -50.0, -1500.0}, 0.2};
}

/// A client and a device at the two ends of a line, in virtual time.
class Line
{
public:
    Line(NdiClientSettings client, PolarisDevice::Settings device)
        : m_client{std::move(client)}, m_device{std::move(device), poses()}
    {
    }

    /// The first one was taken away.
    void replaceDevice(PolarisDevice::Settings device)
    {
        m_device = PolarisDevice{std::move(device), poses()};
    }

    [[nodiscard]] NdiClient& client() { return m_client; }
    [[nodiscard]] PolarisDevice& device() { return m_device; }
    void hide(const std::string& tool) { m_hidden = tool; }
    /// Which tools have a pose that is none.
    void garble(std::function<bool(const std::string& tool)> isGarbled)
    {
        m_isGarbled = std::move(isGarbled);
    }
    /// A bit of each reply is wrong.
    void disturb(bool disturbs) { m_disturbs = disturbs; }
    void plug(bool isPlugged) { m_isPlugged = isPlugged; }
    void passBreaks(bool passes) { m_passesBreaks = passes; }
    /// A bit of the next command of this name is wrong.
    void damageNext(const std::string& command) { m_damaged = command; }
    /// How often a command was sent.
    [[nodiscard]] int sent(const std::string& command) const
    {
        return int(std::ranges::count(m_sent, command));
    }

    /// The host's port cannot be set to this rate, and says so or stays silently where it was.
    void lackRate(int rate, bool tells)
    {
        m_lacked = rate;
        m_tells = tells;
    }

    /// The device was set to this rate by somebody before.
    void leaveAt(int rate)
    {
        const std::string command = rate == 115200 ? "COMM:500000048\r" : "COMM:000000084\r";
        static_cast<void>(m_device.take(std::as_bytes(std::span{command}), m_device.rate(), m_now));
    }

    void start()
    {
        m_client.start(m_now, [this](int rate) { return !m_tells || rate != m_lacked; });
        act();
    }

    /// As after the host's cable was pulled: what was under way is lost, the device knows nothing.
    void startAnew()
    {
        m_underWay.clear();
        start();
    }

    /// As after it was switched off and on: all that was under way is lost.
    void powerCycle() { m_underWay = {m_device.reset(m_now)}; }

    /// @returns the measurements in this time.
    std::vector<NdiMeasurement> run(Duration time)
    {
        const LocalTime end = m_now + time;
        std::vector<NdiMeasurement> measured;
        while (m_now < end) {
            LocalTime next = std::min(end, m_client.nextWake());
            for (const PolarisDevice::Reply& reply : m_underWay)
                next = std::min(next, reply.at);
            m_now = std::max(next, m_now + 1us);
            deliver();
            act();
            for (NdiMeasurement& each : m_client.takeMeasurements())
                measured.push_back(std::move(each));
        }
        return measured;
    }

private:
    [[nodiscard]] PolarisDevice::PoseOf poses() const
    {
        return [this](const std::string& tool, LocalTime t) -> std::optional<PolarisPose> {
            if (tool == m_hidden)
                return std::nullopt;
            PolarisPose pose = truth(t);
            if (m_isGarbled && m_isGarbled(tool))
                pose.q.coeffs() *= 2.0;
            return pose;
        };
    }

    void deliver()
    {
        std::string arrived;
        for (const PolarisDevice::Reply& reply : m_underWay)
            if (reply.at <= m_now)
                arrived += reply.bytes;
        std::erase_if(m_underWay, [this](const auto& reply) { return reply.at <= m_now; });
        if (m_isPlugged && !arrived.empty())
            m_client.take(std::as_bytes(std::span{arrived}), m_now);
    }

    void act()
    {
        m_device.faults().corruptsNext = m_device.faults().corruptsNext || m_disturbs;
        NdiPortAction action = m_client.advance(m_now);
        if (action.rate != m_lacked)
            m_hostRate = action.rate.value_or(m_hostRate);
        if (!action.bytes.empty())
            m_sent.push_back(action.bytes.substr(0, action.bytes.find(':')));
        if (!m_isPlugged)
            return;
        if (!m_damaged.empty() && action.bytes.starts_with(m_damaged + ':')) {
            action.bytes[m_damaged.size() + 1] ^= 0x01;
            m_damaged.clear();
        }
        if (action.sendBreak && m_passesBreaks)
            m_underWay = {m_device.reset(m_now)};
        for (PolarisDevice::Reply& reply :
             m_device.take(std::as_bytes(std::span{action.bytes}), m_hostRate, m_now))
            m_underWay.push_back(std::move(reply));
    }

    LocalTime m_now{10s};
    NdiClient m_client;
    PolarisDevice m_device;
    std::vector<PolarisDevice::Reply> m_underWay;
    std::string m_hidden;
    std::function<bool(const std::string&)> m_isGarbled;
    std::string m_damaged;
    std::vector<std::string> m_sent; ///< names of commands
    bool m_disturbs = false;
    int m_hostRate = 9600;
    int m_lacked = 0; ///< rate that the host's port does not have
    bool m_tells = false;
    bool m_isPlugged = true;
    bool m_passesBreaks = true;
};

NdiClientSettings threeTools(NdiPoseReply poses, int rate)
{
    return {.tools = {wireless("head"), wireless("tube"), wireless("stylus")},
            .poses = poses,
            .rates = {rate}};
}

} // namespace

/// The client against a device that shares no code with it.
class NdiClientTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tracksWhatTheDeviceSees_data()
    {
        QTest::addColumn<int>("poses");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("TX") << int(NdiPoseReply::Tx) << kTextPosition;
        QTest::newRow("BX") << int(NdiPoseReply::Bx) << kBinaryPosition;
        QTest::newRow("BX2") << int(NdiPoseReply::Bx2) << kBinaryPosition;
    }

    void tracksWhatTheDeviceSees()
    {
        QFETCH(int, poses);
        QFETCH(double, tolerance);
        Line line{threeTools(NdiPoseReply(poses), 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.client().trouble(), std::string{});
        QCOMPARE(line.device().rate(), 115200);
        const auto measured = line.run(2s);
        QVERIFY(measured.size() > 100);
        for (const NdiMeasurement& each : measured) {
            QCOMPARE(each.tools.size(), std::size_t{3});
            for (const auto& tool : each.tools) {
                QVERIFY(tool && tool->X_TO);
                // The device states the pose of the exposure, whose time the client estimates: x
                // tells the true one.
                const double exposed = tool->X_TO->translation().x() / 0.1;
                const Vec3 p_T = 1e-3 * truth(LocalTime{fromSeconds(exposed)}).p_mm;
                QVERIFY((tool->X_TO->translation() - p_T).norm() < tolerance);
                QVERIFY(std::abs(tool->error - 0.2e-3) < 1e-7);
                QCOMPARE(tool->sight, NdiSight::Tracked);
            }
        }
    }

    void asksAnOlderDeviceByWhatItKnows_data()
    {
        QTest::addColumn<int>("poses");
        QTest::addColumn<bool>("hasBinary");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("BX where only TX is known")
            << int(NdiPoseReply::Bx) << false << kTextPosition;
        QTest::newRow("BX2 where only TX is known")
            << int(NdiPoseReply::Bx2) << false << kTextPosition;
        QTest::newRow("BX2 where BX is known") << int(NdiPoseReply::Bx2) << true << kBinaryPosition;
    }

    void asksAnOlderDeviceByWhatItKnows()
    {
        QFETCH(int, poses);
        QFETCH(bool, hasBinary);
        QFETCH(double, tolerance);
        Line line{threeTools(NdiPoseReply(poses), 115200),
                  {.hasBinary = hasBinary, .hasGeneral = false}};
        line.start();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.client().trouble(), std::string{});
        const auto measured = line.run(2s);
        QVERIFY(measured.size() > 90); // TX: 50 a second
        const auto& tool = measured.back().tools[0];
        QVERIFY(tool && tool->X_TO);
        const double exposed = tool->X_TO->translation().x() / 0.1;
        const Vec3 p_T = 1e-3 * truth(LocalTime{fromSeconds(exposed)}).p_mm;
        QVERIFY((tool->X_TO->translation() - p_T).norm() < tolerance);
    }

    // 16.7 ms between exposures: a reply is asked for at some time within.
    void stampsTheExposureLessTheTransfer_data() { tracksWhatTheDeviceSees_data(); }

    void stampsTheExposureLessTheTransfer()
    {
        QFETCH(int, poses);
        Line line{threeTools(NdiPoseReply(poses), 57600), {}};
        line.start();
        static_cast<void>(line.run(8s));
        const auto measured = line.run(5s);
        QVERIFY(measured.size() > 100);
        for (const NdiMeasurement& each : measured) {
            const double exposed = each.tools[0]->X_TO->translation().x() / 0.1;
            const double late = toSeconds(each.exposed.time_since_epoch()) - exposed;
            // TX at 57600 takes 40 ms on the wire, which must not be in the stamp.
            QVERIFY2(late >= -1e-4 && late <= 1.0 / 60.0 + 0.001,
                     qPrintable(QString::number(late)));
        }
    }

    void threeToolsComeAtSixtyHertzAlsoWhileOneIsHidden()
    {
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        QVERIFY(line.run(10s).size() >= 590);
        line.hide("tube");
        const auto measured = line.run(10s);
        QVERIFY(measured.size() >= 590);
        QCOMPARE(measured.back().tools[1]->sight, NdiSight::Missing);
        QVERIFY(!measured.back().tools[1]->X_TO);
        QVERIFY(measured.back().tools[0]->X_TO);
    }

    void noExposureIsPassedOnTwice()
    {
        Line line{threeTools(NdiPoseReply::Bx, 921600), {.exposuresPerSecond = 20.0}};
        line.start();
        static_cast<void>(line.run(5s));
        const auto measured = line.run(5s);
        QVERIFY(std::abs(double(measured.size()) - 100.0) <= 1.0);
    }

    void wiredToolsAreTakenInTheOrderOfTheirPorts()
    {
        Line line{{.tools = {{"probe"}, wireless("tube"), {"second probe"}, {"third"}},
                   .rates = {115200}},
                  {.wired = {{.port = 1}, {.port = 3}}}};
        line.start();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.client().trouble(), std::string{"third: nothing is plugged in for it"});
        line.hide("wired 2");
        const auto measured = line.run(1s);
        const auto& tools = measured.back().tools;
        QVERIFY(tools[0]->X_TO && tools[1]->X_TO);
        QVERIFY(tools[2] && !tools[2]->X_TO);
        QCOMPARE(tools[3]->sight, NdiSight::Unoccupied);
    }

    void aWiredToolIsLostUntilItIsPluggedInAgain_data()
    {
        QTest::addColumn<int>("poses");
        QTest::newRow("TX") << int(NdiPoseReply::Tx);
        QTest::newRow("BX") << int(NdiPoseReply::Bx);
        QTest::newRow("BX2") << int(NdiPoseReply::Bx2);
    }

    void aWiredToolIsLostUntilItIsPluggedInAgain()
    {
        QFETCH(const int, poses);
        Line line{{.tools = {{"probe"}, wireless("tube"), {"second probe"}},
                   .poses = NdiPoseReply(poses),
                   .rates = {115200}},
                  {.wired = {{.port = 1}, {.port = 3}}}};
        line.start();
        static_cast<void>(line.run(5s));
        line.device().ports().unplug(2);
        const auto without = line.run(3s);
        QVERIFY(without.size() > 100);
        QVERIFY(without.back().tools[0]->X_TO && without.back().tools[1]->X_TO);
        for (std::size_t i = 1; i < without.size(); ++i)
            QVERIFY(without[i].tools[2] && validityOf(*without[i].tools[2]) == Validity::Lost);
        QCOMPARE(line.client().trouble(),
                 std::string{"second probe: nothing is plugged in for it"});
        QCOMPARE(line.client().found()->pluggedIn, std::size_t{1});
        line.device().ports().plugIn(2);
        static_cast<void>(line.run(1500ms));
        const auto with = line.run(500ms);
        QVERIFY(with.size() > 20);
        QVERIFY(with.back().tools[2] && with.back().tools[2]->X_TO);
        QCOMPARE(line.client().trouble(), std::string{});
        QCOMPARE(line.client().found()->pluggedIn, std::size_t{2});
    }

    void aToolThatIsPluggedInLaterIsTracked()
    {
        Line line{{.tools = {{"probe"}}, .rates = {115200}}, {.wired = {{.port = 1}}}};
        line.device().ports().unplug(1);
        line.start();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.client().trouble(), std::string{"probe: nothing is plugged in for it"});
        line.device().ports().plugIn(1);
        static_cast<void>(line.run(1500ms));
        const auto measured = line.run(500ms);
        QVERIFY(!measured.empty() && measured.back().tools[0]->X_TO);
    }

    /// The device refuses to be given tools while it tracks.
    void stopsOnlyWhenAToolIsToBeSetUp()
    {
        Line line{{.tools = {{"probe"}, wireless("tube"), {"second probe"}, {"absent"}},
                   .rates = {115200}},
                  {.wired = {{.port = 1}, {.port = 3}}}};
        line.start();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().trouble(), std::string{"absent: nothing is plugged in for it"});
        line.device().ports().unplug(2);
        QVERIFY(line.run(3s).size() >= 170);
        QCOMPARE(line.sent("TSTOP"), 0);
        line.device().ports().plugIn(2);
        static_cast<void>(line.run(3s));
        QCOMPARE(line.sent("TSTOP"), 1);
        QCOMPARE(line.sent("TSTART"), 2);
        QVERIFY(line.device().isTracking());
        QVERIFY(line.run(1s).back().tools[2]->X_TO);
    }

    /// The answer to a command that arrived damaged is an error too.
    void aWiredToolThatWasRefusedIsTriedAgain_data()
    {
        QTest::addColumn<QByteArray>("command");
        QTest::newRow("PINIT") << QByteArray{"PINIT"};
        QTest::newRow("PENA") << QByteArray{"PENA"};
    }

    void aWiredToolThatWasRefusedIsTriedAgain()
    {
        QFETCH(const QByteArray, command);
        Line line{{.tools = {{"probe"}, wireless("tube")}, .rates = {115200}},
                  {.wired = {{.port = 1}}}};
        line.damageNext(command.toStdString());
        line.start();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.client().trouble(), std::string{});
        const auto measured = line.run(500ms);
        QVERIFY(!measured.empty());
        QVERIFY(measured.back().tools[0]->X_TO && measured.back().tools[1]->X_TO);
    }

    void aWiredToolThatIsAlwaysRefusedDoesNotStopTheOthersForEver()
    {
        Line line{{.tools = {{"probe"}, wireless("tube")}, .rates = {115200}},
                  {.wired = {{.port = 1}}, .constants = {{"PINIT:01", "ERROR13"}}}};
        line.start();
        static_cast<void>(line.run(8s));
        QCOMPARE(line.sent("TSTOP"), 2); // of three tries the first was before it tracked
        QVERIFY(line.client().trouble().starts_with("probe: "));
        const auto measured = line.run(3s);
        QVERIFY(measured.size() >= 178);
        QVERIFY(measured.back().tools[1]->X_TO);
        QCOMPARE(line.sent("TSTOP"), 2);
    }

    void aRefusedWirelessToolIsNotTakenForAnAbsentWiredOne_data()
    {
        QTest::addColumn<bool>("isAlways");
        QTest::newRow("refused whenever it is tried") << true;
        QTest::newRow("refused once, for a command that arrived damaged") << false;
    }

    /// Its port is listed among those that wait to be initialised, as if a tool were plugged in.
    void aRefusedWirelessToolIsNotTakenForAnAbsentWiredOne()
    {
        QFETCH(const bool, isAlways);
        PolarisDevice::Settings device;
        if (isAlways)
            device.constants["PINIT:01"] = "ERROR13";
        Line line{{.tools = {{"probe"}, wireless("tube"), wireless("stylus")}, .rates = {115200}},
                  std::move(device)};
        if (!isAlways)
            line.damageNext("PINIT");
        line.start();
        static_cast<void>(line.run(8s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        const std::string trouble = line.client().trouble();
        QVERIFY2(trouble.starts_with("probe: nothing is plugged in for it; tube: "),
                 trouble.c_str());
        QCOMPARE(line.client().found()->pluggedIn, std::size_t{0});
        QCOMPARE(line.sent("TSTOP"), 0); // the others are not stopped for it
        const auto measured = line.run(1s);
        QVERIFY(measured.size() >= 55);
        QCOMPARE(measured.back().tools[0]->sight, NdiSight::Unoccupied);
        QVERIFY(!measured.back().tools[1]);
        QVERIFY(measured.back().tools[2]->X_TO);
    }

    /// The second comes back first: it must not be taken for the first.
    void toolsThatArePluggedInAgainAreToldApart()
    {
        Line line{{.tools = {{"probe"}, {"second probe"}}, .rates = {115200}},
                  {.wired = {{.port = 1}, {.port = 3}}}};
        line.start();
        static_cast<void>(line.run(5s));
        line.device().ports().unplug(1);
        line.device().ports().unplug(2);
        static_cast<void>(line.run(2s));
        line.device().ports().plugIn(2);
        static_cast<void>(line.run(2s));
        auto measured = line.run(500ms);
        QVERIFY(!measured.empty());
        QVERIFY(!measured.back().tools[0]->X_TO && measured.back().tools[1]->X_TO);
        line.device().ports().plugIn(1);
        static_cast<void>(line.run(2s));
        measured = line.run(500ms);
        QVERIFY(measured.back().tools[0]->X_TO && measured.back().tools[1]->X_TO);
    }

    void tellsWhyAToolHasNoPose_data()
    {
        QTest::addColumn<int>("poses");
        QTest::addColumn<int>("loss");
        QTest::addColumn<int>("place");
        QTest::addColumn<int>("sight");
        const std::vector<std::pair<const char*, NdiPoseReply>> replies{
            {"TX", NdiPoseReply::Tx}, {"BX", NdiPoseReply::Bx}, {"BX2", NdiPoseReply::Bx2}};
        for (const auto& [name, poses] : replies) {
            const auto row = [&, name = name, poses = poses](const char* what, PolarisLoss loss,
                                                             PolarisPlace place, NdiSight sight) {
                QTest::addRow("%s, %s", name, what)
                    << int(poses) << int(loss) << int(place) << int(sight);
            };
            const auto inside = PolarisPlace::Inside;
            row("hidden", PolarisLoss::Hidden, inside, NdiSight::Missing);
            row("few markers", PolarisLoss::FewMarkers, inside, NdiSight::TooFewMarkers);
            row("bad fit", PolarisLoss::BadFit, inside, NdiSight::BadFit);
            row("out of the volume", PolarisLoss::Hidden, PolarisPlace::Outside,
                NdiSight::OutOfVolume);
            row("hidden, partly out of the volume", PolarisLoss::Hidden, PolarisPlace::PartlyOut,
                NdiSight::Missing);
        }
    }

    void tellsWhyAToolHasNoPose()
    {
        QFETCH(const int, poses);
        QFETCH(const int, loss);
        QFETCH(const int, place);
        QFETCH(const int, sight);
        Line line{threeTools(NdiPoseReply(poses), 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        line.device().faults().losses["tube"] = PolarisLoss(loss);
        line.device().faults().places["tube"] = PolarisPlace(place);
        const auto measured = line.run(1s);
        QVERIFY(measured.size() > 35);
        QCOMPARE(int(measured.back().tools[1]->sight), sight);
        QVERIFY(!measured.back().tools[1]->X_TO);
        QVERIFY(measured.back().tools[0]->X_TO);
        line.device().faults() = {};
        QCOMPARE(line.run(1s).back().tools[1]->sight, NdiSight::Tracked);
    }

    void aPoseOutOfTheVolumeIsTakenWithCare_data()
    {
        QTest::addColumn<int>("poses");
        QTest::addColumn<int>("place");
        QTest::addColumn<int>("sight");
        const std::vector<std::pair<const char*, NdiPoseReply>> replies{
            {"TX", NdiPoseReply::Tx}, {"BX", NdiPoseReply::Bx}, {"BX2", NdiPoseReply::Bx2}};
        for (const auto& [name, poses] : replies) {
            QTest::addRow("%s, out of it", name)
                << int(poses) << int(PolarisPlace::Outside) << int(NdiSight::OutOfVolume);
            QTest::addRow("%s, partly", name)
                << int(poses) << int(PolarisPlace::PartlyOut) << int(NdiSight::PartlyOutOfVolume);
        }
    }

    void aPoseOutOfTheVolumeIsTakenWithCare()
    {
        QFETCH(const int, poses);
        QFETCH(const int, place);
        QFETCH(const int, sight);
        Line line{threeTools(NdiPoseReply(poses), 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        line.device().faults().places["tube"] = PolarisPlace(place);
        const auto measured = line.run(1s);
        QVERIFY(measured.size() > 35);
        const auto& tube = measured.back().tools[1];
        QCOMPARE(int(tube->sight), sight);
        QVERIFY(tube->X_TO);
        QCOMPARE(validityOf(*tube), Validity::PartlyOccluded);
        QCOMPARE(measured.back().tools[0]->sight, NdiSight::Tracked);
        line.device().faults().places.clear();
        QCOMPARE(line.run(1s).back().tools[1]->sight, NdiSight::Tracked);
    }

    void tellsThatOtherLightDisturbs_data() { aWiredToolIsLostUntilItIsPluggedInAgain_data(); }

    void tellsThatOtherLightDisturbs()
    {
        QFETCH(const int, poses);
        Line line{threeTools(NdiPoseReply(poses), 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        line.device().faults().hasInterference = true;
        const auto measured = line.run(1s);
        QVERIFY(!measured.empty());
        for (const auto& tool : measured.back().tools)
            QCOMPARE(tool->sight, NdiSight::Interference);
    }

    void takesTheBestRateThatBothSidesHold()
    {
        Line line{{.tools = {wireless("tube")}, .rates = {921600, 230400, 38400, 9600}},
                  {.rates = {9600, 19200, 38400}}};
        line.start();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.device().rate(), 38400);
    }

    void aDamagedCommandCostsNoRate()
    {
        Line line{{.tools = {wireless("tube")}, .rates = {115200, 38400, 9600}}, {}};
        line.damageNext("COMM");
        line.start();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.device().rate(), 115200);
    }

    /// The device before it did not have the rate.
    void anotherDeviceIsAskedForTheBestRate()
    {
        NdiClientSettings settings{.tools = {wireless("tube")}, .rates = {115200, 38400}};
        Line line{settings, {.rates = {9600, 38400}}};
        line.start();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.device().rate(), 38400);
        line.replaceDevice({});
        line.startAnew();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.device().rate(), 115200);
    }

    void aRateThatTheHostRefusesIsNotSet()
    {
        Line line{{.tools = {wireless("tube")}, .rates = {921600, 115200}}, {}};
        line.lackRate(921600, true);
        line.start();
        static_cast<void>(line.run(2s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.device().rate(), 115200);
        QCOMPARE(line.sent("COMM"), 1);
    }

    /// Many adapters take any rate, and do not have it: that is found out once.
    void beginsWithTheRateThatWorked()
    {
        Line line{{.tools = {wireless("tube")}, .rates = {921600, 115200}}, {}};
        line.lackRate(921600, false);
        line.start();
        static_cast<void>(line.run(10s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.device().rate(), 115200);
        line.startAnew();
        static_cast<void>(line.run(2s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.device().rate(), 115200);
    }

    void comesBackAfterThePowerWasCycled()
    {
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        line.powerCycle();
        static_cast<void>(line.run(2s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QVERIFY(line.run(1s).size() >= 58);
    }

    void comesBackAfterTheCableWasPulled()
    {
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        line.plug(false);
        QVERIFY(line.run(4s).empty());
        QCOMPARE(line.client().phase() == NdiClient::Phase::Tracking, false);
        line.plug(true);
        static_cast<void>(line.run(6s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QVERIFY(line.run(1s).size() >= 58);
    }

    /// It is at its rate and tracks on: nothing is to be reset.
    void isBackAtOnceAfterASilence_data()
    {
        QTest::addColumn<int>("poses");
        QTest::addColumn<bool>("isSerial");
        QTest::addColumn<int>("silence_ms");
        for (const int silence : {900, 1000, 1100, 1200, 1500}) {
            QTest::addRow("BX, %d ms", silence) << int(NdiPoseReply::Bx) << true << silence;
            QTest::addRow("TX, %d ms", silence) << int(NdiPoseReply::Tx) << true << silence;
            QTest::addRow("network, %d ms", silence) << int(NdiPoseReply::Bx2) << false << silence;
        }
    }

    void isBackAtOnceAfterASilence()
    {
        QFETCH(const int, poses);
        QFETCH(const bool, isSerial);
        QFETCH(const int, silence_ms);
        NdiClientSettings settings = threeTools(NdiPoseReply(poses), 115200);
        settings.isSerial = isSerial;
        Line line{settings, {.hasRate = isSerial}};
        line.start();
        static_cast<void>(line.run(5s));
        const int resets = line.sent("RESET");
        line.plug(false);
        QVERIFY(line.run(std::chrono::milliseconds{silence_ms}).size() <= 1);
        QCOMPARE(line.client().trouble(), std::string{"it does not answer"});
        line.plug(true);
        QVERIFY(!line.run(500ms).empty());
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.client().trouble(), std::string{});
        QCOMPARE(line.sent("RESET"), resets);
        QVERIFY(line.run(1s).size() >= 45); // TX: 50
    }

    /// It is asked between the resets, too, which nothing of the device hears.
    void isBackSoonAfterALongSilence()
    {
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        line.plug(false);
        for (int second = 1; second <= 20; ++second) {
            static_cast<void>(line.run(1s));
            QCOMPARE(line.client().trouble(), std::string{"it does not answer"});
            QVERIFY(!line.client().found());
        }
        line.passBreaks(false);
        line.plug(true);
        QVERIFY(!line.run(2s).empty());
        QCOMPARE(line.client().trouble(), std::string{});
    }

    void comesBackWhereTheDeviceHasAnotherRate()
    {
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        line.device().loseRate();
        static_cast<void>(line.run(6s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.device().rate(), 115200);
        QVERIFY(line.run(1s).size() >= 58);
    }

    void saysThatADeviceDoesNotAnswer()
    {
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.plug(false);
        line.start();
        static_cast<void>(line.run(3s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Silent);
        QCOMPARE(line.client().trouble(), std::string{"it does not answer"});
    }

    void resetsByCommandWhereABreakDoesNotPass_data()
    {
        QTest::addColumn<int>("rate");
        for (const int rate : {9600, 115200})
            QTest::addRow("left at %d", rate) << rate;
    }

    void resetsByCommandWhereABreakDoesNotPass()
    {
        QFETCH(int, rate);
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.passBreaks(false);
        line.leaveAt(rate);
        line.start();
        static_cast<void>(line.run(8s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.device().rate(), 115200);
    }

    void damagedRepliesCostOneExposureEach()
    {
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        const std::size_t before = line.client().damagedReplies();
        line.device().faults().corruptsNext = true;
        QVERIFY(line.run(1s).size() >= 58); // of 60
        QVERIFY(line.client().damagedReplies() > before);
        // Nothing tells that the rest of a reply does not come, but its time.
        line.device().faults().cutsNext = true;
        QVERIFY(line.run(1s).size() >= 40);
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
    }

    void oneToolWithoutARightPoseCostsNoOther()
    {
        bool isBroken = false;
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.garble([&](const std::string& tool) { return isBroken && tool == "tube"; });
        line.start();
        static_cast<void>(line.run(5s));
        isBroken = true;
        const auto measured = line.run(1s);
        QVERIFY(measured.size() >= 58);
        QVERIFY(measured.back().tools[0]->X_TO && measured.back().tools[2]->X_TO);
        QCOMPARE(measured.back().tools[1]->sight, NdiSight::Failed);
        QCOMPARE(line.client().trouble(), std::string{});
    }

    void saysThatRepliesCannotBeRead()
    {
        Line line{threeTools(NdiPoseReply::Bx, 115200), {.constants = {{"BX:0801", "0"}}}};
        line.start();
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QCOMPARE(line.client().trouble(), std::string{"its replies cannot be read: BX: length"});
    }

    void saysThatRepliesArriveDamaged()
    {
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        line.disturb(true);
        static_cast<void>(line.run(1500ms));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Silent);
        QVERIFY2(line.client().trouble().starts_with("its replies arrive damaged: "),
                 line.client().trouble().c_str());
        line.disturb(false);
        static_cast<void>(line.run(5s));
        QCOMPARE(line.client().trouble(), std::string{});
        QVERIFY(line.run(1s).size() >= 58);
    }

    /// 303 ms are what the replies take on the line.
    void tracksFourToolsByTextAtTheSlowestRate()
    {
        NdiClientSettings settings = threeTools(NdiPoseReply::Tx, 9600);
        settings.tools.push_back(wireless("jaw"));
        Line line{settings, {}};
        line.start();
        static_cast<void>(line.run(10s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QVERIFY(line.run(10s).size() >= 31);
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
    }

    void noticesThatTheClockOfADeviceWasSet_data()
    {
        QTest::addColumn<int>("seconds");
        QTest::newRow("back") << -5;
        QTest::newRow("ahead") << 5;
    }

    void noticesThatTheClockOfADeviceWasSet()
    {
        QFETCH(const int, seconds);
        Line line{threeTools(NdiPoseReply::Bx2, 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        line.device().faults().clockSetBy = std::chrono::seconds{seconds};
        const auto measured = line.run(1s);
        QVERIFY(measured.size() > 30);
        for (const NdiMeasurement& each : measured) {
            const double exposed = each.tools[0]->X_TO->translation().x() / 0.1;
            const double late = toSeconds(each.exposed.time_since_epoch()) - exposed;
            QVERIFY2(late >= -1e-4 && late <= 0.1, qPrintable(QString::number(late)));
        }
    }

    void worksWithoutARateOverANetwork()
    {
        NdiClientSettings settings = threeTools(NdiPoseReply::Bx2, 9600);
        settings.isSerial = false;
        Line line{settings, {.hasRate = false}};
        line.start();
        static_cast<void>(line.run(1s));
        QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
        QVERIFY(line.run(1s).size() >= 59);
    }

    /// The program before was killed while it tracked. INIT alone helps a strict device little.
    void takesOverADeviceOnTheNetwork()
    {
        NdiClientSettings settings{.tools = {{"probe"}, wireless("tube")}, .isSerial = false};
        Line line{settings, {.wired = {{.port = 1}}, .hasRate = false, .isStrict = true}};
        for (int times = 0; times < 3; ++times) {
            line.startAnew();
            static_cast<void>(line.run(1s));
            QCOMPARE(line.client().phase(), NdiClient::Phase::Tracking);
            QCOMPARE(line.client().trouble(), std::string{});
            const auto measured = line.run(1s);
            QVERIFY(measured.size() >= 59);
            QVERIFY(measured.back().tools[0]->X_TO && measured.back().tools[1]->X_TO);
            QCOMPARE(line.device().ports().all().size(), std::size_t{2});
        }
        line.client().leave();
        static_cast<void>(line.run(100ms));
        QVERIFY(line.client().hasLeft());
        QVERIFY(!line.device().isTracking());
        QVERIFY(line.device().ports().all().empty());
    }

    void leavesTheDeviceIdle()
    {
        Line line{threeTools(NdiPoseReply::Bx, 115200), {}};
        line.start();
        static_cast<void>(line.run(5s));
        QVERIFY(line.device().isTracking());
        line.client().leave();
        static_cast<void>(line.run(100ms));
        QVERIFY(line.client().hasLeft());
        QVERIFY(!line.device().isTracking());
    }
};

CARINA_TEST(NdiClientTest)

} // namespace carina::ndi_client_test

#include "tst_ndi_client.moc"
