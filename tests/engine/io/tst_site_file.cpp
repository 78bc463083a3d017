#include "engine/io/site_file.h"

#include "tests/engine/io/site_sample.h"
#include "tests/engine/io/surface_files.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <limits>

namespace carina
{
namespace
{

constexpr double kExact = 1e-15; // m, and as coefficients of a rotation

bool near(const RigidTransform& a, const RigidTransform& b)
{
    return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < kExact;
}

/// JSON written with single quotes.
std::string json(std::string text)
{
    std::replace(text.begin(), text.end(), '\'', '"');
    return text;
}

/// A site of the smallest kind, and other fields in it.
std::string siteWith(const std::string& fields, const std::string& step = "'touch'")
{
    return json("{'schema': 'carina.site/1', 'step': " + step + ", " + fields + "}");
}

std::string siteAt(const std::string& step)
{
    return json("{'schema': 'carina.site/1', 'step': " + step + "}");
}

const std::string kCatalogue = "'catalogue': {'name': 'c', 'landmarks': ["
                               "{'name': 'a', 'p_AQ_mm': [0, 0, 1]},"
                               "{'name': 'b', 'p_AQ_mm': [0, 1, 0]},"
                               "{'name': 'c', 'p_AQ_mm': [1, 0, 0]}]}";

std::string touched(const std::string& name)
{
    return "{'landmark': '" + name + "', 'p_TQ_mm': [1, 2, 3], 'spread_mm': 0.5}";
}

std::string registration(const std::string& row, const std::string& rms)
{
    return "'registration': {'X_AM_mm': [[1, 0, 0, 5], " + row
           + ", [0, 0, 1, 7], [0, 0, 0, 1]],"
             "'X_AT_mm': [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]],"
             "'rms_mm': "
           + rms + ", 'residuals_mm': [{'name': 'a', 'mm': 0.25}]}";
}

std::string display(const std::string& width, const std::string& height)
{
    return "'display': {'p_HDl_mm': [1, 0, 0], 'p_HDr_mm': [1, 0, 0],"
           "'p_HQ_screen_centre_mm': [0, 0, 1], 'screen_width_mm': "
           + width + ", 'screen_height_mm': " + height + "}";
}

std::string stylus(const std::string& rms, const std::string& date)
{
    return "'stylus': {'p_SQ_mm': [0, 0, 1], 'rms_mm': " + rms + ", 'calibrated_at': '" + date
           + "'}";
}

} // namespace

class TestSiteFile : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::filesystem::path path() const
    {
        return (m_folder.path() + QStringLiteral("/site.json")).toStdString();
    }
    QByteArray bytes() const
    {
        QFile file{QString::fromStdString(path().string())};
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
    }

private Q_SLOTS:
    void readsBackAWholeSite()
    {
        const Site site = test::wholeSite();
        const auto written = writeSiteFile(path(), site);
        QVERIFY2(written.has_value(), written ? "" : written.error().detail.c_str());
        const auto back = readSiteFile(path());
        QVERIFY2(back.has_value(), back ? "" : back.error().detail.c_str());
        QCOMPARE(back->step, SiteStep::Verify);
        QCOMPARE(back->tracker, site.tracker);
        QVERIFY((back->stylus->p_SQ - site.stylus->p_SQ).norm() < kExact);
        QVERIFY(std::abs(back->stylus->rms - site.stylus->rms) < kExact);
        QCOMPARE(back->stylus->calibratedAt, site.stylus->calibratedAt);
        QCOMPARE(back->catalogue->anatomy, site.catalogue->anatomy);
        QCOMPARE(back->catalogue->landmarks.size(), 4U);
        QCOMPARE(back->touched.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(back->touched[i].landmark, site.touched[i].landmark);
            QVERIFY((back->touched[i].p_TQ - site.touched[i].p_TQ).norm() < kExact);
            QVERIFY(std::abs(back->touched[i].spread - site.touched[i].spread) < kExact);
        }
    }

