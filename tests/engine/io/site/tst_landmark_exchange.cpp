#include "engine/io/site/landmark_exchange.h"

#include "tests/engine/io/mesh/surface_files.h"
#include "tests/engine/io/site/landmark_samples.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>
#include <iterator>

namespace carina::landmark_exchange_test
{
namespace
{

constexpr double kExact = 1e-15; // m

const std::vector<Landmark> kExpected{{"Notch, upper", {0.0, -0.0605, 0.036}},
                                      {"Côte \"5\"", {0.08, -0.123, -0.111}},
                                      {"Tip", {1e-5, -0.1315, -0.13125}}};

std::string bytesIn(const std::filesystem::path& file)
{
    std::ifstream stream{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

class TestLandmarkExchange : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::filesystem::path path(const std::string& name) const
    {
        return std::filesystem::path{m_folder.path().toStdString()} / name;
    }

    std::filesystem::path written(const std::string& name, const std::string& text) const
    {
        test::writeFile(path(name), text);
        return path(name);
    }

    static void addFormats()
    {
        QTest::addColumn<std::string>("name");
        QTest::newRow("table") << std::string{"Rib cage.csv"};
        QTest::newRow("points of Slicer") << std::string{"Rib cage.fcsv"};
        QTest::newRow("markups of Slicer") << std::string{"Rib cage.mrk.json"};
        QTest::newRow("in capitals") << std::string{"Rib cage.FCSV"};
    }

private Q_SLOTS:
    void readsWhatOthersWrote_data()
    {
        QTest::addColumn<std::string>("name");
        QTest::addColumn<std::string>("text");
        QTest::addColumn<std::string>("catalogue");
        const auto row = [](const char* what, const std::string& name, const std::string& text,
                            const std::string& catalogue) {
            QTest::newRow(what) << name << text << catalogue;
        };
        row("a table", "Thorax.csv", test::kLandmarkTable, "Thorax");
        row("a table of another system", "Thorax.csv",
            "\xEF\xBB\xBF\r\n"
                + QString::fromStdString(test::kLandmarkTable)
                      .replace(QLatin1Char{'\n'}, QStringLiteral(" \r\n"))
                      .toStdString(),
            "Thorax");
        row("points in LPS", "a.b.fcsv", test::kSlicerPoints, "a.b");
        row("points in RAS", "F.fcsv", test::kSlicerPointsRas, "F");
        row("points of before 4.11", "F.fcsv",
            replaced(replaced(test::kSlicerPointsRas, "= RAS", "= 0"), "4.13", "4.10"), "F");
        row("points of before 4.11 in LPS", "F.fcsv",
            replaced(replaced(test::kSlicerPoints, "= LPS", "= 1"), "4.13", "4.10"), "F");
        row("points of Slicer 5", "F.fcsv",
            replaced(test::kSlicerPoints, "\"\"\",,\n", "\"\"\",,,2,0\n"), "F");
        row("markups", "F.mrk.json", test::kSlicerMarkups, "Thorax");
        row("markups in RAS", "F.mrk.json", test::kSlicerMarkupsRas, "F");
    }

    void readsWhatOthersWrote()
    {
        QFETCH(std::string, name);
        QFETCH(std::string, text);
        QFETCH(std::string, catalogue);
        const auto read = importLandmarks(written(name, text), "ab12");
        QVERIFY2(read.has_value(), read ? "" : read.error().detail.c_str());
        QCOMPARE(read->name, catalogue);
        QCOMPARE(read->anatomy, std::string{"ab12"});
        QCOMPARE(read->landmarks.size(), kExpected.size());
        for (std::size_t i = 0; i < kExpected.size(); ++i) {
            QCOMPARE(read->landmarks[i].name, kExpected[i].name);
            QVERIFY((read->landmarks[i].p_AQ - kExpected[i].p_AQ).norm() < kExact);
        }
    }

    void readsBackWhatItWrote_data() { addFormats(); }

    void readsBackWhatItWrote()
    {
        QFETCH(std::string, name);
        LandmarkCatalogue catalogue = ribCageCatalogue(metres(1.753), "0f3a");
        catalogue.landmarks.push_back({" \"Côte\", 5 ", {1.0 / 3.0, -1e-9, 999.0}});
        catalogue.landmarks.push_back({" Tip ", {0.1, 0.2, 0.3}});
        catalogue.landmarks.push_back({"#5", {0.0, 0.0, 0.0}});
        const auto wrote = exportLandmarks(path(name), catalogue);
        QVERIFY2(wrote.has_value(), wrote ? "" : wrote.error().detail.c_str());
        const auto back = importLandmarks(path(name), "0f3a");
        QVERIFY2(back.has_value(), back ? "" : back.error().detail.c_str());
        QCOMPARE(back->name, catalogue.name);
        QCOMPARE(back->landmarks.size(), catalogue.landmarks.size());
        for (std::size_t i = 0; i < catalogue.landmarks.size(); ++i) {
            QCOMPARE(back->landmarks[i].name, catalogue.landmarks[i].name);
            const Vec3& p_AQ = catalogue.landmarks[i].p_AQ;
            QVERIFY((back->landmarks[i].p_AQ - p_AQ).norm() <= kExact * (1.0 + p_AQ.norm()));
        }
    }

    /// What Slicer 5 opens: axes and columns are named, and numbers are in millimetres.
    void writesWhatSlicerReads()
    {
        const LandmarkCatalogue catalogue{"Thorax", "ab12", kExpected};
        QVERIFY(exportLandmarks(path("F.fcsv"), catalogue));
        QCOMPARE(bytesIn(path("F.fcsv")), test::kSlicerPoints);
        QVERIFY(exportLandmarks(path("F.csv"), catalogue));
        QCOMPARE(bytesIn(path("F.csv")), test::kLandmarkTable);
        QVERIFY(exportLandmarks(path("F.mrk.json"), catalogue));
        const std::string markups = bytesIn(path("F.mrk.json"));
        for (const char* needed : {"markups-schema-v1.0.3.json#\"", "\"type\": \"Fiducial\"",
                                   "\"coordinateSystem\": \"LPS\"", "\"coordinateUnits\": \"mm\"",
                                   "\"name\": \"Thorax\"", "\"label\": \"Tip\"",
                                   "\"positionStatus\": \"defined\"", "-60.5"})
            QVERIFY2(markups.find(needed) != std::string::npos, needed);
    }

    void saysWhereAFileIsAtFault_data()
    {
        QTest::addColumn<std::string>("name");
        QTest::addColumn<std::string>("text");
        QTest::addColumn<Errc>("code");
        QTest::addColumn<QString>("fault");
        const auto row = [](const char* what, const char* name, const std::string& text,
                            const char* fault, Errc code = Errc::FileMalformed) {
            QTest::newRow(what) << std::string{name} << text << code << QString::fromUtf8(fault);
        };
        const std::string& table = test::kLandmarkTable;
        const std::string& points = test::kSlicerPoints;
        const std::string& markups = test::kSlicerMarkups;
        const auto spoilt = [&row](const char* name, const std::string& good) {
            return [&row, name, &good](const char* what, const char* from, const char* to,
                                       const char* fault, Errc code = Errc::FileMalformed) {
                row(what, name, replaced(good, from, to), fault, code);
            };
        };
        const auto inTable = spoilt("a.csv", table);
        const auto inPoints = spoilt("a.fcsv", points);
        const auto inMarkups = spoilt("a.mrk.json", markups);
        row("an empty table", "a.csv", "", "it is empty", Errc::FileEmpty);
        row("blank lines", "a.csv", " \n\t\r\n", "there is no line in it", Errc::FileEmpty);
        inTable("a column missing", "z_mm", "z", "line 1: there is no column \"z_mm\"");
        inTable("no names", "name", "label", "line 1: there is no column \"name\"");
        inTable("a field too few", "-131.5,", "", "line 4: it has 3 fields, and 4 are expected");
        inTable("a field too many", "Tip,", "Tip,,", "line 4: it has 5 fields, and 4 are expected");
        inTable("a word for a number", "-60.5", "-60.5mm",
                "line 2: y_mm: a number of millimetres below a kilometre is expected, and it is "
                "\"-60.5mm\"");
        inTable("no number", "-60.5", "nan", "line 2: y_mm: a number");
        inTable("infinitely far", "-60.5", "inf", "line 2: y_mm: a number");
        inTable("a kilometre away", "36", "1e6", "line 2: z_mm: a number");
        inTable("a kilometre down", "36", "-1e6", "line 2: z_mm: a number");
        inTable("an open quote", "upper\"", "upper",
                "line 2: the quotes of field 1 do not close at its end");
        inTable("text behind a quote", "upper\"", "upper\" rim", "line 2: the quotes of field 1");
        inTable("Latin 1", "\xC3\xB4", "\xF4", "line 3: it is no UTF-8");
        row("two landmarks", "a.csv", table.substr(0, table.find("Tip")),
            "2 landmarks, and 3 are the fewest");
        inTable("twice the same name", "Tip", "\"Notch, upper\"",
                "\"Notch, upper\" is there twice");
        inTable("a landmark without a name", "Tip", "", "a landmark has no name");
        row("no points", "a.fcsv", "\n", "there is no line in it", Errc::FileEmpty);
        inPoints("axes not named", "CoordinateSystem", "System",
                 "line 4: no line \"# CoordinateSystem = LPS\" or RAS is before");
        inPoints("axes of a picture", "= LPS", "= IJK",
                 "line 2: the axes are \"IJK\", and LPS or RAS are expected", Errc::UnknownFormat);
        inPoints("axes by a number not known", "= LPS", "= 2", "line 2: the axes are \"2\"",
                 Errc::UnknownFormat);
        inPoints("columns not named", "# columns", "# fields",
                 "line 4: no line \"# columns = ...\" before has x");
        inPoints("no column for names", "label", "text",
                 "line 4: no line \"# columns = ...\" before has label");
        row("a point cut off", "a.fcsv", points.substr(0, points.find(",Tip")),
            "line 6: label: the field is missing");
        inPoints("no number in a point", "-123", "", "line 5: y: a number");
        inPoints("a point not placed", "Tip,,", "Tip,,,1,0", "line 6: the point was not placed");
        row("no JSON", "a.mrk.json", table, "at byte");
        row("a list", "a.mrk.json", "[1]", "@schema: a text is expected");
        inMarkups("schema 2", "schema-v1.0.3", "schema-v2.0.0",
                  "and one of markups-schema-v1 is expected", Errc::UnknownFormat);
        inMarkups("no markups", "\"markups\"", "\"marks\"", "markups: a list is expected");
        inMarkups("a curve", "Fiducial", "Curve",
                  "markups: there is no list of points (type Fiducial)");
        inMarkups("two lists", "{\"type\": \"Curve\"", "{\"type\": \"Fiducial\"",
                  "markups: there is more than one list of points");
        inMarkups("other axes", "\"LPS\"", "\"SPL\"",
                  "markups[1].coordinateSystem: LPS or RAS are expected");
        inMarkups("another unit", "\"mm\"", "\"um\"",
                  "markups[1].coordinateUnits: millimetres are expected (\"mm\")");
        inMarkups("another unit, as DICOM has it", "\"mm\"", "[\"um\", \"UCUM\", \"micrometer\"]",
                  "markups[1].coordinateUnits: millimetres are expected (\"mm\")");
        inMarkups(
            "two numbers", ", 36]", "]",
            "markups[1].controlPoints[0].position: three numbers are expected, in millimetres");
        inMarkups("no label", "\"label\": \"Tip\"", "\"label\": \"\"",
                  "markups[1].controlPoints[2].label: a text is expected");
        inMarkups("a markup not placed", "\"defined\"", "\"preview\"",
                  "markups[1].controlPoints[2].positionStatus: the point was not placed");
    }

    void saysWhereAFileIsAtFault()
    {
        QFETCH(std::string, name);
        QFETCH(std::string, text);
        QFETCH(Errc, code);
        QFETCH(QString, fault);
        const auto file = written(name, text);
        const auto read = importLandmarks(file, {});
        QVERIFY(!read);
        const QString detail = QString::fromStdString(read.error().detail);
        QVERIFY2(read.error().code == code, qPrintable(detail));
        QVERIFY2(detail.startsWith(QString::fromStdString(file.string() + ": ")),
                 qPrintable(detail));
        QVERIFY2(detail.contains(fault), qPrintable(detail));
    }

    void takesTheUnitAsDicomHasIt()
    {
        const auto file = written("a.mrk.json", replaced(test::kSlicerMarkups, "\"mm\"",
                                                         "[\"mm\", \"UCUM\", \"millimeter\"]"));
        QVERIFY(importLandmarks(file, {}));
    }

    void refusesFilesOfOtherKinds()
    {
        for (const char* name : {"landmarks.json", "landmarks", ".csv", "a.csv.txt"}) {
            QCOMPARE(importLandmarks(path(name), {}).error().code, Errc::UnknownFormat);
            QCOMPARE(exportLandmarks(path(name), ribCageCatalogue(metres(1.7), {})).error().code,
                     Errc::UnknownFormat);
        }
        QCOMPARE(importLandmarks(path("absent.csv"), {}).error().code, Errc::FileNotFound);
    }

    void refusesToWriteWhatCannotBeRead()
    {
        LandmarkCatalogue catalogue = ribCageCatalogue(metres(1.75), {});
        catalogue.landmarks[1].name = "Tip\nof it";
        QCOMPARE(exportLandmarks(path("new.csv"), catalogue).error().code, Errc::OutOfRange);
        catalogue.landmarks.resize(2);
        QCOMPARE(exportLandmarks(path("new.csv"), catalogue).error().code, Errc::TooFewLandmarks);
        QVERIFY(!std::filesystem::exists(path("new.csv")));
        QCOMPARE(
            exportLandmarks("/dev/null/new.csv", ribCageCatalogue(metres(1.75), {})).error().code,
            Errc::FileUnwritable);
    }
};

CARINA_TEST(TestLandmarkExchange)

} // namespace carina::landmark_exchange_test

#include "tst_landmark_exchange.moc"
