#include "engine/lungs/mechanics/respiratory_fold.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::apnoea_test
{

namespace
{

constexpr PatientBuild kAdult{metres(1.75), 77.0, 30.0, Sex::Male};

RespiratorySettings quietAdult()
{
    RespiratorySettings settings;
    settings.build = kAdult;
    settings.pattern = restingPattern(kAdult);
    return settings;
}

void run(RespiratoryFold& fold, double seconds)
{
    for (int step = 0; step < std::lround(seconds / kRespiratoryStep); ++step)
        fold.step();
}

Volume gasOf(const RespiratoryFold& fold) { return fold.content()[0].gas + fold.content()[1].gas; }

/// Greatest less least gas during a time.
Volume moved(RespiratoryFold& fold, double seconds)
{
    Volume least = gasOf(fold);
    Volume most = least;
    for (int step = 0; step < std::lround(seconds / kRespiratoryStep); ++step) {
        fold.step();
        least = std::min(least, gasOf(fold));
        most = std::max(most, gasOf(fold));
    }
    return most - least;
}

} // namespace

/// Breathing that stops, and a bag in its place.
class TestApnoea : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stopsAndGoesOn();
    void retainsCarbonDioxide();
    void failsBeforeItStops();
    void isVentilatedByABag();
    void inspiresByItsOwnEffortAlone();
    void continuesFromACheckpoint();
};

// Once what was inspired has left, no gas moves, and nothing counts as a breath.
void TestApnoea::stopsAndGoesOn()
{
    RespiratorySettings settings = quietAdult();
    RespiratoryFold fold{settings};
    run(fold, 30.0);
    QVERIFY(!fold.isStill());
    settings.ownBreathing = 0.0;
    fold.set(settings);
    run(fold, 20.0);
    QVERIFY(fold.isStill());
    QVERIFY(inMillilitres(moved(fold, 60.0)) < 2.0);
    QCOMPARE(fold.muscle().si, 0.0);
    QCOMPARE(fold.lastBreath().rate.si, 0.0);
    settings.ownBreathing = 1.0;
    fold.set(settings);
    run(fold, 30.0);
    const double breath_ml = inMillilitres(fold.lastBreath().tidalVolume);
    QVERIFY2(breath_ml > 0.9 * inMillilitres(settings.pattern.tidalVolume),
             qPrintable(QString::number(breath_ml)));
    QVERIFY(fold.lastBreath().rate >= 0.9 * settings.pattern.rate);
}

// The tension rises by a tenth in a minute of apnoea (ventilatory_drive.h).
void TestApnoea::retainsCarbonDioxide()
{
    RespiratorySettings settings = quietAdult();
    RespiratoryFold fold{settings};
    run(fold, 30.0);
    settings.ownBreathing = 0.0;
    fold.set(settings);
    run(fold, 1.0);
    const double before = fold.state().drive.carbonDioxide;
    run(fold, 60.0);
    const double rise = fold.state().drive.carbonDioxide - before;
    QVERIFY2(std::abs(rise - 0.1) < 0.005, qPrintable(QString::number(rise)));
}

void TestApnoea::failsBeforeItStops()
{
    RespiratorySettings settings = quietAdult();
    RespiratoryFold whole{settings};
    settings.ownBreathing = 0.5;
    RespiratoryFold failing{settings};
    run(whole, 30.0);
    run(failing, 30.0);
    QVERIFY(failing.lastBreath().rate < 0.7 * whole.lastBreath().rate);
    QVERIFY(failing.lastBreath().rate >= 0.95 * kSlowestOwn);
    QVERIFY(failing.lastBreath().tidalVolume < 0.7 * whole.lastBreath().tidalVolume);
    QVERIFY(failing.lastBreath().tidalVolume > 0.3 * whole.lastBreath().tidalVolume);
}

// The muscles rest in more than a third of a breath, and stay at their peak for a while; a patient
// that makes no effort inspires nothing by itself.
void TestApnoea::inspiresByItsOwnEffortAlone()
{
    RespiratorySettings settings = quietAdult();
    RespiratoryFold fold{settings};
    run(fold, 30.0);
    int resting = 0;
    int atPeak = 0;
    const auto steps = std::lround(60.0 / kRespiratoryStep);
    for (int step = 0; step < steps; ++step) {
        fold.step();
        const double inspiration = fold.inspiration().value_or(-1.0);
        QVERIFY(inspiration >= 0.0 && inspiration <= 1.0);
        resting += int(inspiration == 0.0);
        atPeak += int(inspiration > 0.99);
    }
    QVERIFY(3 * resting > steps);
    QVERIFY(20 * atPeak > steps);
    settings.ownBreathing = 0.0;
    settings.bag = {perMinute(12.0), millilitres(500.0)};
    fold.set(settings);
    run(fold, 20.0);
    QVERIFY(!fold.inspiration());
}

void TestApnoea::isVentilatedByABag()
{
    RespiratorySettings settings = quietAdult();
    settings.ownBreathing = 0.0;
    RespiratoryFold fold{settings};
    run(fold, 20.0);
    settings.bag = {perMinute(10.0), millilitres(450.0)};
    fold.set(settings);
    run(fold, 40.0);
    QVERIFY(fold.isVentilated() && !fold.isStill());
    const BreathFigures& breath = fold.lastBreath();
    QVERIFY2(std::abs(inMillilitres(breath.tidalVolume) - 450.0) < 5.0,
             qPrintable(QString::number(inMillilitres(breath.tidalVolume))));
    QVERIFY(std::abs(inPerMinute(breath.rate) - 10.0) < 0.1);
    QVERIFY(inCmH2O(breath.peak) > 3.0);
    QVERIFY(std::abs(inCmH2O(breath.endExpiratory)) < 1.0); // it keeps no pressure
    settings.bag.rate = {};
    fold.set(settings);
    run(fold, 30.0);
    QVERIFY(fold.isStill());
    QVERIFY(inMillilitres(moved(fold, 30.0)) < 2.0);
}

void TestApnoea::continuesFromACheckpoint()
{
    RespiratorySettings settings = quietAdult();
    RespiratoryFold fold{settings};
    run(fold, 10.0);
    settings.ownBreathing = 0.0;
    fold.set(settings);
    run(fold, 5.0);
    RespiratoryFold other{settings, fold.state()};
    settings.ownBreathing = 1.0;
    for (RespiratoryFold* each : {&fold, &other}) {
        run(*each, 3.0);
        each->set(settings);
        run(*each, 20.0);
    }
    QVERIFY(fold.state() == other.state());
}

CARINA_TEST(TestApnoea)

} // namespace carina::apnoea_test

#include "tst_apnoea.moc"
