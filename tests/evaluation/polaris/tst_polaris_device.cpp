#include "evaluation/polaris/polaris_device.h"

#include "evaluation/polaris/polaris_bytes.h"
#include "tests/evaluation/polaris/rom_file.h"
#include "tests/support/test_class.h"

namespace carina::polaris_device_test
{
namespace
{

using namespace std::chrono_literals;

/// Of handle 01 at frame 3AD in polaris_stream_07_13_2005.txt, record 14.
const PolarisPose kRecorded{Quat{0.7003, 0.7110, -0.0250, 0.0572}, Vec3{-214.0, 98.9, -1581.8},
                            0.1106};
const std::string kText = "+07003+07110-00250+00572-021400+009890-158180+01106";
/// The same in single precision.
const QByteArray kReals = "dc46333f1904363fcdccccbc8c4a6a3d 000056c3cdccc5429ab9c5c4 4182e23d";

/// A device at a serial line, and who talks to it.
class Talk
{
public:
    explicit Talk(PolarisDevice::Settings settings)
        : m_device{std::move(settings), [this](const std::string& tool, LocalTime) {
                       m_asked = tool;
                       return m_isSeen && !tool.empty() ? std::optional{kRecorded} : std::nullopt;
                   }}
    {
    }

    /// @param command with its checksum. @returns the reply, whole.
    std::string say(const std::string& command)
    {
        const std::string bytes = command + '\r';
        const auto replies = m_device.take(std::as_bytes(std::span{bytes}), m_device.rate(), m_now);
        return replies.size() == 1 ? replies[0].bytes : std::string{};
    }
    /// With a checksum of the device's own. @returns the reply without its own.
    std::string told(const std::string& command)
    {
        const std::string whole = polaris::asText(command);
        const std::string reply = say(whole.substr(0, whole.size() - 1));
        return reply.substr(0, reply.size() - std::min<std::size_t>(5, reply.size()));
    }
    /// Gives the device the bytes of a .rom file. @returns what it says to PINIT.
    std::string load(const std::string& rom)
    {
        const std::string handle = told("PHRQ:*********1****");
        for (std::size_t at = 0; at < 1024; at += 64) {
            std::string block = "PVWR:" + handle + polaris::written("%04X", unsigned(at));
            for (std::size_t i = at; i < at + 64; ++i)
                block += polaris::written(
                    "%02X", i < rom.size() ? unsigned(static_cast<unsigned char>(rom[i])) : 0U);
            if (told(block) != "OKAY")
                return {};
        }
        return told("PINIT:" + handle);
    }
    /// Until frame 3AD.
    void wait() { m_now += fromSeconds(941.0 / 60.0) + 1ms; }

    PolarisDevice& device() { return m_device; }
    void hide() { m_isSeen = false; }
    [[nodiscard]] const std::string& asked() const { return m_asked; }

private:
    LocalTime m_now{10s};
    bool m_isSeen = true;
    std::string m_asked; ///< the tool of which the pose was asked for last
    PolarisDevice m_device;
};

} // namespace

/// What the device answers, held against bytes that were written by hand from the table of NDI's
/// commands, with checksums that another program computed.
class PolarisDeviceTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void statesTheVolume_data()
    {
        QTest::addColumn<QByteArray>("command");
        QTest::addColumn<int>("place");
        QTest::addColumn<bool>("isSeen");
        QTest::addColumn<QByteArray>("reply");
        const auto row = [](const char* name, const char* command, PolarisPlace place, bool isSeen,
                            const QByteArray& reply) {
            QTest::newRow(name) << QByteArray{command} << int(place) << isSeen << reply;
        };
        const auto hex = [](const QByteArray& digits) { return QByteArray::fromHex(digits); };
        const auto inside = PolarisPlace::Inside;
        const auto partly = PolarisPlace::PartlyOut;
        const auto outside = PolarisPlace::Outside;
        const QByteArray text = QByteArray::fromStdString(kText);

        row("TX, as recorded", "TX:0001031A", inside, true,
            "0101" + text + "00000031000003AD\n0000D166\r");
        row("TX, partly out", "TX:0001031A", partly, true,
            "0101" + text + "000000B1000003AD\n0000F5D7\r");
        row("TX, outside", "TX:0001031A", outside, true, "0101MISSING00000071000003AD\n0000DE47\r");
        row("TX, outside and asked for", "TX:0801C19B", outside, true,
            "0101" + text + "00000071000003AD\n0000D262\r");

        row("BX, inside", "BX:0001C26D", inside, true,
            hex("c4a52d003043 010101" + kReals + "31000000ad0300000000 f42f"));
        row("BX, partly out", "BX:0001C26D", partly, true,
            hex("c4a52d003043 010101" + kReals + "b1000000ad0300000000 f3c7"));
        row("BX, outside", "BX:0001C26D", outside, true,
            hex("c4a50d002983 01010271000000ad0300000000 faa9"));
        row("BX, outside and asked for", "BX:080100EC", outside, true,
            hex("c4a52d003043 010101" + kReals + "71000000ad0300000000 f6fb"));

