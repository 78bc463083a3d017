#include "engine/registration/error/leave_one_out.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::leave_one_out_test
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

    /// Of 4000 sound sets of touches with 1 mm each way, one in a hundred has a landmark called
    /// outlying, or fewer: the bounds are Bonferroni's.
    void leavesSoundTouchesAlone()
    {
        constexpr int kSets = 4000;
        test::Hand hand{137};
        for (const int count : {5, 8}) {
            int alarms = 0;
            for (int i = 0; i < kSets; ++i)
                alarms += outlyingLandmark(touched(hand, count, 1e-3)) ? 1 : 0;
            QVERIFY2(alarms <= 1.4 * kOutlierFalseAlarm * kSets
                         && alarms >= 0.3 * kOutlierFalseAlarm * kSets,
                     qPrintable(QStringLiteral("%1 of %2").arg(alarms).arg(kSets)));
        }
    }

    /// A touch 15 mm off among eight with 1 mm is named, and how far off it is.
    void namesTheOneThatAllOthersContradict()
    {
        test::Hand hand{139};
        int named = 0;
        constexpr int kSets = 200;
        for (int i = 0; i < kSets; ++i) {
            auto pairs = touched(hand, 8, 1e-3);
            const auto wrong = std::size_t(i % 8);
            pairs[wrong].p_MQ += 0.015 * hand.unit().normalized();
            const auto outlier = outlyingLandmark(pairs);
            named += outlier && outlier->landmark == wrong
                             && std::abs(outlier->distance.si - 0.015) < 0.006
                         ? 1
                         : 0;
        }
        QVERIFY2(named >= 0.95 * kSets, qPrintable(QString::number(named)));
    }

    void callsNoneOfTooFewOutlying()
    {
        test::Hand hand{149};
        QVERIFY(!outlyingLandmark(touched(hand, 3, 1e-2)));
        QVERIFY(!outlyingLandmark({}));
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

CARINA_TEST(TestLeaveOneOut)

} // namespace carina::leave_one_out_test

#include "tst_leave_one_out.moc"
