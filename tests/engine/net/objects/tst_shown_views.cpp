#include "engine/net/objects/shown_views.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::shown_views_test
{
namespace
{

using namespace std::chrono_literals;

constexpr ParticipantId kOwner{1};
constexpr ParticipantId kViewer{2};
constexpr ObjectId kTurned{1};
constexpr ObjectId kTracked{2};
constexpr SessionTime kStart{1000s};
constexpr double kSpeed = 0.1; // m/s

/// A session in which the owner has an object that is acted on and one that is tracked.
SessionState twoObjects()
{
    SessionState state;
    std::uint64_t number = 0;
    for (const ObjectId id : {kTurned, kTracked})
        state.apply({FactNumber{++number}, ProposalId{number}, kOwner, StationId{}, kStart, kStart,
                     fact::ObjectShared{id, kOwner, ObjectKind::Tube, "object"}});
    return state;
}

RigidTransform at(double x) { return RigidTransform{Quat::Identity(), Vec3{x, 0.0, 0.0}}; }

/// Both objects move along x; they are shown late by so much, and in this size.
ShownViews viewsLateBy(Duration late, double scale = 1.0)
{
    return ShownViews{[late, scale](ObjectId, SessionTime t) {
                          const double moved = kSpeed * toSeconds(t - late - kStart);
                          return std::optional{ActedPose{at(moved), scale}};
                      },
                      [](ObjectId, SessionTime) { return std::optional<RigidTransform>{}; }};
}

} // namespace

class TestShownViews : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void driftOfALateViewIsSpeedTimesDelay()
    {
        const SessionState state = twoObjects();
        ShownViews owner = viewsLateBy(0ms);
        ShownViews viewer = viewsLateBy(40ms);
        // Neither looks at the very times that are compared.
        for (SessionTime t = kStart + 3ms; t < kStart + 2s; t += 17ms) {
            QVERIFY(viewer.advance(state, kViewer, t).empty());
            for (const ShownPose& shown : owner.advance(state, kOwner, t + 5ms))
                viewer.compare(shown);
        }
        QCOMPARE(viewer.drifts()->size(), std::size_t{2});
        QVERIFY(std::abs(viewer.drifts()->at(kTurned).drift.position.si - 0.004) < 1e-12);
    }

    void driftOfASizeIsItsRatio()
    {
        const SessionState state = twoObjects();
        ShownViews owner = viewsLateBy(0ms, 1.5);
        ShownViews viewer = viewsLateBy(0ms, 1.2);
        QVERIFY(viewer.advance(state, kViewer, kStart).empty());
        for (const ShownPose& shown : owner.advance(state, kOwner, kStart))
            viewer.compare(shown);
        QVERIFY(std::abs(viewer.drifts()->at(kTurned).drift.scale - 0.25) < 1e-12);
        QCOMPARE(viewer.drifts()->at(kTurned).drift.position.si, 0.0);
    }

    void comparisonHoldsForTwoSeconds()
    {
        const SessionState state = twoObjects();
        ShownViews viewer = viewsLateBy(40ms);
        QVERIFY(viewer.advance(state, kViewer, kStart).empty());
        viewer.compare({kTurned, kStart, at(0.0)});
        static_cast<void>(viewer.advance(state, kViewer, kStart + 2s));
        QCOMPARE(viewer.drifts()->size(), std::size_t{1});
        static_cast<void>(viewer.advance(state, kViewer, kStart + 2250ms));
        QVERIFY(viewer.drifts()->empty());
    }

    void ownObjectHasNoDrift()
    {
        const SessionState state = twoObjects();
        ShownViews viewer = viewsLateBy(40ms);
        QVERIFY(viewer.advance(state, kViewer, kStart).empty());
        viewer.compare({kTurned, kStart, at(0.0)});
        static_cast<void>(viewer.advance(state, kOwner, kStart + 250ms)); // it took them over
        QVERIFY(viewer.drifts()->empty());
    }

    void trackedObjectIsMeasuredOnceItsSamplesAreHere()
    {
        const SessionState state = twoObjects();
        std::vector<SessionTime> asked;
        ShownViews owner{[](ObjectId id, SessionTime) {
                             return id == kTurned ? std::optional{ActedPose{at(0.0)}}
                                                  : std::nullopt;
                         },
                         [&](ObjectId, SessionTime t) {
                             asked.push_back(t);
                             return std::optional{at(1.0)};
                         }};
        QCOMPARE(owner.advance(state, kOwner, kStart).size(), std::size_t{1});
        QCOMPARE(owner.nextDue(kStart), kStart + 100ms);
        QVERIFY(owner.advance(state, kOwner, kStart + 99ms).empty());
        const auto measured = owner.advance(state, kOwner, kStart + 100ms);
        QCOMPARE(measured.size(), std::size_t{1});
        QCOMPARE(measured[0].object, kTracked);
        QCOMPARE(measured[0].at, kStart);
        QCOMPARE(asked, std::vector<SessionTime>{kStart});
        QCOMPARE(owner.nextDue(kStart + 100ms), kStart + 250ms);
    }

    void viewsOfAnotherSessionAreForgotten()
    {
        const SessionState state = twoObjects();
        ShownViews viewer = viewsLateBy(40ms);
        QVERIFY(viewer.advance(state, kViewer, kStart).empty());
        viewer.clear();
        viewer.compare({kTurned, kStart, at(0.0)});
        QVERIFY(viewer.drifts()->empty());
    }
};

CARINA_TEST(TestShownViews)

} // namespace carina::shown_views_test

#include "tst_shown_views.moc"
