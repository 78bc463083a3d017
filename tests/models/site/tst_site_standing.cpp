#include "models/site/site_standing.h"

#include "models/registration/registration_targets.h"
#include "models/site/site_tasks.h"
#include "models/site/standing_words.h"
#include "tests/models/registration/made_site.h"
#include "tests/support/test_class.h"

namespace carina::site_standing_test
{
namespace
{

using namespace test;

const QDateTime kDay{{2004, 3, 27}, {12, 0}, Qt::UTC};
const Vec3 kGlottis{0.0, -0.05, 0.12};

SiteCircumstances here()
{
    return {.anatomy = "0f3a",
            .tracker = QString::fromStdString(kTracker),
            .today = kDay,
            .p_A_glottis = kGlottis};
}

Site withPatient(Site site, std::string anatomy)
{
    site.catalogue->anatomy = std::move(anatomy);
    return site;
}

/// The first landmark touched again.
Site touchedAnew(Site site)
{
    const Landmark landmark = site.catalogue->landmarks.front();
    return withTouch(std::move(site), landmark.name, touchAt(landmark.p_AQ));
}

/// Found again after it was moved.
Site laidAnew(Site site)
{
    site.registration->relays.push_back({.at = "2004-03-27T11:00:00Z", .landmarks = 3});
    makeStale(site.verification->stale, StaleCause::Manikin);
    return site;
}

Site withLandmarkMoved(Site site)
{
    LandmarkCatalogue moved = *site.catalogue;
    moved.landmarks.front().p_AQ.x() += 1e-3;
    return withLandmarks(std::move(site), moved);
}

Site beingRelaid(Site site)
{
    site.relay.emplace();
    return site;
}

Site fittedAgain(Site site)
{
    return withFit(std::move(site), {.tool = kTool, .at = "2004-03-27T10:40:00Z"}).value();
}

Site verifiedAt(const char* at)
{
    Site site = verifiedSite();
    site.verification->at = at;
    return site;
}

} // namespace

/// Every cause for which a registration cannot be relied on, and what is said of it.
class TestSiteStanding : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsEachCause_data()
    {
        QTest::addColumn<Site>("site");
        QTest::addColumn<RegistrationState>("state");
        QTest::addColumn<StaleReason>("reason");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("toDo");
        const auto row = [](const char* name, const Site& site, RegistrationState state,
                            StaleReason reason, const char* text, const char* toDo) {
            QTest::newRow(name) << site << state << reason << QString::fromUtf8(text)
                                << QString::fromUtf8(toDo);
        };
        using State = RegistrationState;
        using Why = StaleReason;
        row("not touched", preparedSite(), State::Missing, Why::None, "▲ not registered",
            "register it");
        row("not fitted", touchedSite(), State::Missing, Why::None, "▲ not registered",
            "register it");
        row("another patient", withPatient(verifiedSite(), "other"), State::Stale, Why::Patient,
            "▲ stale: another patient", "for this one");
        row("no patient in particular", withPatient(verifiedSite(), ""), State::Good, Why::None,
            "✓ registered", "");
        row("another tracker", withTracker(verifiedSite(), "Tracker B"), State::Stale, Why::Tracker,
            "▲ stale: tracker changed", "register it again");
        row("another tracker and back",
            withTracker(withTracker(verifiedSite(), "Tracker B"), kTracker), State::Stale,
            Why::Tracker, "▲ stale: tracker changed", "register it again");
        row("stylus", withStylus(verifiedSite(), someTip()), State::Stale, Why::Stylus,
            "▲ stale: stylus calibrated anew", "touch the landmarks again");
        row("landmark moved", withLandmarkMoved(verifiedSite()), State::Stale, Why::Landmarks,
            "▲ stale: landmarks changed", "fit the patient again");
        row("landmark touched", touchedAnew(verifiedSite()), State::Stale, Why::Touches,
            "▲ stale: landmarks touched anew", "fit the patient");
        row("touched after it was moved", touchedAnew(laidAnew(verifiedSite())), State::Stale,
            Why::Manikin, "▲ stale: manikin moved", "touch its landmarks");
        row("being registered again", beingRelaid(verifiedSite()), State::Stale, Why::Registering,
            "▲ stale: being registered again", "finish that");
        row("not verified", fittedSite(), State::Unverified, Why::None, "▲ unverified",
            "verify it");
        row("no verdict", verifiedSite(Verdict::Open), State::Unverified, Why::None, "▲ unverified",
            "verify it");
        row("fitted again", fittedAgain(verifiedSite()), State::Unverified, Why::Fit,
            "▲ unverified", "verify it");
        row("moved and found again", laidAnew(verifiedSite()), State::Unverified, Why::Manikin,
            "▲ unverified", "verify it");
        row("judged not good", verifiedSite(Verdict::NotGood), State::NotGood, Why::None,
            "▲ not good: 1.0\u00a0mm at check", "touch the landmarks again");
        row("30 days ago", verifiedAt("2004-02-26T12:00:00Z"), State::Good, Why::None,
            "✓ registered", "");
        row("31 days ago", verifiedAt("2004-02-25T12:00:00Z"), State::Stale, Why::Age,
            "▲ stale: verified long ago", "verify two points");
        row("good", verifiedSite(), State::Good, Why::None, "✓ registered", "");
    }

