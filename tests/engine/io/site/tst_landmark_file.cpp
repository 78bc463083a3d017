#include "engine/io/site/landmark_file.h"

#include "tests/engine/io/mesh/surface_files.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QTemporaryDir>

#include <limits>

namespace carina::landmark_file_test
{
namespace
{

constexpr double kExact = 1e-15; // m

const std::string kFile = R"({"schema": "carina.landmarks/1", "name": "Thorax", "anatomy": "ab12",
 "landmarks": [{"name": "Notch", "p_AQ_mm": [0, -60.5, 36]},
               {"name": "Côte gauche", "p_AQ_mm": [80, -123, -111]},
               {"name": "Tip", "p_AQ_mm": [0, -131.5, -131.25]}]})";

std::string replaced(const std::string& from, const std::string& to)
{
    std::string text = kFile;
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

class TestLandmarkFile : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::filesystem::path path() const
    {
        return (m_folder.path() + QStringLiteral("/landmarks.json")).toStdString();
    }

private Q_SLOTS:
    void readsMillimetresAsMetres()
    {
        test::writeFile(path(), kFile);
        const auto catalogue = readLandmarkFile(path());
        QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().detail.c_str());
        QCOMPARE(catalogue->name, std::string{"Thorax"});
        QCOMPARE(catalogue->anatomy, std::string{"ab12"});
        QCOMPARE(catalogue->landmarks.size(), 3U);
        QCOMPARE(catalogue->landmarks[1].name, std::string{"Côte gauche"});
        QVERIFY((catalogue->landmarks[0].p_AQ - Vec3{0.0, -0.0605, 0.036}).norm() < kExact);
        QVERIFY((catalogue->landmarks[2].p_AQ - Vec3{0.0, -0.1315, -0.13125}).norm() < kExact);
    }

    void readsBackWhatItWrote_data()
    {
        QTest::addColumn<std::string>("anatomy");
        QTest::newRow("of a patient") << std::string{"0f3a"};
        QTest::newRow("of none") << std::string{};
    }

    void readsBackWhatItWrote()
    {
        QFETCH(std::string, anatomy);
        const LandmarkCatalogue catalogue = ribCageCatalogue(metres(1.75), anatomy);
        QVERIFY(writeLandmarkFile(path(), catalogue));
        const auto back = readLandmarkFile(path());
        QVERIFY(back.has_value());
        QCOMPARE(back->name, catalogue.name);
        QCOMPARE(back->anatomy, anatomy);
        QCOMPARE(back->landmarks.size(), catalogue.landmarks.size());
        for (std::size_t i = 0; i < catalogue.landmarks.size(); ++i) {
            QCOMPARE(back->landmarks[i].name, catalogue.landmarks[i].name);
            QVERIFY((back->landmarks[i].p_AQ - catalogue.landmarks[i].p_AQ).norm() < kExact);
        }
    }

    void refusesToWriteACatalogueThatCannotBeUsed()
    {
        QFile::remove(QString::fromStdString(path().string()));
        LandmarkCatalogue catalogue = ribCageCatalogue(metres(1.75), {});
        catalogue.landmarks[2].p_AQ.x() = std::numeric_limits<double>::quiet_NaN();
        const auto written = writeLandmarkFile(path(), catalogue);
        QVERIFY(!written);
        QCOMPARE(written.error().code, Errc::NotFinite);
        QVERIFY(!std::filesystem::exists(path()));
    }

    void saysWhereAFileIsAtFault_data()
    {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<Errc>("code");
        QTest::addColumn<QString>("fault");
        const auto row = [](const char* name, const std::string& text, const char* fault,
                            Errc code = Errc::FileMalformed) {
            QTest::newRow(name) << text << code << QString::fromLatin1(fault);
        };
        row("empty", "", "it is empty", Errc::FileEmpty);
        row("cut off", kFile.substr(0, 90), "at byte");
        row("no JSON", "Notch 0 60 36", "at byte");
        row("a list", "[1, 2]", "schema: a text is due");
        row("another kind", replaced("landmarks/1", "site/1"),
            "it is carina.site/1, and carina.landmarks/1 is due", Errc::UnknownFormat);
        row("a later version", replaced("landmarks/1", "landmarks/2"), "carina.landmarks/2",
            Errc::UnknownFormat);
        row("no name", replaced("\"Thorax\"", "7"), "name: a text is due");
        row("an unnamed landmark", replaced("\"Notch\"", "\"\""),
            "landmarks[0].name: a text is due");
        row("no list", replaced("\"landmarks\": [", "\"landmarks\": {\"a\": [").append("}"),
            "landmarks: a list is due");
        row("no object in the list", replaced("[{\"name\": \"Notch\"", "[5, {\"name\": \"Notch\""),
            "landmarks[0]: an object is due");
        row("two numbers", replaced("[0, -60.5, 36]", "[0, -60.5]"),
            "landmarks[0].p_AQ_mm: three numbers are due, in millimetres");
        row("four numbers", replaced("-111]", "-111, 0]"), "landmarks[1].p_AQ_mm: three numbers");
        row("a word for a number", replaced("36]", "\"36\"]"), "landmarks[0].p_AQ_mm");
        row("null for a number", replaced("36]", "null]"), "landmarks[0].p_AQ_mm");
        row("a kilometre", replaced("36]", "1e6]"), "landmarks[0].p_AQ_mm");
        row("in another unit", replaced("p_AQ_mm", "p_AQ_m"),
            "landmarks[0].p_AQ_m: this key is not known");
        row("a misspelled key", replaced("\"anatomy\"", "\"anatomie\""),
            "anatomie: this key is not known");
        row("twice the same name", replaced("Tip", "Notch"), "landmarks: \"Notch\" is there twice");
    }

    void saysWhereAFileIsAtFault()
    {
        QFETCH(std::string, text);
        QFETCH(Errc, code);
        QFETCH(QString, fault);
        test::writeFile(path(), text);
        const auto catalogue = readLandmarkFile(path());
        QVERIFY(!catalogue);
        const QString detail = QString::fromStdString(catalogue.error().detail);
        QVERIFY2(catalogue.error().code == code, qPrintable(detail));
        QVERIFY2(detail.startsWith(QString::fromStdString(path().string()) + QStringLiteral(": ")),
                 qPrintable(detail));
        QVERIFY2(detail.contains(fault), qPrintable(detail));
    }

    void refusesAFileThatIsNotThere()
    {
        const auto catalogue = readLandmarkFile(path().parent_path() / "absent.json");
        QVERIFY(!catalogue);
        QCOMPARE(catalogue.error().code, Errc::FileNotFound);
    }
};

CARINA_TEST(TestLandmarkFile)

} // namespace carina::landmark_file_test

#include "tst_landmark_file.moc"
