#include "engine/registration/error/localisation_error.h"

#include "tests/engine/registration/error/registration_trials.h"
#include "tests/support/test_class.h"

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
        const LocalisationError a{millimetres(1.0), 6.0};
        const LocalisationError b{millimetres(2.0), 18.0};
        const LocalisationError both = pooled(a, b);
        QVERIFY(near(both.rms.si, 1e-3 * std::sqrt((6.0 + 18.0 * 4.0) / 24.0), 1e-12));
        QCOMPARE(both.degrees, 24.0);
        QVERIFY(both.limit() / both.rms < b.limit() / b.rms);
    }

    void prefersWhatIsKnown()
    {
        const LocalisationError estimated{millimetres(1.0), 6.0};
        const LocalisationError known{millimetres(0.35)};
        QCOMPARE(pooled(estimated, known).rms, known.rms);
        QCOMPARE(pooled(known, estimated).rms, known.rms);
        QCOMPARE(pooled(estimated, known).degrees, kKnownExactly);
    }
};

CARINA_TEST(TestLocalisationError)

} // namespace carina::localisation_error_test

#include "tst_localisation_error.moc"
