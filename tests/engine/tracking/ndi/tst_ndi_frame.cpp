#include "engine/tracking/ndi/ndi_frame.h"

#include "tests/engine/tracking/ndi/wire_bytes.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>

namespace carina::ndi_frame_test
{
namespace
{

using test::WireBytes;

constexpr double kTolerance = 1e-9; // m

// Recorded from a Polaris: handle 01 at frame 0x3AD.
const std::string kRecordedPose = "+07003+07110-00250+00572-021400+009890-158180+01106";
const std::string kRecorded = "0101" + kRecordedPose + "00000031000003AD\n0000";

Result<NdiFrame> tx(const std::string& text) { return decodeTx(text, kNdiPoses); }

/// A pose in BX and BX2: half a turn about y.
WireBytes pose(float q0 = 0.0F, float x_mm = 10.0F)
{
    return WireBytes{}
        .real(q0)
        .real(0.0F)
        .real(1.0F)
        .real(0.0F)
        .real(x_mm)
        .real(-20.0F)
        .real(-1500.0F)
        .real(0.25F);
}

WireBytes bxOf(const WireBytes& tools, std::uint32_t count, std::uint32_t system = 0)
{
    return WireBytes{}.u8(count).bytes(tools).u16(system);
}

WireBytes component(std::uint32_t type, std::uint32_t count, const WireBytes& items)
{
    return WireBytes{}.u16(type).u32(12 + items.size()).u16(0).u32(count).bytes(items);
}

/// A frame 77 at 5.25 s with these components.
WireBytes bx2Of(const WireBytes& components, std::uint32_t count)
{
    const WireBytes inner = WireBytes{}.u16(1).u16(count).bytes(components);
    const WireBytes frame =
        WireBytes{}.u8(1).u8(3).u16(0).u32(77).u32(5).u32(250000000).bytes(inner);
    return WireBytes{}.u16(1).u16(1).bytes(component(1, 1, frame));
}

Errc errorOf(const Result<NdiFrame>& frame) { return frame ? Errc::Cancelled : frame.error().code; }

bool isNear(const Vec3& a, const Vec3& b) { return (a - b).norm() < kTolerance; }

} // namespace

class NdiFrameTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsARecordedReplyToTx()
    {
        const auto frame = tx(kRecorded);
        QVERIFY(frame);
        QCOMPARE(frame->tools.size(), std::size_t{1});
        const NdiTool& tool = frame->tools[0];
        QCOMPARE(tool.handle, std::uint16_t{1});
        QCOMPARE(tool.sight, NdiSight::Tracked);
        QCOMPARE(tool.frameNumber, 0x3ADU);
        QCOMPARE(tool.status, 0x31U);
        QVERIFY(isNear(tool.X_TO->translation(), {-0.21400, 0.09890, -1.58180}));
        QVERIFY(std::abs(tool.error - 0.1106e-3) < kTolerance);
        // Four digits: its length is 0.9999 as received.
        QVERIFY(std::abs(tool.X_TO->rotation().norm() - 1.0) < 1e-12);
        QVERIFY(std::abs(tool.X_TO->rotation().w() / tool.X_TO->rotation().x() - 0.7003 / 0.7110)
                < 1e-12);
        QCOMPARE(validityOf(tool), Validity::Tracked);
    }

    void saysWhyTxHasNoPose_data()
    {
        QTest::addColumn<QByteArray>("tool");
        QTest::addColumn<int>("sight");
        const auto row = [](const char* name, const std::string& tool, NdiSight sight) {
            QTest::newRow(name) << QByteArray::fromStdString(tool) << int(sight);
        };
        row("missing", "MISSING00000031000003A3", NdiSight::Missing);
        row("out of the volume", "MISSING00000071000003A3", NdiSight::OutOfVolume);
        row("disabled", "DISABLED", NdiSight::Disabled);
        row("no tool", "UNOCCUPIED", NdiSight::Unoccupied);
        row("no rotation", "+17003+07110-00250+00572-021400+009890-158180+0110600000031000003AD",
            NdiSight::Failed);
    }

