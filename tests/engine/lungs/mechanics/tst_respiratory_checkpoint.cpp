#include "engine/lungs/mechanics/respiratory_fold.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::respiratory_checkpoint_test
{

namespace
{

constexpr int kSecond = 500; // steps

RespiratorySettings quiet()
{
    RespiratorySettings settings;
    settings.pattern = restingPattern(settings.build);
    return settings;
}

RespiratorySettings ventilated()
{
    RespiratorySettings settings = quiet();
    settings.ventilator.mode = VentilationMode::VolumeControl;
    settings.tube = millimetres(8.0);
    return settings;
}

/// An hour of a hard life in a minute: settings change and breaths are heard.
RespiratorySettings settingsAt(int second)
{
    RespiratorySettings settings = second < 20 ? quiet() : ventilated();
    if (second >= 10)
        settings.conditions = {{ConditionKind::TensionPneumothorax, 0.8, ConditionSide::Left}};
    if (second >= 40)
        settings.conditions = {{ConditionKind::Asthma, 0.4, ConditionSide::Both}};
    settings.ventilator.ownEffort = 0.3;
    settings.ventilator.ownRate = perMinute(19.0);
    settings.ventilator.trigger = litresPerSecond(0.03);
    return settings;
}

void live(RespiratoryFold& fold, int fromStep, int toStep)
{
    for (int i = fromStep; i < toStep; ++i) {
        if (i % kSecond == 0)
            fold.set(settingsAt(i / kSecond));
        if (i % 1717 == 0 && i / kSecond < 30)
            fold.trigger(0.01);
        fold.step();
    }
}

} // namespace

class TestRespiratoryCheckpoint : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTheSameBitForBit();
    void goesOnFromACheckpointBitForBit_data();
    void goesOnFromACheckpointBitForBit();
};

void TestRespiratoryCheckpoint::isTheSameBitForBit()
{
    RespiratoryFold first{settingsAt(0)};
    RespiratoryFold second{settingsAt(0)};
    live(first, 0, 60 * kSecond);
    live(second, 0, 60 * kSecond);
    QVERIFY(first.state() == second.state());
    QVERIFY(first.moment().airwayFlow == second.moment().airwayFlow);
    QCOMPARE(first.state().steps, std::int64_t{60 * kSecond});
}

void TestRespiratoryCheckpoint::goesOnFromACheckpointBitForBit_data()
{
    QTest::addColumn<int>("step");
    QTest::newRow("before anything") << 0;
    QTest::newRow("in a breath") << 4321;
    QTest::newRow("with trapped gas") << 19 * kSecond + 77;
    QTest::newRow("under the ventilator") << 33 * kSecond;
}

void TestRespiratoryCheckpoint::goesOnFromACheckpointBitForBit()
{
    QFETCH(const int, step);
    RespiratoryFold whole{settingsAt(0)};
    live(whole, 0, step);
    RespiratoryFold restored{whole.settings(), whole.state()};
    QVERIFY(restored.moment().airwayFlow == whole.moment().airwayFlow);
    for (int second = step / kSecond + 1; second <= 45; ++second) {
        const int from = std::max(step, (second - 1) * kSecond);
        live(whole, from, second * kSecond);
        live(restored, from, second * kSecond);
        QVERIFY(restored.state() == whole.state());
        QVERIFY(restored.moment().alveolar == whole.moment().alveolar);
    }
}

CARINA_TEST(TestRespiratoryCheckpoint)

} // namespace carina::respiratory_checkpoint_test

#include "tst_respiratory_checkpoint.moc"
