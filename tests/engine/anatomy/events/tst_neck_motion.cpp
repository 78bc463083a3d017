#include "engine/anatomy/events/neck_motion.h"

#include "tests/support/test_class.h"

#include <cmath>

namespace carina::neck_motion_test
{
namespace
{

constexpr double kRounding_deg = 1e-9;

AirwayEvents stiff(double severity) { return {{AirwayEventKind::StiffNeck, severity}}; }

bool isNear(const HeadPosition& position, double flexion_deg, double extension_deg)
{
    return std::abs(inDegrees(position.flexion) - flexion_deg) < kRounding_deg
           && std::abs(inDegrees(position.extension) - extension_deg) < kRounding_deg;
}

} // namespace

/// How far events let head and neck move.
class TestNeckMotion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isNotLimitedWithoutAStiffNeck()
    {
        QVERIFY(withinMotion(kSniffing, {}) == kSniffing);
        QVERIFY(withinMotion(kSniffing, {{AirwayEventKind::Trismus, 1.0}}) == kSniffing);
        QVERIFY(withinMotion(kSniffing, stiff(0.0)) == kSniffing);
    }

    void isNoneInARigidCollar()
    {
        for (const HeadPosition& position :
             {kSniffing, kHeadExtended, HeadPosition{kLeastFlexion, kLeastExtension}})
            QVERIFY(isNear(withinMotion(position, stiff(1.0)), 0.0, 0.0));
    }

    // Of flexion by 35 and extension by 30 degrees half is left, to the other side of 25 and 10.
    void becomesLessWithTheSeverity()
    {
        QVERIFY(isNear(withinMotion({kMostFlexion, kMostExtension}, stiff(0.5)), 17.5, 15.0));
        QVERIFY(isNear(withinMotion({kLeastFlexion, kLeastExtension}, stiff(0.5)), -12.5, -5.0));
        QVERIFY(isNear(withinMotion(kSniffing, stiff(0.1)), 31.5, 24.2));
    }

    void leavesWhatIsWithinIt()
    {
        const HeadPosition little{degrees(5.0), degrees(-1.0)};
        QVERIFY(withinMotion(little, stiff(0.8)) == little);
        QVERIFY(withinMotion({}, stiff(1.0)) == HeadPosition{});
    }
};

CARINA_TEST(TestNeckMotion)

} // namespace carina::neck_motion_test

#include "tst_neck_motion.moc"
