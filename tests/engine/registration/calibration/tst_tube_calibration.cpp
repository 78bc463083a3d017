#include "engine/registration/calibration/tube_calibration.h"

#include "engine/registration/calibration/tip_check.h"
#include "tests/engine/registration/calibration/touched_tools.h"
#include "tests/support/test_class.h"

#include <functional>
#include <limits>

namespace carina::tube_calibration_test
{
namespace
{

using namespace test;

constexpr double kExact = 1e-8; // m, 1/m
constexpr Length kFle = millimetres(0.35);
constexpr int kDraws = 3000;

using Spoil = std::function<void(std::vector<TubeTouch>&)>;

std::vector<TubeTouch> exactTouches(const TubeRest& tube)
{
    std::mt19937 random{1};
    return touchesOf(tube, {}, random);
}

bool hasTwoBends(const TubeRest& rest) { return rest.bends[0] != rest.bends[1]; }

/// On the circle of that radius, by its angle alone.
Vec3 onCircle(double radius, double angle)
{
    return {0.0, -radius * (1.0 - std::cos(angle)), -radius * std::sin(angle)};
}

} // namespace

class TestTubeCalibration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void liesOnACircleWhereItHasOneBend()
    {
        for (const double share : {0.0, 0.3, 0.5, 0.8, 1.0}) {
            const Vec3 there = centreOfTube(kAdultTube, share * kAdultTube.length);
            QVERIFY((there - onCircle(0.14, share * 0.3 / 0.14)).norm() < kExact);
            const Vec3 beside = there + 0.005 * Vec3::UnitX();
            QVERIFY(std::abs(distanceFromTube(kAdultTube, beside) - 0.005) < kExact);
        }
        // A point inside the circle, near its middle, and one beyond the tip.
        QVERIFY(std::abs(distanceFromTube(kAdultTube, {0.0, -0.04, -0.01})
                         - (0.14 - std::hypot(0.1, 0.01)))
                < kExact);
        QVERIFY(std::abs(distanceFromTube(kAdultTube, {0.0, 0.01, 0.02}) - std::hypot(0.01, 0.02))
                < kExact);
    }

    void goesOnWithTheOtherBendWithoutAKink()
    {
        TubeRest tube = kAdultTube;
        tube.bends = {2.0, 9.0};
        const auto step = [&](double from) {
            return Vec3{centreOfTube(tube, metres(from + 1e-4)) - centreOfTube(tube, metres(from))};
        };
        QVERIFY((step(0.1499) - step(0.15)).norm() < 1e-6);
        tube.bends = {0.0, 0.0};
        QVERIFY((tipOfTube(tube) - Vec3{0.0, 0.0, -0.3}).norm() < kExact);
        QVERIFY(std::abs(distanceFromTube(tube, {0.003, 0.004, -0.2}) - 0.005) < kExact);
    }

    void findsTheTubeOfExactTouches_data()
    {
        QTest::addColumn<double>("length_mm");
        QTest::addColumn<double>("first");
        QTest::addColumn<double>("second");
        QTest::addColumn<double>("outer_mm");
        QTest::newRow("an adult's, as it is sold") << 300.0 << 7.143 << 7.143 << 10.2;
        QTest::newRow("a child's") << 180.0 << 8.0 << 8.0 << 6.0;
        QTest::newRow("nearly straight") << 300.0 << 1.0 << 1.0 << 10.2;
        QTest::newRow("straight to the cuff") << 300.0 << 0.0 << 6.0 << 10.2;
        QTest::newRow("warmed by a mouth") << 290.0 << 7.0 << 3.5 << 9.6;
    }
    void findsTheTubeOfExactTouches()
    {
        QFETCH(double, length_mm);
        QFETCH(double, first);
        QFETCH(double, second);
        QFETCH(double, outer_mm);
        const TubeRest tube{.length = millimetres(length_mm),
                            .bends = {first, second},
                            .outerDiameter = millimetres(outer_mm)};
        const auto found = calibrateTube(exactTouches(tube), tube.outerDiameter);
        QVERIFY2(found.has_value(), found ? "" : found.error().detail.c_str());
        QVERIFY((found->X_NE.matrix() - kX_NE.matrix()).norm() < 1e-6);
        QVERIFY((found->p_NQ_tip() - kX_NE * tipOfTube(tube)).norm() < kExact);
        QVERIFY(std::abs(found->rest.length.si - tube.length.si) < 1e-7);
        QVERIFY(std::abs(found->rest.bends[0] - first) < 1e-4);
        QVERIFY(std::abs(found->rest.bends[1] - second) < 1e-4);
        QVERIFY(found->rms < kExact);
    }

    void takesTwoBendsOnlyWhereTheyAreMoreThanChance()
    {
        std::mt19937 random{3};
        int ofOne = 0;
        int ofTwo = 0;
        TubeRest hockeyStick = kAdultTube;
        hockeyStick.bends = {3.0, 9.0};
        for (int i = 0; i < 300; ++i) {
            const auto one =
                calibrateTube(touchesOf(kAdultTube, kFle, random), kAdultTube.outerDiameter);
            const auto two =
                calibrateTube(touchesOf(hockeyStick, kFle, random), kAdultTube.outerDiameter);
            QVERIFY(one.has_value() && two.has_value());
            ofOne += hasTwoBends(one->rest);
            ofTwo += hasTwoBends(two->rest);
        }
        QVERIFY(ofOne <= 9); // 1 % by chance
        QCOMPARE(ofTwo, 300);
    }