    void knowsEachCause()
    {
        QFETCH(const Site, site);
        QFETCH(const RegistrationState, state);
        QFETCH(const StaleReason, reason);
        QFETCH(const QString, text);
        QFETCH(const QString, toDo);
        const RegistrationStanding standing = siteStanding(site, here());
        QCOMPARE(standing.state, state);
        QCOMPARE(standing.reason, reason);
        QVERIFY2(standingText(standing).startsWith(text), qPrintable(standingText(standing)));
        const QString notice = standingNotice(standing);
        QCOMPARE(notice.isEmpty(), toDo.isEmpty());
        QVERIFY2(notice.contains(toDo), qPrintable(notice));
    }

    /// The verify page is done exactly where the trainee's program has nothing to say.
    void isWhatTheWizardSays_data() { knowsEachCause_data(); }
    void isWhatTheWizardSays()
    {
        QFETCH(const Site, site);
        SiteCircumstances ofWizard = here();
        ofWizard.anatomy.clear(); // it opens no site of another patient
        const bool isDone = siteTask(site, SiteStep::Verify, kTool, ofWizard.tracker, kDay).state
                            == TaskState::Done;
        QCOMPARE(isDone, siteStanding(site, ofWizard).state == RegistrationState::Good);
    }

    void saysTheExpectedErrorAtTheGlottis()
    {
        const Site site = verifiedSite();
        const auto expected =
            expectedErrors(site.registration->covariance_A, site.registration->degrees,
                           {{QStringLiteral("Glottis"), kGlottis}});
        const RegistrationStanding standing = siteStanding(site, here());
        QVERIFY(std::abs(inMillimetres(standing.error) - expected.front().bound_mm) <= 0.05);
        QVERIFY(standing.error.si > 0.0);
        QCOMPARE(standingText(standing), QStringLiteral("✓ registered, %1\u00a0mm")
                                             .arg(inMillimetres(standing.error), 0, 'f', 1));
        SiteCircumstances nowhere = here();
        nowhere.p_A_glottis.reset();
        QCOMPARE(standingText(siteStanding(site, nowhere)), QStringLiteral("✓ registered"));
    }

    void saysTheLargestErrorOfAnyCheck()
    {
        Site site = verifiedSite(Verdict::NotGood);
        site.verification->points[0].error = 4.24e-3;
        QCOMPARE(inMillimetres(siteStanding(site, here()).error), 4.2);
    }

    /// A file can hold any number; a fact cannot.
    void statesNoErrorThatTheHostRefuses()
    {
        Site site = verifiedSite(Verdict::NotGood);
        site.verification->points[0].error = 1e9;
        QCOMPARE(inMillimetres(siteStanding(site, here()).error), 1000.0);
        QCOMPARE(inMillimetres(driftedBy(1e9).error), 1000.0);
    }

    void saysByHowMuchItDrifted()
    {
        const RegistrationStanding standing = driftedBy(0.0081);
        QCOMPARE(standingText(standing), QStringLiteral("▲ stale: moved by about 8\u00a0mm"));
        QVERIFY(standingNotice(standing).contains(QStringLiteral("8\u00a0mm")));
    }

    void saysNothingOfASimulatedManikin()
    {
        const RegistrationStanding standing{RegistrationState::Simulated, StaleReason::None, {}};
        QCOMPARE(standingText(standing), QStringLiteral("✓ simulated"));
        QVERIFY(standingNotice(standing).isEmpty());
    }
};

CARINA_TEST(TestSiteStanding)

} // namespace carina::site_standing_test

#include "tst_site_standing.moc"
