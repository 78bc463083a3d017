#include "engine/airway/tube/elastic_tube.h"
#include "tests/engine/airway/tube/bent_lumen.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::elastic_tube_test
{
namespace
{

using test::BentLumen;
using test::fed;
using test::restCurve;
using namespace std::chrono_literals;

constexpr double kDepth_m = 4e-3;
constexpr double kOutside_m = 0.5e-3;
constexpr double kSettled_m = 0.2e-3; ///< by which a tube at rest goes on in one step
constexpr double kInside = 0.2;       ///< metres of tube, when it is in
constexpr double kSpeed = 0.15;       ///< m/s
constexpr SessionTime kBegin{10s};
constexpr SessionTime kEnd{13s};

const TubeSize& size()
{
    static const TubeSize it = tubeOfSize(millimetres(7.0)).value();
    return it;
}

TubeShape shape()
{
    TubeShape it;
    it.p_E_centre = restCurve(size());
    it.p_E_tip = it.p_E_centre.back();
    it.outerDiameter = size().outer;
    it.fitsAirway = false;
    return it;
}

ElasticTube tube()
{
    return {shape(),
            std::make_shared<const AirwayLumen>(BentLumen{}.lumenFor(0.5 * shape().outerDiameter))};
}

/// A hand that feeds it from in front of the teeth, and then holds it.
std::optional<RigidTransform> hand(SessionTime t)
{
    const double inside = -0.02 + kSpeed * toSeconds(t - kBegin);
    return fed(size(), std::min(inside, kInside));
}

TissueAround still()
{
    return {[](const Vec3& p_A, AirwayTissue) { return p_A; }, {}};
}

void follow(ElasticTube& tube, Duration each)
{
    for (SessionTime t = kBegin; t <= kEnd; t += each)
        tube.follow(t, hand, still());
}

bool areSame(std::span<const Vec3> a, std::span<const Vec3> b) { return std::ranges::equal(a, b); }

} // namespace

class TestElasticTube : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasTheSizeOfTheShape()
    {
        const TubeSize found = sizeOf(shape());
        QVERIFY(std::abs((found.inner - size().inner).si) < 1e-9);
        QCOMPARE(found.outer, size().outer);
        QVERIFY(std::abs((found.length - size().length).si) < 1e-4);
    }

    void followsItsConnectorInTheLumen()
    {
        ElasticTube followed = tube();
        QVERIFY(!followed.isLaid());
        follow(followed, 20ms);
        QVERIFY(followed.isLaid());
        const double room = BentLumen{}.radius - size().outerRadius().si;
        const std::span<const Vec3> nodes = followed.tube().constrained();
        for (const Vec3& p_A : nodes)
            if (p_A.y() > 0.0)
                QVERIFY(BentLumen{}.fromMiddle(p_A) < room + kOutside_m);
        QVERIFY(std::abs(followed.tube().tip().depth.si - kInside) < kDepth_m);
    }

    void givesTheSameShapeHoweverOftenItIsAsked()
    {
        ElasticTube often = tube();
        ElasticTube seldom = tube();
        follow(often, 20ms);
        follow(seldom, 100ms);
        QVERIFY(areSame(often.tube().constrained(), seldom.tube().constrained()));
    }

    void takesNoMoreStepsAtOnceThanItMay()
    {
        ElasticTube followed = tube();
        int asked = 0;
        const auto counted = [&asked](SessionTime t) {
            ++asked;
            return hand(t);
        };
        followed.follow(kBegin, counted, still());
        QCOMPARE(asked, 1);
        followed.follow(kBegin + 10s, counted, still());
        QCOMPARE(asked, 1 + ElasticTube::kMostSteps);
    }

    void isNotLaidWhereItIsNotSeen()
    {
        ElasticTube followed = tube();
        const auto unseen = [](SessionTime) { return std::optional<RigidTransform>{}; };
        followed.follow(kBegin, unseen, still());
        QVERIFY(!followed.isLaid());
    }

    /// At the pose of the latest step, whatever it lay like, and not where it was not seen.
    void liesWhereAnotherHasItsTip()
    {
        ElasticTube followed = tube();
        follow(followed, 20ms);
        const Vec3 p_E_tip = hand(kEnd)->inverse() * followed.tube().tip().p_A;
        ElasticTube laid = tube();
        const auto unseen = [](SessionTime) { return std::optional<RigidTransform>{}; };
        QVERIFY(!laid.layAnew(kEnd, p_E_tip, false, unseen, still()));
        QVERIFY(!laid.isLaid());
        QVERIFY(laid.layAnew(kEnd + 3ms, p_E_tip, false, hand, still()));
        laid.follow(kEnd + 500ms, hand, still());
        QVERIFY((laid.tube().tip().p_A - followed.tube().tip().p_A).norm() < kSettled_m);
    }

    void forgetsHowItLay()
    {
        ElasticTube followed = tube();
        follow(followed, 20ms);
        followed.letGo();
        QVERIFY(!followed.isLaid());
        ElasticTube fresh = tube();
        for (ElasticTube* it : {&followed, &fresh})
            it->follow(kBegin + 500ms, hand, still());
        QVERIFY(areSame(followed.tube().constrained(), fresh.tube().constrained()));
    }

    void goesAheadAndKeepsNothingOfIt()
    {
        ElasticTube followed = tube();
        follow(followed, 20ms);
        const std::span<const Vec3> nodes = followed.tube().constrained();
        const std::vector<Vec3> before{nodes.begin(), nodes.end()};
        const RigidTransform X_AE = *hand(kEnd);
        const auto seen = [&X_AE](SessionTime) { return std::optional{X_AE}; };
        const std::vector<Vec3> p_E = followed.ahead(kEnd, X_AE, seen, still());
        QCOMPARE(p_E.size(), before.size());
        for (std::size_t i = 0; i < p_E.size(); ++i)
            QVERIFY((X_AE * p_E[i] - before[i]).norm() < kSettled_m);
        const RigidTransform withdrawn = fed(size(), kInside - 0.01);
        const Vec3 p_A_tip = withdrawn * followed.ahead(kEnd, withdrawn, seen, still()).back();
        QVERIFY(std::abs((p_A_tip - before.back()).norm() - 0.01) < kDepth_m);
        QVERIFY(areSame(followed.tube().constrained(), before));
    }

    /// Two programs follow it until different moments, and draw the same moment: one between two
    /// steps, and one at a step, where it lies as it does once it is followed until there.
    void liesTheSameAheadUntilWheneverItWasFollowed_data()
    {
        QTest::addColumn<int>("followed_ms");
        for (const int followed_ms : {900, 910, 920, 955, 990})
            QTest::addRow("%d ms", followed_ms) << followed_ms;
    }
    void liesTheSameAheadUntilWheneverItWasFollowed()
    {
        QFETCH(int, followed_ms);
        ElasticTube less = tube();
        ElasticTube more = tube();
        for (ElasticTube* it : {&less, &more})
            it->follow(kBegin + 500ms, hand, still());
        less.follow(kBegin + std::chrono::milliseconds{followed_ms}, hand, still());
        more.follow(kBegin + 1000ms, hand, still());
        const SessionTime between = kBegin + 1003ms;
        QVERIFY(areSame(less.ahead(between, *hand(between), hand, still()),
                        more.ahead(between, *hand(between), hand, still())));
        const SessionTime atStep = kBegin + 1000ms;
        std::vector<Vec3> p_E;
        for (const Vec3& p_A : more.tube().constrained())
            p_E.push_back(hand(atStep)->inverse() * p_A);
        QVERIFY(areSame(less.ahead(atStep, *hand(atStep), hand, still()), p_E));
    }

    void takesNoMoreStepsAheadThanItMay()
    {
        ElasticTube followed = tube();
        followed.follow(kBegin, hand, still());
        int asked = 0;
        const auto counted = [&asked](SessionTime t) {
            ++asked;
            return hand(t);
        };
        static_cast<void>(followed.ahead(kEnd, *hand(kEnd), counted, still()));
        QVERIFY(asked > 0 && asked < ElasticTube::kMostStepsAhead);
    }
};

CARINA_TEST(TestElasticTube)

} // namespace carina::elastic_tube_test

#include "tst_elastic_tube.moc"
