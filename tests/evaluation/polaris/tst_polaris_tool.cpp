#include "evaluation/polaris/polaris_tool.h"

#include "tests/evaluation/polaris/rom_file.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <cmath>
#include <fstream>
#include <iterator>

namespace carina::polaris_tool_test
{
namespace
{

constexpr double kLastPlace_mm = 1e-5; // of single precision at 200 mm

std::string bytesOf(const std::filesystem::path& file)
{
    std::ifstream in{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
}

} // namespace

class PolarisToolTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsWhatAFileStates()
    {
        const test::RomFile file{.markers_mm = {{0, 0, 0}, {50, 0, 0}, {0, 70, 0}, {-40, -45, 15}},
                                 .normal = Vec3::UnitX(),
                                 .fewest = 4};
        const auto tool = polarisTool(file.bytes());
        QVERIFY2(tool, tool ? "" : tool.error().detail.c_str());
        QCOMPARE(tool->information, std::string{"02000001Test        00334802401"});
        QCOMPARE(tool->partNumber, std::string{"probe"});
        QCOMPARE(tool->fewestMarkers, 4U);
        QCOMPARE(tool->largestError_mm, 0.75);
        QCOMPARE(tool->largestAngle_deg, 60.0);
        QCOMPARE(tool->markers.size(), std::size_t{4});
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(tool->markers[i].p_mm == file.markers_mm[i]);
            QVERIFY(tool->markers[i].normal == Vec3::UnitX());
        }
    }

    /// The pointer 8700340: 0 and 50 mm along z, and at 100 and 135 mm 25 mm beside it.
    void readsAPointerOfNdi()
    {
        const auto path = test::testData("tracker/rom/8700340.rom");
        if (!path)
            QSKIP("the tool files of NDI are not here");
        const auto tool = polarisTool(bytesOf(*path));
        QVERIFY2(tool, tool ? "" : tool.error().detail.c_str());
        QCOMPARE(tool->information, std::string{"02000001NDI         00034802401"});
        QCOMPARE(tool->partNumber, std::string{"8700340"});
        const std::vector<Vec3> markers_mm{{0, 0, 0}, {0, 0, 50}, {0, 25, 100}, {0, -25, 135}};
        QCOMPARE(tool->markers.size(), markers_mm.size());
        for (std::size_t i = 0; i < markers_mm.size(); ++i)
            QVERIFY((tool->markers[i].p_mm - markers_mm[i]).norm() < kLastPlace_mm);
    }

    /// Of old tools the fields of text have other bytes behind their end.
    void aTextEndsWhereItPrintsNoMore()
    {
        const auto tool = polarisTool(
            test::RomFile{.maker = std::string{"UNKNOWN\0\xD0!", 10}, .partNumber = "10\rA"}
                .bytes());
        QVERIFY(tool);
        QCOMPARE(tool->information, std::string{"02000001UNKNOWN     00334802401"});
        QCOMPARE(tool->partNumber, std::string{"10"});
    }

    void saysWhatIsWrongWithAFile_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QByteArray>("fault");
        const auto row = [](const char* name, const std::string& bytes, const char* fault) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes) << QByteArray{fault};
        };
        const std::string right = test::RomFile{}.bytes();
        std::string other = right;
        other[0] = 'M';
        std::string damaged = right;
        damaged[600] = char(damaged[600] + 1);
        row("empty", {}, "it has 0 bytes, not 752");
        row("cut", right.substr(0, 751), "it has 751 bytes, not 752");
        row("of another kind", other, "it does not begin with NDI");
        row("damaged", damaged, "its checksum is ");
        row("no marker", test::RomFile{.markers_mm = {}, .fewest = 0}.bytes(),
            "it states 0 markers, not 1 to 20");
        row("too few for a pose", test::RomFile{.fewest = 5}.bytes(),
            "a pose needs 5 markers, and it has 4");
        row("far away", test::RomFile{.markers_mm = {{0, 0, 0}, {0, 0, 2001}, {9, 0, 0}}}.bytes(),
            "its marker 2 is not within 2 m of its origin");
        row("nowhere", test::RomFile{.markers_mm = {{0, 0, 0}, {0, 9, 0}, {NAN, 0, 0}}}.bytes(),
            "its marker 3 is not within 2 m of its origin");
    }

    void saysWhatIsWrongWithAFile()
    {
        QFETCH(const QByteArray, bytes);
        QFETCH(const QByteArray, fault);
        const auto tool = polarisTool(bytes.toStdString());
        QVERIFY(!tool);
        QCOMPARE(tool.error().code, Errc::FileMalformed);
        QVERIFY2(tool.error().detail.starts_with(fault.toStdString()), tool.error().detail.c_str());
    }

    void toolsAreToldApartByTheirMarkersAlone()
    {
        const auto tool = polarisTool(test::RomFile{}.bytes());
        const auto renamed = polarisTool(test::RomFile{.partNumber = "another"}.bytes());
        test::RomFile moved;
        moved.markers_mm[1].x() += 0.5;
        const auto other = polarisTool(moved.bytes());
        QVERIFY(tool && renamed && other);
        QVERIFY(haveSameMarkers(*tool, *renamed));
        QVERIFY(!haveSameMarkers(*tool, *other));
    }
};

CARINA_TEST(PolarisToolTest)

} // namespace carina::polaris_tool_test

#include "tst_polaris_tool.moc"
