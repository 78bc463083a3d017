#include "engine/registration/error/error_bound.h"
#include "tests/models/registration/made_desk.h"
#include "tests/support/test_class.h"

namespace carina::verify_task_test
{
namespace
{

using namespace test;

constexpr double kExact_mm = 1e-6;
constexpr Length kHand = millimetres(1.0);
constexpr int kRegistrations = 300;
/// Three standard deviations of what a 95 % share is counted to be in so many.
constexpr double kAgree = 0.038;

/// A manikin that was moved after it was registered.
Site movedSite(const Vec3& by_A)
{
    std::mt19937 random{3};
    MadeDesk desk{touchedBy(random, kHand)};
    desk.fitting.fit();
    Site site = desk.editor.site();
    site.registration->X_AT = RigidTransform::translation(by_A) * site.registration->X_AT;
    return site;
}

QStringList namesOf(const std::vector<CheckPoint>& points)
{
    QStringList names;
    for (const CheckPoint& point : points)
        names << point.name;
    return names;
}

} // namespace

class TestVerifyTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void offersPlacesThatTheFitDidNotUse()
    {
        RegistrationSite site;
        const auto model = site.model();
        QVERIFY(model->verifying().points().empty()); // nothing is registered
        QVERIFY(!model->verifying().next());
        site.fitAll(*model);
        QCOMPARE(namesOf(model->verifying().points()),
                 (QStringList{QStringLiteral("Edge of the upper incisors"),
                              QStringLiteral("Inner end of the left clavicle"),
                              QStringLiteral("Inner end of the right clavicle")}));
        model->landmarkTask().chooseSet(1);
        model->fitting().fit();
        const QStringList more = namesOf(model->verifying().points());
        QCOMPARE(more.size(), 5);
        QVERIFY(more[3].contains(QStringLiteral("tenth rib")));
    }

