#include "models/site/site_changes.h"

#include "tests/models/registration/made_site.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::site_changes_test
{
namespace
{

using namespace test;
using Stale = std::optional<StaleCause>;

bool allTouchesAre(const Site& site, const Stale& stale)
{
    return std::ranges::all_of(site.touched,
                               [&](const TouchedPoint& touch) { return touch.stale == stale; });
}

/// The registration and its verification are still there, and stale for this.
bool isKeptAs(const Site& site, const Stale& stale)
{
    return site.registration->stale == stale && site.verification->stale == stale
           && site.verification->verdict == Verdict::Good && site.verification->points.size() == 2;
}

LandmarkCatalogue withMoved(std::size_t landmark)
{
    LandmarkCatalogue catalogue = eightLandmarks();
    catalogue.landmarks[landmark].p_AQ += Vec3{0.0, 0.0, 2e-3};
    return catalogue;
}

std::string nameOf(std::size_t landmark) { return eightLandmarks().landmarks[landmark].name; }

} // namespace

/// What each change leaves fresh, makes stale, and keeps.
class TestSiteChanges : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void makesAllStaleByAnotherTracker()
    {
        const Site site = withTracker(verifiedSite(), "Tracker B");
        QCOMPARE(site.tracker, std::string{"Tracker B"});
        QVERIFY(allTouchesAre(site, StaleCause::Tracker));
        QVERIFY(isKeptAs(site, StaleCause::Tracker));
        QCOMPARE(freshTouches(site).size(), std::size_t{0});
        QVERIFY(isKeptAs(withTracker(verifiedSite(), kTracker), std::nullopt)); // the same
    }

    void makesTouchesStaleByANewTip()
    {
        const Site site = withStylus(verifiedSite(), someTip());
        QCOMPARE(site.styluses.size(), std::size_t{1});
        QVERIFY(allTouchesAre(site, StaleCause::Stylus));
        QVERIFY(isKeptAs(site, StaleCause::Stylus));
    }

    void keepsOneTipForEachTool()
    {
        StylusTip other = someTip();
        other.tool = "Pointer";
        other.p_SQ.z() = -0.2;
        const Site site = withStylus(preparedSite(), other);
        QCOMPARE(site.styluses.size(), std::size_t{2});
        QCOMPARE(site.stylus("Pointer")->p_SQ.z(), -0.2);
        QCOMPARE(site.stylus(kTool)->p_SQ.z(), -0.15);
        Site nameless = preparedSite();
        nameless.styluses[0].tool.clear(); // of a file of the version before
        QCOMPARE(withStylus(nameless, other).styluses.size(), std::size_t{1});
    }

    void addsAnAxisAndChangesNothingElse()
    {
        const Site site =
            withStylusAxis(verifiedSite(), kTool, {Vec3::UnitY(), degrees(0.3), "2004-03-28"});
        QVERIFY(site.styluses[0].axis->axis_S == Vec3::UnitY());
        QVERIFY(isKeptAs(site, std::nullopt));
    }

    void makesOnlyTheTouchOfAMovedLandmarkStale()
    {
        const Site site = withLandmarks(verifiedSite(), withMoved(4));
        for (std::size_t i = 0; i < 8; ++i)
            QVERIFY(touchOf(site, nameOf(i))->stale
                    == (i == 4 ? Stale{StaleCause::Landmarks} : std::nullopt));
        QVERIFY(isKeptAs(site, StaleCause::Landmarks));
        QCOMPARE(touchedPairs(site).size(), std::size_t{7});
        const Site touched = withTouch(site, nameOf(4), touchAt(withMoved(4).landmarks[4].p_AQ));
        QVERIFY(allTouchesAre(touched, std::nullopt));
        QVERIFY(isKeptAs(touched, StaleCause::Landmarks)); // until it is fitted again
    }

    void dropsTouchesOfLandmarksThatAreNoMore()
    {
        LandmarkCatalogue four = eightLandmarks();
        four.landmarks.resize(4);
        const Site site = withLandmarks(verifiedSite(), four);
        QCOMPARE(site.touched.size(), std::size_t{4});
        QVERIFY(allTouchesAre(site, std::nullopt));
        QVERIFY(isKeptAs(site, StaleCause::Landmarks));
        QVERIFY(isKeptAs(withLandmarks(verifiedSite(), eightLandmarks()), std::nullopt));
    }

    void makesTheFitStaleByANewTouch()
    {
        const Site site =
            withTouch(verifiedSite(), nameOf(2), touchAt(eightLandmarks().landmarks[2].p_AQ));
        QCOMPARE(site.touched.size(), std::size_t{8});
        QVERIFY(allTouchesAre(site, std::nullopt));
        QVERIFY(isKeptAs(site, StaleCause::Touches));
    }

    void namesTheDeepestCause()
    {
        const Site touched =
            withTouch(verifiedSite(), nameOf(2), touchAt(eightLandmarks().landmarks[2].p_AQ));
        const Site moved = withLandmarks(touched, withMoved(1));
        QVERIFY(isKeptAs(moved, StaleCause::Landmarks));
        const Site calibrated = withStylus(moved, someTip());
        QVERIFY(isKeptAs(calibrated, StaleCause::Stylus));
        QVERIFY(isKeptAs(withTracker(calibrated, "Tracker B"), StaleCause::Tracker));
        const Site other = withTracker(verifiedSite(), "Tracker B");
        QVERIFY(isKeptAs(withStylus(other, someTip()), StaleCause::Tracker));
    }

    void isFreshAgainByANewFit()
    {
        Site site = withLandmarks(verifiedSite(), withMoved(4));
        site = withFit(site, {.tool = kTool, .at = "2004-03-28T09:00:00Z"}).value();
        QVERIFY(!site.registration->stale);
        QCOMPARE(site.registration->residuals.size(), std::size_t{7}); // without the stale one
        QCOMPARE(site.registration->degrees, 15.0);
        QCOMPARE(site.registration->madeAt, std::string{"2004-03-28T09:00:00Z"});
        QVERIFY(site.verification->stale == StaleCause::Landmarks);
        const Site again = withFit(verifiedSite(), {.tool = kTool, .at = {}}).value();
        QVERIFY(again.verification->stale == StaleCause::Fit);
    }

    void takesNoTouchForBetterThanTheTrackerSeesTheTip()
    {
        constexpr double kArm = 0.05;
        constexpr double kError = 1e-3; // of a marker, RMS; far above the residuals
        TrackedTool stylus{.name = kTool, .role = ToolRole::Stylus};
        stylus.noise = {metres(kError), 1.0};
        stylus.probe.emplace();
        for (const Vec3& p : {Vec3{kArm, 0.0, 0.0}, Vec3{0.0, kArm, 0.0}, Vec3{-kArm, 0.0, 0.0},
                              Vec3{0.0, -kArm, 0.0}})
            stylus.probe->markers.push_back({p, Vec3::Zero()});
        const Site site =
            withFit(touchedSite(), {.tool = kTool, .stylus = stylus, .at = {}}).value();
        // The mean of four markers, and turns of s / (sqrt(2) kArm) about the axes of their square
        // and s / (2 kArm) about its normal, with s the error in one coordinate.
        const Vec3 p = someTip().p_SQ;
        const double s2 = kError * kError / 3.0;
        const double aboutAxis = s2 / (2.0 * kArm * kArm);
        const double aboutNormal = s2 / (4.0 * kArm * kArm);
        const double expected =
            kError * kError / 4.0
            + aboutAxis * (2.0 * p.squaredNorm() - p.x() * p.x() - p.y() * p.y())
            + aboutNormal * (p.squaredNorm() - p.z() * p.z());
        QVERIFY(std::abs(site.registration->fle / std::sqrt(expected) - 1.0) < 1e-6);
        QVERIFY(site.registration->fle > 1.5 * fittedSite().registration->fle);
    }

    void needsThreeTouchesToFit()
    {
        QCOMPARE(withFit(touchedSite(2), {.tool = kTool, .at = {}}).error().code,
                 Errc::TooFewLandmarks);
        QCOMPARE(withFit({}, {.tool = kTool, .at = {}}).error().code, Errc::TooFewLandmarks);
        QVERIFY(withFit(touchedSite(3), {.tool = kTool, .at = {}}).has_value());
    }

    void givesTouchesToOtherLandmarks()
    {
        const Site before = touchedSite();
        const Site site = withOrder(before, {0, 1, 3, 2, 4, 5, 6, 7});
        QVERIFY(touchOf(site, nameOf(2))->p_TQ == touchOf(before, nameOf(3))->p_TQ);
        QVERIFY(touchOf(site, nameOf(3))->p_TQ == touchOf(before, nameOf(2))->p_TQ);
        QVERIFY(touchOf(site, nameOf(7))->p_TQ == touchOf(before, nameOf(7))->p_TQ);
        QCOMPARE(site.touched.size(), std::size_t{8});
    }

    /// T follows A by the same motion, and the error is no larger than it was.
    void keepsWhatASwabTold()
    {
        const Site before = verifiedSite();
        const RigidTransform moved{rotationFromVector({0.002, 0.0, 0.001}), {1e-3, 0.0, 0.0}};
        SurfaceRefinement refinement{.X_AM = moved * before.registration->X_AM, .extent = 0.1};
        const Site site = withSwab(before, kTool, "Left fifth rib", 120, refinement);
        QVERIFY(site.registration->X_AT.matrix().isApprox(
            (moved * before.registration->X_AT).matrix(), 1e-12));
        QCOMPARE(site.registration->swab->points, 120);
        QVERIFY(site.registration->covariance_A.trace()
                < before.registration->covariance_A.trace());
        QVERIFY(site.verification->stale == StaleCause::Fit);
        QVERIFY(!site.registration->stale);
        double squares = 0.0; // of how far the touches stay from their landmarks now
        for (const LandmarkPair& pair : touchedPairs(site))
            squares += (pair.p_AQ - site.registration->X_AT * pair.p_MQ).squaredNorm();
        QVERIFY(std::abs(site.registration->rms - std::sqrt(squares / 8.0)) < 1e-12);
        QVERIFY(site.registration->rms > 1e-3);
    }

    /// One probe slipped: where it sits on the manikin is noted anew.
    void notesTheProbesOfAManikinThatIsLaidAnew()
    {
        Site site = fittedSite();
        site.relay.emplace();
        const RigidTransform X_TM{rotationFromVector({0.0, 0.1, 0.0}), {0.1, 0.0, -1.0}};
        const RigidTransform X_TJ = RigidTransform::translation({0.2, 0.1, -1.0});
        const RigidTransform X_AT = site.registration->X_AM * X_TM.inverse();
        const Site laid = withRelay(site, {.X_TM = X_TM, .X_AT = X_AT},
                                    {.tool = kTool, .X_TJ = X_TJ, .at = "2004-03-29T10:15:00Z"});
        QVERIFY(
            laid.registration->X_JM->matrix().isApprox((X_TJ.inverse() * X_TM).matrix(), 1e-12));
        QVERIFY(!laid.registration->X_BM);
        QCOMPARE(laid.registration->relays.back().at, std::string{"2004-03-29T10:15:00Z"});
        // The next touch is where the manikin lies now; those of before are known less well.
        const Site touched = withTouch(laid, nameOf(3), touchAt(Vec3::Zero()));
        QCOMPARE(freshTouches(touched).size(), std::size_t{1});
        QVERIFY(touched.registration->stale == StaleCause::Manikin);
        QCOMPARE(freshTouches(withTouch(touched, nameOf(4), touchAt(Vec3::Zero()))).size(),
                 std::size_t{2});
    }

    void givesUpLayingAnewWhatChanges()
    {
        Site site = fittedSite();
        site.relay.emplace();
        QVERIFY(!withStylus(site, someTip()).relay);
        QVERIFY(!withTracker(site, "Tracker B").relay);
        LandmarkCatalogue fewer = eightLandmarks();
        fewer.landmarks.resize(6);
        QVERIFY(!withLandmarks(site, fewer).relay);
        QVERIFY(withTracker(site, kTracker).relay.has_value());
    }

    void beginsAVerificationAnewOnceItIsStale()
    {
        Site site = withVerified(verifiedSite(), checkedPoint("Left clavicle"));
        QCOMPARE(site.verification->points.size(), std::size_t{2}); // touched again
        QCOMPARE(site.verification->verdict, Verdict::Open);
        QVERIFY(site.verification->at.empty());
        site = withVerified(withStylus(verifiedSite(), someTip()), checkedPoint("Left clavicle"));
        QCOMPARE(site.verification->points.size(), std::size_t{1});
        QVERIFY(!site.verification->stale);
    }
};

CARINA_TEST(TestSiteChanges)

} // namespace carina::site_changes_test

#include "tst_site_changes.moc"
