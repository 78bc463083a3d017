#include "engine/registration/leave_one_out.h"

#include "tests/engine/registration/registration_trials.h"

#include <QTest>

#include <cmath>

namespace carina
{
namespace
{

std::vector<LandmarkPair> touched(test::Hand& hand, int count, double noise)
{
    const RigidTransform X_MA = hand.pose();
    std::vector<LandmarkPair> pairs;
    for (const Vec3& p : test::firstLandmarks(count))
        pairs.push_back({p, X_MA * (p + noise * hand.unit())});
    return pairs;
}

} // namespace

class TestLeaveOneOut : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTheDistanceFromTheFitOfTheOthers()
    {
        test::Hand hand{109};
        const auto pairs = touched(hand, 6, 1e-3);
        const auto distances = leaveOneOut(pairs);
        QVERIFY(distances.has_value());
        QCOMPARE(distances->size(), 6U);
        for (std::size_t out = 0; out < 6; ++out) {
            std::vector<Vec3> p_A;
            std::vector<Vec3> p_M;
            for (std::size_t i = 0; i < 6; ++i)
                if (i != out) {
                    p_A.push_back(pairs[i].p_AQ);
                    p_M.push_back(pairs[i].p_MQ);
                }
            const double expected =
                (pairs[out].p_AQ - test::hornFit(p_A, p_M) * pairs[out].p_MQ).norm();
            QVERIFY(std::abs(*(*distances)[out] - expected) < 1e-9);
        }
    }

    /// The residual of a touch that is 10 mm off is far less, as it draws the fit to itself; left
    /// out, it stands by 10 mm.
    void showsATouchAtAWrongPlace()
    {
        test::Hand hand{113};
        auto pairs = touched(hand, 4, 0.0);
        pairs[0].p_MQ += 0.010 * hand.unit().normalized();
        const auto distances = leaveOneOut(pairs);
        QVERIFY(distances.has_value());
        QVERIFY(std::abs(*(*distances)[0] - 0.010) < 1e-9);
        QVERIFY(fitRigid(pairs)->residuals[0] < 0.006);
    }

    void saysNothingWhereTheOthersDoNotSuffice()
    {
        test::Hand hand{127};
        const auto three = leaveOneOut(touched(hand, 3, 1e-3));
        QVERIFY(three.has_value());
        QCOMPARE(three->size(), 3U);
        for (const auto& distance : *three)
            QVERIFY(!distance);
        std::vector<LandmarkPair> pairs;
        for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{0.1, 0, 0}, Vec3{0.2, 0, 0}, Vec3{0, 0.1, 0}})
            pairs.push_back({p, p});
        const auto line = leaveOneOut(pairs);
        QVERIFY((*line)[0] && (*line)[1] && (*line)[2]);
        QVERIFY(!(*line)[3]); // without it the others lie on one line
    }

    void refusesWhatCannotBeFitted()
    {
        test::Hand hand{131};
        const auto two = leaveOneOut(touched(hand, 2, 1e-3));
        QVERIFY(!two);
        QCOMPARE(two.error().code, Errc::TooFewLandmarks);
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestLeaveOneOut)
#include "tst_leave_one_out.moc"
