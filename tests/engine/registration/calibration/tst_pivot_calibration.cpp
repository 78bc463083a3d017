#include "engine/registration/calibration/pivot_calibration.h"

#include "tests/engine/registration/calibration/swung_stylus.h"
#include "tests/support/test_class.h"

#include <limits>

namespace carina::pivot_calibration_test
{

using test::kDivot_T;
using test::kTip_S;
using test::noisy;
using test::shifted;
using test::standing;
using test::swung;

namespace
{

constexpr double kExact = 1e-12;             // m
constexpr Length kNoise = millimetres(0.35); // three-dimensional RMS of a tracker's position

std::optional<Errc> refusal(const std::vector<RigidTransform>& X_TS)
{
    const auto pivot = calibratePivot(X_TS);
    if (!pivot)
        return pivot.error().code;
    return pivot->refusal ? std::optional{pivot->refusal->code} : std::nullopt;
}

/// A stylus that leans by an angle to all sides, once round.
std::vector<RigidTransform> leaning(Angle lean)
{
    std::vector<RigidTransform> X_TS;
    for (int i = 0; i < 360; ++i) {
        const double around = degrees(i).si;
        X_TS.push_back(
            standing(rotationFromVector(lean.si * Vec3{std::cos(around), std::sin(around), 0.0})));
    }
    return X_TS;
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
        QVERIFY(pivot->uncertainty() < 10.0 * kExact);
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
            const auto pivot = calibratePivot(noisy(swung(300, degrees(30.0)), kNoise, random));
            QVERIFY(pivot.has_value());
            QVERIFY((pivot->p_SQ - kTip_S).cwiseAbs().maxCoeff() < kFourDeviations);
            QVERIFY(std::abs(pivot->rms / kNoise.si - 1.0) < kShareOfNoise);
            QCOMPARE(pivot->outliers, 0);
        }
    }

    void givesTheSameAnswerAgain()
    {
        std::mt19937 random{3};
        auto X_TS = noisy(swung(300, degrees(30.0)), kNoise, random);
        test::strike(X_TS, 0.3, millimetres(5.0), millimetres(50.0), random);
        const auto once = calibratePivot(X_TS);
        const auto again = calibratePivot(X_TS);
        QVERIFY(once && again);
        QCOMPARE(again->p_SQ, once->p_SQ);
        QCOMPARE(again->outliers, once->outliers);
    }

    /// Unit vectors stray from their mean m by sqrt(1 - |m|^2), RMS. Of poses that lean by 20
    /// degrees to all sides |m| is the cosine along the stylus and (1 + cosine) / 2 across it.
    void tellsHowMuchEachDirectionTurned()
    {
        const auto pivot = calibratePivot(leaning(degrees(20.0)));
        QVERIFY(pivot.has_value());
        const double cosine = std::cos(degrees(20.0).si);
        const double across = std::sqrt(1.0 - std::pow(0.5 * (1.0 + cosine), 2));
        const double along = std::sqrt(1.0 - cosine * cosine);
        QVERIFY(std::abs(pivot->coverage.turns[0].si - across) < kExact);
        QVERIFY(std::abs(pivot->coverage.turns[1].si - across) < kExact);
        QVERIFY(std::abs(pivot->coverage.turns[2].si - along) < kExact);
        QVERIFY((pivot->coverage.dirs_S[2] - Vec3::UnitZ()).norm() < 1e-9);
    }

