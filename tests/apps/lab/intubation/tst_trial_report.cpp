#include "apps/lab/intubation/trial_report.h"

#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "apps/lab/intubation/trial_statistics.h"
#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

#include <algorithm>
#include <cmath>

namespace carina::lab::trial_report_test
{
namespace
{

/// With the tube as it is measured: what the hands move is rigid.
const IntubationSubject& subject()
{
    static const IntubationSubject boy = [] {
        const PatientDimensions dimensions = dimensionsOf(BuiltinPatient::TwelveYears);
        IntubationSubject it =
            intubationSubject(test::tubePatient(dimensions), buildOf(dimensions), {}).value();
        it.lumen = nullptr;
        return it;
    }();
    return boy;
}

IntubationTrial trialOf(MotionKind kind, std::uint32_t seed = 1)
{
    return runTrial(subject(), kind, seed).value();
}

double metricOf(const QJsonObject& report, const char* word)
{
    for (const QJsonValue& metric : report[QStringLiteral("metrics")].toArray())
        if (metric[QStringLiteral("metric")] == QLatin1StringView{word})
            return metric[QStringLiteral("value")].toDouble();
    return std::nan("");
}

double lowestSaturation(const QJsonObject& report)
{
    double lowest = 100.0;
    for (const QJsonValue& row : report[QStringLiteral("vitals")].toArray())
        lowest = std::min(lowest, row[QStringLiteral("saturation_percent")].toDouble());
    return lowest;
}

/// A trial as if the monitor had told this.
IntubationTrial told(TrueSeat truth, TubeSeat outcome, double confidence)
{
    IntubationTrial trial;
    trial.truth.outcome = truth;
    trial.truth.depthAtTeeth = millimetres(200.0);
    trial.course.seat = outcome;
    trial.course.confidence = confidence;
    trial.course.tip.depthAtTeeth = millimetres(205.0);
    trial.registrationAtTeeth = millimetres(1.0);
    trial.registrationAtTip = millimetres(9.0);
    return trial;
}

} // namespace

class TestTrialReport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The patient is on oxygen, and a child of twelve years stays above 90 % for minutes.
    void tellsOfAGoodIntubation()
    {
        const QJsonObject report = trialReport(subject(), trialOf(MotionKind::Good));
        QCOMPARE(report[QStringLiteral("schema")].toString(), QStringLiteral("carina.intubate/1"));
        QCOMPARE(report[QStringLiteral("script")].toString(), QStringLiteral("good"));
        QCOMPARE(report[QStringLiteral("truth")][QStringLiteral("outcome")].toString(),
                 QStringLiteral("trachea"));
        QVERIFY(!report[QStringLiteral("timeline")].toArray().isEmpty());
        QVERIFY(lowestSaturation(report) > 95.0);
        QCOMPARE(metricOf(report, "attempts"), 1.0);
        const QJsonObject score = report[QStringLiteral("score")].toObject();
        QVERIFY(score[QStringLiteral("points")].toDouble() > 0.0);
        QVERIFY(score[QStringLiteral("points")].toDouble()
                <= score[QStringLiteral("possible")].toDouble());
    }

    /// Its CO2 is gone, and what is recognised late costs points.
    void tellsWhatAnOesophagealTubeDoes()
    {
        const QJsonObject good = trialReport(subject(), trialOf(MotionKind::Good));
        const QJsonObject late = trialReport(subject(), trialOf(MotionKind::LateRecognition));
        QCOMPARE(metricOf(late, "attempts"), 2.0);
        QVERIFY(lowestSaturation(late) < lowestSaturation(good));
        QVERIFY(late[QStringLiteral("score")][QStringLiteral("points")].toDouble()
                < good[QStringLiteral("score")][QStringLiteral("points")].toDouble());
    }

    /// A share of nothing is none.
    void tellsNoShareOfNothing()
    {
        const QJsonObject report = TrialStatistics{}.report(subject());
        for (const char* key : {"depth", "above_carina", "times"}) {
            const QJsonValue within = report[QLatin1StringView{key}][QStringLiteral("within")];
            QVERIFY2(within.isNull(), key);
        }
    }