    /// The error of the tip as it is predicted, and as it is.
    void predictsTheErrorOfTheTip()
    {
        std::mt19937 random{7};
        const Vec3 p_NQ = kX_NE * tipOfTube(kAdultTube);
        double predicted = 0.0;
        double measured = 0.0;
        double touch = 0.0;
        int within = 0;
        for (int i = 0; i < kDraws; ++i) {
            const auto found =
                calibrateTube(touchesOf(kAdultTube, kFle, random), kAdultTube.outerDiameter);
            QVERIFY(found.has_value());
            predicted += found->covariance_N.trace() / kDraws;
            touch += found->fle.si * found->fle.si / kDraws;
            const double off = (found->p_NQ_tip() - p_NQ).norm();
            measured += off * off / kDraws;
            within += metres(off) < errorBound(found->covariance_N, found->degrees);
        }
        qInfo("tip of a tube: predicted %.3f mm, measured %.3f mm (RMS), %.1f %% below the bound",
              1e3 * std::sqrt(predicted), 1e3 * std::sqrt(measured), 100.0 * within / kDraws);
        QVERIFY(std::abs(std::sqrt(predicted / measured) - 1.0) < 0.03);
        QVERIFY(std::abs(std::sqrt(touch) / kFle.si - 1.0) < 0.03);
        QVERIFY(std::abs(double(within) / kDraws - 0.95) < 0.02);
    }

    /// Which is said of all tools alike: of a touch, whether it tells one distance or three.
    void tellsHowFarATouchIsOff()
    {
        std::mt19937 random{5};
        const auto touches = touchesOf(kAdultTube, kFle, random);
        const auto found = calibrateTube(touches, kAdultTube.outerDiameter);
        QVERIFY(found.has_value());
        const double squares = found->fle.si * found->fle.si / 3.0 * found->degrees;
        QVERIFY(std::abs(found->rms - std::sqrt(squares / double(touches.size()))) < kExact);
    }

    void refusesWhatDeterminesNoTube_data()
    {
        QTest::addColumn<Spoil>("spoil");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, Errc code, Spoil spoil) {
            QTest::newRow(name) << std::move(spoil) << int(code);
        };
        row("no touches", Errc::TooFewPoints, [](auto& touches) { touches.clear(); });
        row("two of the rim", Errc::TooFewPoints,
            [](auto& touches) { touches.erase(touches.begin()); });
        row("three of the wall", Errc::TooFewPoints,
            [](auto& touches) { touches.erase(touches.begin() + 3, touches.begin() + 5); });
        row("no tip", Errc::TooFewPoints, [](auto& touches) { touches.pop_back(); });
        row("the rim twice at one place", Errc::DegenerateLandmarks,
            [](auto& touches) { touches[1].p_NQ = touches[0].p_NQ; });
        row("the tip at the connector", Errc::DegenerateLandmarks,
            [](auto& touches) { touches.back().p_NQ = touches.front().p_NQ; });
        row("the wall near the connector only", Errc::DegenerateLandmarks, [](auto& touches) {
            for (std::size_t i = 3; i < 8; ++i)
                touches[i].p_NQ =
                    kX_NE
                    * placeOnTube(kAdultTube, {TubePart::Wall, 0.1 + 0.05 * double(i - 3), false});
        });
        row("straight", Errc::DegenerateLandmarks, [](auto& touches) {
            TubeRest straight = kAdultTube;
            straight.bends = {0.05, 0.05};
            touches = exactTouches(straight);
        });
        row("one on something else", Errc::NoSurfaceFit, [](auto& touches) {
            touches[5].p_NQ += Vec3{0.02, 0.0, 0.02};
        });
        row("not a number", Errc::NotFinite,
            [](auto& touches) { touches[4].p_NQ.y() = std::numeric_limits<double>::quiet_NaN(); });
        row("far away", Errc::OutOfRange, [](auto& touches) { touches[4].p_NQ.y() = 1e4; });
    }
    void refusesWhatDeterminesNoTube()
    {
        QFETCH(Spoil, spoil);
        QFETCH(int, code);
        auto touches = exactTouches(kAdultTube);
        spoil(touches);
        const auto found = calibrateTube(touches, kAdultTube.outerDiameter);
        QVERIFY(!found);
        QVERIFY2(int(found.error().code) == code, found.error().detail.c_str());
    }

    void refusesADiameterThatNoTubeHas()
    {
        for (const double mm : {0.0, 1.9, 21.0, std::numeric_limits<double>::quiet_NaN()})
            QCOMPARE(calibrateTube(exactTouches(kAdultTube), millimetres(mm)).error().code,
                     Errc::OutOfRange);
    }

    /// The check touch: a sound tube is seldom called bent, a bent one is found.
    void tellsABentTubeFromASoundOne()
    {
        std::mt19937 random{11};
        int alarms = 0;
        int foundBent = 0;
        constexpr int kChecks = 1000;
        const Vec3 p_NQ = kX_NE * tipOfTube(kAdultTube);
        for (int i = 0; i < kChecks; ++i) {
            const auto tube =
                calibrateTube(touchesOf(kAdultTube, kFle, random), kAdultTube.outerDiameter);
            const auto check = [&](const Vec3& at) {
                return checkTip(tube->p_NQ_tip(), tube->covariance_N, tube->fle, tube->degrees,
                                strayed(at, kFle, random))
                    .isBent();
            };
            alarms += check(p_NQ);
            foundBent += check(p_NQ + 0.005 * Vec3::UnitY());
        }
        qInfo("of %d checks: a sound tube called bent in %d, one bent by 5 mm in %d", kChecks,
              alarms, foundBent);
        QVERIFY(alarms <= 60);
        QVERIFY(foundBent >= 990);
    }
};

CARINA_TEST(TestTubeCalibration)

} // namespace carina::tube_calibration_test

#include "tst_tube_calibration.moc"
