#include "evaluation/intubation/observed_motion.h"

#include "engine/geometry/rotation.h"
#include "evaluation/intubation/motion_script.h"
#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::observed_motion_test
{
namespace
{

constexpr SessionTime kStart{std::chrono::seconds{100}};

const IntubationMotion& goodMotion()
{
    static const IntubationMotion motion = [] {
        const auto boy = test::boyOfTubes();
        std::mt19937 random = generatorOf(MotionKind::Good, 3);
        return scriptedMotion(MotionKind::Good, drawnParameters(MotionKind::Good, random), boy,
                              test::tubeOfBoy(), 3)
            .value();
    }();
    return motion;
}

} // namespace

class TestObservedMotion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void seesTheTruthWithoutErrors()
    {
        ObservationSettings exact{.jitter = {},
                                  .noise = {},
                                  .rotationNoise = {},
                                  .dropouts = 0.0,
                                  .registration = {},
                                  .registrationTurn = {}};
        std::mt19937 random{1};
        const ObservedMotion seen = observed(goodMotion(), exact, kStart, random);
        QCOMPARE(seen.tube.size(), std::size_t(toSeconds(goodMotion().length()) * 60.0) + 1);
        for (std::size_t i = 0; i < seen.tube.size(); i += 97) {
            const MotionMoment moment = goodMotion().at(seen.tube[i].time - kStart);
            QVERIFY((seen.tube[i].X_FO.translation() - moment.X_AE.translation()).norm() < 1e-12);
            QVERIFY(angleBetween(seen.laryngoscope[i].X_FO.rotation(), moment.X_AL.rotation()).si
                    < 1e-9);
        }
    }

    /// Noise by the true poses in the frame of the registration.
    void hasTheErrorsThatItIsTold()
    {
        std::mt19937 random{2};
        double squares = 0.0;
        double turns = 0.0;
        int seen = 0;
        int lost = 0;
        int longest = 0;
        for (int run = 0; run < 4; ++run) {
            const ObservedMotion motion = observed(goodMotion(), {}, kStart, random);
            int length = 0;
            for (const PoseSample& sample : motion.tube) {
                length = sample.validity == Validity::Lost ? length + 1 : 0;
                longest = std::max(longest, length);
                if (sample.validity == Validity::Lost) {
                    ++lost;
                    continue;
                }
                ++seen;
                const RigidTransform X_AprimeE =
                    motion.X_AprimeA * goodMotion().at(sample.time - kStart).X_AE;
                squares += (sample.X_FO.translation() - X_AprimeE.translation()).squaredNorm();
                turns +=
                    std::pow(angleBetween(sample.X_FO.rotation(), X_AprimeE.rotation()).si, 2.0);
            }
            QVERIFY(std::ranges::is_sorted(motion.tube, {}, &PoseSample::time));
        }
        QVERIFY(std::abs(1e3 * std::sqrt(squares / seen) - 0.35) < 0.02);
        QVERIFY(std::abs(inDegrees(radians(std::sqrt(turns / seen))) - 0.25) < 0.015);
        const double share = double(lost) / (lost + seen);
        QVERIFY2(share > 0.01 && share < 0.035, qPrintable(QString::number(share)));
        QVERIFY(longest >= 5);
    }

    void drawsAnotherRegistrationForEachRun()
    {
        std::mt19937 random{3};
        // Few exposures: the registration alone is of interest.
        const ObservationSettings settings{.rate = hertz(0.05)};
        double squares = 0.0;
        double turns = 0.0;
        constexpr int kRuns = 400;
        for (int run = 0; run < kRuns; ++run) {
            const RigidTransform error = observed(goodMotion(), settings, kStart, random).X_AprimeA;
            squares += error.translation().squaredNorm() / kRuns;
            turns += std::pow(angleOf(error.rotation()).si, 2.0) / kRuns;
        }
        QVERIFY(std::abs(1e3 * std::sqrt(squares) - 1.5) < 0.15);
        QVERIFY(std::abs(inDegrees(radians(std::sqrt(turns))) - 1.0) < 0.1);
    }

    void isTheSameBitForBit()
    {
        std::mt19937 once{4};
        std::mt19937 again{4};
        const ObservedMotion a = observed(goodMotion(), {}, kStart, once);
        const ObservedMotion b = observed(goodMotion(), {}, kStart, again);
        QCOMPARE(a.tube.size(), b.tube.size());
        for (std::size_t i = 0; i < a.tube.size(); ++i) {
            QCOMPARE(a.tube[i].time, b.tube[i].time);
            QCOMPARE(a.tube[i].X_FO.translation(), b.tube[i].X_FO.translation());
        }
    }
};

CARINA_TEST(TestObservedMotion)

} // namespace carina::observed_motion_test

#include "tst_observed_motion.moc"
