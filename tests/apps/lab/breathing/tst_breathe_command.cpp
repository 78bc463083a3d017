#include "apps/lab/commands.h"
#include "engine/lungs/mechanics/respiratory_fold.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <cmath>
#include <limits>

namespace carina::breathe_command_test
{

namespace
{

constexpr double kVolumeTolerance_ml = 0.1;

Result<QJsonObject> breathe(const QString& words)
{
    return lab::breatheCommand().run(words.split(QLatin1Char(' '), Qt::SkipEmptyParts));
}

/// The greatest less the least gas in both lungs over so many frames, 60 a second.
double swing_ml(const RespiratorySettings& settings, int frames)
{
    RespiratoryFold fold{settings};
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    std::int64_t step = 0;
    for (int frame = 0; frame < frames; ++frame) {
        for (; step < std::llround(frame / 60.0 / kRespiratoryStep); ++step)
            fold.step();
        const double gas = inMillilitres(fold.content()[0].gas + fold.content()[1].gas);
        least = std::min(least, gas);
        greatest = std::max(greatest, gas);
    }
    return greatest - least;
}

RespiratorySettings breathing(const PatientBuild& build, double rate_perMin, double tidalVolume_ml)
{
    RespiratorySettings settings;
    settings.build = build;
    settings.pattern = restingPattern(build);
    settings.pattern.rate = perMinute(rate_perMin);
    settings.pattern.tidalVolume = millilitres(tidalVolume_ml);
    return settings;
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
    void drawsTheVolumeOfTheMechanicsInEveryLevel_data();
    void drawsTheVolumeOfTheMechanicsInEveryLevel();
    void drawsRealLungs();
    void drawsOneLevelWhereOneIsAskedFor();
    void refusesWhatItCannotDo_data();
    void refusesWhatItCannotDo();
};

void TestBreatheCommand::drawsTheVolumeOfTheMechanicsInEveryLevel_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<double>("swing_ml");
    QTest::addColumn<double>("frc_ml");
    const PatientBuild boy{metres(1.5), 40.0, 12.0, Sex::Male};
    QTest::newRow("child") << QStringLiteral("--rate-per-min 19 --tidal-volume-ml 280 --seconds 1")
                           << swing_ml(breathing(boy, 19.0, 280.0), 61) << 1200.0;
    QTest::newRow("adult") << QStringLiteral("--patient adult --rate-per-min 30 --tidal-volume-ml "
                                             "540 --seconds 1")
                           << swing_ml(breathing({}, 30.0, 540.0), 61) << 2310.0;
    RespiratorySettings ill = breathing({}, 16.0, 540.0);
    ill.conditions = {{ConditionKind::SimplePneumothorax, 0.9, ConditionSide::Right}};
    ill.ventilator.mode = VentilationMode::VolumeControl;
    QTest::newRow("pneumothorax under a ventilator")
        << QStringLiteral("--patient adult --rate-per-min 16 --tidal-volume-ml 540 --seconds 1 "
                          "--condition simple_pneumothorax --severity 0.9 --side right "
                          "--ventilator volume")
        << swing_ml(ill, 61) << 2310.0;
    for (const auto& [name, position] : {std::pair{"sitting", BodyPosition::Sitting},
                                         {"prone", BodyPosition::Prone},
                                         {"left_lateral", BodyPosition::LeftLateral}}) {
        RespiratorySettings turned = breathing(boy, 19.0, 280.0);
        turned.position = position;
        QTest::newRow(name) << QStringLiteral("--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 "
                                              "--position ")
                                   + QString::fromLatin1(name)
                            << swing_ml(turned, 61) << 1200.0;
    }
}

void TestBreatheCommand::drawsTheVolumeOfTheMechanicsInEveryLevel()
{
    QFETCH(QString, words);
    QFETCH(double, swing_ml);
    QFETCH(double, frc_ml);
    const Result<QJsonObject> object = breathe(words);
    QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
    QCOMPARE((*object)[QStringLiteral("schema")].toString(), QStringLiteral("carina.breathe/1"));
    QVERIFY(number(*object, "max_volume_error_ml") < kVolumeTolerance_ml);
    QVERIFY(std::abs(number(*object, "frc_ml") - frc_ml) < 1.0);

    const QJsonArray levels = (*object)[QStringLiteral("levels")].toArray();
    QVERIFY(levels.size() >= 3);
    for (const QJsonValue& level : levels) {
        QCOMPARE(level[QStringLiteral("frames")].toInt(), 61);
        const double drawn_ml = level[QStringLiteral("tidal_volume_drawn_ml")].toDouble();
        QVERIFY(std::abs(drawn_ml - swing_ml) < 2.0 * kVolumeTolerance_ml);
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
         QStringLiteral("1"), QStringLiteral("--anatomy"),
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
    row("nothing", "", "--seconds");
    row("unknown position", "--every-condition --position upside_down", "upside_down");
    row("a rate of nothing", "--rate-per-min 0 --tidal-volume-ml 280 --seconds 1", "from 4 to 60");
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
        "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 --patient giant",
        "a patient is adult");
    row("a folder there is not",
        "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 --anatomy /no/such/folder",
        "/no/such/folder");
    row("a flag there is not", "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 --loud",
        "--loud");
    row("a word too many", "--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 more", "more");
    row("more than anybody breathes", "--rate-per-min 19 --tidal-volume-ml 5000 --seconds 3",
        "from 10 to 2000");
    row("less than a newborn breathes", "--rate-per-min 19 --tidal-volume-ml 9.9 --seconds 3",
        "from 10 to 2000");
    const auto ill = [&](const char* name, const char* words, const char* mention) {
        const QByteArray all =
            QByteArray{"--rate-per-min 19 --tidal-volume-ml 280 --seconds 1 "} + words;
        row(name, all.constData(), mention);
    };
    ill("a condition there is not", "--condition cold",
        "has no --condition cold; choose one of normal, ards, copd, asthma,");
    ill("a side there is not", "--condition ards --side back",
        "has no --side back; choose one of both, right, left.");
    ill("a severity of health", "--condition normal --severity 0.5", "not normal");
    ill("a side of health", "--condition normal --side left", "not normal");
    ill("a severity of nothing", "--severity 0.5", "not normal");
    ill("more than severe", "--condition ards --severity 1.1", "--severity");
    ill("a tube in both bronchi", "--condition mainstem_intubation", "--side");
    ill("a ventilator there is not", "--ventilator iron",
        "has no --ventilator iron; choose one of none, volume, pressure.");
    ill("one way and every condition", "--every-condition", "nothing else");
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

CARINA_SCREEN_TEST(TestBreatheCommand)

} // namespace carina::breathe_command_test

#include "tst_breathe_command.moc"
