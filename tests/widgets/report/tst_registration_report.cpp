#include "widgets/report/registration_report.h"

#include "tests/support/test_class.h"
#include "tests/widgets/report/pdf_reader.h"
#include "tests/widgets/report/whole_report.h"

#include <QTemporaryDir>

#include <limits>

namespace carina::registration_report_test
{
namespace
{

QString letters(const char* words) { return QString::fromUtf8(words); }

/// Lengths of the bars on a page, from top to bottom, in its pixels.
std::vector<int> barsOn(const QImage& page)
{
    const QRgb bar = qRgb(140, 184, 219);
    std::vector<int> lengths;
    bool isInBar = false;
    for (int y = 0; y < page.height(); ++y) {
        int first = -1;
        int last = -1;
        for (int x = 0; x < page.width(); ++x)
            if (page.pixel(x, y) == bar) {
                first = first < 0 ? x : first;
                last = x;
            }
        if (first >= 0 && !isInBar)
            lengths.push_back(last - first + 1);
        isInBar = first >= 0;
    }
    return lengths;
}

} // namespace

class RegistrationReportTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        if (!test::hasPdfReader())
            QSKIP("pdftotext of the Debian package poppler-utils is not installed");
        QVERIFY(m_folder.isValid());
    }

    void isADocumentOfTwoPagesOfA4()
    {
        const QString file = written(test::wholeReport());
        QCOMPARE(test::propertyOf(file, letters("Pages")), letters("2"));
        QVERIFY(test::propertyOf(file, letters("Page size")).endsWith(letters("(A4)")));
        QVERIFY(test::propertyOf(file, letters("Title")).contains(letters("Ana Borg")));
        const QStringList pages = test::pagesOf(file);
        QVERIFY(pages[0].endsWith(letters("Page 1 of 2")));
        QVERIFY(pages[1].endsWith(letters("Page 2 of 2")));
    }

    void everyWordAndNumberIsThere_data()
    {
        QTest::addColumn<QStringList>("words");
        const auto row = [](const char* name, const char* words) {
            QTest::newRow(name) << letters(words).split(QLatin1Char{'|'});
        };
        row("who and what", "Registration report|skills-lab-2.site.json|Ana Borg|Airway trainer 3|"
                            "Polaris Vega|Jo Technician|2026-11-22T07:15:00Z");
        row("verdict", "✓ Verified|below 1.97 mm in 95 %|within their bounds: 2 of 2|"
                       "1.12 mm, at Nasion");
        row("notes", "The chin probe was moved.|Two landmarks were exchanged.");
        row("points checked", "Suprasternal notch 0.81 mm 1.52 mm ✓ yes|"
                              "Nasion 1.12 mm 1.66 mm ✓ yes");
        row("targets", "Glottis 0.48 mm 0.93 mm front to back|Carina 0.41 mm 0.72 mm left to right|"
                       "Incisors 0.54 mm 1.03 mm head to feet|"
                       "Left lung base 0.95 mm 1.91 mm front to back|"
                       "Right lung base 0.96 mm 1.92 mm front to back");
        row("landmarks", "Left jaw angle 0.11 mm 0.62 mm 0.85 mm 1.21 mm|"
                         "Right jaw angle 0.12 mm 0.63 mm 0.86 mm 1.22 mm|"
                         "Left tenth rib 0.13 mm 1.44 mm 0.87 mm 2.23 mm|"
                         "Right tenth rib 0.14 mm 0.35 mm 0.88 mm —");
        row("fit", "residuals: 0.84 mm|1.19 mm|confidence limit: 1.87 mm");
        row("stylus", "0.43 mm|0.06 mm|412|38 degrees to all sides|2026-11-21T16:40:00Z");
        row("picture", "Expected error, drawn on the skin.");
    }
    void everyWordAndNumberIsThere()
    {
        QFETCH(QStringList, words);
        const QString all = test::pagesOf(written(test::wholeReport())).join(QLatin1Char{' '});
        for (const QString& word : words)
            QVERIFY2(all.contains(word), qPrintable(word + letters("\nin ") + all));
    }

    void termsAreSpelledOutOnce_data()
    {
        QTest::addColumn<QString>("term");
        QTest::newRow("FRE") << letters("Fiducial registration error (FRE)");
        QTest::newRow("FLE") << letters("Fiducial localisation error (FLE)");
        QTest::newRow("TRE") << letters("Target registration error (TRE)");
    }
    void termsAreSpelledOutOnce()
    {
        QFETCH(QString, term);
        const QString all = test::pagesOf(written(test::wholeReport())).join(QLatin1Char{' '});
        QCOMPARE(all.count(term), 1);
    }

    void verdictIsTold_data()
    {
        QTest::addColumn<RegistrationReport::Verdict>("verdict");
        QTest::addColumn<QString>("words");
        QTest::newRow("good") << RegistrationReport::Verdict::Verified << letters("✓ Verified");
        QTest::newRow("bad") << RegistrationReport::Verdict::NotGoodEnough
                             << letters("▲ Not good enough");
        QTest::newRow("none") << RegistrationReport::Verdict::NotVerified
                              << letters("○ Not verified");
    }
    void verdictIsTold()
    {
        QFETCH(RegistrationReport::Verdict, verdict);
        QFETCH(QString, words);
        const QStringList pages = test::pagesOf(written({.verdict = verdict}));
        QCOMPARE(pages,
                 QStringList{letters("Registration report %1 Registration report Page 1 of 1")
                                 .arg(words)}); // so no section is there without content
    }

    void pointsBeyondTheirBoundAreTold()
    {
        const QString page = onlyPageOf({.checked = {{letters("Near"), 1.49, 1.50},
                                                     {letters("On it"), 1.50, 1.50},
                                                     {letters("Beyond"), 1.51, 1.50}}});
        QVERIFY(page.contains(letters("Near 1.49 mm 1.50 mm ✓ yes")));
        QVERIFY(page.contains(letters("On it 1.50 mm 1.50 mm ✓ yes")));
        QVERIFY(page.contains(letters("Beyond 1.51 mm 1.50 mm ▲ no")));
        QVERIFY(page.contains(letters("2 of 3. Largest error: 1.51 mm, at Beyond")));
    }

    void manyLandmarksGoOverPagesAndNoneIsLost()
    {
        constexpr int kLandmarks = 40;
        RegistrationReport report = test::wholeReport();
        report.landmarks.clear();
        const auto name = [](int i) { return letters("Landmark-%1!").arg(i); };
        for (int i = 0; i < kLandmarks; ++i)
            report.landmarks.push_back({.name = name(i), .residual_mm = 10.0 + i});
        const QString file = written(report);
        const QStringList pages = test::pagesOf(file);
        QCOMPARE(QString::number(pages.size()), test::propertyOf(file, letters("Pages")));
        int pagesWithLandmarks = 0;
        int found = 0;
        for (const QString& page : pages) {
            const auto here = static_cast<int>(page.count(letters("Landmark-")));
            found += here;
            pagesWithLandmarks += here > 0;
            QCOMPARE(page.contains(letters("Spread Residual Expected Left out")), here > 0);
        }
        QCOMPARE(found, kLandmarks);
        QVERIFY(pagesWithLandmarks >= 2);
        const QString all = pages.join(QLatin1Char{' '});
        for (int i = 0; i < kLandmarks; ++i)
            QVERIFY(all.contains(letters("%1 — %2.00 mm — —").arg(name(i)).arg(10 + i)));
    }

    void barsAreAsLongAsTheirNumbers()
    {
        constexpr double kPixel = 2.0; // at both ends
        const QString file = written({.landmarks = {{.name = letters("a"), .residual_mm = 1.0},
                                                    {.name = letters("b"), .residual_mm = 2.5},
                                                    {.name = letters("c"), .residual_mm = 4.0}}});
        std::vector<int> bars = barsOn(test::firstPageOf(file, 300));
        QCOMPARE(bars.size(), 4U); // the legend's, and one each
        QVERIFY(std::abs(bars[1] - bars[3] / 4.0) < kPixel);
        QVERIFY(std::abs(bars[2] - bars[3] * 2.5 / 4.0) < kPixel);
    }

    void whatIsNoNumberIsADash()
    {
        const double none = std::numeric_limits<double>::quiet_NaN();
        const double endless = std::numeric_limits<double>::infinity();
        const QString page = onlyPageOf(
            {.landmarks = {{letters("Odd"), none, endless, none, 1.25}}, .fre_mm = none});
        QVERIFY(page.contains(letters("Odd — — — 1.25 mm")));
        QVERIFY(page.contains(letters("residuals: —.")));
    }

    void pictureIsInItWhole()
    {
        const QString file = written({.picture = test::madePicture()});
        const QString list = test::printedBy(letters("pdfimages"), {letters("-list"), file});
        QVERIFY2(list.simplified().contains(letters("image 640 400")), qPrintable(list));
    }

    void namesOfAllScriptsAreRead_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("czech") << letters("Žofie Nováčková");
        QTest::newRow("greek") << letters("Ελένη Παπαδοπούλου");
        QTest::newRow("cyrillic") << letters("Юлия Щербакова");
        QTest::newRow("vietnamese") << letters("Nguyễn Thị Hằng");
        QTest::newRow("ligatures") << letters("Effie Fjord-Hoffland");
        QTest::newRow("with a place for an argument") << letters("Ann %1 %2");
    }
    void namesOfAllScriptsAreRead()
    {
        QFETCH(QString, name);
        const QString page = onlyPageOf({.patient = name, .checked = {{name, 1.0, 2.0}}});
        QVERIFY2(page.contains(letters("Patient ") + name), qPrintable(page));
        QVERIFY2(page.contains(name + letters(" 1.00 mm 2.00 mm")), qPrintable(page));
    }

    void longWordsGoOverLines()
    {
        const QString path = letters("folder/").repeated(40) + letters("end.site.json");
        QVERIFY(onlyPageOf({.siteFile = path}).remove(QLatin1Char{' '}).contains(path));
    }

private:
    QString written(const RegistrationReport& report)
    {
        const QString file = m_folder.filePath(letters("report.pdf"));
        return writeRegistrationReport(file.toStdString(), report) ? file : QString{};
    }

    QString onlyPageOf(const RegistrationReport& report)
    {
        const QStringList pages = test::pagesOf(written(report));
        return pages.size() == 1 ? pages.front() : QString{};
    }

    QTemporaryDir m_folder;
};

CARINA_SCREEN_TEST(RegistrationReportTest)

} // namespace carina::registration_report_test

#include "tst_registration_report.moc"