    void asksForOnePlaceAfterAnother()
    {
        MadeDesk desk{fittedSite()};
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(desk.verifying.next(), std::optional{i});
            desk.verifyAt(desk.verifying.points()[i].p_AQ, {0.0, 0.0, 1e-3});
            QVERIFY(desk.verifying.points()[i].error_mm.has_value());
        }
        QVERIFY(!desk.verifying.next());
        desk.verifying.choose(1);
        QCOMPARE(desk.verifying.next(), std::optional<std::size_t>{1});
        desk.verifyAt(desk.verifying.points()[1].p_AQ);
        QCOMPARE(desk.editor.site().verification->points.size(), std::size_t{3});
        QVERIFY(!desk.verifying.next());
    }

    void measuresHowFarAPlaceIsOff()
    {
        Site site = fittedSite();
        site.registration->X_AT = kX_TA.inverse();
        MadeDesk desk{site};
        desk.verifyAt(desk.verifying.points()[0].p_AQ, {2e-3, 0.0, -1.5e-3});
        QVERIFY(std::abs(*desk.verifying.points()[0].error_mm - 2.5) < kExact_mm);
    }

    void addsPlacesThatAreClicked()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        model->enter(SiteStep::Verify);
        model->pick({5.0, -1.0, 0.0}, Vec3::UnitY()); // far beside the patient
        QVERIFY(!model->problem().isEmpty());
        for (const double x : {0.05, -0.05}) {
            model->pick({x, -1.0, 0.0}, Vec3::UnitY());
            const auto points = model->verifying().points();
            QCOMPARE(model->verifying().next(), std::optional{points.size() - 1});
            QVERIFY(
                points.back().name.endsWith(x > 0.0 ? QStringLiteral("1") : QStringLiteral("2")));
            site.hold(*model, site.X_TA * points.back().p_AQ);
        }
        QCOMPARE(model->site().verification->points.size(), std::size_t{2});
        QCOMPARE(model->verifying().next(), std::optional<std::size_t>{0});
        QCOMPARE(model->verifying().points().size(), std::size_t{5});
        QCOMPARE(model->verifying().suggestion(), Verdict::Good);
    }

    /// Each has a name of its own, also after a restart, and a stray click is taken back.
    void namesPlacesThatAreClickedOnce()
    {
        RegistrationSite site;
        auto model = site.model();
        site.fitAll(*model);
        model->enter(SiteStep::Verify);
        const auto before = model->verifying().points().size();
        model->pick({0.05, -1.0, 0.0}, Vec3::UnitY());
        model->pick({-0.05, -1.0, 0.0}, Vec3::UnitY());
        site.hold(*model, site.X_TA * model->verifying().points().back().p_AQ);
        QCOMPARE(model->site().verification->points[0].name, std::string{"Place 2"});
        model = site.model(); // "Place 2" is in its file, "Place 1" is not
        model->pick({0.04, -1.0, -0.02}, Vec3::UnitY());
        QCOMPARE(model->verifying().points().size(), before + 2);
        const auto asked = model->verifying().next();
        QVERIFY(asked && !model->verifying().points()[*asked].error_mm);
        QVERIFY(model->canUndo());
        model->undo();
        QCOMPARE(model->verifying().points().size(), before + 1);
        QVERIFY(model->site().verification->points.size() == 1);
    }

    /// Registrations and checks by a hand that strays by 1 mm: 95 of 100 errors are within their
    /// bounds, and 95 of 100 sets of three checks are called good.
    void promisesWhatItKeeps()
    {
        std::mt19937 random{77};
        int within = 0;
        int good = 0;
        for (int i = 0; i < kRegistrations; ++i) {
            MadeDesk desk{touchedBy(random, kHand)};
            desk.fitting.fit();
            for (const CheckPoint& point : desk.verifying.points())
                desk.verifyAt(point.p_AQ, anyError(random, kHand));
            for (const CheckPoint& point : desk.verifying.points())
                within += point.isWithin() ? 1 : 0;
            good += desk.verifying.suggestion() == Verdict::Good ? 1 : 0;
        }
        const double shareWithin = within / (3.0 * kRegistrations);
        const double shareGood = double(good) / kRegistrations;
        qInfo("%.3f of the errors within their bounds, %.3f of the sets good", shareWithin,
              shareGood);
        QVERIFY(std::abs(shareWithin - kBoundShare) < kAgree);
        QVERIFY(std::abs(shareGood - kBoundShare) < kAgree);
    }

    /// The verdict judges all places together, so one alone may be beyond its own bound: the table
    /// says so of it, and of no place that the verdict does not bear.
    void tellsWhatIsToleratedFromWhatIsNot()
    {
        std::mt19937 random{5};
        MadeDesk made{touchedBy(random, kHand)};
        made.fitting.fit();
        Site site = made.editor.site();
        site.registration->X_AT = kX_TA.inverse();
        MadeDesk desk{site};
        for (int i = 0; i < 3; ++i)
            desk.verifyAt(desk.verifying.points()[*desk.verifying.next()].p_AQ);
        QCOMPARE(desk.verifying.touched(), std::size_t{3});
        const CheckPoint last = desk.verifying.points()[2];
        QVERIFY(last.isWithin() && !last.isTolerated());
        QVERIFY(last.limit_mm > last.bound_mm);
        const auto touchAgain = [&](double error_mm) {
            desk.verifying.choose(2);
            desk.verifyAt(last.p_AQ, {1e-3 * error_mm, 0.0, 0.0});
        };
        touchAgain(0.5 * (last.bound_mm + last.limit_mm));
        QVERIFY(desk.verifying.points()[2].isTolerated());
        QCOMPARE(desk.verifying.suggestion(), Verdict::Good);
        touchAgain(1.01 * last.limit_mm);
        QVERIFY(!desk.verifying.points()[2].isTolerated());
        QCOMPARE(desk.verifying.suggestion(), Verdict::NotGood);
    }

    /// Files of version 1 did not keep how large a registration's error may be.
    void judgesNothingWithoutAnExpectedError()
    {
        Site site = fittedSite();
        site.registration->degrees = 0.0;
        site.registration->covariance_A.setZero();
        MadeDesk desk{site};
        QVERIFY(!desk.verifying.canJudge());
        QVERIFY(desk.verifying.points().empty() && !desk.verifying.next());
        desk.verifyAt(Vec3::Zero());
        QVERIFY(!desk.editor.site().verification);
        QCOMPARE(desk.verifying.suggestion(), Verdict::Open);
        desk.fitting.fit();
        QVERIFY(desk.verifying.canJudge() && desk.verifying.next());
    }

    void refusesAPlaceThatWasNotMeant()
    {
        MadeDesk desk{fittedSite()};
        desk.verifyAt(desk.verifying.points()[0].p_AQ, {0.0, 0.0, 0.041});
        QVERIFY(!desk.editor.site().verification);
        QVERIFY(desk.editor.problem().contains(QStringLiteral("41")));
        desk.verifyAt(desk.verifying.points()[0].p_AQ, {0.0, 0.0, 0.039});
        QVERIFY(desk.editor.site().verification.has_value());
    }

    void doesNotJudgeByOnePoint()
    {
        MadeDesk desk{fittedSite()};
        QCOMPARE(desk.verifying.suggestion(), Verdict::Open);
        desk.verifyAt(desk.verifying.points()[0].p_AQ);
        QCOMPARE(desk.verifying.suggestion(), Verdict::Open);
        desk.verifyAt(desk.verifying.points()[1].p_AQ);
        QCOMPARE(desk.verifying.suggestion(), Verdict::Good);
    }

    /// Clavicles and ribs say little about the throat.
    void knowsWhetherAPlaceAtTheAirwayWasTouched()
    {
        MadeDesk desk{fittedSite()};
        QVERIFY(!desk.verifying.hasAirwayPoint());
        for (const std::size_t clavicle : {1, 2}) {
            desk.verifying.choose(clavicle);
            desk.verifyAt(desk.verifying.points()[clavicle].p_AQ);
        }
        QCOMPARE(desk.verifying.suggestion(), Verdict::Good);
        QVERIFY(!desk.verifying.hasAirwayPoint());
        desk.verifying.choose(0); // the incisors
        desk.verifyAt(desk.verifying.points()[0].p_AQ);
        QVERIFY(desk.verifying.hasAirwayPoint());
    }

    /// Two suffice for a verdict, all are proposed.
    void isCompleteOnceAllPlacesAreTouched()
    {
        MadeDesk desk{fittedSite()};
        for (int i = 0; i < 3; ++i) {
            QVERIFY(!desk.verifying.isComplete());
            desk.verifyAt(desk.verifying.points()[*desk.verifying.next()].p_AQ);
        }
        QVERIFY(desk.verifying.isComplete());
        desk.verifying.choose(1); // to touch it again
        QVERIFY(desk.verifying.isComplete());
    }

    void keepsTheVerdict()
    {
        MadeDesk desk{fittedSite()};
        for (int i = 0; i < 3; ++i)
            desk.verifyAt(desk.verifying.points()[*desk.verifying.next()].p_AQ);
        QVERIFY(!desk.verifying.isRecorded());
        desk.verifying.record(desk.verifying.suggestion());
        QVERIFY(desk.verifying.isRecorded());
        const SiteVerification& kept = *desk.editor.site().verification;
        QCOMPARE(kept.verdict, Verdict::Good);
        QCOMPARE(kept.at, std::string{"2004-03-27T10:15:00Z"});
        QCOMPARE(kept.operatorName, std::string{"A. Frei"});
        desk.editor.undo();
        QVERIFY(!desk.verifying.isRecorded());
        QCOMPARE(desk.editor.site().verification->verdict, Verdict::Open);
        QCOMPARE(desk.editor.site().verification->points.size(), std::size_t{3});
    }

    void callsAManikinThatWasMovedNotGood_data()
    {
        QTest::addColumn<double>("by_mm");
        for (const int by_mm : {6, 10, 20})
            QTest::addRow("%d mm", by_mm) << double(by_mm);
    }
    void callsAManikinThatWasMovedNotGood()
    {
        QFETCH(double, by_mm);
        std::mt19937 random{9};
        MadeDesk desk{movedSite({0.0, 0.0, 1e-3 * by_mm})};
        for (int i = 0; i < 3; ++i)
            desk.verifyAt(desk.verifying.points()[*desk.verifying.next()].p_AQ,
                          anyError(random, kHand));
        QCOMPARE(desk.verifying.suggestion(), Verdict::NotGood);
        desk.verifying.record(Verdict::NotGood);
        QCOMPARE(desk.editor.site().verification->verdict, Verdict::NotGood);
        desk.verifying.choose(0);
        desk.verifyAt(desk.verifying.points()[0].p_AQ);
        QVERIFY(!desk.verifying.isRecorded()); // it is to be judged again
    }

    void forgetsErrorsOnceTheFitIsAnother()
    {
        MadeDesk desk{verifiedSite()};
        QCOMPARE(desk.verifying.suggestion(), Verdict::Good);
        desk.fitting.fit();
        QVERIFY(desk.editor.site().verification->stale == StaleCause::Fit);
        QCOMPARE(desk.verifying.suggestion(), Verdict::Open);
        for (const CheckPoint& point : desk.verifying.points())
            QVERIFY(!point.error_mm);
    }

    void saysWhenTheStylusIsOutOfView()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        model->enter(SiteStep::Verify);
        site.m_now += std::chrono::seconds{1};
        model->takeNow();
        QVERIFY(model->problem().contains(QStringLiteral("out of view")));
        site.tipAt(site.X_TA * model->verifying().points()[0].p_AQ);
        model->takeNow();
        QVERIFY(model->problem().isEmpty());
        QCOMPARE(model->site().verification->points.size(), std::size_t{1});
    }
};

CARINA_TEST(TestVerifyTask)

} // namespace carina::verify_task_test

#include "tst_verify_task.moc"
