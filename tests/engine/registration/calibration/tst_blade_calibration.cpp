#include "engine/registration/calibration/blade_calibration.h"

#include "engine/registration/error/error_bound.h"
#include "tests/engine/registration/calibration/touched_tools.h"
#include "tests/support/test_class.h"

#include <limits>

namespace carina::blade_calibration_test
{
namespace
{

using namespace test;

constexpr double kExact = 1e-9; // m
constexpr Length kFle = millimetres(0.35);
constexpr int kDraws = 3000;

const BladeShape kStraightBlade{.heelWidth = millimetres(14.0),
                                .handle = millimetres(120.0),
                                .p_L_tip = {0.0, 0.0, -0.155},
                                .p_L_half = {0.0, -0.002, -0.078}};

std::vector<BladeTouch> exactTouches(const BladeShape& blade)
{
    std::mt19937 random{1};
    return touchesOf(blade, {}, random);
}

} // namespace

class TestBladeCalibration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheBladeOfExactTouches()
    {
        for (const BladeShape& blade : {kCurvedBlade, kStraightBlade}) {
            const auto found = calibrateBlade(exactTouches(blade));
            QVERIFY(found.has_value());
            QVERIFY((found->X_NL.matrix() - kX_NL.matrix()).norm() < 1e-7);
            QVERIFY((found->shape.p_L_tip - blade.p_L_tip).norm() < kExact);
            QVERIFY((found->shape.p_L_half - blade.p_L_half).norm() < kExact);
            QVERIFY(std::abs(found->shape.heelWidth.si - blade.heelWidth.si) < kExact);
            QVERIFY(std::abs(found->shape.handle.si - blade.handle.si) < kExact);
            QVERIFY(found->rms < kExact);
        }
    }

    void tellsACurvedBladeFromAStraightOne()
    {
        QVERIFY(kCurvedBlade.isCurved());
        QVERIFY(!kStraightBlade.isCurved());
        // Half way to the tip the line is 6.1 mm above the heel: the underside sags by 18.1 mm,
        // measured along y; the line leans by 5.3 degrees.
        QVERIFY(std::abs(inMillimetres(kCurvedBlade.sag()) - 18.09 * std::cos(0.0921)) < 0.02);
    }

    void predictsTheErrorOfTheTip()
    {
        std::mt19937 random{7};
        const Vec3 p_NQ = kX_NL * kCurvedBlade.p_L_tip;
        double predicted = 0.0;
        double measured = 0.0;
        int within = 0;
        for (int i = 0; i < kDraws; ++i) {
            const auto found = calibrateBlade(touchesOf(kCurvedBlade, kFle, random));
            QVERIFY(found.has_value());
            predicted += found->covariance_N.trace() / kDraws;
            const double off = (found->p_NQ_tip() - p_NQ).norm();
            measured += off * off / kDraws;
            within += metres(off) < errorBound(found->covariance_N, found->degrees);
        }
        qInfo("tip of a blade: predicted %.3f mm, measured %.3f mm (RMS), %.1f %% below the bound",
              1e3 * std::sqrt(predicted), 1e3 * std::sqrt(measured), 100.0 * within / kDraws);
        QVERIFY(std::abs(std::sqrt(predicted / measured) - 1.0) < 0.03);
        QVERIFY(std::abs(double(within) / kDraws - 0.95) < 0.02);
    }

    void refusesWhatDeterminesNoBlade()
    {
        const auto codeOf = [](const auto& spoil) {
            auto touches = exactTouches(kCurvedBlade);
            spoil(touches);
            const auto found = calibrateBlade(touches);
            return found ? std::nullopt : std::optional{found.error().code};
        };
        QVERIFY(codeOf([](auto& touches) { touches.pop_back(); }) == Errc::TooFewPoints);
        QVERIFY(codeOf([](auto& touches) { std::swap(touches[0].p_NQ, touches[1].p_NQ); })
                == Errc::NoSurfaceFit);
        QVERIFY(codeOf([](auto& touches) {
                    touches[2].p_NQ += kX_NL.rotation() * Vec3{0.02, 0, 0};
                })
                == Errc::NoSurfaceFit);
        QVERIFY(codeOf([](auto& touches) { touches[4].p_NQ = touches[0].p_NQ; })
                == Errc::DegenerateLandmarks);
        QVERIFY(codeOf([](auto& touches) {
                    for (auto& touch : touches)
                        touch.p_NQ = {0.0, 0.0, 0.05 * int(touch.place)};
                })
                == Errc::DegenerateLandmarks);
        QVERIFY(codeOf([](auto& touches) {
                    touches[3].p_NQ.x() = std::numeric_limits<double>::infinity();
                })
                == Errc::NotFinite);
        QVERIFY(codeOf([](auto& touches) { touches[3].p_NQ.x() = -2e3; }) == Errc::OutOfRange);
    }
};

CARINA_TEST(TestBladeCalibration)

} // namespace carina::blade_calibration_test

#include "tst_blade_calibration.moc"
