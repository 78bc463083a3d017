#include "engine/registration/landmarks/landmark_order.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/engine/registration/landmarks/catalogue_places.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace carina::landmark_order_test
{
namespace
{

constexpr int kTrials = 1000;
constexpr double kNoise = 2e-3; // m along each axis
const Length kFle = metres(std::sqrt(3.0) * kNoise);
constexpr double kFarEnough = 0.040; // m

using Order = std::vector<std::size_t>;

Order asListed(std::size_t count)
{
    Order order(count);
    std::iota(order.begin(), order.end(), 0U);
    return order;
}

/// Landmark i is touched at the place of landmark order[i].
std::vector<LandmarkPair> touched(test::Hand& hand, const std::vector<Vec3>& p_A,
                                  const Order& order, double noise = kNoise)
{
    const RigidTransform X_MA = hand.pose();
    std::vector<LandmarkPair> pairs;
    for (std::size_t i = 0; i < p_A.size(); ++i)
        pairs.push_back({p_A[i], X_MA * (p_A[order[i]] + noise * hand.unit())});
    return pairs;
}

/// The order that undoes another.
Order undone(const Order& order)
{
    Order back(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        back[order[i]] = i;
    return back;
}

const Order kLeftForRight{0, 1, 3, 2, 5, 4, 7, 6};

} // namespace

class TestLandmarkOrder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTwoThatWereExchanged()
    {
        test::Hand hand{73};
        const std::vector<Vec3> p_A = test::eightOfTheCatalogue();
        int found = 0;
        for (int trial = 0; trial < kTrials; ++trial) {
            Order order = asListed(8);
            std::size_t a = 0;
            std::size_t b = 0;
            while ((p_A[a] - p_A[b]).norm() < kFarEnough) {
                a = hand.random()() % 8;
                b = hand.random()() % 8;
            }
            std::swap(order[a], order[b]);
            const auto finding = recogniseOrder(touched(hand, p_A, order), kFle);
            QVERIFY(finding.has_value());
            found += finding->order == TouchOrder::Exchanged && finding->touchOf == order ? 1 : 0;
        }
        QVERIFY2(found >= 0.99 * kTrials, qPrintable(QString::number(found)));
    }

    void keepsMostOrdersAsTheyAre()
    {
        test::Hand hand{79};
        int kept = 0;
        for (int trial = 0; trial < kTrials; ++trial) {
            const auto pairs = touched(hand, test::eightOfTheCatalogue(), asListed(8));
            const auto finding = recogniseOrder(pairs, kFle);
            QVERIFY(finding.has_value());
            kept += finding->order == TouchOrder::AsGiven ? 1 : 0;
            QCOMPARE(finding->touchOf, asListed(8));
            QCOMPARE(finding->rms.si, fitRigid(pairs)->rms);
            QCOMPARE(finding->rmsAsGiven, finding->rms);
        }
        QVERIFY2(kept >= 0.995 * kTrials, qPrintable(QString::number(kept)));
    }

    void findsAnyOrder_data()
    {
        QTest::addColumn<Order>("order");
        QTest::newRow("left for right") << kLeftForRight;
        QTest::newRow("three in a ring") << Order{1, 4, 2, 3, 0, 5, 6, 7};
        QTest::newRow("two pairs") << Order{1, 0, 2, 3, 4, 7, 6, 5};
        QTest::newRow("backwards") << Order{7, 6, 5, 4, 3, 2, 1, 0};
        QTest::newRow("one on") << Order{1, 2, 3, 4, 5, 6, 7, 0};
    }

    void findsAnyOrder()
    {
        QFETCH(Order, order);
        test::Hand hand{83};
        for (int trial = 0; trial < 20; ++trial) {
            const auto pairs = touched(hand, test::eightOfTheCatalogue(), order, 0.5e-3);
            const auto finding = recogniseOrder(pairs, kFle);
            QVERIFY(finding.has_value());
            QCOMPARE(finding->order, TouchOrder::Exchanged);
            QCOMPARE(finding->touchOf, undone(order));
            QCOMPARE(finding->explanations, 1U);
            QVERIFY(finding->rms.si < 2e-3 && finding->rmsAsGiven.si > 10e-3);
            const auto repaired = finding->repaired(pairs);
            QVERIFY(std::abs(fitRigid(repaired)->rms / finding->rms.si - 1.0) < 1e-9);
            for (std::size_t i = 0; i < 8; ++i) {
                QCOMPARE(repaired[i].p_AQ, pairs[i].p_AQ);
                QCOMPARE(repaired[i].p_MQ, pairs[undone(order)[i]].p_MQ);
            }
        }
    }

    void findsAMirrorImage()
    {
        test::Hand hand{89};
        std::vector<Vec3> crooked = test::eightOfTheCatalogue();
        crooked[0].x() += 0.05; // so that no order makes left of right
        auto pairs = touched(hand, crooked, asListed(8), 0.5e-3);
        for (LandmarkPair& pair : pairs)
            pair.p_MQ.y() = -pair.p_MQ.y();
        const auto finding = recogniseOrder(pairs, kFle);
        QVERIFY(finding.has_value());
        QCOMPARE(finding->order, TouchOrder::MirrorImage);
        QVERIFY(finding->rms.si < 2e-3 && finding->rmsAsGiven.si > 10e-3);
        QCOMPARE(finding->touchOf, asListed(8));
        QCOMPARE(finding->explanations, 0U);
    }

    void doesNotExplainAWrongPlace()
    {
        test::Hand hand{97};
        auto pairs = touched(hand, test::eightOfTheCatalogue(), asListed(8), 0.5e-3);
        pairs[4].p_MQ += Vec3{0.03, -0.03, 0.03};
        const auto finding = recogniseOrder(pairs, kFle);
        QVERIFY(finding.has_value());
        QCOMPARE(finding->order, TouchOrder::Unexplained);
        QCOMPARE(finding->touchOf, asListed(8));
        QCOMPARE(finding->rms, finding->rmsAsGiven);
    }

    /// Four in the corners of a square can be turned onto themselves.
    void countsWhatElseWouldExplain()
    {
        test::Hand hand{101};
        const std::vector<Vec3> square{
            {0.1, 0.1, 0}, {-0.1, 0.1, 0}, {-0.1, -0.1, 0}, {0.1, -0.1, 0}};
        const auto finding = recogniseOrder(touched(hand, square, asListed(4), 1e-4), kFle);
        QVERIFY(finding.has_value());
        QCOMPARE(finding->order, TouchOrder::AsGiven);
        QCOMPARE(finding->explanations, 8U); // four turns, and as many turned over
        const auto eight =
            recogniseOrder(touched(hand, test::eightOfTheCatalogue(), asListed(8), 0.0), kFle);
        QCOMPARE(eight->explanations, 1U);
    }

    /// Chi-squared of 6 degrees of freedom is above 22.458 once in a thousand.
    void drawsTheLineAtOneInAThousand()
    {
        const double side = 0.1;
        const auto pushed = [&](double push) {
            std::vector<LandmarkPair> pairs;
            for (const Vec3& corner :
                 {Vec3{1, 1.5, 0}, Vec3{-1, 1.5, 0}, Vec3{-1, -1.5, 0}, Vec3{1, -1.5, 0}})
                pairs.push_back({side * corner, side * corner});
            // Up and down in turn: nothing of it is a motion of the whole.
            for (std::size_t i = 0; i < 4; ++i)
                pairs[i].p_MQ.z() += i % 2 == 0 ? push : -push;
            return pairs;
        };
        const double limit = std::sqrt(22.458 / 4.0) * kNoise; // of each of four
        QCOMPARE(recogniseOrder(pushed(0.995 * limit), kFle)->order, TouchOrder::AsGiven);
        QCOMPARE(recogniseOrder(pushed(1.005 * limit), kFle)->order, TouchOrder::Unexplained);
    }

    void repairsWhatHasNoFitAsItIs()
    {
        const std::vector<Vec3> p_A{{.1, .1, .1}, {.1, -.1, -.1}, {-.1, .1, -.1}, {-.1, -.1, .1}};
        test::Hand hand{103};
        const auto finding = recogniseOrder(touched(hand, p_A, {1, 0, 2, 3}, 0.0), kFle);
        QVERIFY(finding.has_value());
        QCOMPARE(finding->order, TouchOrder::Exchanged);
        QVERIFY(finding->rmsAsGiven.si > 1.0 || finding->rmsAsGiven.si > 10.0 * finding->rms.si);
        QCOMPARE(finding->explanations, 12U); // the turns of a tetrahedron
    }

    void refusesWhatCannotBeJudged_data()
    {
        QTest::addColumn<std::vector<LandmarkPair>>("pairs");
        QTest::addColumn<Errc>("code");
        test::Hand hand{107};
        auto pairs = touched(hand, test::eightOfTheCatalogue(), asListed(8));
        pairs.resize(2);
        QTest::newRow("two") << pairs << Errc::TooFewLandmarks;
        pairs = touched(hand, test::eightOfTheCatalogue(), asListed(8));
        pairs[2].p_MQ.x() = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("no number") << pairs << Errc::NotFinite;
        pairs[2].p_MQ.x() = 1e4;
        QTest::newRow("far") << pairs << Errc::OutOfRange;
        pairs.clear();
        for (int i = 0; i < 12; ++i)
            pairs.push_back({1e-3 * hand.unit(), 1e-3 * hand.unit()});
        QTest::newRow("a dozen within millimetres") << pairs << Errc::DegenerateLandmarks;
    }

    void refusesWhatCannotBeJudged()
    {
        QFETCH(std::vector<LandmarkPair>, pairs);
        QFETCH(Errc, code);
        const auto finding = recogniseOrder(pairs, kFle);
        QVERIFY(!finding);
        QCOMPARE(finding.error().code, code);
    }
};

CARINA_TEST(TestLandmarkOrder)

} // namespace carina::landmark_order_test

#include "tst_landmark_order.moc"
