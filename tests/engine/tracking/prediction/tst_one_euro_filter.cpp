#include "engine/tracking/prediction/one_euro_filter.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>
#include <random>

namespace carina::one_euro_filter_test
{
namespace
{

using namespace std::chrono_literals;

PoseSample sampleAt(double t, const RigidTransform& X_FO)
{
    return {.time = SessionTime{fromSeconds(t)}, .X_FO = X_FO};
}

} // namespace

class TestOneEuroFilter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isALowPassOfFirstOrderAtRest()
    {
        // The step response after n samples of a share a is 1 - (1 - a)^n, where the speed counts
        // for nothing.
        OneEuroFilter filter{{.position = {hertz(2.0), 0.0}, .rotation = {hertz(2.0), 0.0}}};
        const RigidTransform after{rotationFromVector({0.0, 0.0, 0.5}), Vec3{0.1, 0.0, 0.0}};
        static_cast<void>(filter.smoothed(sampleAt(0.0, {})));
        const double turns = 2.0 * std::numbers::pi * 2.0 / 60.0;
        const double share = turns / (1.0 + turns);
        for (int n = 1; n <= 20; ++n) {
            const auto smoothed = filter.smoothed(sampleAt(n / 60.0, after));
            const double reached = 1.0 - std::pow(1.0 - share, n);
            QVERIFY(std::abs(smoothed.X_FO.translation().x() - 0.1 * reached) < 1e-9);
            QVERIFY(std::abs(rotationVector(smoothed.X_FO.rotation()).z() - 0.5 * reached) < 1e-6);
        }
    }

    void takesJitterFromAToolAtRest()
    {
        std::mt19937 random{5};
        std::normal_distribution<double> noise{0.0, 0.1e-3};
        OneEuroFilter filter;
        double raw = 0.0;
        double smooth = 0.0;
        for (int i = 0; i < 3000; ++i) {
            const Vec3 p{noise(random), noise(random), noise(random)};
            const auto smoothed = filter.smoothed(sampleAt(i / 60.0, {Quat::Identity(), p}));
            if (i < 120)
                continue;
            raw += p.squaredNorm();
            smooth += smoothed.X_FO.translation().squaredNorm();
        }
        QVERIFY(std::sqrt(smooth / raw) < 0.4);
    }

    void followsAToolThatMoves()
    {
        // At 0.3 m/s the limit is 20 Hz: a delay of 8 ms.
        OneEuroFilter filter;
        PoseSample last;
        for (int i = 0; i <= 120; ++i)
            last = filter.smoothed(
                sampleAt(i / 60.0, RigidTransform::translation({0.3 * i / 60.0, 0.0, 0.0})));
        const double late = (0.6 - last.X_FO.translation().x()) / 0.3;
        QVERIFY(std::abs(late - 1.0 / (2.0 * std::numbers::pi * 20.0)) < 0.5e-3);
    }

    void leavesAloneWhatIsLostAndStartsAnewAfterAGap()
    {
        OneEuroFilter filter;
        static_cast<void>(filter.smoothed(sampleAt(0.0, {})));
        const RigidTransform elsewhere = RigidTransform::translation({1.0, 0.0, 0.0});
        PoseSample lost = sampleAt(0.02, elsewhere);
        lost.validity = Validity::Lost;
        QCOMPARE(filter.smoothed(lost).X_FO.translation().x(), 1.0);
        QVERIFY(filter.smoothed(sampleAt(0.04, elsewhere)).X_FO.translation().x() < 1.0);
        QCOMPARE(filter.smoothed(sampleAt(0.20, elsewhere)).X_FO.translation().x(), 1.0);
        QCOMPARE(filter.smoothed(sampleAt(0.10, {})).X_FO.translation().x(), 0.0); // too late
    }
};

CARINA_TEST(TestOneEuroFilter)

} // namespace carina::one_euro_filter_test

#include "tst_one_euro_filter.moc"
