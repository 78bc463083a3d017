#include "models/registration/registration_guard.h"
#include "models/site/site_setup.h"
#include "tests/models/registration/made_site.h"
#include "tests/models/registration/registration_site.h"
#include "tests/support/test_class.h"

namespace carina::registration_guard_test
{

using namespace test;

namespace
{

const std::string kStylus = "Stylus"; ///< as WrittenTracker names it
const Vec3 kBent_m{0.0, 0.02, 0.0};

/// A session on a site that was registered, the stylus in somebody's hand.
struct Session {
    explicit Session(const SiteSetup& setup)
        : tracking{std::unique_ptr<Tracker>{tracker}, setup.registration},
          guard{tracking, *setup.guard}
    {
    }

    /// The tip rests for a second and a half where the manikin has this landmark.
    void restOn(const Landmark& landmark, const Vec3& moved_A)
    {
        const Vec3 p_TQ = kX_TA * Vec3{landmark.p_AQ + moved_A};
        for (int i = 0; i < 90; ++i) {
            now += RegistrationSite::kPeriod;
            tracker->m_stylus.push(
                {.time = now, .X_FO = RigidTransform::translation(p_TQ - someTip().p_SQ)});
            guard.look();
        }
        for (int i = 0; i < 30; ++i) { // and lifts
            now += RegistrationSite::kPeriod;
            tracker->m_stylus.push(
                {.time = now,
                 .X_FO = RigidTransform::translation(p_TQ + 0.001 * i * Vec3::UnitX())});
            guard.look();
        }
    }

    WrittenTracker* tracker = new WrittenTracker;
    StationTracking tracking;
    RegistrationGuard guard;
    SessionTime now{};
};

/// As fittedSite, of a patient of its own.
Site registered(std::vector<StylusTip> styluses)
{
    Site site = fittedSite();
    site.catalogue->anatomy.clear();
    site.styluses = std::move(styluses);
    return site;
}

StylusTip tipCalled(const std::string& tool, const Vec3& off_S = Vec3::Zero())
{
    StylusTip tip = someTip();
    tip.tool = tool;
    tip.p_SQ += off_S;
    return tip;
}

SiteSetup setupOf(const Site& site) { return *siteSetup(site, RegistrationSite::patient()); }

} // namespace

class TestRegistrationGuard : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsAManikinThatWasPushed()
    {
        Session session{setupOf(registered({tipCalled(kStylus)}))};
        const auto landmarks = eightLandmarks().landmarks;
        for (const std::size_t i : {0U, 1U, 2U})
            session.restOn(landmarks[i], Vec3::Zero());
        QCOMPARE(session.guard.report().state, WatchState::Good);
        for (const std::size_t i : {0U, 1U, 2U, 3U})
            session.restOn(landmarks[i], {0.008, 0.0, 0.0});
        QCOMPARE(session.guard.report().state, WatchState::Drifted);
        const auto standing = driftedBy(session.guard.report().shift_A.norm());
        QCOMPARE(inMillimetres(standing.error), 8.0);
    }

    /// The site knows another stylus besides, calibrated last.
    void looksAtTheTipOfTheStylusInHand()
    {
        Session session{setupOf(registered({tipCalled(kStylus), tipCalled("Other", kBent_m)}))};
        for (const std::size_t i : {0U, 1U, 2U})
            session.restOn(eightLandmarks().landmarks[i], Vec3::Zero());
        QCOMPARE(session.guard.report().state, WatchState::Good);
    }

    void looksAtNothingWithoutATip()
    {
        Session session{setupOf(registered({tipCalled("Other", kBent_m)}))};
        for (const std::size_t i : {0U, 1U, 2U})
            session.restOn(eightLandmarks().landmarks[i], Vec3::Zero());
        QCOMPARE(session.guard.report().state, WatchState::Unchecked);
    }

    void watchesNothingWhoseErrorIsNotKnown()
    {
        Site site = registered({tipCalled(kStylus)});
        site.registration->covariance_A.setZero();
        QVERIFY(!setupOf(site).guard);
        site = registered({tipCalled(kStylus)});
        site.registration->degrees = 0.0;
        QVERIFY(!setupOf(site).guard);
        QVERIFY(!setupOf(registered({})).guard);
    }

    void knowsASiteThatLaysThePatientAsBefore()
    {
        const SiteSetup before = setupOf(registered({tipCalled(kStylus)}));
        Site site = registered({tipCalled(kStylus)});
        site.step = SiteStep::Verify;
        site.operatorName = "B. Kern";
        QVERIFY(isSamePlace(setupOf(site), before) && isSameGuard(setupOf(site), before));
        site.styluses = {tipCalled(kStylus, kBent_m)}; // it was calibrated again
        QVERIFY(isSamePlace(setupOf(site), before) && !isSameGuard(setupOf(site), before));
        site.registration->X_JM = RigidTransform{};
        QVERIFY(!isSamePlace(setupOf(site), before));
        site = registered({tipCalled(kStylus)});
        site.registration->X_AT =
            RigidTransform::translation({1e-6, 0.0, 0.0}) * site.registration->X_AT;
        QVERIFY(!isSamePlace(setupOf(site), before));
    }
};

CARINA_TEST(TestRegistrationGuard)

} // namespace carina::registration_guard_test

#include "tst_registration_guard.moc"
