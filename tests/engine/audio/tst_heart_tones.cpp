#include "engine/audio/heart_tones.h"
#include "tests/engine/audio/measured_sound.h"
#include "tests/support/test_class.h"

namespace carina::heart_tones_test
{

using namespace carina::test;

class TestHeartTones : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    // Weissler et al. 1968: 413 - 1.7 * 70 = 294 ms.
    void hasTheSecondToneAtTheEndOfEjection()
    {
        HeartTones heart;
        heart.beat(perMinute(70.0));
        const auto samples = heard(heart, 0.8);
        QVERIFY(effective(between(samples, 0.02, 0.1)) > 0.2);
        QCOMPARE(effective(between(samples, 0.13, 0.29)), 0.0);
        QVERIFY(effective(between(samples, 0.294 + 0.01, 0.294 + 0.07)) > 0.2);
        QCOMPARE(effective(between(samples, 0.294 + 0.081, 0.8)), 0.0);
    }

    void isHigherInTheSecondTone()
    {
        HeartTones heart;
        heart.beat(perMinute(70.0));
        const auto samples = heard(heart, 0.8);
        const double first = loudest(between(samples, 0.0, 0.12), 30.0, 200.0, 1.0);
        const double second = loudest(between(samples, 0.294, 0.374), 30.0, 200.0, 1.0);
        QVERIFY2(std::abs(first - HeartTones::kFirst_hz) < 8.0, qPrintable(QString::number(first)));
        QVERIFY2(std::abs(second - HeartTones::kSecond_hz) < 10.0,
                 qPrintable(QString::number(second)));
    }

    void hasRoomForBothTonesInAFastHeart()
    {
        for (double rate = 40.0; rate <= 250.0; rate += 10.0) {
            const double over_s = HeartTones::ejection_s(perMinute(rate)) + HeartTones::kSecond_s;
            QVERIFY2(over_s < 60.0 / rate, qPrintable(QString::number(rate)));
            QVERIFY(HeartTones::ejection_s(perMinute(rate)) >= HeartTones::kFirst_s);
        }
    }

    void doesNotClick()
    {
        HeartTones heart;
        heart.beat(perMinute(200.0));
        auto samples = heard(heart, 0.05);
        heart.beat(perMinute(200.0)); // before the last is over
        const auto more = heard(heart, 0.5);
        samples.insert(samples.end(), more.begin(), more.end());
        QVERIFY(largestStep(samples) < 0.02);
    }
};

CARINA_TEST(TestHeartTones)

} // namespace carina::heart_tones_test

#include "tst_heart_tones.moc"
