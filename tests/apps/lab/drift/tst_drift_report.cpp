#include "apps/lab/drift/drift_page.h"
#include "apps/lab/drift/drift_report.h"
#include "engine/core/units.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::lab::drift_report_test
{
namespace
{

constexpr double kTolerance_deg = 1e-9;

DriftSettings settingsOf(const char* strategy)
{
    DriftSettings settings;
    settings.strategy = findSyncStrategy(strategy);
    settings.script = {.angularSpeed = degrees(100.0).si, .speed = 0.1};
    settings.scenario = *findScenario("metro");
    return settings;
}

DriftFigures averaging(double timeAverage_deg, double limit_deg)
{
    DriftFigures figures;
    figures.timeAverage = degrees(timeAverage_deg).si;
    figures.limit = degrees(limit_deg).si;
    return figures;
}

} // namespace

class DriftReportTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// At 100 deg/s 0.2 ms are 0.02 degrees and 0.3 ms are 0.03.
    void boundIsTheSmallerOfTheTwoWithTheSessionClock_data()
    {
        QTest::addColumn<QByteArray>("strategy");
        QTest::addColumn<double>("virtual_deg");
        QTest::addColumn<double>("limit_deg");
        QTest::addColumn<double>("bound_deg");
        QTest::newRow("the limit") << QByteArray{"session-clock"} << 0.100 << 0.004 << 0.026;
        QTest::newRow("virtual time") << QByteArray{"session-clock"} << 0.080 << 0.100 << 0.130;
        QTest::newRow("another strategy") << QByteArray{"asa-fixed"} << 0.080 << 0.001 << 0.130;
    }
    void boundIsTheSmallerOfTheTwoWithTheSessionClock()
    {
        QFETCH(const QByteArray, strategy);
        QFETCH(const double, virtual_deg);
        QFETCH(const double, limit_deg);
        QFETCH(const double, bound_deg);
        const DriftSettings settings = settingsOf(strategy.constData());
        const DriftFigures inVirtualTime = averaging(virtual_deg, limit_deg);
        LiveFigures live;
        for (const double above_deg : {-0.001, 0.001}) {
            live.drift = averaging(bound_deg + above_deg, limit_deg);
            const QJsonObject report = reportOf(live, settings, inVirtualTime);
            const double bound = report[drift_key::kBound].toDouble();
            QVERIFY2(std::abs(bound - bound_deg) < kTolerance_deg,
                     qPrintable(QString::number(bound)));
            QCOMPARE(report[drift_key::kIsWithinBound].toBool(), above_deg < 0.0);
        }
    }

    /// How far off a lost action leaves a viewer is chance with a strategy that does not repeat it;
    /// the session clock does, and so does local lag.
    void lostActionsAreInTheAverageOfWhatRepeatsThem()
    {
        LiveFigures live;
        live.drift = averaging(1.0, 1.0);
        live.drift.timeAverageShown = degrees(0.1).si;
        const DriftFigures inVirtualTime = averaging(0.1, 1.0);
        for (const char* strategy : {"asa-fixed", "session-clock", "local-lag"}) {
            const auto report = reportOf(live, settingsOf(strategy), inVirtualTime);
            QCOMPARE(report[drift_key::kIsWithinBound].toBool(),
                     QByteArray{strategy} == QByteArray{"asa-fixed"});
        }
    }

    void losesNoMoreActionsThanTheNetwork_data()
    {
        QTest::addColumn<QByteArray>("strategy");
        QTest::addColumn<QByteArray>("scenario");
        QTest::addColumn<double>("inVirtualTime");
        QTest::addColumn<double>("allowed");
        QTest::newRow("nothing is lost")
            << QByteArray{"event"} << QByteArray{"metro"} << 0.0 << 0.0;
        // Three viewers, and 3 sqrt(0.25).
        QTest::newRow("some is lost") << QByteArray{"event"} << QByteArray{"wan"} << 0.25 << 4.75;
        QTest::newRow("cut") << QByteArray{"event"} << QByteArray{"partition"} << 0.0 << 3.0;
        QTest::newRow("and repeated") << QByteArray{"local-lag"} << QByteArray{"wan"} << 0.0 << 0.0;
        QTest::newRow("and repeated too late")
            << QByteArray{"session-clock"} << QByteArray{"partition"} << 4.0 << 10.0;
    }
    void losesNoMoreActionsThanTheNetwork()
    {
        QFETCH(const QByteArray, strategy);
        QFETCH(const QByteArray, scenario);
        QFETCH(const double, inVirtualTime);
        QFETCH(const double, allowed);
        DriftSettings settings = settingsOf(strategy.constData());
        settings.scenario = *findScenario(scenario.toStdString());
        settings.participants = 4;
        DriftFigures expected = averaging(0.1, 1.0);
        expected.lost = inVirtualTime;
        LiveFigures live;
        live.drift = averaging(0.1, 1.0);
        for (const double more : {0.0, 1.0}) {
            live.drift.lost = std::floor(allowed) + more;
            const auto report = reportOf(live, settings, expected);
            QVERIFY(std::abs(report[drift_key::kLostBound].toDouble() - allowed) < kTolerance_deg);
            QCOMPARE(report[drift_key::kIsWithinBound].toBool(), more == 0.0);
        }
    }
};

CARINA_TEST(DriftReportTest)

} // namespace carina::lab::drift_report_test

#include "tst_drift_report.moc"
