#include "models/site/site_setup.h"

#include "models/site/site_changes.h"
#include "tests/models/registration/registration_site.h"
#include "tests/support/test_class.h"

namespace carina::site_setup_test
{
namespace
{

constexpr double kExact = 1e-9; // m, and as coefficients of a rotation

} // namespace

class TestSiteSetup : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void laysThePatientWhereItWasFitted()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        const auto setup = siteSetup(model->site(), site.patient());
        QVERIFY(setup.has_value());
        QVERIFY((setup->registration.X_AT * site.X_TA).matrix().isApprox(Mat4::Identity(), kExact));
        const RigidTransform X_JA = site.X_TJ.inverse() * site.X_TA;
        QVERIFY(setup->registration.X_JA->matrix().isApprox(X_JA.matrix(), kExact));
    }

    void knowsNoChinProbeThatWasNotSeen()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        Site without = model->site();
        without.registration->X_JM.reset();
        const auto setup = siteSetup(without, site.patient());
        QVERIFY(!setup->registration.X_JA);
    }

    /// What cannot be used says why, and the headset is known all the same.
    void judgesThePlaceWhereverItIs()
    {
        RegistrationSite site;
        const auto model = site.model();
        Site open = model->site();
        open.display = DisplayGeometry{.screenWidth = 0.5};
        const auto placeOf = [&](const Site& of) {
            return sitePlace(of, site.patient(), {}, QDateTime{{2004, 3, 27}, {12, 0}, Qt::UTC});
        };
        QVERIFY(!placeOf(open).setup);
        QCOMPARE(placeOf(open).standing.state, RegistrationState::Missing);
        QCOMPARE(placeOf(open).display->screenWidth, 0.5);
        site.fitAll(*model);
        const SitePlace fitted = placeOf(model->site());
        QVERIFY(fitted.setup && !fitted.display);
        QCOMPARE(fitted.standing.state, RegistrationState::Unverified);
        Site foreign = model->site();
        foreign.catalogue->anatomy = "somebody else";
        QVERIFY(!placeOf(foreign).setup);
        QCOMPARE(placeOf(foreign).standing.reason, StaleReason::Patient);
    }

    void refusesASiteThatIsNotFitted()
    {
        RegistrationSite site;
        const auto model = site.model();
        QCOMPARE(siteSetup(model->site(), site.patient()).error().code, Errc::NotRegistered);
        site.touchAll(*model);
        QCOMPARE(siteSetup(model->site(), site.patient()).error().code, Errc::NotRegistered);
    }

    /// Until the tracker is changed, with which their markers may be others.
    void drawsTubeAndLaryngoscopeAsTheyWereTouched()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        const auto plain = siteSetup(model->site(), site.patient());
        QVERIFY(plain && !plain->registration.X_NE && !plain->tube && !plain->blade);
        SiteTool tube{.role = ToolRole::Tube,
                      .X_NO = RigidTransform::translation({0.0, -0.05, 0.0}),
                      .tube = TubeRest{.length = millimetres(280.0),
                                       .bends = {7.0, 7.0},
                                       .outerDiameter = millimetres(9.6)}};
        const Site with = withTool(model->site(), tube);
        const auto setup = siteSetup(with, site.patient());
        QVERIFY(setup && setup->registration.X_NE);
        QVERIFY(setup->registration.X_NE->translation() == tube.X_NO.translation());
        QVERIFY(setup->tube == tube.tube);
        QVERIFY(!areSameTools(*plain, *setup) && !isSamePlace(*plain, *setup));
        Site moved = with;
        moved.tools.front().stale = StaleCause::Tracker;
        QVERIFY(!siteSetup(moved, site.patient())->registration.X_NE);
    }

    /// X_AT is of the tracker that the landmarks were touched with.
    void refusesASiteOfAnotherTracker()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        model->touching().choose(0); // stale beforehand
        site.hold(*model, site.X_TA * site.landmarks()[0].p_AQ);
        QVERIFY(siteSetup(model->site(), site.patient()).has_value());
        const Site other = withTracker(model->site(), "Another tracker");
        QCOMPARE(siteSetup(other, site.patient()).error().code, Errc::NotRegistered);
        const Site first = withTracker(other, model->site().tracker); // it stood elsewhere since
        QCOMPARE(siteSetup(first, site.patient()).error().code, Errc::NotRegistered);
    }

    void refusesTheSiteOfAnotherPatient()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        Site foreign = model->site();
        foreign.catalogue->anatomy = "somebody else";
        QCOMPARE(siteSetup(foreign, site.patient()).error().code, Errc::OtherPatient);
        foreign.catalogue->anatomy.clear(); // made for no patient in particular
        QVERIFY(siteSetup(foreign, site.patient()).has_value());
    }
};

CARINA_TEST(TestSiteSetup)

} // namespace carina::site_setup_test

#include "tst_site_setup.moc"