    void readsBackRegistrationAndDisplay()
    {
        const Site site = test::wholeSite();
        QVERIFY(writeSiteFile(path(), site));
        const auto back = readSiteFile(path());
        QVERIFY(back && back->registration && back->registration->X_JM && back->display);
        QVERIFY(near(back->registration->X_AM, site.registration->X_AM));
        QVERIFY(near(back->registration->X_AT, site.registration->X_AT));
        QVERIFY(near(*back->registration->X_JM, *site.registration->X_JM));
        QVERIFY(std::abs(back->registration->rms - site.registration->rms) < kExact);
        QCOMPARE(back->registration->residuals.size(), 2U);
        QCOMPARE(back->registration->residuals[1].landmark,
                 site.registration->residuals[1].landmark);
        QVERIFY(std::abs(back->registration->residuals[1].residual - 0.9e-3) < kExact);
        QVERIFY((back->display->p_HDl - site.display->p_HDl).norm() < kExact);
        QVERIFY((back->display->p_HDr - site.display->p_HDr).norm() < kExact);
        QVERIFY((back->display->p_HQ_screenCentre - site.display->p_HQ_screenCentre).norm()
                < kExact);
        QVERIFY(std::abs(back->display->screenWidth - 0.8) < kExact);
        QVERIFY(std::abs(back->display->screenHeight - 0.45) < kExact);
    }

    void readsBackASiteThatIsJustBegun()
    {
        QVERIFY(writeSiteFile(path(), Site{}));
        const auto back = readSiteFile(path());
        QVERIFY(back.has_value());
        QCOMPARE(back->step, SiteStep::Tracker);
        QVERIFY(back->tracker.empty() && back->touched.empty());
        QVERIFY(!back->stylus && !back->catalogue && !back->registration && !back->display);
    }

    void readsBackEveryStep()
    {
        for (const SiteStep step : {SiteStep::Tracker, SiteStep::Stylus, SiteStep::Landmarks,
                                    SiteStep::Touch, SiteStep::Fit, SiteStep::Verify}) {
            QVERIFY(writeSiteFile(path(), {.step = step}));
            const auto back = readSiteFile(path());
            QVERIFY(back.has_value());
            QCOMPARE(back->step, step);
        }
    }

    void readsWhatAPersonWrote()
    {
        test::writeFile(path(), siteWith(kCatalogue + ", 'touched': [" + touched("b") + "], "
                                         + registration("[0, 1, 0, 6]", "0.25")));
        const auto site = readSiteFile(path());
        QVERIFY2(site.has_value(), site ? "" : site.error().detail.c_str());
        QCOMPARE(site->step, SiteStep::Touch);
        QVERIFY((site->touched[0].p_TQ - Vec3{0.001, 0.002, 0.003}).norm() < kExact);
        QVERIFY(near(site->registration->X_AM, RigidTransform::translation({.005, .006, .007})));
        QVERIFY(!site->registration->X_JM);
    }

