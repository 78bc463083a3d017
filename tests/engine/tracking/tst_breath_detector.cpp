#include "engine/tracking/breath_detector.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>
#include <vector>

namespace carina::breath_detector_test
{

namespace
{

constexpr double kFrame_s = 1.0 / 60.0;

SessionTime at(double seconds) { return SessionTime{fromSeconds(seconds)}; }

/// A manikin's chest: up by a half sine over a third of a breath, down over the next, then at rest.
double breathingHeight(double seconds, double rate_perMin, double motion_m)
{
    const double breaths = seconds * rate_perMin / 60.0;
    const double phase = 3.0 * (breaths - std::floor(breaths));
    if (phase >= 2.0)
        return 0.0;
    return 0.5 * motion_m * (1.0 - std::cos(std::numbers::pi * phase));
}

template <class Height> std::vector<double> beginnings(double seconds, Height height)
{
    BreathDetector detector;
    std::vector<double> found;
    for (double t = 0.0; t < seconds; t += kFrame_s)
        if (const auto began = detector.add(at(t), height(t)))
            found.push_back(toSeconds(began->time_since_epoch()));
    return found;
}

} // namespace

class TestBreathDetector : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsEveryBreath_data()
    {
        QTest::addColumn<double>("rate_perMin");
        QTest::addColumn<double>("motion_mm");
        QTest::addColumn<double>("noise_mm");
        QTest::addColumn<double>("drift_mmPerS");
        QTest::newRow("as on the bench") << 15.0 << 10.0 << 0.0 << 0.0;
        QTest::newRow("measured") << 15.0 << 10.0 << 0.35 << 0.0;
        QTest::newRow("slow") << 6.0 << 20.0 << 0.35 << 0.0;
        QTest::newRow("fast") << 40.0 << 8.0 << 0.35 << 0.0;
        QTest::newRow("while the marker slips") << 15.0 << 10.0 << 0.2 << -0.3;
    }

    /// A half sine begins with no speed: the line through two of its points leaves the ground by
    /// 0.158 of the rise later.
    void findsEveryBreath()
    {
        QFETCH(double, rate_perMin);
        QFETCH(double, motion_mm);
        QFETCH(double, noise_mm);
        QFETCH(double, drift_mmPerS);
        std::mt19937 random{7};
        std::normal_distribution<double> noise{0.0, std::max(1e-12, noise_mm)};
        const double breath = 60.0 / rate_perMin;
        const double start = 0.5 * breath; // it rests at first
        const auto found = beginnings(start + 8.4 * breath, [&](double t) {
            return breathingHeight(t + breath - start, rate_perMin, 1e-3 * motion_mm)
                   + 1e-3 * (noise(random) + drift_mmPerS * t);
        });
        QCOMPARE(found.size(), std::size_t{9});
        const double late = 0.158 * breath / 3.0;
        for (std::size_t i = 1; i < found.size(); ++i) { // the first tells how far it moves
            const double expected = start + double(i) * breath + late;
            QVERIFY2(std::abs(found[i] - expected) < 0.03 + 0.1 * breath / 3.0,
                     qPrintable(QStringLiteral("%1 for %2").arg(found[i]).arg(expected)));
        }
    }

    void hearsNothingInAChestThatRests()
    {
        std::mt19937 random{7};
        std::normal_distribution<double> noise{0.0, 0.2e-3};
        QVERIFY(beginnings(120.0, [&](double) { return noise(random); }).empty());
        QVERIFY(beginnings(60.0, [](double t) { return -1e-3 * t; }).empty());
    }

    void hearsThroughWhatHappensToTheMarker_data()
    {
        QTest::addColumn<double>("from_s");
        QTest::addColumn<double>("to_s");
        QTest::addColumn<double>("up_mm");
        QTest::addColumn<double>("heardFrom_s");
        QTest::newRow("one lean") << 60.4 << 62.0 << 45.0 << 64.0;
        QTest::newRow("a lean while it rests") << 63.0 << 63.8 << 45.0 << 64.0;
        QTest::newRow("a lean before any breath") << -0.3 << 0.7 << 45.0 << 16.0;
        QTest::newRow("a lean of five breaths") << 60.4 << 81.0 << 45.0 << 84.0;
        QTest::newRow("registration laid higher") << 60.4 << 1e9 << 300.0 << 64.0;
        QTest::newRow("registration laid lower") << 60.4 << 1e9 << -300.0 << 64.0;
    }

    /// 10 mm, 15 times a minute. Whatever came, every breath is heard once from then on.
    void hearsThroughWhatHappensToTheMarker()
    {
        QFETCH(double, from_s);
        QFETCH(double, to_s);
        QFETCH(double, up_mm);
        QFETCH(double, heardFrom_s);
        const auto found = beginnings(120.0, [&](double t) {
            const double lifted = t >= from_s && t < to_s ? 1e-3 * up_mm : 0.0;
            return breathingHeight(t, 15.0, 10e-3) + lifted;
        });
        std::vector<double> late;
        std::ranges::copy_if(found, std::back_inserter(late),
                             [&](double t) { return t > heardFrom_s - 0.5; });
        QCOMPARE(late.size(), static_cast<std::size_t>((120.0 - heardFrom_s) / 4.0));
        for (std::size_t i = 0; i < late.size(); ++i) {
            const double expected = heardFrom_s + 4.0 * double(i) + 0.158 * 4.0 / 3.0;
            QVERIFY2(std::abs(late[i] - expected) < 0.1,
                     qPrintable(QStringLiteral("%1 for %2").arg(late[i]).arg(expected)));
        }
    }

    void tellsABreathOnce()
    {
        const auto found = beginnings(3.0, [](double t) { return t < 1.0 ? 0.0 : 0.02; });
        QCOMPARE(found.size(), std::size_t{1});
        QVERIFY(found[0] <= 1.0 + 2.0 * kFrame_s && found[0] >= 1.0 - kFrame_s);
    }

    void ignoresSamplesThatAreNotNew()
    {
        BreathDetector detector;
        QVERIFY(!detector.add(at(1.0), 0.0));
        QVERIFY(!detector.add(at(1.0), 0.1));
        QVERIFY(!detector.add(at(0.9), 0.1));
        QVERIFY(detector.add(at(1.1), 0.1).has_value());
    }
};

CARINA_TEST(TestBreathDetector)

} // namespace carina::breath_detector_test

#include "tst_breath_detector.moc"
