#include "apps/lab/breathe_command.h"
#include "tests/support/test_data.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace carina;

namespace
{

constexpr double kVolumeTolerance_ml = 0.1;

Result<QJsonObject> breathe(const QString& words)
{
    return lab::breatheCommand().run(words.split(QLatin1Char(' '), Qt::SkipEmptyParts));
}

double number(const QJsonObject& object, const char* key)
{
    return object[QLatin1StringView{key}].toDouble(std::nan(""));
}

} // namespace

class TestBreatheCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsTheVolumeCommandedInEveryLevel_data();
    void drawsTheVolumeCommandedInEveryLevel();
    void drawsRealLungs();
    void drawsOneLevelWhereOneIsAskedFor();
    void refusesWhatItCannotDo_data();
    void refusesWhatItCannotDo();
};

void TestBreatheCommand::drawsTheVolumeCommandedInEveryLevel_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<double>("tidalVolume_ml");
    QTest::addColumn<double>("frc_ml");
    QTest::newRow("child") << QStringLiteral("--rate-per-min 19 --tidal-volume-ml 280 --seconds 2")
                           << 280.0 << 1200.0;
    QTest::newRow("adult") << QStringLiteral("--patient adult --rate-per-min 30 --tidal-volume-ml "
                                             "540 --seconds 2")
                           << 540.0 << 2310.0;
}

void TestBreatheCommand::drawsTheVolumeCommandedInEveryLevel()
{
    QFETCH(QString, words);
    QFETCH(double, tidalVolume_ml);
    QFETCH(double, frc_ml);
    const Result<QJsonObject> object = breathe(words);
    QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
    QCOMPARE((*object)[QStringLiteral("schema")].toString(), QStringLiteral("carina.breathe/1"));
    QVERIFY(number(*object, "max_volume_error_ml") < kVolumeTolerance_ml);
    QVERIFY(std::abs(number(*object, "frc_ml") - frc_ml) < 1.0);

    const QJsonArray levels = (*object)[QStringLiteral("levels")].toArray();
    QVERIFY(levels.size() >= 3);
    // Frames meet the top of the breath to within half a frame, where the flow is small.
    constexpr double kMissedTop_ml = 2.0;
    for (const QJsonValue& level : levels) {
        QCOMPARE(level[QStringLiteral("frames")].toInt(), 121);
        const double drawn_ml = level[QStringLiteral("tidal_volume_drawn_ml")].toDouble();
        QVERIFY(drawn_ml <= tidalVolume_ml + kVolumeTolerance_ml);
        QVERIFY(drawn_ml > tidalVolume_ml - kMissedTop_ml);
    }
    double rest_ml = 0.0;
    for (const char* side : {"right", "left"}) {
        const QJsonObject lung =
            (*object)[QStringLiteral("lungs")][QLatin1StringView{side}].toObject();
        QVERIFY(number(lung, "max_volume_error_ml") < kVolumeTolerance_ml);
        QCOMPARE(lung[QStringLiteral("levels")].toArray().size(), levels.size());
        rest_ml += number(lung, "rest_volume_ml");
    }
    QVERIFY(std::abs(rest_ml - number(*object, "frc_ml")) < 1e-9 * frc_ml);
}

void TestBreatheCommand::drawsRealLungs()
{
    const auto folder = test::testData("anatomy/lungs");
    if (!folder)
        QSKIP("needs ../shared/data/anatomy/lungs");
    const QTemporaryDir cache;
    qputenv("XDG_CACHE_HOME", cache.path().toUtf8());
    const Result<QJsonObject> object = lab::breatheCommand().run(
        {QStringLiteral("--rate-per-min"), QStringLiteral("19"),
         QStringLiteral("--tidal-volume-ml"), QStringLiteral("280"), QStringLiteral("--seconds"),
         QStringLiteral("2"), QStringLiteral("--anatomy"),
         QString::fromStdString(folder->string())});
    QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
    QVERIFY(number(*object, "max_volume_error_ml") < kVolumeTolerance_ml);
    const QJsonObject lungs = (*object)[QStringLiteral("lungs")].toObject();
    // The lobes' volumes as their README gives the lungs', less the fissures between them.
    QVERIFY(std::abs(number(lungs[QStringLiteral("right")].toObject(), "rest_volume_ml") - 1567.0)
            < 40.0);
    QVERIFY(std::abs(number(lungs[QStringLiteral("left")].toObject(), "rest_volume_ml") - 1297.0)
            < 40.0);
}

void TestBreatheCommand::drawsOneLevelWhereOneIsAskedFor()
{
    const Result<QJsonObject> object =
        breathe(QStringLiteral("--rate-per-min 19 --tidal-volume-ml 280 --seconds 0.5 --level 2"));
    QVERIFY(object.has_value());
    const QJsonArray levels = (*object)[QStringLiteral("levels")].toArray();
    QCOMPARE(levels.size(), 1);
    QCOMPARE(levels.first()[QStringLiteral("level")].toInt(), 2);
}

void TestBreatheCommand::refusesWhatItCannotDo_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("mention");
    const auto row = [](const char* name, const char* words, const char* mention) {
        QTest::newRow(name) << QString::fromLatin1(words) << QString::fromLatin1(mention);
    };
    row("nothing", "", "--rate-per-min");
    row("a rate of nothing", "--rate-per-min 0 --tidal-volume-ml 280 --seconds 1", "from 1 to 120");
    row("a rate that is not a number", "--rate-per-min nan --tidal-volume-ml 280 --seconds 1",
        "--rate-per-min");
    row("a word for a volume", "--rate-per-min 19 --tidal-volume-ml much --seconds 1",
        "--tidal-volume-ml");
    row("no end", "--rate-per-min 19 --tidal-volume-ml 280 --seconds inf", "--seconds");
    row("half a level", "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 --level 0.5",
        "--level");
    row("a level there is not", "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 --level 50",
        "levels 0 to");
    row("a patient there is not",
        "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 --patient giant", "--patient adult");
    row("a folder there is not",
        "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 --anatomy /no/such/folder",
        "/no/such/folder");
    row("a folder and a patient",
        "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 --anatomy . --patient adult",
        "not both");
    row("a flag there is not", "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 --loud",
        "--loud");
    row("a word too many", "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 more", "more");
    row("more than a lung can hold", "--rate-per-min 19 --tidal-volume-ml 5000 --seconds 3", "ml");
}

void TestBreatheCommand::refusesWhatItCannotDo()
{
    QFETCH(QString, words);
    QFETCH(QString, mention);
    const Result<QJsonObject> object = breathe(words);
    QVERIFY(!object);
    QVERIFY2(QString::fromStdString(object.error().detail).contains(mention),
             object.error().detail.c_str());
}

QTEST_MAIN(TestBreatheCommand)
#include "tst_breathe_command.moc"
