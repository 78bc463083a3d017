#include "engine/io/site/devices/site_devices.h"

#include "engine/geometry/rotation.h"
#include "engine/io/site/site_file.h"
#include "tests/engine/io/site/site_sample.h"
#include "tests/engine/io/site/site_text.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>

namespace carina::site_devices_test
{
namespace
{

const SiteDevice kSecond{
    .file = "camera.json",
    .frame = SiteDeviceFrame{
        .place = {{rotationFromVector({0.3, -1.2, 0.8}), {1.5, -0.2, 0.7}}, fromSeconds(-0.0125)},
        .rms = 0.6e-3,
        .turn = degrees(0.35),
        .pairs = 812,
        .calibratedAt = "2026-11-24T10:00:00Z"}};

std::string frame(const std::string& late = "3")
{
    return "'frame': {'X_TD_mm': [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]], "
           "'late_ms': "
           + late + ", 'rms_mm': 0.5, 'rms_deg': 0.2, 'pairs': 90, 'calibrated_at': '2026-11-24'}";
}

std::string server(const std::string& name, const std::string& role)
{
    return test::json("{'schema': 'carina.tracker/1', 'kind': 'openigtlink', 'address': "
                      "'192.0.2.8:18944', 'tools': [{'name': '"
                      + name + "', 'role': '" + role + "'}]}");
}

} // namespace

class TestSiteDevices : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::filesystem::path path(const std::string& name) const
    {
        return std::filesystem::path{m_folder.path().toStdString()} / name;
    }
    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream{path(name)} << text;
    }

private Q_SLOTS:
    void readsBackTheDevices()
    {
        Site site = test::wholeSite();
        site.devices = {{.file = "polaris.json"}, kSecond};
        const auto written = writeSiteFile(path("site.json"), site);
        QVERIFY2(written, written ? "" : written.error().detail.c_str());
        const auto back = readSiteFile(path("site.json"));
        QVERIFY2(back, back ? "" : back.error().detail.c_str());
        QCOMPARE(back->devices.size(), 2U);
        QCOMPARE(back->devices[0].file, std::string{"polaris.json"});
        QVERIFY(!back->devices[0].frame);
        const SiteDeviceFrame& is = *back->devices[1].frame;
        const SiteDeviceFrame& was = *kSecond.frame;
        constexpr double kExact = 1e-12;
        QVERIFY((is.place.X_FD.matrix() - was.place.X_FD.matrix()).cwiseAbs().maxCoeff() < kExact);
        QCOMPARE(is.place.late, was.place.late);
        QVERIFY(std::abs(is.rms - was.rms) < kExact);
        QVERIFY(std::abs((is.turn - was.turn).si) < kExact);
        QCOMPARE(is.pairs, was.pairs);
        QCOMPARE(is.calibratedAt, was.calibratedAt);
    }

    void refusesWhatContradictsItself_data()
    {
        QTest::addColumn<std::string>("devices");
        QTest::addColumn<std::string>("where");
        const std::string first = "{'file': 'a.json'}";
        QTest::addRow("a second device without a frame")
            << first + ", {'file': 'b.json'}" << std::string{"devices[1].frame"};
        QTest::addRow("a first device with a frame")
            << "{'file': 'a.json', " + frame() + "}" << std::string{"devices[0].frame"};
        QTest::addRow("one device twice")
            << first + ", {'file': 'a.json', " + frame() + "}" << std::string{"devices[1].file"};
        QTest::addRow("a stamp of a minute later")
            << first + ", {'file': 'b.json', " + frame("60000") + "}"
            << std::string{"devices[1].frame.late_ms"};
        QTest::addRow("a mirror") << first + ", {'file': 'b.json', "
                                         + QString::fromStdString(frame())
                                               .replace(QStringLiteral("[0, 0, 1, 7]"),
                                                        QStringLiteral("[0, 0, -1, 7]"))
                                               .toStdString()
                                         + "}"
                                  << std::string{"devices[1].frame.X_TD_mm"};
        std::string many = first;
        for (int i = 0; i < 8; ++i)
            many += ", {'file': '" + std::to_string(i) + ".json', " + frame() + "}";
        QTest::addRow("nine devices") << many << std::string{"devices"};
    }

    void refusesWhatContradictsItself()
    {
        QFETCH(std::string, devices);
        QFETCH(std::string, where);
        write("bad.json", test::siteWith("'devices': [" + devices + "]"));
        const auto site = readSiteFile(path("bad.json"));
        QVERIFY(!site);
        QCOMPARE(site.error().code, Errc::FileMalformed);
        QVERIFY2(site.error().detail.find(where + ": ") != std::string::npos,
                 site.error().detail.c_str());
    }

    void readsWhatTheFilesDescribe()
    {
        write("first.json", server("Chin", "jaw"));
        write("camera.json", server("Head", "head"));
        const auto read = readSiteDevices(path(""), {{.file = "first.json"}, kSecond});
        QVERIFY2(read, read ? "" : read.error().detail.c_str());
        QCOMPARE(read->size(), 2U);
        QCOMPARE((*read)[1].described.tools[0].role, ToolRole::Head);
        QCOMPARE((*read)[1].place.late, kSecond.frame->place.late);
    }

    void refusesTheSameToolOfTwoDevices_data()
    {
        QTest::addColumn<std::string>("name");
        QTest::addColumn<std::string>("role");
        QTest::addRow("role") << std::string{"Other"} << std::string{"jaw"};
        QTest::addRow("name") << std::string{"Chin"} << std::string{"other"};
    }

    void refusesTheSameToolOfTwoDevices()
    {
        QFETCH(std::string, name);
        QFETCH(std::string, role);
        write("first.json", server("Chin", "jaw"));
        write("camera.json", server(name, role));
        const auto read = readSiteDevices(path(""), {{.file = "first.json"}, kSecond});
        QVERIFY(!read);
        QCOMPARE(read.error().code, Errc::FileMalformed);
        QVERIFY(read.error().detail.starts_with("camera.json: "));
    }

    void readsNothingBesideTheFolder()
    {
        const auto read = readSiteDevices(path(""), {{.file = "../tracker.json"}});
        QVERIFY(!read);
    }
};

CARINA_TEST(TestSiteDevices)

} // namespace carina::site_devices_test

#include "tst_site_devices.moc"