    void saysWhereAFileIsAtFault_data()
    {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<QString>("fault");
        const auto row = [](const char* name, const std::string& text, const char* fault) {
            QTest::newRow(name) << text << QString::fromLatin1(fault);
        };
        row("no step", json("{'schema': 'carina.site/1'}"), "step: a text is due");
        row("no such step", siteAt("'touching'"), "step: \"touching\" is no step");
        row("a number for a step", siteAt("3"), "step: a text is due");
        row("a key too many", siteWith("'tracking': 'x'"), "tracking: this key is not known");
        row("an empty tracker", siteWith("'tracker': ''"), "tracker: a text is due");
        row("no object", siteWith("'stylus': 5"), "stylus: an object is due");
        row("no date", siteWith(stylus("1", "today")), "stylus.calibrated_at: a date and time");
        row("negative RMS", siteWith(stylus("-1", "2004-03-27")),
            "stylus.rms_mm: a length in millimetres is due");
        row("a faulty catalogue", siteWith("'catalogue': {'name': 'c', 'landmarks': []}"),
            "catalogue.landmarks: 0 landmarks, and 3 are the fewest");
        row("touched without a catalogue", siteWith("'touched': [" + touched("a") + "]"),
            "touched[0].landmark: \"a\" is not in the catalogue");
        row("touched what is not in it",
            siteWith(kCatalogue + ", 'touched': [" + touched("a") + ", " + touched("d") + "]"),
            "touched[1].landmark: \"d\" is not in the catalogue");
        row("touched twice",
            siteWith(kCatalogue + ", 'touched': [" + touched("a") + ", " + touched("a") + "]"),
            "touched[1].landmark: \"a\" is there twice");
        row("a mirror", siteWith(registration("[0, -1, 0, 6]", "1")),
            "registration.X_AM_mm: a pose matrix scales, shears or mirrors");
        row("three numbers in a row", siteWith(registration("[0, 1, 0]", "1")),
            "registration.X_AM_mm: four rows of four numbers are due");
        row("five rows", siteWith(registration("[0, 1, 0, 6], [0, 1, 0, 6]", "1")),
            "registration.X_AM_mm: four rows of four numbers are due");
        row("no RMS", siteWith(registration("[0, 1, 0, 6]", "null")),
            "registration.rms_mm: a length in millimetres is due");
        row("no display", siteWith("'display': {}"), "display.p_HDl_mm: three numbers are due");
        row("no width", siteWith(display("0", "5")),
            "display.screen_width_mm: a screen has some width");
        row("no height", siteWith(display("5", "0")),
            "display.screen_height_mm: a screen has some height");
    }

    void saysWhereAFileIsAtFault()
    {
        QFETCH(std::string, text);
        QFETCH(QString, fault);
        test::writeFile(path(), text);
        const auto site = readSiteFile(path());
        QVERIFY(!site);
        const QString detail = QString::fromStdString(site.error().detail);
        QVERIFY2(site.error().code == Errc::FileMalformed, qPrintable(detail));
        QVERIFY2(detail.startsWith(QString::fromStdString(path().string()) + QStringLiteral(": ")),
                 qPrintable(detail));
        QVERIFY2(detail.contains(fault), qPrintable(detail));
    }

    void refusesAnotherVersion()
    {
        test::writeFile(path(), json("{'schema': 'carina.site/2', 'step': 'fit'}"));
        const auto site = readSiteFile(path());
        QVERIFY(!site);
        QCOMPARE(site.error().code, Errc::UnknownFormat);
    }

    void refusesEveryCutOffFile()
    {
        QVERIFY(writeSiteFile(path(), test::wholeSite()));
        const QByteArray whole = bytes().trimmed();
        for (qsizetype length = 0; length < whole.size(); length += 13) {
            test::writeFile(path(), whole.first(length).toStdString());
            const auto site = readSiteFile(path());
            QVERIFY(!site);
            QCOMPARE(site.error().code, length == 0 ? Errc::FileEmpty : Errc::FileMalformed);
        }
    }

    void leavesTheFileAsItWasWhenASiteCannotBeRead()
    {
        QVERIFY(writeSiteFile(path(), test::wholeSite()));
        const QByteArray before = bytes();
        Site site = test::wholeSite();
        site.touched[1].p_TQ.y() = std::numeric_limits<double>::quiet_NaN();
        const auto written = writeSiteFile(path(), site);
        QVERIFY(!written);
        QCOMPARE(written.error().code, Errc::FileMalformed);
        QVERIFY(written.error().detail.ends_with("touched[1].p_TQ_mm: three numbers are due, in "
                                                 "millimetres"));
        QCOMPARE(bytes(), before);
    }

    void saysWhenItCannotWrite()
    {
        const auto written = writeSiteFile("/proc/none/site.json", Site{});
        QVERIFY(!written);
        QCOMPARE(written.error().code, Errc::FileUnwritable);
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestSiteFile)
#include "tst_site_file.moc"
