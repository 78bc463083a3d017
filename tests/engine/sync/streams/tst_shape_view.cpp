#include "engine/sync/streams/shape_view.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::shape_view_test
{
namespace
{

using namespace std::chrono_literals;

constexpr SessionTime kStart{50h};
constexpr double kExact = 1e-9;     // of a number per metre
constexpr double kPerSecond = 20.0; // by which the first number grows, 1/m

/// The first number grows evenly, the others are still.
StreamShape shapeAt(Duration after, double length = 0.3)
{
    return {kStart + after, length, 0.01, {7.0, 7.0}, {kPerSecond * toSeconds(after), 3.0}};
}

ShapeView fedEach(Duration each, Duration until)
{
    ShapeView view;
    for (Duration t{}; t <= until; t += each)
        view.take(shapeAt(t));
    return view;
}

/// The first number at a time, were each linear in the places of the object.
double firstOf(const ShapeBetween& shape)
{
    return shape.from.perMetre[0] + shape.times * (shape.to.perMetre[0] - shape.from.perMetre[0]);
}

bool isAt(const std::optional<ShapeBetween>& shape, double first_s)
{
    return shape && std::abs(firstOf(*shape) - kPerSecond * first_s) < kExact;
}

} // namespace

class TestShapeView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isNothingBeforeTheFirst()
    {
        ShapeView view;
        QVERIFY(!view.at(kStart));
        view.take(shapeAt(0ms));
        QVERIFY(isAt(view.at(kStart), 0.0));
        QVERIFY(isAt(view.at(kStart - 1s), 0.0));    // an older one is not known
        QVERIFY(isAt(view.at(kStart + 100ms), 0.0)); // nor how fast it goes on
    }

    void isInterpolated()
    {
        const ShapeView view = fedEach(40ms, 400ms);
        for (Duration t{}; t <= 400ms; t += 7ms) {
            QVERIFY(isAt(view.at(kStart + t), toSeconds(t)));
        }
    }

    /// As a pose does: for 150 ms in full, and over 100 ms ever less.
    void goesOnAsFastAsItWas()
    {
        const ShapeView view = fedEach(16ms, 320ms);
        for (Duration ahead{}; ahead <= 150ms; ahead += 10ms)
            QVERIFY(isAt(view.at(kStart + 320ms + ahead), 0.320 + toSeconds(ahead)));
        QVERIFY(isAt(view.at(kStart + 320ms + 250ms), 0.320 + 0.200));
        QVERIFY(isAt(view.at(kStart + 320ms + 300ms), 0.320 + 0.200));
        QVERIFY(!view.at(kStart + 320ms + 301ms));
    }

    /// A noise of one in two neighbours is not carried on as a motion.
    void isFastOverALongerTimeThanBetweenTwo()
    {
        ShapeView view = fedEach(16ms, 304ms);
        StreamShape noisy = shapeAt(320ms);
        noisy.perMetre[0] += 0.1;
        view.take(noisy);
        const double ahead = firstOf(*view.at(kStart + 320ms + 80ms));
        QVERIFY(std::abs(ahead - kPerSecond * 0.400) < 0.1 * (1.0 + 80.0 / 80.0) + kExact);
    }

    /// Of two forms within a millisecond nobody knows how fast they go on.
    void doesNotGoOnWithoutABaseline()
    {
        ShapeView view;
        view.take(shapeAt(0ms));
        view.take(shapeAt(1ms));
        QVERIFY(isAt(view.at(kStart + 101ms), 0.001));
    }

    void leavesWhatIsNotLater()
    {
        ShapeView view = fedEach(16ms, 160ms);
        StreamShape late = shapeAt(160ms);
        late.perMetre[0] = 50.0;
        view.take(late);
        late.time = kStart + 100ms;
        view.take(late);
        QVERIFY(isAt(view.at(kStart + 160ms), 0.160));
        QVERIFY(isAt(view.at(kStart + 101ms), 0.101));
    }

    /// After a gap, and of another tube, it begins anew.
    void doesNotJoinWhatIsNotOneMotion()
    {
        ShapeView view = fedEach(16ms, 160ms);
        view.take(shapeAt(160ms + 301ms));
        QVERIFY(isAt(view.at(kStart + 300ms), 0.461));
        QVERIFY(isAt(view.at(kStart + 461ms + 100ms), 0.461));
        view.take(shapeAt(480ms, 0.25));
        QCOMPARE(view.at(kStart + 470ms)->from.length, 0.25);
    }

    void keepsASecond()
    {
        const ShapeView view = fedEach(10ms, 2s);
        constexpr Duration kKept = 10ms * int(ShapeView::kKept - 1);
        QVERIFY(isAt(view.at(kStart + 2s - kKept), 2.0 - toSeconds(kKept)));
        QVERIFY(isAt(view.at(kStart), 2.0 - toSeconds(kKept)));
    }

    void isForgotten()
    {
        ShapeView view = fedEach(16ms, 160ms);
        view.clear();
        QVERIFY(!view.at(kStart + 160ms));
    }
};

CARINA_TEST(TestShapeView)

} // namespace carina::shape_view_test

#include "tst_shape_view.moc"
