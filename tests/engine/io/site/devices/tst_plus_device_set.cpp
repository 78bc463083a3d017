#include "engine/io/site/devices/plus_device_set.h"

#include "tests/support/test_class.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace carina::plus_device_set_test
{
namespace
{

/// As PLUS writes its device sets.
const QByteArray kPolarisSet = R"(<PlusConfiguration version="2.3">
  <DataCollection StartupDelaySec="1.0">
    <DeviceSet Name="Polaris with two tools" Description="Stylus and reference"/>
    <Device Id="VideoDevice" Type="NoiseVideo" ToolReferenceFrame="Image"/>
    <Device Id="TrackerDevice" Type="PolarisTracker" SerialPort="3" BaudRate="115200"
            AcquisitionRate="50" ToolReferenceFrame="Tracker">
      <DataSources>
        <DataSource Type="Tool" Id="Stylus" PortName="5" RomFile="roms/stylus.rom"/>
        <DataSource Type="Tool" Id="Ett" PortName="1"/>
        <DataSource Type="Tool" Id="Reference" PortName="0"/>
        <DataSource Type="Video" Id="Camera" PortName="2"/>
      </DataSources>
      <OutputChannels>
        <OutputChannel Id="TrackerStream">
          <DataSource Type="Tool" Id="Stylus"/>
        </OutputChannel>
      </OutputChannels>
    </Device>
  </DataCollection>
</PlusConfiguration>
)";

const QByteArray kServerSet = R"(<PlusConfiguration version="2.3"><DataCollection>
  <Device Id="T" Type="OpenIGTLinkTracker" ServerAddress="192.0.2.7" ServerPort="18946"
          MessageType="tdata" ToolReferenceFrame="Polaris">
    <DataSources><DataSource Type="Tool" Id="Tube"/><DataSource Type="Tool" Id="Ett"/></DataSources>
  </Device>
</DataCollection></PlusConfiguration>)";

QByteArray romBytes()
{
    const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
    const auto definition =
        NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "stylus")
            .value();
    return {reinterpret_cast<const char*>(definition.bytes().data()),
            qsizetype(definition.bytes().size())};
}

} // namespace

class PlusDeviceSetTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid() && QDir{m_folder.path()}.mkdir(QStringLiteral("roms")));
        write("roms/stylus.rom", romBytes());
    }

    void readsAPolarisWithItsTools()
    {
        const auto described = read(kPolarisSet);
        QVERIFY2(described.has_value(), described ? "" : described.error().detail.c_str());
        QCOMPARE(described->kind, TrackerKind::Ndi);
        QCOMPARE(described->address, std::string{"/dev/ttyS2"});
        QCOMPARE(described->fastestRate, 115200);
        QCOMPARE(described->tools.size(), std::size_t{3});
        // Those that are plugged in are in the order of their ports.
        QCOMPARE(described->tools[0].name, std::string{"Reference"});
        QCOMPARE(described->tools[0].role, ToolRole::Other);
        QCOMPARE(described->tools[1].name, std::string{"Ett"});
        QCOMPARE(described->tools[1].role, ToolRole::Tube);
        QVERIFY(!described->tools[1].definition);
        QCOMPARE(described->tools[2].role, ToolRole::Stylus);
        QCOMPARE(described->tools[2].definition->partNumber(), std::string{"stylus"});
    }

    void readsADeviceOnTheNetwork()
    {
        const auto described = read(QByteArray{kPolarisSet}.replace(
            "SerialPort=\"3\" BaudRate=\"115200\"", "NetworkHostname=\"192.0.2.9\""));
        QVERIFY(described);
        QCOMPARE(described->address, std::string{"192.0.2.9:8765"});
    }

    void readsAServerOfOpenIgtLink()
    {
        const auto described = read(kServerSet);
        QVERIFY2(described.has_value(), described ? "" : described.error().detail.c_str());
        QCOMPARE(described->kind, TrackerKind::OpenIgtLink);
        QCOMPARE(described->address, std::string{"192.0.2.7:18946"});
        QCOMPARE(described->igtlPoses, IgtlPoses::Tdata);
        QCOMPARE(described->tools[0].device, std::string{"TubeToPolaris"});
        QCOMPARE(described->tools[0].role, ToolRole::Tube);
        QCOMPARE(described->tools[1].role, ToolRole::Other); // there is a tube already
    }

    void saysThatNoTrackerIsSupported()
    {
        const auto described =
            read(QByteArray{kPolarisSet}.replace("PolarisTracker", "SavedDataSource"));
        QVERIFY(!described);
        QVERIFY(described.error().detail.ends_with(
            "set.xml: it names no tracker of a supported type, which are PolarisTracker, "
            "NDITracker and OpenIGTLinkTracker"));
    }

    void refusesOtherFiles_data()
    {
        QTest::addColumn<QByteArray>("xml");
        QTest::addColumn<int>("code");
        QTest::newRow("no XML") << QByteArray{"tracker"} << int(Errc::FileMalformed);
        QTest::newRow("another document") << QByteArray{"<svg/>"} << int(Errc::FileMalformed);
        QTest::newRow("its end is missing")
            << kPolarisSet.left(kPolarisSet.size() / 2) << int(Errc::FileMalformed);
        QTest::newRow("entities") << "<!DOCTYPE x [<!ENTITY a \"aaaa\">]>" + kServerSet
                                  << int(Errc::FileMalformed);
        QTest::newRow("no tracker")
            << QByteArray{kPolarisSet}.replace("PolarisTracker", "MicronTracker")
            << int(Errc::UnknownFormat);
        QTest::newRow("no tools") << QByteArray{kServerSet}.replace("Tool\"", "Video\"")
                                  << int(Errc::FileMalformed);
        QTest::newRow("a tool without a name")
            << QByteArray{kServerSet}.replace("Id=\"Tube\"", "") << int(Errc::FileMalformed);
        QTest::newRow("a definition that is not there")
            << QByteArray{kPolarisSet}.replace("stylus.rom", "none.rom") << int(Errc::FileNotFound);
        QTest::newRow("a definition elsewhere")
            << QByteArray{kPolarisSet}.replace("roms/stylus.rom", "../../etc/passwd")
            << int(Errc::FileUnreadable);
        QTest::newRow("too many tools") << QByteArray{kServerSet}.replace(
            "<DataSource Type=\"Tool\" Id=\"Tube\"/>",
            QByteArray{"<DataSource Type=\"Tool\" Id=\"A\"/>"}.repeated(65))
                                        << int(Errc::FileMalformed);
    }

    void refusesOtherFiles()
    {
        QFETCH(const QByteArray, xml);
        QFETCH(const int, code);
        const auto described = read(xml);
        QVERIFY(!described);
        QCOMPARE(int(described.error().code), code);
    }

private:
    void write(const char* name, const QByteArray& bytes)
    {
        QFile file{m_folder.filePath(QLatin1String{name})};
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    [[nodiscard]] Result<TrackerDescription> read(const QByteArray& xml)
    {
        write("set.xml", xml);
        return readPlusDeviceSet(m_folder.filePath(QStringLiteral("set.xml")).toStdString());
    }

    QTemporaryDir m_folder;
};

CARINA_TEST(PlusDeviceSetTest)

} // namespace carina::plus_device_set_test

#include "tst_plus_device_set.moc"
