#include "evaluation/drift/shown_actions.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <array>
#include <numbers>

namespace carina::shown_actions_test
{
namespace
{

constexpr double kTolerance = 1e-12; ///< rad
constexpr double kTurn = 0.2;        ///< rad, from look() to the end of the action

/// A viewer whose picture turns about an axis at the end of an action of another, or the same, one.
void act(ShownActions& viewer, const Vec3& shown_A, const Vec3& axis_A, double angle,
         int samples = 1)
{
    const Quat before = rotationFromVector(0.7 * Vec3{1.0, -2.0, 0.5});
    for (int i = 0; i < samples; ++i)
        viewer.addSample(angle);
    viewer.look(before);
    viewer.endAction(rotationFromVector(kTurn * shown_A) * before, axis_A);
}

const Vec3 kX = Vec3::UnitX();
const Vec3 kY = Vec3::UnitY();

} // namespace

class TestShownActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTheMeanWhereAllAreShown()
    {
        ShownActions viewer;
        act(viewer, kX, kX, 0.1, 1);
        act(viewer, kY, kY, 0.4, 2);
        QCOMPARE(viewer.lost(), 0);
        QVERIFY(std::abs(*meanShown(std::array{viewer}) - 0.3) < kTolerance);
    }

    void lostActionAndTheNextAreLeftOut()
    {
        ShownActions viewer;
        act(viewer, kX, kX, 0.1);
        act(viewer, kX, kY, 2.0); // goes on
        act(viewer, kX, kX, 1.0); // comes back
        act(viewer, kY, kY, 0.3);
        QCOMPARE(viewer.lost(), 1);
        QVERIFY(std::abs(*meanShown(std::array{viewer}) - 0.2) < kTolerance);
    }

    void whatDoesNotTurnAsTheActionDoesIsLost_data()
    {
        QTest::addColumn<double>("off"); // rad, of the axis about which the picture turns
        QTest::addColumn<bool>("isShown");
        QTest::newRow("the same axis") << 0.0 << true;
        QTest::newRow("rounded") << 0.1 << true;
        QTest::newRow("across") << std::numbers::pi / 2.0 << false;
        QTest::newRow("backwards") << std::numbers::pi << false;
    }
    void whatDoesNotTurnAsTheActionDoesIsLost()
    {
        QFETCH(double, off);
        QFETCH(bool, isShown);
        ShownActions viewer;
        act(viewer, std::cos(off) * kX + std::sin(off) * kY, kX, 0.1);
        QCOMPARE(viewer.lost(), isShown ? 0 : 1);
        QCOMPARE(meanShown(std::array{viewer}).has_value(), isShown);
    }

    void whatStandsStillIsLost()
    {
        ShownActions viewer;
        act(viewer, Vec3::Zero(), kX, 0.1);
        QCOMPARE(viewer.lost(), 1);
    }

    void viewersCountByTheirSamples()
    {
        ShownActions one;
        ShownActions other;
        act(one, kX, kX, 0.1, 3);
        act(other, kX, kX, 0.5, 1);
        QVERIFY(std::abs(*meanShown(std::array{one, other}) - 0.2) < kTolerance);
        QVERIFY(!meanShown({}));
    }
};

CARINA_TEST(TestShownActions)

} // namespace carina::shown_actions_test

#include "tst_shown_actions.moc"
