#include "engine/tracking/several/body_motion.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>

namespace carina::body_motion_test
{
namespace
{

/// Turned about two perpendicular axes by sines, each for whole periods, and moved along x.
std::vector<RigidTransform> turned(const Quat& R_FG, double first, double second)
{
    std::vector<RigidTransform> poses;
    constexpr int kPoses = 1000;
    for (int i = 0; i < kPoses; ++i) {
        const double phase = 2.0 * std::numbers::pi * i / kPoses;
        poses.push_back({R_FG
                             * rotationFromVector({first * std::sin(3.0 * phase),
                                                   second * std::sin(7.0 * phase), 0.0}),
                         Vec3{0.1 * std::sin(phase), 0.02, -1.0}});
    }
    return poses;
}

} // namespace

class TestBodyMotion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// A sine has an RMS of its amplitude over sqrt(2).
    void tellsHowFarABodyWasTurnedAndMoved()
    {
        const Quat anyhow = rotationFromVector({1.2, -0.7, 2.0});
        const BodyMotion motion = bodyMotion(turned(anyhow, 0.1, 0.06));
        constexpr double kWithin = 1e-3; // rad; small turns about two axes nearly add
        QVERIFY(std::abs(motion.turned[0].si - 0.1 / std::numbers::sqrt2) < kWithin);
        QVERIFY(std::abs(motion.turned[1].si - 0.06 / std::numbers::sqrt2) < kWithin);
        QVERIFY(motion.turned[2].si < kWithin);
        QVERIFY(std::abs(motion.moved.si - 0.2) < 1e-5);
    }

    void knowsATurnAboutOneAxisInAnyFrame()
    {
        for (const Vec3& frame : {Vec3{0.0, 0.0, 0.0}, Vec3{0.5, 0.4, -1.9}, Vec3{3.0, 0.0, 0.5}}) {
            const BodyMotion motion = bodyMotion(turned(rotationFromVector(frame), 0.5, 0.0));
            QVERIFY(motion.turned[0] > degrees(15.0));
            QVERIFY(motion.turned[1].si < 1e-6);
        }
    }

    void leavesOutWhatWasNotSeen()
    {
        std::vector<PoseSample> samples(3);
        samples[1].validity = Validity::Lost;
        samples[2].validity = Validity::PartlyOccluded;
        QCOMPARE(seenPoses(samples).size(), 2U);
        QCOMPARE(bodyMotion({}).moved.si, 0.0);
    }
};

CARINA_TEST(TestBodyMotion)

} // namespace carina::body_motion_test

#include "tst_body_motion.moc"