    void countsWhatWasWrong()
    {
        TrialStatistics statistics;
        statistics.add(told(TrueSeat::Trachea, TubeSeat::Trachea, 0.95));
        statistics.add(told(TrueSeat::Trachea, TubeSeat::Oesophagus, 0.55));
        statistics.add(told(TrueSeat::Oesophagus, TubeSeat::Trachea, 0.9));
        const QJsonObject report = statistics.report(subject());
        QCOMPARE(report[QStringLiteral("runs")].toInt(), 3);
        QCOMPARE(report[QStringLiteral("wrong_outcomes")].toInt(), 2);
        QCOMPARE(report[QStringLiteral("wrong_and_unsure")].toInt(), 1);
        QCOMPARE(report[QStringLiteral("right_and_sure")].toInt(), 1);
        const QJsonArray confusion = report[QStringLiteral("confusion")].toArray();
        QCOMPARE(confusion[1][QStringLiteral("truth")].toString(), QStringLiteral("trachea"));
        QCOMPARE(confusion[1][QStringLiteral("trachea")].toInt(), 1);
        QCOMPARE(confusion[1][QStringLiteral("oesophagus")].toInt(), 1);
        QCOMPARE(confusion[4][QStringLiteral("trachea")].toInt(), 1);
        // 5 mm deeper, with 3 and 1 mm allowed.
        const QJsonObject depth = report[QStringLiteral("depth")].toObject();
        QVERIFY(std::abs(depth[QStringLiteral("median_mm")].toDouble() - 5.0) < 1e-9);
        QCOMPARE(depth[QStringLiteral("within")].toDouble(), 0.0);
        const QJsonArray wrong = report[QStringLiteral("wrong")].toArray();
        QCOMPARE(wrong.size(), 2);
        QCOMPARE(wrong[0][QStringLiteral("confidence")].toDouble(), 0.55);
        QVERIFY(wrong[0][QStringLiteral("outside")].isNull());
    }

    /// A depth that is frozen is not told, and so not wrong.
    void countsNoErrorOfAFrozenDepth()
    {
        IntubationTrial apart = told(TrueSeat::Trachea, TubeSeat::Trachea, 0.4);
        apart.course.shapes.isIn = true;
        TrialStatistics statistics;
        statistics.add(apart);
        const QJsonObject report = statistics.report(subject());
        QCOMPARE(report[QStringLiteral("depth_frozen")].toInt(), 1);
        QCOMPARE(report[QStringLiteral("depth")][QStringLiteral("greatest_mm")].toDouble(), 0.0);
        IntubationTrial whole = trialOf(MotionKind::Good);
        QVERIFY(trialReport(subject(), whole)[QStringLiteral("depth_at_teeth_mm")].isDouble());
        whole.course.shapes.isIn = true;
        QVERIFY(trialReport(subject(), whole)[QStringLiteral("depth_at_teeth_mm")].isNull());
        QVERIFY(trialReport(subject(), whole)[QStringLiteral("tip_above_carina_mm")].isNull());
    }

    void tellsNoDistanceFromTheCarinaInTheOesophagus()
    {
        const auto above = [](MotionKind kind) {
            return trialReport(subject(), trialOf(kind))[QStringLiteral("tip_above_carina_mm")];
        };
        QVERIFY(above(MotionKind::Good).isDouble());
        QVERIFY(above(MotionKind::Oesophageal).isNull());
    }

    void saysInWhichShapeTheTubeWasShown()
    {
        IntubationSubject bending = subject();
        bending.lumen = std::make_shared<const AirwayLumen>();
        const IntubationTrial trial = told(TrueSeat::Trachea, TubeSeat::Trachea, 0.95);
        for (const auto& [of, shape] : {std::pair{bending, QStringLiteral("rod")},
                                        std::pair{subject(), QStringLiteral("rigid")}}) {
            QCOMPARE(watchedReport(of, trial)[QStringLiteral("tube")].toString(), shape);
            QCOMPARE(TrialStatistics{}.report(of)[QStringLiteral("tube")].toString(), shape);
        }
    }

    void refusesBadArguments_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QByteArray>("named");
        const auto row = [](const char* name, const char* words, const char* named) {
            QTest::newRow(name) << QString::fromLatin1(words) << QByteArray{named};
        };
        row("nothing", "", "one motion or recording, or --all-scripts");
        row("both", "good --all-scripts", "one motion or recording, or --all-scripts");
        row("unknown motion", "bad", "choose one of good, slow, oesophageal");
        row("seeds of one", "good --seeds 3", "--seeds with --all-scripts");
        row("registration of a recording", "poses.csv --registration 3",
            "--registration with motions");
        row("site of a motion", "good --site a.json", "--site with a recording");
        row("told of all", "--all-scripts --told first_breath=3", "--told with a recording");
        row("saved of all", "--all-scripts --save a.csv", "--save with one motion");
        row("seed of all", "--all-scripts --seed 3", "--seed with one motion");
        row("no seeds", "--all-scripts --seeds 0", "1");
        row("too thick", "good --tube 9.5", "from 2.5 to 9");
        row("unknown patient", "good --patient horse", "a patient is adult");
    }
    void refusesBadArguments()
    {
        QFETCH(const QString, words);
        QFETCH(const QByteArray, named);
        const auto printed =
            intubateCommand().run(words.split(QLatin1Char(' '), Qt::SkipEmptyParts));
        QVERIFY(!printed);
        const QByteArray detail = QByteArray::fromStdString(printed.error().detail);
        QVERIFY2(detail.contains(named), detail.constData());
    }

    void namesEachMotionOnItsPage()
    {
        const QString page = pageOf(intubateCommand()).simplified();
        for (const NamedMotion& motion : kNamedMotions)
            QVERIFY2(page.contains(QLatin1StringView{motion.name.data()}), motion.name.data());
    }
};

CARINA_TEST(TestTrialReport)

} // namespace carina::lab::trial_report_test

#include "tst_trial_report.moc"
