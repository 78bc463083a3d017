#include "engine/registration/error/localisation_error.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <array>
#include <cmath>

namespace carina::localisation_error_test
{
namespace
{

constexpr int kTrials = 10'000;
constexpr Length kFle = millimetres(1.5);

/// The FRE of a fit of landmarks that stray by kFle.
Length someFre(test::Hand& hand, const std::vector<Vec3>& p_A)
{
    const Mat3 factor = kFle.si / std::sqrt(3.0) * Mat3::Identity();
    std::vector<Vec3> p_M;
    for (const Vec3& p : p_A)
        p_M.push_back(p + hand.error(factor));
    const RigidTransform X_AM = test::hornFit(p_A, p_M);
    double squares = 0.0;
    for (std::size_t i = 0; i < p_A.size(); ++i)
        squares += (p_A[i] - X_AM * p_M[i]).squaredNorm();
    return metres(std::sqrt(squares / double(p_A.size())));
}

bool near(double a, double b, double share) { return std::abs(a / b - 1.0) < share; }

} // namespace

class TestLocalisationError : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// With four landmarks the FRE is 0.707 FLE, with eight 0.866.
    void followsFromTheResiduals()
    {
        const LocalisationError four = localisationError(millimetres(std::sqrt(0.5)), 4);
        QVERIFY(near(four.rms.si, 1e-3, 1e-12));
        QCOMPARE(four.degrees, 6.0);
        const LocalisationError eight = localisationError(millimetres(std::sqrt(0.75)), 8);
        QVERIFY(near(eight.rms.si, 1e-3, 1e-12));
        QCOMPARE(eight.degrees, 18.0);
        QCOMPARE(localisationError(millimetres(1.0), 3).degrees, 3.0);
    }

    void isTheErrorMadeAndItsLimitHolds_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {3, 4, 6, 8})
            QTest::addRow("%d landmarks", count) << count;
    }

    void isTheErrorMadeAndItsLimitHolds()
    {
        QFETCH(int, count);
        const std::vector<Vec3> p_A = test::firstLandmarks(count);
        test::Hand hand{43};
        double squares = 0.0;
        int below95 = 0;
        int below5 = 0;
        const LocalisationError one = localisationError(metres(1.0), std::size_t(count));
        const double upper = one.limit() / one.rms;
        const double lower = one.limit(0.05) / one.rms;
        for (int i = 0; i < kTrials; ++i) {
            const LocalisationError found =
                localisationError(someFre(hand, p_A), std::size_t(count));
            squares += found.rms.si * found.rms.si / kTrials;
            below95 += kFle < upper * found.rms ? 1 : 0;
            below5 += kFle < lower * found.rms ? 1 : 0;
        }
        QVERIFY(near(squares, kFle.si * kFle.si, 0.03));
        QVERIFY(std::abs(below95 - 0.95 * kTrials) < 0.007 * kTrials); // three standard errors
        QVERIFY(std::abs(below5 - 0.05 * kTrials) < 0.007 * kTrials);
    }

    /// 18 degrees of freedom: the 5 % quantile of chi-squared is 9.3905.
    void limitsByChiSquared()
    {
        const LocalisationError error{millimetres(2.0), 18.0};
        QVERIFY(near(error.limit().si, 2e-3 * std::sqrt(18.0 / 9.3905), 1e-4));
        QCOMPARE(error.limit(0.95).si, error.limit().si);
        const LocalisationError given{millimetres(2.0)};
        QCOMPARE(given.limit().si, 2e-3);
        QCOMPARE(given.limit(0.05).si, 2e-3);
    }

    void poolsByDegreesOfFreedom()
    {
        const LocalisationError now{millimetres(1.5), 18.0};
        const std::array earlier{LocalisationError{millimetres(1.0), 6.0},
                                 LocalisationError{millimetres(2.0), 18.0}};
        const PooledLocalisation all = pooled(now, earlier);
        QVERIFY(
            near(all.fle.rms.si, 1e-3 * std::sqrt((18.0 * 2.25 + 6.0 + 18.0 * 4.0) / 42.0), 1e-12));
        QCOMPARE(all.fle.degrees, 42.0);
        QCOMPARE(all.pooled, 2);
        QCOMPARE(all.disagreeing, 0);
        QVERIFY(all.fle.limit() / all.fle.rms < now.limit() / now.rms);
        QCOMPARE(pooled(now, {}).fle.rms, now.rms);
        QCOMPARE(pooled(now, {}).fle.degrees, now.degrees);
    }

    /// The 0.5 % quantile of F with 18 and 6 degrees of freedom to either side, by tables: ratios
    /// of variances beyond 9.6644 (18 above 6) and 1 / 4.6627 (6 above 18) are of one pair in a
    /// hundred.
    void leavesOutWhatDisagrees()
    {
        const LocalisationError now{millimetres(1.0), 6.0};
        for (const auto& [ratio, agrees] :
             {std::pair{9.6, true}, std::pair{9.8, false}, std::pair{1.0 / 4.6, true},
              std::pair{1.0 / 4.8, false}}) {
            const std::array earlier{LocalisationError{millimetres(std::sqrt(ratio)), 18.0}};
            const PooledLocalisation found = pooled(now, earlier);
            QCOMPARE(found.pooled, agrees ? 1 : 0);
            QCOMPARE(found.disagreeing, agrees ? 0 : 1);
            QCOMPARE(found.fle.degrees, agrees ? 24.0 : 6.0);
        }
    }

    /// Of two registrations by the same hand one in a hundred is left out; of one whose touches
    /// stray three times as far, eight landmarks each, almost none is pooled.
    void poolsRegistrationsByTheSameHand()
    {
        const std::vector<Vec3> p_A = test::firstLandmarks(8);
        test::Hand hand{44};
        int leftOut = 0;
        int foreign = 0;
        for (int i = 0; i < kTrials; ++i) {
            const LocalisationError now = localisationError(someFre(hand, p_A), 8);
            LocalisationError earlier = localisationError(someFre(hand, p_A), 8);
            leftOut += pooled(now, std::array{earlier}).disagreeing;
            earlier.rms = 3.0 * earlier.rms;
            foreign += pooled(now, std::array{earlier}).pooled;
        }
        QVERIFY2(std::abs(leftOut - 0.01 * kTrials) < 0.003 * kTrials, // three standard errors
                 qPrintable(QString::number(leftOut)));
        QVERIFY2(foreign < 0.05 * kTrials, qPrintable(QString::number(foreign)));
    }
};

CARINA_TEST(TestLocalisationError)

} // namespace carina::localisation_error_test

#include "tst_localisation_error.moc"