    /// Of the tool: bits and the states of its twenty markers, as option 0002 has them.
    void saysWhyAToolIsMissing_data()
    {
        QTest::addColumn<int>("bits");
        QTest::addColumn<int>("markers");
        QTest::addColumn<int>("system");
        QTest::addColumn<int>("status");
        QTest::addColumn<int>("sight");
        const auto row = [](const char* name, int bits, int markers, int system, int status,
                            NdiSight sight) {
            QTest::newRow(name) << bits << markers << system << status << int(sight);
        };
        row("hidden, as recorded", 0x02, 0x00, 0, 0x31, NdiSight::Missing);
        row("too few markers", 0x02, 0x03, 0, 0x31, NdiSight::TooFewMarkers);
        row("a bad fit", 0x01, 0x22, 0, 0x31, NdiSight::BadFit);
        row("both", 0x03, 0x22, 0, 0x31, NdiSight::BadFit);
        row("other light", 0x02, 0x00, 0x0002, 0x31, NdiSight::Interference);
        row("other light, and a bad fit", 0x01, 0x22, 0x0002, 0x31, NdiSight::BadFit);
        row("out of the volume", 0x02, 0x03, 0x0002, 0x71, NdiSight::OutOfVolume);
    }

    void saysWhyAToolIsMissing()
    {
        QFETCH(const int, bits);
        QFETCH(const int, markers);
        QFETCH(const int, system);
        QFETCH(const int, status);
        QFETCH(const int, sight);
        const auto digits = [](int number, int width) {
            return QStringLiteral("%1").arg(number, width, 16, QLatin1Char{'0'}).toUpper();
        };
        const QString text = QStringLiteral("0101MISSING") + digits(status, 8)
                             + QStringLiteral("000003A3") + digits(bits, 2) + digits(markers, 20)
                             + QLatin1Char{'\n'} + digits(system, 4);
        const auto byText = decodeTx(text.toStdString(), kNdiPoses | kNdiMarkerStates);
        QVERIFY(byText);
        QCOMPARE(int(byText->tools[0].sight), sight);
        WireBytes states = WireBytes{}.u8(std::uint32_t(bits));
        for (int i = 0; i < 9; ++i)
            states.u8(0);
        states.u8(std::uint32_t(markers));
        const WireBytes tool =
            WireBytes{}.u8(1).u8(2).u32(std::uint32_t(status)).u32(7).bytes(states);
        const auto inBinary =
            decodeBx(bxOf(tool, 1, std::uint32_t(system)).span(), kNdiPoses | kNdiMarkerStates);
        QVERIFY(inBinary);
        QCOMPARE(int(inBinary->tools[0].sight), sight);
    }

    void saysWhyTxHasNoPose()
    {
        QFETCH(QByteArray, tool);
        QFETCH(int, sight);
        const auto frame = tx("010A" + tool.toStdString() + "\n0000");
        QVERIFY(frame);
        QCOMPARE(frame->tools[0].handle, std::uint16_t{0x0A});
        QCOMPARE(int(frame->tools[0].sight), sight);
        QVERIFY(!frame->tools[0].X_TO);
        QCOMPARE(validityOf(frame->tools[0]), Validity::Lost);
    }

    void aPoseAtTheEdgeOfTheVolumeIsPartlyOccluded()
    {
        const auto sightWith = [](const std::string& status) {
            const auto frame = tx("0101" + kRecordedPose + status + "000003AD\n0000");
            return frame ? std::pair{frame->tools[0].sight, validityOf(frame->tools[0])}
                         : std::pair{NdiSight::Failed, Validity::Lost};
        };
        QCOMPARE(sightWith("000000B1"),
                 (std::pair{NdiSight::PartlyOutOfVolume, Validity::PartlyOccluded}));
        QCOMPARE(sightWith("00000071"),
                 (std::pair{NdiSight::OutOfVolume, Validity::PartlyOccluded}));
    }

