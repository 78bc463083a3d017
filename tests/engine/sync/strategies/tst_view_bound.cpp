#include "engine/sync/strategies/view_bound.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>

namespace carina::view_bound_test
{

using namespace std::chrono_literals;

class TestViewBound : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTheTrackersErrorAndTheDelays_data()
    {
        QTest::addColumn<Duration>("delay");
        QTest::newRow("one computer") << Duration{};
        QTest::newRow("metro") << Duration{8ms};
        QTest::newRow("wan") << Duration{40ms};
    }

    // A hand to and fro with 1 m/s^2 root mean square gets no farther from where its motion three
    // frames and the delay before led, and 3 Hz nearly as far.
    void isTheTrackersErrorAndTheDelays()
    {
        QFETCH(Duration, delay);
        const double age = 0.05 + toSeconds(delay);
        double farthest = 0.0;
        for (const double hertz : {0.5, 1.5, 3.0}) {
            const double w = 2.0 * std::numbers::pi * hertz;
            const double amplitude = std::numbers::sqrt2 / (w * w);
            for (double t = 0.0; t < 2.0; t += 0.001) {
                const double led = std::cos(w * t) - w * age * std::sin(w * t);
                farthest = std::max(farthest, amplitude * std::abs(std::cos(w * (t + age)) - led));
            }
        }
        const double bound = trackedViewBound({}, delay).position.si;
        QVERIFY(farthest < bound);
        QVERIFY(bound < 0.001 + 1.1 * farthest);
    }

    void isTheLimitWhereThatIsMore()
    {
        const Drift bound = trackedViewBound({degrees(10.0), millimetres(20.0)}, 40ms);
        QVERIFY(std::abs(inDegrees(bound.rotation) - 11.0) < 1e-9);
        QVERIFY(std::abs(inMillimetres(bound.position) - 21.0) < 1e-9);
    }
};

CARINA_TEST(TestViewBound)

} // namespace carina::view_bound_test

#include "tst_view_bound.moc"
