#include "engine/sync/strategies/view_comparison.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::view_comparison_test
{
namespace
{

using namespace std::chrono_literals;

constexpr ObjectId kObject{7};
constexpr SessionTime kAt{100s};

ShownPose shownAt(SessionTime t, double x, double turned_rad = 0.0)
{
    const Quat q{std::cos(turned_rad / 2.0), 0.0, 0.0, std::sin(turned_rad / 2.0)};
    return {kObject, t, RigidTransform{q, Vec3{x, 0.0, 0.0}}};
}

} // namespace

class TestViewComparison : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allProgramsTakeTheSameTimes()
    {
        QCOMPARE(ViewComparison::timeBefore(kAt), kAt);
        QCOMPARE(ViewComparison::timeBefore(kAt + 249ms), kAt);
        QCOMPARE(ViewComparison::timeBefore(kAt + 250ms), kAt + 250ms);
        QCOMPARE(ViewComparison::timeBefore(kAt - 1ns), kAt - 250ms);
    }

    void driftIsTheDifferenceOfTwoViews()
    {
        ViewComparison views;
        views.remember(shownAt(kAt, 0.010));
        views.remember(shownAt(kAt + 250ms, 0.020, 0.1));
        const auto drift = views.compare(shownAt(kAt + 250ms, 0.023, 0.3));
        QVERIFY(drift);
        QVERIFY(std::abs(drift->rotation.si - 0.2) < 1e-12);
        QVERIFY(std::abs(drift->position.si - 0.003) < 1e-12);
        QVERIFY(std::abs(views.compare(shownAt(kAt, 0.0))->position.si - 0.010) < 1e-12);
    }

    /// Whoever of the two shows it larger.
    void driftOfASizeIsTheLargerByTheSmaller()
    {
        ViewComparison views;
        views.remember(shownAt(kAt, 0.0));
        ShownPose owners = shownAt(kAt, 0.0);
        QCOMPARE(views.compare(owners)->scale, 0.0);
        for (const double scale : {1.25, 0.8}) {
            owners.scale = scale;
            QVERIFY(std::abs(views.compare(owners)->scale - 0.25) < 1e-12);
        }
    }

    void onlyOfTheSameTimeAndObject()
    {
        ViewComparison views;
        QVERIFY(!views.compare(shownAt(kAt, 0.0)));
        views.remember(shownAt(kAt, 0.0));
        QVERIFY(!views.compare(shownAt(kAt + 250ms, 0.0)));
        ShownPose other = shownAt(kAt, 0.0);
        other.object = ObjectId{8};
        QVERIFY(!views.compare(other));
        views.clear();
        QVERIFY(!views.compare(shownAt(kAt, 0.0)));
    }

    void forgetsWhatIsLongAgo()
    {
        ViewComparison views;
        for (std::size_t i = 0; i <= ViewComparison::kKept; ++i)
            views.remember(shownAt(kAt + i * ViewComparison::kPeriod, 0.0));
        QVERIFY(!views.compare(shownAt(kAt, 0.0)));
        QVERIFY(views.compare(shownAt(kAt + ViewComparison::kPeriod, 0.0)));
    }
};

CARINA_TEST(TestViewComparison)

} // namespace carina::view_comparison_test

#include "tst_view_comparison.moc"