    void keepsTheReasonForAPerson_data()
    {
        QTest::addColumn<int>("sight");
        QTest::addColumn<int>("told");
        QTest::newRow("tracked") << int(NdiSight::Tracked) << int(ToolSight::Unsaid);
        QTest::newRow("missing") << int(NdiSight::Missing) << int(ToolSight::Unsaid);
        QTest::newRow("at the edge")
            << int(NdiSight::PartlyOutOfVolume) << int(ToolSight::PartlyOutOfVolume);
        QTest::newRow("outside") << int(NdiSight::OutOfVolume) << int(ToolSight::OutOfVolume);
        QTest::newRow("turned away")
            << int(NdiSight::TooFewMarkers) << int(ToolSight::TooFewMarkers);
        QTest::newRow("sunlight") << int(NdiSight::Interference) << int(ToolSight::Interference);
        QTest::newRow("bent") << int(NdiSight::BadFit) << int(ToolSight::BadFit);
        QTest::newRow("behind") << int(NdiSight::Failed) << int(ToolSight::Failed);
    }

    void keepsTheReasonForAPerson()
    {
        QFETCH(const int, sight);
        QFETCH(const int, told);
        QCOMPARE(int(toolSightOf({.sight = NdiSight(sight)})), told);
    }

    void readsSeveralToolsAndTheSystemStatus()
    {
        const auto frame = tx("0301MISSING00000031000003A3\n02DISABLED\n03" + kRecordedPose
                              + "00000031000003A3\n00A2");
        QVERIFY(frame);
        QCOMPARE(frame->tools.size(), std::size_t{3});
        QVERIFY(frame->tools[2].X_TO);
        QCOMPARE(frame->status, std::uint16_t{0xA2});
        QVERIFY(tx("000000")->tools.empty());
    }