    /// The tip of 1,000 noisy calibrations scatters as the covariance says; its variance is then
    /// known to sqrt(2 / 1000), 4.5 per cent, and three such deviations are allowed.
    void tellsHowUncertainTheTipIs()
    {
        constexpr int kTrials = 1000;
        constexpr double kTolerance = 0.14;
        std::mt19937 random{19};
        Vec3 scatter = Vec3::Zero();
        Vec3 told = Vec3::Zero();
        for (int i = 0; i < kTrials; ++i) {
            const auto pivot = calibratePivot(noisy(swung(14, degrees(25.0)), kNoise, random));
            QVERIFY(pivot.has_value());
            scatter += (pivot->p_SQ - kTip_S).cwiseAbs2() / kTrials;
            told += pivot->covariance_S.diagonal() / kTrials;
            QCOMPARE(pivot->uncertainty(), std::sqrt(pivot->covariance_S.trace()));
        }
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY2(std::abs(told[axis] / scatter[axis] - 1.0) < kTolerance,
                     qPrintable(QString::number(told[axis] / scatter[axis])));
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

    void refusesWhenFewerThanHalfAgree_data()
    {
        QTest::addColumn<int>("struck");
        QTest::addColumn<std::optional<Errc>>("code");
        QTest::newRow("half of them agree") << 50 << std::optional<Errc>{};
        QTest::newRow("one fewer") << 51 << std::optional{Errc::ToolMoved};
    }

    void refusesWhenFewerThanHalfAgree()
    {
        QFETCH(int, struck);
        QFETCH(std::optional<Errc>, code);
        std::mt19937 random{13};
        auto X_TS = swung(100, degrees(30.0));
        test::strike(X_TS, struck / 100.0, millimetres(20.0), millimetres(500.0), random);
        QCOMPARE(refusal(X_TS), code);
    }

    /// Two divots 2 mm apart, half of the poses in each: the best is 1 mm from both.
    void refusesATipThatStrayed()
    {
        auto X_TS = swung(200, degrees(30.0));
        for (std::size_t i = 0; i < X_TS.size(); i += 2)
            X_TS[i] = shifted(X_TS[i], {2e-3, 0.0, 0.0});
        const auto strict = calibratePivot(X_TS, {.largestRms = millimetres(0.97)});
        QVERIFY(strict && strict->refusal);
        QCOMPARE(strict->refusal->code, Errc::ToolMoved);
        QVERIFY2(strict->refusal->detail.find("0.97 mm are the most") != std::string::npos,
                 strict->refusal->detail.c_str());
        const auto lenient = calibratePivot(X_TS, {.largestRms = millimetres(1.001)});
        QVERIFY(lenient && !lenient->refusal);
        QCOMPARE(strict->rms, lenient->rms); // the figures do not depend on the judgement
        QVERIFY(strict->p_SQ == lenient->p_SQ);
    }

    void refusesTooLittleMotion_data()
    {
        QTest::addColumn<double>("lean_deg");
        QTest::newRow("standing still") << 0.0;
        QTest::newRow("trembling") << 1.0;
        QTest::newRow("hardly swung") << 4.0;
        QTest::newRow("swung narrowly, the tip's own direction by 6 degrees") << 6.0;
    }

    void refusesTooLittleMotion()
    {
        QFETCH(double, lean_deg);
        const auto pivot = calibratePivot(swung(200, degrees(lean_deg)));
        QVERIFY(!pivot);
        QCOMPARE(pivot.error().code, Errc::NotEnoughMotion);
        QVERIFY2(pivot.error().detail.starts_with("the stylus was hardly turned: two directions"),
                 pivot.error().detail.c_str());
    }

    void refusesOneAxisOnlyAndNamesIt_data()
    {
        QTest::addColumn<Vec3>("axis");
        QTest::addColumn<std::string>("named");
        QTest::newRow("about itself") << Vec3{0.0, 0.0, 1.0} << std::string{"(0.00 0.00 1.00)"};
        QTest::newRow("back and forth") << Vec3{1.0, 0.0, 0.0} << std::string{"(1.00 0.00 0.00)"};
        QTest::newRow("about any axis") << Vec3{0.6, 0.0, 0.8} << std::string{"(0.60 0.00 0.80)"};
    }

    void refusesOneAxisOnlyAndNamesIt()
    {
        QFETCH(Vec3, axis);
        QFETCH(std::string, named);
        std::vector<RigidTransform> X_TS;
        for (int i = 0; i < 200; ++i)
            X_TS.push_back(standing(rotationFromVector((i - 100) * 0.012 * axis)));
        std::mt19937 random{17};
        for (const auto& poses : {X_TS, noisy(X_TS, kNoise, random)}) {
            const auto pivot = calibratePivot(poses);
            QVERIFY(!pivot);
            QCOMPARE(pivot.error().code, Errc::NotEnoughMotion);
            const std::string& detail = pivot.error().detail;
            QVERIFY2(detail.starts_with("the stylus was turned about one axis only"),
                     detail.c_str());
            QString plain = QString::fromStdString(detail);
            plain.remove(QLatin1Char{'-'}); // of a zero
            QVERIFY2(plain.contains(QString::fromStdString(named)), detail.c_str());
        }
    }

    /// Leaning by an angle to all sides turns the least turned directions as
    /// tellsHowMuchEachDirectionTurned says.
    void drawsTheLineAtTheLeastTurn()
    {
        const double turn = std::sqrt(1.0 - std::pow(0.5 * (1.0 + std::cos(degrees(20.0).si)), 2));
        const auto X_TS = leaning(degrees(20.0));
        QVERIFY(!calibratePivot(X_TS, {.leastTurn = radians(1.001 * turn)}));
        QVERIFY(calibratePivot(X_TS, {.leastTurn = radians(0.999 * turn)}));
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

CARINA_TEST(TestPivotCalibration)

} // namespace carina::pivot_calibration_test

#include "tst_pivot_calibration.moc"
