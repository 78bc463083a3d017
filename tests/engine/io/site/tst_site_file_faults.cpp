#include "engine/io/site/site_file.h"

#include "tests/engine/io/mesh/surface_files.h"
#include "tests/engine/io/site/site_sample.h"
#include "tests/engine/io/site/site_text.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <random>

namespace carina::site_file_faults_test
{
namespace
{

using namespace test;

constexpr int kDamaged = 3000;

void addRow(const char* name, const std::string& text, const char* fault)
{
    QTest::newRow(name) << text << QString::fromLatin1(fault);
}

void addColumns()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<QString>("fault");
}

/// The file of a version that had no digests yet.
std::string withoutDigest(const QByteArray& file)
{
    QJsonObject object = QJsonDocument::fromJson(file).object();
    object.remove(QStringLiteral("digest"));
    object.insert(QStringLiteral("schema"), QStringLiteral("carina.site/3"));
    return QJsonDocument{object}.toJson().toStdString();
}

} // namespace

class TestSiteFileFaults : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::filesystem::path path() const
    {
        return (m_folder.path() + QStringLiteral("/site.json")).toStdString();
    }

    [[nodiscard]] QByteArray bytes() const
    {
        QFile file{QString::fromStdString(path().string())};
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
    }
    [[nodiscard]] QByteArray written() const
    {
        return writeSiteFile(path(), wholeSite()) ? bytes() : QByteArray{};
    }

    void isRefused()
    {
        QFETCH(std::string, text);
        QFETCH(QString, fault);
        writeFile(path(), text);
        const auto site = readSiteFile(path());
        QVERIFY(!site);
        const QString detail = QString::fromStdString(site.error().detail);
        QVERIFY2(site.error().code == Errc::FileMalformed, qPrintable(detail));
        QVERIFY2(detail.startsWith(QString::fromStdString(path().string()) + QStringLiteral(": ")),
                 qPrintable(detail));
        QVERIFY2(detail.contains(fault), qPrintable(detail));
    }

