#include "engine/registration/calibration/spin_calibration.h"

#include "tests/engine/registration/calibration/swung_stylus.h"
#include "tests/support/test_class.h"

#include <limits>

namespace carina::spin_calibration_test
{
namespace
{

constexpr double kExact = 1e-9;
const Vec3 kAxis_S = Vec3{0.1, -0.2, -0.97}.normalized();
const Vec3 kOnAxis_S{0.004, 0.011, -0.02};
const Vec3 kAhead_S = kOnAxis_S + 0.15 * kAxis_S;
const RigidTransform kX_TS{rotationFromVector({0.7, -0.4, 1.1}), {0.2, -0.1, -1.7}};

/// A tool that is spun evenly about its axis through kOnAxis_S, by `spin` in all, while it slides
/// along it by `slide`.
std::vector<RigidTransform> spun(int count, Angle spin, Length slide = {})
{
    std::vector<RigidTransform> X_TS;
    for (int i = 0; i < count; ++i) {
        const double share = (i + 0.5) / count - 0.5;
        const Quat turn = rotationFromVector(share * spin.si * kAxis_S);
        const Vec3 p = kOnAxis_S - turn * kOnAxis_S + share * slide.si * kAxis_S;
        X_TS.push_back(kX_TS * RigidTransform{turn, p});
    }
    return X_TS;
}

/// Turns a pose about a point of the axis by a small wobble.
RigidTransform wobbled(const RigidTransform& X_TS, const Vec3& turn_T)
{
    const Quat turn = rotationFromVector(turn_T);
    const Vec3 p_TC = X_TS * kOnAxis_S;
    return {turn * X_TS.rotation(), p_TC + turn * (X_TS.translation() - p_TC)};
}

std::vector<RigidTransform> wobbling(std::vector<RigidTransform> X_TS, Angle perAxis,
                                     std::mt19937& random)
{
    std::normal_distribution<double> part{0.0, perAxis.si};
    for (RigidTransform& pose : X_TS)
        pose = wobbled(pose, {part(random), part(random), part(random)});
    return X_TS;
}

/// The point of the axis nearest to the origin of S.
Vec3 nearestOnAxis() { return kOnAxis_S - kOnAxis_S.dot(kAxis_S) * kAxis_S; }

} // namespace

class TestSpinCalibration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheAxis_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("spin_deg");
        QTest::addColumn<double>("slide_mm");
        QTest::newRow("a whole turn") << 200 << 360.0 << 0.0;
        QTest::newRow("two turns") << 200 << 720.0 << 0.0;
        QTest::newRow("a quarter of a turn") << 200 << 90.0 << 0.0;
        QTest::newRow("fewest poses") << 10 << 200.0 << 0.0;
        QTest::newRow("sliding along") << 200 << 300.0 << 40.0;
    }

    void findsTheAxis()
    {
        QFETCH(int, count);
        QFETCH(double, spin_deg);
        QFETCH(double, slide_mm);
        const auto spin =
            calibrateSpin(spun(count, degrees(spin_deg), millimetres(slide_mm)), kAhead_S);
        QVERIFY2(spin.has_value(), spin ? "" : spin.error().detail.c_str());
        QVERIFY((spin->axis_S - kAxis_S).norm() < kExact);
        QVERIFY((spin->p_SC - nearestOnAxis()).norm() < kExact);
        QVERIFY(spin->wobble.si < 1e-7);
        QVERIFY(spin->rms < kExact);
        QCOMPARE(spin->outliers, 0);
    }

    void pointsToTheSideItIsTold()
    {
        const auto X_TS = spun(50, degrees(180.0));
        const auto back = calibrateSpin(X_TS, kOnAxis_S - 0.15 * kAxis_S);
        QVERIFY(back.has_value());
        QVERIFY((back->axis_S + kAxis_S).norm() < kExact);
    }

    /// Spun evenly by an angle s, a direction across strays from its mean by
    /// sqrt(1 - (sin(s/2) / (s/2))^2).
    void tellsHowFarItWasSpun()
    {
        const auto spin = calibrateSpin(spun(2000, degrees(120.0)), kAhead_S);
        QVERIFY(spin.has_value());
        const double half = degrees(60.0).si;
        const double turn = std::sqrt(1.0 - std::pow(std::sin(half) / half, 2));
        QVERIFY(std::abs(spin->coverage.turns[1].si - turn) < 1e-6);
        QVERIFY(std::abs(spin->coverage.turns[2].si - turn) < 1e-6);
        QVERIFY(spin->coverage.turns[0].si < 1e-7);
    }

    /// Noise of 0.5 degrees about each axis: the tool's leans by sqrt(2) of it. Over 400 trials the
    /// axis strays as told; its mean square is then known to 1 / sqrt(400), and three such
    /// deviations are allowed.
    void tellsHowUncertainTheAxisIs()
    {
        constexpr int kTrials = 400;
        std::mt19937 random{5};
        double scatter = 0.0;
        double told = 0.0;
        for (int i = 0; i < kTrials; ++i) {
            const auto spin =
                calibrateSpin(wobbling(spun(100, degrees(240.0)), degrees(0.5), random), kAhead_S);
            QVERIFY2(spin.has_value(), spin ? "" : spin.error().detail.c_str());
            QVERIFY(std::abs(inDegrees(spin->wobble) - 0.5 * std::numbers::sqrt2) < 0.2);
            scatter += (spin->axis_S - kAxis_S).squaredNorm() / kTrials;
            told += spin->uncertainty.si * spin->uncertainty.si / kTrials;
        }
        QVERIFY2(std::abs(told / scatter - 1.0) < 0.15,
                 qPrintable(QString::number(told / scatter)));
    }

    /// Two lines 2 mm apart, half of the poses on each: 1 mm from the mean.
    void tellsHowFarThePointOfTheAxisStrayed()
    {
        auto X_TS = spun(200, degrees(360.0));
        const Vec3 aside_T = 2e-3 * (kX_TS.rotation() * kAxis_S).unitOrthogonal();
        for (std::size_t i = 0; i < X_TS.size(); i += 2)
            X_TS[i] = test::shifted(X_TS[i], aside_T);
        const auto spin = calibrateSpin(X_TS, kAhead_S);
        QVERIFY(spin.has_value());
        QVERIFY(std::abs(spin->rms - 1e-3) < 0.01e-3);
    }

    void leavesOutliersOut()
    {
        std::mt19937 random{23};
        auto X_TS = wobbling(spun(200, degrees(270.0)), degrees(0.2), random);
        for (std::size_t i = 0; i < X_TS.size(); i += 5) {
            const Vec3 axis_T = kX_TS.rotation() * kAxis_S;
            X_TS[i] = wobbled(X_TS[i], degrees(5.0).si * axis_T.unitOrthogonal());
        }
        const auto spin = calibrateSpin(X_TS, kAhead_S);
        QVERIFY2(spin.has_value(), spin ? "" : spin.error().detail.c_str());
        QCOMPARE(spin->outliers, 40);
        QVERIFY((spin->axis_S - kAxis_S).norm() < degrees(0.1).si);
    }

    void refuses_data()
    {
        QTest::addColumn<std::vector<RigidTransform>>("X_TS");
        QTest::addColumn<Errc>("code");
        QTest::addColumn<QString>("why");
        auto broken = spun(40, degrees(200.0));
        broken[3] = test::shifted(broken[3], {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0});
        QTest::newRow("nine poses")
            << spun(9, degrees(200.0)) << Errc::TooFewPoses << QStringLiteral("9 poses");
        QTest::newRow("a tool at rest") << spun(50, degrees(0.0)) << Errc::NotEnoughSpin
                                        << QStringLiteral("by 0.0 degrees, and 20.0 degrees");
        QTest::newRow("spun a little") << spun(50, degrees(50.0)) << Errc::NotEnoughSpin
                                       << QStringLiteral("it turned about its axis by");
        QTest::newRow("swung to all sides")
            << test::swung(300, degrees(40.0)) << Errc::ToolMoved << QStringLiteral("agree");
        QTest::newRow("no pose") << broken << Errc::NotFinite << QStringLiteral("a pose");
    }

    void refuses()
    {
        QFETCH(std::vector<RigidTransform>, X_TS);
        QFETCH(Errc, code);
        QFETCH(QString, why);
        const auto spin = calibrateSpin(X_TS, kAhead_S);
        QVERIFY(!spin);
        const QString detail = QString::fromStdString(spin.error().detail);
        QVERIFY2(spin.error().code == code && detail.contains(why), qPrintable(detail));
    }

    /// The figures stand beside the refusal.
    void refusesToUseAnAxisThatWobbled()
    {
        std::mt19937 random{29};
        const auto spin =
            calibrateSpin(wobbling(spun(300, degrees(300.0)), degrees(1.3), random), kAhead_S);
        QVERIFY(spin.has_value());
        QVERIFY(spin->refusal && spin->refusal->code == Errc::ToolMoved);
        QVERIFY(spin->refusal->detail.starts_with("the axis wobbled by"));
        QVERIFY(spin->wobble > degrees(1.5));
        QVERIFY((spin->axis_S - kAxis_S).norm() < degrees(0.5).si);
        QVERIFY(!calibrateSpin(spun(300, degrees(300.0)), kAhead_S)->refusal);
    }

    void drawsTheLineAtTheLeastTurn()
    {
        const auto X_TS = spun(2000, degrees(120.0));
        const double half = degrees(60.0).si;
        const double turn = std::sqrt(1.0 - std::pow(std::sin(half) / half, 2));
        QVERIFY(!calibrateSpin(X_TS, kAhead_S, {.leastTurn = radians(1.001 * turn)}));
        QVERIFY(calibrateSpin(X_TS, kAhead_S, {.leastTurn = radians(0.999 * turn)}));
    }
};

CARINA_TEST(TestSpinCalibration)

} // namespace carina::spin_calibration_test

#include "tst_spin_calibration.moc"