    void refusesDamagedTx_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const std::string& text, Errc code) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << int(code);
        };
        row("nothing", "", Errc::DeviceReplyDamaged);
        row("a number that is none", "0G", Errc::DeviceReplyDamaged);
        row("one tool too few", "02" + kRecorded.substr(2), Errc::DeviceReplyDamaged);
        row("one tool too many", "00" + kRecorded.substr(2), Errc::DeviceReplyDamaged);
        row("cut", kRecorded.substr(0, 40), Errc::DeviceReplyDamaged);
        row("something behind", kRecorded + "0", Errc::DeviceReplyDamaged);
        row("no line end", "0101MISSING00000031000003A30000", Errc::DeviceReplyDamaged);
        std::string sign = kRecorded;
        sign[4] = '0';
        row("no sign", sign, Errc::DeviceReplyDamaged);
        std::string blank = kRecorded;
        blank[6] = ' ';
        row("a blank in a number", blank, Errc::DeviceReplyDamaged);
    }

    void refusesDamagedTx()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, code);
        QCOMPARE(int(errorOf(tx(text.toStdString()))), code);
    }

    void refusesOptionsThatItDoesNotUnderstand()
    {
        QCOMPARE(errorOf(decodeTx(kRecorded, 0x0009)), Errc::WrongOption);
        QCOMPARE(errorOf(decodeBx(bxOf({}, 0).span(), 0x0011)), Errc::WrongOption);
    }

    // Recorded from a Polaris.
    void readsRecordedOptionsOfTx()
    {
        const auto strays =
            decodeTx("0201\n02\n030+015360+030698-223261+015173+022199-225596+007159"
                     "+026725-2274150000",
                     kNdiStrays);
        QVERIFY(strays);
        QVERIFY(strays->tools.empty());
        QCOMPARE(strays->p_TStrays.size(), std::size_t{3});
        QVERIFY(isNear(strays->p_TStrays[1], {0.15173, 0.22199, -2.25596}));
        const auto states = decodeTx("0201MISSING000000310000040D0200000000000000000000\n02+05036+"
                                     "04469+04825+05601-005056+010437-202772+00180000000310000040"
                                     "C0000000000030000300003\n0000",
                                     kNdiPoses | kNdiMarkerStates);
        QVERIFY(states);
        QVERIFY(isNear(states->tools[1].X_TO->translation(), {-0.05056, 0.10437, -2.02772}));
        const auto single = decodeTx("0201MISSING000000310000037700\n02+04985+04691+04244+05926-"
                                     "007836+009627-209044+00509000000310000037600\n0000",
                                     kNdiPoses | kNdiSingleStray);
        QVERIFY(single);
        QVERIFY(single->tools[1].p_TMarkers.empty());
        QCOMPARE(single->tools[1].frameNumber, 0x376U);
    }

    void readsBx()
    {
        const WireBytes tools = WireBytes{}
                                    .u8(0x0A)
                                    .u8(1)
                                    .bytes(pose())
                                    .u32(0x31)
                                    .u32(900)
                                    .u8(0x0B)
                                    .u8(2)
                                    .u32(0x71)
                                    .u32(900)
                                    .u8(0x0C)
                                    .u8(4);
        const auto frame = decodeBx(bxOf(tools, 3, 0x0002).span(), kNdiPoses);
        QVERIFY(frame);
        QCOMPARE(frame->tools.size(), std::size_t{3});
        const NdiTool& tool = frame->tools[0];
        QCOMPARE(tool.handle, std::uint16_t{0x0A});
        QCOMPARE(tool.frameNumber, 900U);
        QVERIFY(isNear(tool.X_TO->translation(), {0.010, -0.020, -1.500}));
        QVERIFY(isNear(*tool.X_TO * Vec3{1.0, 2.0, 3.0}, {-0.990, 1.980, -4.500}));
        QVERIFY(std::abs(tool.error - 0.25e-3) < kTolerance);
        QCOMPARE(frame->tools[1].sight, NdiSight::OutOfVolume);
        QCOMPARE(validityOf(frame->tools[1]), Validity::Lost);
        QCOMPARE(frame->tools[2].sight, NdiSight::Disabled);
        QCOMPARE(frame->status, std::uint16_t{2});
    }

    void readsMarkersAndStraysOfBx()
    {
        WireBytes states;
        for (int i = 0; i < 11; ++i)
            states.u8(0x33);
        const WireBytes markers =
            WireBytes{}.u8(2).u8(0x02).real(1.0F).real(2.0F).real(3.0F).real(4.0F).real(5.0F).real(
                6.0F);
        const WireBytes tools =
            WireBytes{}.u8(1).u8(2).u32(0x31).u32(7).bytes(states).bytes(markers);
        const WireBytes strays = WireBytes{}.u8(1).u8(0).real(7.0F).real(8.0F).real(9.0F);
        const WireBytes body = WireBytes{}.u8(1).bytes(tools).bytes(strays).u16(0);
        const auto frame = decodeBx(body.span(), 0x100B);
        QVERIFY(frame);
        QCOMPARE(frame->tools[0].p_TMarkers.size(), std::size_t{2});
        QVERIFY(isNear(frame->tools[0].p_TMarkers[1], {0.004, 0.005, 0.006}));
        QCOMPARE(frame->p_TStrays.size(), std::size_t{1});
        QVERIFY(isNear(frame->p_TStrays[0], {0.007, 0.008, 0.009}));
    }

    void refusesDamagedBx_data()
    {
        QTest::addColumn<QByteArray>("body");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const WireBytes& body, Errc code) {
            QTest::newRow(name) << QByteArray::fromStdString(body.text()) << int(code);
        };
        row("nothing", {}, Errc::DeviceReplyDamaged);
        row("a tool too few", bxOf({}, 1), Errc::DeviceReplyDamaged);
        row("something behind", WireBytes{}.bytes(bxOf({}, 0)).u8(0), Errc::DeviceReplyDamaged);
        row("an unknown status", bxOf(WireBytes{}.u8(1).u8(8).u32(0).u32(0), 1),
            Errc::DeviceReplyDamaged);
    }

    void refusesDamagedBx()
    {
        QFETCH(QByteArray, body);
        QFETCH(int, code);
        const std::string bytes = body.toStdString();
        QCOMPARE(int(errorOf(decodeBx(std::as_bytes(std::span{bytes}), kNdiPoses))), code);
    }

    void refusesOneToolWhosePoseIsNone_data()
    {
        QTest::addColumn<QByteArray>("pose");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const WireBytes& of, Errc code) {
            QTest::newRow(name) << QByteArray::fromStdString(of.text()) << int(code);
        };
        row("not finite", pose(0.0F, std::numeric_limits<float>::quiet_NaN()), Errc::NotFinite);
        row("no rotation", pose(1.0F), Errc::NotARotation);
        row("too far", pose(0.0F, 2e5F), Errc::OutOfRange);
    }

    void refusesOneToolWhosePoseIsNone()
    {
        QFETCH(const QByteArray, pose);
        QFETCH(const int, code);
        WireBytes wrong;
        for (const char c : pose)
            wrong.u8(static_cast<unsigned char>(c));
        const auto verify = [code](const Result<NdiFrame>& frame) {
            QVERIFY2(frame, frame ? "" : frame.error().detail.c_str());
            QCOMPARE(frame->tools.size(), std::size_t{2});
            QCOMPARE(frame->tools[0].sight, NdiSight::Failed);
            QVERIFY(!frame->tools[0].X_TO);
            QVERIFY(frame->refusedPose);
            QCOMPARE(int(frame->refusedPose->code), code);
            QCOMPARE(frame->tools[1].sight, NdiSight::Tracked);
            QVERIFY(isNear(frame->tools[1].X_TO->translation(), {0.010, -0.020, -1.500}));
        };
        const WireBytes right = ndi_frame_test::pose();
        verify(decodeBx(bxOf(WireBytes{}
                                 .u8(1)
                                 .u8(1)
                                 .bytes(wrong)
                                 .u32(0x31)
                                 .u32(7)
                                 .u8(2)
                                 .u8(1)
                                 .bytes(right)
                                 .u32(0x31)
                                 .u32(7),
                             2)
                            .span(),
                        kNdiPoses));
        const WireBytes tools = WireBytes{}.u16(1).u16(0).bytes(wrong).u16(2).u16(0).bytes(right);
        verify(decodeBx2(bx2Of(component(2, 2, tools), 1).span()));
    }

    /// The newest.
    void readsTheLastOfSeveralFramesOfBx2()
    {
        const auto frame = [](std::uint32_t number, std::uint32_t seconds, float x_mm) {
            const WireBytes tool = WireBytes{}.u16(3).u16(0).bytes(pose(0.0F, x_mm));
            return WireBytes{}.u8(1).u8(3).u16(0).u32(number).u32(seconds).u32(0).bytes(
                WireBytes{}.u16(1).u16(1).bytes(component(2, 1, tool)));
        };
        const WireBytes frames = WireBytes{}.bytes(frame(77, 5, 10.0F)).bytes(frame(78, 6, 30.0F));
        const auto decoded =
            decodeBx2(WireBytes{}.u16(1).u16(1).bytes(component(1, 2, frames)).span());
        QVERIFY2(decoded, decoded ? "" : decoded.error().detail.c_str());
        QCOMPARE(decoded->tools.size(), std::size_t{1});
        QCOMPARE(decoded->tools[0].frameNumber, 78U);
        QCOMPARE(decoded->deviceTime.value(), Duration{std::chrono::seconds{6}});
        QVERIFY(isNear(decoded->tools[0].X_TO->translation(), {0.030, -0.020, -1.500}));
    }

    void readsBx2WithItsTime()
    {
        const WireBytes tools = WireBytes{}
                                    .u16(3)
                                    .u16(0x0000)
                                    .bytes(pose())
                                    .u16(4)
                                    .u16(0x0003)
                                    .bytes(pose())
                                    .u16(5)
                                    .u16(0x010E)
                                    .u16(6)
                                    .u16(0x0111)
                                    .u16(7)
                                    .u16(0x010D)
                                    .u16(8)
                                    .u16(0x0100)
                                    .u16(9)
                                    .u16(0x0005)
                                    .bytes(pose())
                                    .u16(10)
                                    .u16(0x0114);
        const WireBytes marker = WireBytes{}.u8(0).u8(0).u16(0).real(1.0F).real(2.0F).real(3.0F);
        const WireBytes markers =
            WireBytes{}.u16(3).u16(1).bytes(marker).u16(0xFFFF).u16(1).bytes(marker);
        const WireBytes buttons = WireBytes{}.u16(3).u16(1).u8(1);
        const WireBytes components = WireBytes{}
                                         .bytes(component(2, 8, tools))
                                         .bytes(component(3, 2, markers))
                                         .bytes(component(4, 1, buttons));
        const auto frame = decodeBx2(bx2Of(components, 3).span());
        QVERIFY(frame);
        QCOMPARE(frame->deviceTime.value(), Duration{std::chrono::milliseconds{5250}});
        std::vector<NdiSight> sights;
        for (const NdiTool& tool : frame->tools)
            sights.push_back(tool.sight);
        QCOMPARE(sights,
                 (std::vector{NdiSight::Tracked, NdiSight::PartlyOutOfVolume,
                              NdiSight::Interference, NdiSight::BadFit, NdiSight::TooFewMarkers,
                              NdiSight::Missing, NdiSight::PartlyAveraged, NdiSight::Failed}));
        QVERIFY(isNear(frame->tools[0].X_TO->translation(), {0.010, -0.020, -1.500}));
        QCOMPARE(frame->tools[0].frameNumber, 77U);
        QVERIFY(!frame->tools[2].X_TO);
        QVERIFY(isNear(frame->tools[0].p_TMarkers.at(0), {0.001, 0.002, 0.003}));
        QCOMPARE(frame->p_TStrays.size(), std::size_t{1});
    }

    void refusesDamagedBx2_data()
    {
        QTest::addColumn<QByteArray>("body");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const WireBytes& body, Errc code) {
            QTest::newRow(name) << QByteArray::fromStdString(body.text()) << int(code);
        };
        const WireBytes tool = WireBytes{}.u16(3).u16(0).bytes(pose());
        row("nothing", {}, Errc::DeviceReplyDamaged);
        row("a component too few", WireBytes{}.u16(1).u16(1), Errc::DeviceReplyDamaged);
        row("a component shorter than its header",
            WireBytes{}.u16(1).u16(1).u16(2).u32(11).u16(0).u32(0), Errc::DeviceReplyDamaged);
        row("a component longer than the reply",
            WireBytes{}.u16(1).u16(1).u16(2).u32(0xFFFFFFFF).u16(0).u32(0),
            Errc::DeviceReplyDamaged);
        row("more items than there are", bx2Of(component(2, 2, tool), 1), Errc::DeviceReplyDamaged);
        row("fewer items than there are", bx2Of(component(2, 0, tool), 1),
            Errc::DeviceReplyDamaged);
        row("countless items", bx2Of(component(2, 0xFFFFFFFF, tool), 1), Errc::DeviceReplyDamaged);
        const WireBytes nested = WireBytes{}.u8(1).u8(0).u16(0).u32(1).u32(0).u32(0).u16(1).u16(0);
        row("a frame in a frame", bx2Of(component(1, 1, nested), 1), Errc::DeviceReplyDamaged);
        row("a frame too few", WireBytes{}.u16(1).u16(1).bytes(component(1, 2, nested)),
            Errc::DeviceReplyDamaged);
    }

    void refusesDamagedBx2()
    {
        QFETCH(QByteArray, body);
        QFETCH(int, code);
        const std::string bytes = body.toStdString();
        QCOMPARE(int(errorOf(decodeBx2(std::as_bytes(std::span{bytes})))), code);
    }
};

CARINA_TEST(NdiFrameTest)

} // namespace carina::ndi_frame_test

#include "tst_ndi_frame.moc"