private Q_SLOTS:
    void saysWhatIsWrongWithASite_data()
    {
        addColumns();
        addRow("no step", json("{'schema': 'carina.site/3'}"), "step: a text is expected");
        addRow("no such step", siteAt("'touching'"), "step: \"touching\" is none of its words");
        addRow("a number for a step", siteAt("3"), "step: a text is expected");
        addRow("a key too many", siteWith("'tracking': 'x'"), "tracking: this key is not known");
        addRow("an empty tracker", siteWith("'tracker': ''"), "tracker: a text is expected");
        addRow("an empty operator", siteWith("'operator': ''"), "operator: a text is expected");
        addRow("a faulty catalogue", siteWith("'catalogue': {'name': 'c', 'landmarks': []}"),
               "catalogue.landmarks: 0 landmarks, and 3 are the fewest");
        addRow("no display", siteWith("'display': {}"),
               "display.p_HDl_mm: three numbers are expected");
        addRow("no width", siteWith(display("0", "5")),
               "display.screen_width_mm: a screen has some width");
        addRow("no height", siteWith(display("5", "0")),
               "display.screen_height_mm: a screen has some height");
    }
    void saysWhatIsWrongWithASite() { isRefused(); }

    void saysWhatIsWrongWithAStylus_data()
    {
        addColumns();
        addRow("no object", siteWith("'stylus': 5"), "stylus: an object is expected");
        addRow("no list", siteWith("'styluses': 5"), "styluses: a list");
        addRow("no date", siteWith("'styluses': [" + stylus("1", "today") + "]"),
               "styluses[0].calibrated_at: a date and time");
        addRow("negative RMS", siteWith("'styluses': [" + stylus("-1", "2004-03-27") + "]"),
               "styluses[0].rms_mm: a length in millimetres is expected");
        addRow("the same tool twice",
               siteWith("'styluses': [" + stylus("1", "2004-03-27") + ", "
                        + stylus("2", "2004-03-27") + "]"),
               "styluses[1].tool: \"\" is there twice");
        addRow("five numbers of a covariance", stylusWith("'covariance_S_mm2': [1, 0, 0, 1, 0]"),
               "styluses[0].covariance_S_mm2: 6 numbers are expected");
        addRow("a negative variance", stylusWith("'covariance_S_mm2': [1, 0, 0, 1, 0, -1]"),
               "styluses[0].covariance_S_mm2: no error has such a covariance");
        addRow("correlated by more than one", stylusWith("'covariance_S_mm2': [1, 2, 0, 1, 0, 1]"),
               "styluses[0].covariance_S_mm2: no error has such a covariance");
        addRow("half a pose", stylusWith("'poses': 2.5"), "styluses[0].poses: a whole number");
        addRow("fewer than no outliers", stylusWith("'outliers': -1"),
               "styluses[0].outliers: a whole number");
        const std::string rest = ", 'wobble_deg': 0.2, 'calibrated_at': '2004-03-27'}";
        addRow("a long axis", stylusWith("'axis': {'axis_S': [0, 0, 2]" + rest),
               "styluses[0].axis.axis_S: a direction of length 1 is expected");
        addRow("two numbers of an axis", stylusWith("'axis': {'axis_S': [0, 1]" + rest),
               "styluses[0].axis.axis_S: 3 numbers are expected");
        addRow("a negative wobble",
               stylusWith("'axis': {'axis_S': [0, 0, 1], 'wobble_deg': -1, 'calibrated_at': 'x'}"),
               "styluses[0].axis.wobble_deg: a number that is not negative is expected");
        addRow("an axis of no date",
               stylusWith("'axis': {'axis_S': [0, 0, 1], 'wobble_deg': 1, 'calibrated_at': 'x'}"),
               "styluses[0].axis.calibrated_at: a date and time");
        addRow("an axis that knows more", stylusWith("'axis': {'spin': 1}"),
               "styluses[0].axis.spin: this key is not known");
    }
    void saysWhatIsWrongWithAStylus() { isRefused(); }

    void saysWhatIsWrongWithATouch_data()
    {
        addColumns();
        addRow("without a catalogue", siteWith("'touched': [" + touched("a") + "]"),
               "touched[0].landmark: \"a\" is not in the catalogue");
        addRow("what is not in it",
               siteWith(kCatalogue + ", 'touched': [" + touched("a") + ", " + touched("d") + "]"),
               "touched[1].landmark: \"d\" is not in the catalogue");
        addRow("twice",
               siteWith(kCatalogue + ", 'touched': [" + touched("a") + ", " + touched("a") + "]"),
               "touched[1].landmark: \"a\" is there twice");
        addRow("three numbers of a turn", touchedWith(", 'q_TS': [0, 0, 1]"),
               "touched[0].q_TS: 4 numbers are expected");
        addRow("a turn that scales", touchedWith(", 'q_TS': [0, 0, 1, 1]"),
               "touched[0].q_TS: a quaternion of length 1 is expected");
        for (const char* length : {"-0.1", "1e9", "'0.1'", "null"})
            addRow(length, touchedWith(std::string{", 'seen_error_mm': "} + length),
                   "touched[0].seen_error_mm: a length in millimetres is expected");
        addRow("stale for no known cause", touchedWith(", 'stale': 'age'"),
               "touched[0].stale: \"age\" is none of its words");
        addRow("fitted once", touchedWith(", 'fitted': 1"),
               "touched[0].fitted: true or false is expected");
        addRow("laid anew before it is registered",
               siteWith(kCatalogue + ", 'relay': [" + touched("a") + "]"),
               "relay: only a registered manikin is laid anew");
    }
    void saysWhatIsWrongWithATouch() { isRefused(); }

    void saysWhatIsWrongWithARegistration_data()
    {
        addColumns();
        addRow("a mirror", siteWith(registration("[0, -1, 0, 6]", "1")),
               "registration.X_AM_mm: a pose matrix scales, shears or mirrors");
        addRow("three numbers in a row", siteWith(registration("[0, 1, 0]", "1")),
               "registration.X_AM_mm: four rows of four numbers are expected");
        addRow("five rows", siteWith(registration("[0, 1, 0, 6], [0, 1, 0, 6]", "1")),
               "registration.X_AM_mm: four rows of four numbers are expected");
        addRow("no RMS", siteWith(registration("[0, 1, 0, 6]", "null")),
               "registration.rms_mm: a length in millimetres is expected");
        addRow("a body probe's pose that is none", registeredWith("'X_BM_mm': []"),
               "registration.X_BM_mm: four rows of four numbers are expected");
        addRow("a short covariance", registeredWith("'covariance_mm_mrad': [1, 2, 3]"),
               "registration.covariance_mm_mrad: 21 numbers are expected");
        addRow("a covariance that is none",
               registeredWith("'covariance_mm_mrad': [1,0,0,0,0,0, 1,0,0,0,0, 1,0,0,0, 1,0,0, 1,0, "
                              "-0.001]"),
               "registration.covariance_mm_mrad: no error has such a covariance");
        addRow("a negative FLE", registeredWith("'fle_mm': -1"),
               "registration.fle_mm: a length in millimetres is expected");
        addRow("residuals of no error", registeredWith("'fle_mm': 0, 'degrees_of_freedom': 6"),
               "registration.fle_mm: an error estimated from residuals is above 0");
        addRow("negative degrees", registeredWith("'degrees_of_freedom': -3"),
               "registration.degrees_of_freedom: a whole number is expected");
        addRow("half an earlier registration", registeredWith("'pooled': 0.5"),
               "registration.pooled: a whole number is expected");
        addRow("fewer than none disagree", registeredWith("'disagreeing': -1"),
               "registration.disagreeing: a whole number is expected");
        addRow("made on no day", registeredWith("'made_at': 'once'"),
               "registration.made_at: a date and time");
        addRow("by nobody", registeredWith("'operator': ''"),
               "registration.operator: a text is expected");
        addRow("a swab of nothing", registeredWith("'swab': {'points': 3}"),
               "registration.swab.surface: a text is expected");
        addRow("relaid at no time",
               registeredWith("'relays': [{'at': '', 'landmarks': 3, 'rms_mm': 1}]"),
               "registration.relays[0].at: a text is expected");
        addRow("stale for no known cause", registeredWith("'stale': 'Touches'"),
               "registration.stale: \"Touches\" is none of its words");
    }
    void saysWhatIsWrongWithARegistration() { isRefused(); }

    void saysWhatIsWrongWithALocalisation_data()
    {
        addColumns();
        const auto localisation = [](const std::string& fields) {
            return siteWith("'localisations': [{" + fields + "}]");
        };
        const std::string sound = "'rms_mm': 1, 'degrees_of_freedom': 18";
        addRow("no list", siteWith("'localisations': {}"), "localisations: a list");
        addRow("no error", localisation("'rms_mm': 0, 'degrees_of_freedom': 18"),
               "localisations[0].rms_mm: an error estimated from residuals is above 0");
        addRow("a negative error", localisation("'rms_mm': -1, 'degrees_of_freedom': 18"),
               "localisations[0].rms_mm: a length in millimetres is expected");
        addRow("from nothing", localisation("'rms_mm': 1, 'degrees_of_freedom': 0"),
               "localisations[0].degrees_of_freedom: one or more are expected");
        addRow("no degrees", localisation("'rms_mm': 1"),
               "localisations[0].degrees_of_freedom: a whole number is expected");
        addRow("on no day", localisation(sound + ", 'at': 'once'"),
               "localisations[0].at: a date and time");
        addRow("by nobody", localisation(sound + ", 'operator': ''"),
               "localisations[0].operator: a text is expected");
        addRow("with more", localisation(sound + ", 'tool': 'Stylus'"),
               "localisations[0].tool: this key is not known");
    }
    void saysWhatIsWrongWithALocalisation() { isRefused(); }

    void saysWhatIsWrongWithAVerification_data()
    {
        addColumns();
        const std::string points = ", 'points': [" + verifiedPoint("a") + "]";
        addRow("no such verdict", verificationWith("fine", points),
               "verification.verdict: \"fine\" is none of its words");
        addRow("a verdict of no day", verificationWith("good", points),
               "verification.at: a text is expected");
        addRow("no points", verificationWith("open", ""), "verification.points: a list");
        addRow("the same point twice",
               verificationWith("open", ", 'points': [" + verifiedPoint("a") + ", "
                                            + verifiedPoint("a") + "]"),
               "verification.points[1].name: \"a\" is there twice");
        addRow("stale for no known cause", verificationWith("open", points + ", 'stale': 'old'"),
               "verification.stale: \"old\" is none of its words");
    }
    void saysWhatIsWrongWithAVerification() { isRefused(); }

    void saysWhatIsWrongWithAManikin_data()
    {
        addColumns();
        const auto manikin = [](const std::string& fields) {
            return siteWith("'manikin': {" + fields + "}");
        };
        const auto profile = [&](const std::string& fields) {
            return manikin("'profile': {" + fields + "}");
        };
        addRow("no object", siteWith("'manikin': 5"), "manikin: an object is expected");
        addRow("a key too many", manikin("'colour': 5"), "manikin.colour: this key is not known");
        addRow("a profile of no name", profile(""), "manikin.profile.name: a text is expected");
        addRow("landmarks of no source", profile("'name': 'm', 'landmarks': [{'name': 'a'}]"),
               "manikin.profile.landmarks_source: a text is expected");
        addRow("a landmark twice",
               profile("'name': 'm', 'landmarks': [{'name': 'a'}, {'name': 'a'}]"),
               "manikin.profile.landmarks[1].name: \"a\" is there twice");
        addRow("a patient of no source", profile("'name': 'm', 'patient': 'child'"),
               "manikin.profile.patient_source: a text is expected");
        addRow("a length of no source", profile("'name': 'm', 'teeth_to_carina': {'mm': 245}"),
               "manikin.profile.teeth_to_carina.source: a text is expected");
        addRow("a length of a giant",
               profile("'name': 'm', 'teeth_to_carina': {'mm': 351, 'source': 's'}"),
               "manikin.profile.teeth_to_carina.mm: teeth to carina are 100 to 350 mm");
        addRow("a short airway", manikin("'measured_teeth_to_carina_mm': 99"),
               "manikin.measured_teeth_to_carina_mm: teeth to carina are 100 to 350 mm");
        addRow("no such place", manikin("'airway': [{'place': 'nose', 'p_MQ_mm': [1, 2, 3]}]"),
               "manikin.airway[0].place: \"nose\" is none of its words");
        addRow("a place twice",
               manikin("'airway': [{'place': 'carina', 'p_MQ_mm': [1, 2, 3]},"
                       "{'place': 'carina', 'p_MQ_mm': [1, 2, 3]}]"),
               "manikin.airway[1].place: it is there twice");
        addRow("half a point", manikin("'airway': [{'place': 'carina', 'p_MQ_mm': [1, 2]}]"),
               "manikin.airway[0].p_MQ_mm: three numbers are expected");
    }
    void saysWhatIsWrongWithAManikin() { isRefused(); }

    void refusesAnotherVersion()
    {
        writeFile(path(), json("{'schema': 'carina.site/7', 'step': 'fit'}"));
        const auto site = readSiteFile(path());
        QVERIFY(!site);
        QCOMPARE(site.error().code, Errc::UnknownFormat);
    }

    /// Bytes struck, doubled and left out at random in a file without a digest: it is refused, or
    /// it is a site that can be written and read again.
    void survivesDamagedFiles()
    {
        const std::string whole = withoutDigest(written());
        const std::string alphabet = "0123456789-.,:{}[]\"etrufalsn ";
        std::mt19937 random{2019};
        int read = 0;
        for (int i = 0; i < kDamaged; ++i) {
            std::string text = whole;
            for (int k = 0; k <= i % 3; ++k) {
                const std::size_t at = random() % text.size();
                switch (random() % 3) {
                case 0:
                    text[at] = alphabet[random() % alphabet.size()];
                    break;
                case 1:
                    text.insert(at, text.substr(at, 1 + random() % 40));
                    break;
                default:
                    text.erase(at, 1 + random() % 5);
                }
            }
            writeFile(path(), text);
            const auto site = readSiteFile(path());
            if (!site)
                continue;
            ++read;
            QVERIFY(writeSiteFile(path(), *site));
            QVERIFY(readSiteFile(path()).has_value());
        }
        QVERIFY(read > kDamaged / 100 && read < kDamaged / 2);
    }

    /// Every bit of a small file flipped, one after another: it is refused and left alone, or what
    /// it says is the same (another blank, another line end).
    void noticesEveryFlippedBit()
    {
        const Site small{.operatorName = "A", .styluses = {wholeSite().styluses[0]}};
        QVERIFY(writeSiteFile(path(), small));
        const QByteArray whole = bytes();
        const QJsonObject content = QJsonDocument::fromJson(whole).object();
        int harmless = 0;
        for (qsizetype bit = 0; bit < 8 * whole.size(); ++bit) {
            QByteArray flipped = whole;
            flipped[bit / 8] = char(flipped[bit / 8] ^ (1 << bit % 8));
            writeFile(path(), flipped.toStdString());
            const auto site = readSiteFile(path());
            QCOMPARE(bytes(), flipped);
            if (!site)
                continue;
            ++harmless;
            QVERIFY2(QJsonDocument::fromJson(flipped).object() == content,
                     flipped.mid(std::max(qsizetype{0}, bit / 8 - 20), 40).constData());
        }
        QVERIFY(harmless < whole.size());
    }

    void needsADigestOnlyInFilesThatHaveThem()
    {
        const QByteArray whole = written();
        writeFile(path(), withoutDigest(whole));
        QVERIFY(readSiteFile(path()).has_value());
        QJsonObject object = QJsonDocument::fromJson(whole).object();
        object.remove(QStringLiteral("digest"));
        writeFile(path(), QJsonDocument{object}.toJson().toStdString());
        const auto site = readSiteFile(path());
        QCOMPARE(site.error().code, Errc::FileMalformed);
        QVERIFY(site.error().detail.ends_with("does not match its digest"));
    }

    void letsOnlyItsOwnerReadIt()
    {
        QVERIFY(writeSiteFile(path(), wholeSite()));
        QCOMPARE(std::filesystem::status(path()).permissions(),
                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    }

    void refusesEveryCutOffFile()
    {
        const QByteArray whole = written().trimmed();
        for (qsizetype length = 0; length < whole.size(); length += 13) {
            writeFile(path(), whole.first(length).toStdString());
            const auto site = readSiteFile(path());
            QVERIFY(!site);
            QCOMPARE(site.error().code, length == 0 ? Errc::FileEmpty : Errc::FileMalformed);
        }
    }
};

CARINA_TEST(TestSiteFileFaults)

} // namespace carina::site_file_faults_test

#include "tst_site_file_faults.moc"