        const QByteArray posed = "c4a5540013d3 0100010001005000000000000100000001000000ad03000019"
                                 "000000d5d6ba28 0100010002003000000000000100000001 00";
        const QByteArray missing = "c4a534003bd3 0100010001003000000000000100000001000000ad03000019"
                                   "000000d5d6ba28 0100010002001000000000000100000001 00";
        const char* const general = "BX2:--6d=tools36F8";
        row("BX2, inside", general, inside, true, hex(posed + "0000" + kReals + "2fa1"));
        row("BX2, partly out", general, partly, true, hex(posed + "0300" + kReals + "2fd6"));
        row("BX2, outside", general, outside, true, hex(posed + "0900" + kReals + "2ca4"));
        row("BX2, outside without a pose", general, outside, false, hex(missing + "0901 e43d"));
        row("BX2, hidden", general, inside, false, hex(missing + "1f01 ea5d"));
    }

    void statesTheVolume()
    {
        QFETCH(const QByteArray, command);
        QFETCH(const int, place);
        QFETCH(const bool, isSeen);
        QFETCH(const QByteArray, reply);
        Talk talk{{.wired = {{.port = 1}}}};
        for (const char* step :
             {"INIT:E3A5", "PHSR:02E17E", "PINIT:0131EA", "PENA:01D6D3B", "TSTART:5423"})
            static_cast<void>(talk.say(step));
        talk.device().faults().places["wired 1"] = PolarisPlace(place);
        if (!isSeen)
            talk.hide();
        talk.wait();
        QCOMPARE(QByteArray::fromStdString(talk.say(command.toStdString())).toHex(' '),
                 reply.toHex(' '));
    }

    void aWiredToolTellsWhatIsInItsMemory()
    {
        const auto tool = polarisTool(test::RomFile{.partNumber = "8700340"}.bytes());
        QVERIFY(tool);
        Talk talk{{.wired = {pluggedTool(*tool)}}};
        static_cast<void>(talk.told("INIT:"));
        QCOMPARE(talk.told("PHSR:02"), std::string{"0101001"});
        QCOMPARE(talk.told("PINIT:01"), std::string{"OKAY"});
        QCOMPARE(talk.told("PHINF:010005"), std::string{"02000001Test        00334802401"
                                                        "11"
                                                        "8700340             "});
    }

    void aWirelessToolTellsWhatWasLoaded()
    {
        Talk talk{{}};
        static_cast<void>(talk.told("INIT:"));
        QCOMPARE(talk.load(test::RomFile{}.bytes()), std::string{"OKAY"});
        QCOMPARE(talk.told("PHINF:010005"), std::string{"02000001Test        00334802401"
                                                        "11"
                                                        "probe               "});
    }

    void refusesAToolThatIsNotWhole()
    {
        std::string rom = test::RomFile{}.bytes();
        rom[600] = 'x';
        Talk talk{{}};
        static_cast<void>(talk.told("INIT:"));
        QCOMPARE(talk.load(rom), std::string{"ERROR13"});
    }

    void aWirelessToolIsToldByItsMarkers_data()
    {
        QTest::addColumn<double>("movedBy_mm");
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("its own") << 0.0 << QByteArray{"tube"};
        QTest::newRow("of no tool") << 1.0 << QByteArray{};
    }

    /// Its part number says nothing.
    void aWirelessToolIsToldByItsMarkers()
    {
        QFETCH(const double, movedBy_mm);
        QFETCH(const QByteArray, name);
        test::RomFile other;
        other.markers_mm[3].z() += 20.0;
        const auto tube = polarisTool(test::RomFile{.partNumber = "A"}.bytes());
        const auto head = polarisTool(other.bytes());
        QVERIFY(tube && head);
        Talk talk{{.tools = {{"tube", *tube}, {"head", *head}}}};
        static_cast<void>(talk.told("INIT:"));
        test::RomFile loaded{.partNumber = "head"};
        loaded.markers_mm[3].z() += movedBy_mm;
        QCOMPARE(talk.load(loaded.bytes()), std::string{"OKAY"});
        static_cast<void>(talk.told("PENA:01D"));
        static_cast<void>(talk.told("TSTART:"));
        const std::string reply = talk.told("TX:0001");
        QCOMPARE(QByteArray::fromStdString(talk.asked()), name);
        QCOMPARE(reply.starts_with("0101MISSING"), name.isEmpty());
    }
};

CARINA_TEST(PolarisDeviceTest)

} // namespace carina::polaris_device_test

#include "tst_polaris_device.moc"
