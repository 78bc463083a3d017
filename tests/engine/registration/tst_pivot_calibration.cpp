#include "engine/registration/pivot_calibration.h"

#include "engine/geometry/rotation.h"

#include <QTest>

#include <limits>
#include <numbers>
#include <random>

namespace carina
{
namespace
{

constexpr double kExact = 1e-12;   // m
constexpr double kNoise = 0.35e-3; // m, three-dimensional RMS of a tracker's position
const Vec3 kTip_S{0.012, -0.005, -0.152};
const Vec3 kDivot_T{0.21, -0.13, -1.8};

/// A stylus that stands in its divot, leaning by `lean` to all sides in turn, three times around,
/// and turned about itself by a third as much.
std::vector<RigidTransform> swung(int count, Angle lean)
{
    std::vector<RigidTransform> X_TS;
    for (int i = 0; i < count; ++i) {
        const double around = 3.0 * 2.0 * std::numbers::pi * i / count;
        const Quat R_TS =
            rotationFromVector({0.4, 0.2, -0.3})
            * rotationFromVector({lean.si * std::cos(around), lean.si * std::sin(around),
                                  lean.si / 3.0 * std::sin(1.7 * around)});
        X_TS.push_back({R_TS, kDivot_T - R_TS * kTip_S});
    }
    return X_TS;
}

RigidTransform shifted(const RigidTransform& X_TS, const Vec3& by)
{
    return {X_TS.rotation(), X_TS.translation() + by};
}

std::vector<RigidTransform> noisy(std::vector<RigidTransform> X_TS, std::mt19937& random)
{
    std::normal_distribution<double> part{0.0, kNoise / std::sqrt(3.0)};
    for (RigidTransform& pose : X_TS)
        pose = shifted(pose, {part(random), part(random), part(random)});
    return X_TS;
}

std::optional<Errc> refusal(const std::vector<RigidTransform>& X_TS)
{
    const auto pivot = calibratePivot(X_TS);
    return pivot ? std::nullopt : std::optional{pivot.error().code};
}

} // namespace

class TestPivotCalibration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheTip_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("lean_deg");
        QTest::newRow("swung widely") << 200 << 40.0;
        QTest::newRow("swung a little") << 200 << 15.0;
        QTest::newRow("fewest poses") << 10 << 30.0;
        QTest::newRow("many poses") << 20000 << 30.0;
    }

    void findsTheTip()
    {
        QFETCH(int, count);
        QFETCH(double, lean_deg);
        const auto pivot = calibratePivot(swung(count, degrees(lean_deg)));
        QVERIFY2(pivot.has_value(), pivot ? "" : pivot.error().detail.c_str());
        QVERIFY((pivot->p_SQ - kTip_S).norm() < 10.0 * kExact);
        QVERIFY((pivot->p_TQ - kDivot_T).norm() < 10.0 * kExact);
        QVERIFY(pivot->rms < 10.0 * kExact);
        QCOMPARE(pivot->outliers, 0);
    }

    /// 300 noisy poses that lean by 30 degrees: a component of the tip is uncertain by less than
    /// 0.2 mm / sqrt(300) / 0.3, where 0.3 is the RMS turn of the direction that turns least.
    void findsTheTipInNoise()
    {
        constexpr double kFourDeviations = 4.0 * 0.2e-3 / 17.3 / 0.3; // m
        constexpr double kShareOfNoise = 0.1;
        std::mt19937 random{7};
        for (int i = 0; i < 50; ++i) {
            const auto pivot = calibratePivot(noisy(swung(300, degrees(30.0)), random));
            QVERIFY(pivot.has_value());
            QVERIFY((pivot->p_SQ - kTip_S).cwiseAbs().maxCoeff() < kFourDeviations);
            QVERIFY(std::abs(pivot->rms / kNoise - 1.0) < kShareOfNoise);
            QCOMPARE(pivot->outliers, 0);
        }
    }

    void leavesOutliersOut_data()
    {
        QTest::addColumn<int>("every");
        QTest::addColumn<double>("off_mm");
        QTest::newRow("three in all") << 100 << 50.0;
        QTest::newRow("one in fifty, near") << 50 << 8.0;
        QTest::newRow("one in ten, far") << 10 << 80.0;
        QTest::newRow("one in four, further than the stylus is long") << 4 << 400.0;
    }

    void leavesOutliersOut()
    {
        QFETCH(int, every);
        QFETCH(double, off_mm);
        std::mt19937 random{11};
        auto X_TS = noisy(swung(300, degrees(30.0)), random);
        std::normal_distribution<double> part;
        for (std::size_t i = 0; i < X_TS.size(); i += std::size_t(every)) {
            const Vec3 side = Vec3{part(random), part(random), part(random)}.normalized();
            X_TS[i] = shifted(X_TS[i], off_mm * 1e-3 * side);
        }
        const auto pivot = calibratePivot(X_TS);
        QVERIFY2(pivot.has_value(), pivot ? "" : pivot.error().detail.c_str());
        QCOMPARE(pivot->outliers, 300 / every);
        QVERIFY((pivot->p_SQ - kTip_S).norm() < 0.25e-3);
        QVERIFY(pivot->rms < 1.1 * kNoise);
    }

    void keepsToTheLimitItIsGiven()
    {
        auto X_TS = swung(100, degrees(30.0));
        X_TS[40] = shifted(X_TS[40], {0.0, 0.01, 0.0});
        const auto strict = calibratePivot(X_TS, {.outlierLimit = millimetres(9.0)});
        const auto lenient = calibratePivot(X_TS, {.outlierLimit = millimetres(11.0)});
        QVERIFY(strict && lenient);
        QCOMPARE(strict->outliers, 1);
        QVERIFY(strict->rms < 10.0 * kExact);
        QCOMPARE(lenient->outliers, 0);
        // One of a hundred off by 10 mm, less what the divot follows: near 10 mm / sqrt(100).
        QVERIFY(std::abs(lenient->rms - 1e-3) < 0.05e-3);
    }

    void refusesTooFewPoses_data()
    {
        QTest::addColumn<int>("count");
        QTest::newRow("none") << 0;
        QTest::newRow("one") << 1;
        QTest::newRow("nine") << 9;
    }

    void refusesTooFewPoses()
    {
        QFETCH(int, count);
        QCOMPARE(refusal(swung(count, degrees(30.0))), Errc::TooFewPoses);
    }

    void refusesWhenFewerThanHalfAgree()
    {
        std::mt19937 random{13};
        std::uniform_real_distribution<double> anywhere{-0.5, 0.5};
        auto X_TS = swung(100, degrees(30.0));
        for (std::size_t i = 0; i < 60; ++i)
            X_TS[i] = shifted(X_TS[i], {anywhere(random), anywhere(random), anywhere(random)});
        QCOMPARE(refusal(X_TS), Errc::TooFewPoses);
    }

    void refusesTooLittleMotion_data()
    {
        QTest::addColumn<double>("lean_deg");
        QTest::newRow("standing still") << 0.0;
        QTest::newRow("trembling") << 1.0;
        QTest::newRow("hardly swung") << 4.0;
    }

    void refusesTooLittleMotion()
    {
        QFETCH(double, lean_deg);
        const auto pivot = calibratePivot(swung(200, degrees(lean_deg)));
        QVERIFY(!pivot);
        QCOMPARE(pivot.error().code, Errc::NotEnoughMotion);
        QCOMPARE(pivot.error().detail, std::string{"the stylus was hardly turned"});
    }

    void refusesOneAxisOnly_data()
    {
        QTest::addColumn<Vec3>("axis");
        QTest::newRow("about itself") << Vec3{0.0, 0.0, 1.0};
        QTest::newRow("back and forth") << Vec3{1.0, 0.0, 0.0};
        QTest::newRow("about any axis") << Vec3{0.6, 0.0, 0.8};
    }

    void refusesOneAxisOnly()
    {
        QFETCH(Vec3, axis);
        std::mt19937 random{17};
        std::vector<RigidTransform> X_TS;
        for (int i = 0; i < 200; ++i) {
            const Quat R_TS = rotationFromVector((i - 100) * 0.012 * axis);
            X_TS.push_back({R_TS, kDivot_T - R_TS * kTip_S});
        }
        for (const auto& poses : {X_TS, noisy(X_TS, random)}) {
            const auto pivot = calibratePivot(poses);
            QVERIFY(!pivot);
            QCOMPARE(pivot.error().code, Errc::NotEnoughMotion);
            QCOMPARE(pivot.error().detail,
                     std::string{"the stylus was turned about one axis only"});
        }
    }

    /// Leaning by an angle to all sides about the tip turns the long axis by its sine (RMS), and
    /// the least turned direction across it by 1 / sqrt(2) of that.
    void drawsTheLineAtTheLeastTurn()
    {
        std::vector<RigidTransform> X_TS;
        for (int i = 0; i < 360; ++i) {
            const double around = degrees(i).si;
            const Quat R_TS = rotationFromVector(degrees(20.0).si
                                                 * Vec3{std::cos(around), std::sin(around), 0.0});
            X_TS.push_back({R_TS, kDivot_T - R_TS * kTip_S});
        }
        const double turn = std::sin(degrees(20.0).si) / std::sqrt(2.0);
        QVERIFY(!calibratePivot(X_TS, {.leastTurn = radians(1.02 * turn)}));
        QVERIFY(calibratePivot(X_TS, {.leastTurn = radians(0.98 * turn)}));
    }

    void refusesPosesThatAreNone()
    {
        for (const auto& [value, code] :
             {std::pair{std::numeric_limits<double>::quiet_NaN(), Errc::NotFinite},
              std::pair{std::numeric_limits<double>::infinity(), Errc::NotFinite},
              std::pair{1e300, Errc::OutOfRange}}) {
            auto X_TS = swung(50, degrees(30.0));
            X_TS[20] = shifted(X_TS[20], {0.0, 0.0, value});
            QCOMPARE(refusal(X_TS), code);
        }
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestPivotCalibration)
#include "tst_pivot_calibration.moc"
