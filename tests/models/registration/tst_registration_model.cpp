#include "tests/models/registration/registration_site.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <fstream>

namespace carina::registration_model_test
{
namespace
{

constexpr double kExact = 1e-9;    // m, of exact samples
constexpr double kExact_mm = 1e-6; // the same on a screen

bool isInverse(const RigidTransform& a, const RigidTransform& b)
{
    return (a * b).matrix().isApprox(Mat4::Identity(), kExact);
}

} // namespace

class TestRegistrationModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void opensEveryPageFromTheBeginning()
    {
        RegistrationSite site;
        const auto model = site.model();
        QCOMPARE(model->step(), SiteStep::Tracker);
        QVERIFY(!std::filesystem::exists(site.file()));
        for (int step = 0; step <= int(SiteStep::Verify); ++step) {
            model->enter(static_cast<SiteStep>(step));
            QCOMPARE(int(model->step()), step);
            QVERIFY(!model->instruction().isEmpty());
            QVERIFY(model->problem().isEmpty());
        }
        QVERIFY(!model->canUndo());
        QCOMPARE(model->nextStep(), SiteStep::Tracker);
        site.tipAt(Vec3::Zero());
        model->takeNow(); // nothing can be verified yet
        QVERIFY(!model->site().verification);
    }

    void aTrackerWithoutAStylusIsNotUsed()
    {
        RegistrationSite site;
        site.removeStylus();
        const auto model = site.model();
        QVERIFY(model->instruction().contains(QStringLiteral("no stylus")));
        model->useTracker();
        QCOMPARE(model->step(), SiteStep::Tracker);
        QCOMPARE(model->task(SiteStep::Tracker).state, TaskState::Open);
        QVERIFY(model->problem().contains(QStringLiteral("no stylus")));
    }

    void findsTheTipBySwinging()
    {
        RegistrationSite site;
        const auto model = site.model();
        QSignalSpy told{model.get(), &RegistrationModel::told};
        model->useTracker();
        QCOMPARE(model->step(), SiteStep::Stylus);
        QCOMPARE(model->task(SiteStep::Tracker).state, TaskState::Done);
        QVERIFY(model->stylus().isLookingForTip());
        QCOMPARE(model->progress(), 0.0);
        site.swingFor(*model, 200);
        QVERIFY(model->progress() > 0.2 && model->progress() < 1.0);
        QCOMPARE(model->task(SiteStep::Stylus).state, TaskState::Open);
        site.swing(*model);
        QVERIFY(!model->stylus().isLookingForTip());
        QCOMPARE(model->task(SiteStep::Stylus).state, TaskState::Done);
        QVERIFY((model->stylus().tip()->p_SQ - site.p_SQ).norm() < kExact);
        QCOMPARE(model->stylus().tip()->tool, std::string{"Stylus"});
        QCOMPARE(model->stylus().tip()->calibratedAt, std::string{"2004-03-27T10:15:00Z"});
        QCOMPARE(told.count(), 1);
        QVERIFY(model->problem().isEmpty());
    }

    void takesLandmarksInTheirOrder()
    {
        RegistrationSite site;
        const auto model = site.model();
        QSignalSpy told{model.get(), &RegistrationModel::told};
        site.prepare(*model);
        QCOMPARE(model->step(), SiteStep::Touch);
        const auto landmarks = site.landmarks();
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            QCOMPARE(model->nextLandmark(), std::optional{i});
            QVERIFY(model->landmarks()[i].isNext);
            QVERIFY(!model->landmarks()[i].spread_mm);
            site.hold(*model, site.X_TA * landmarks[i].p_AQ);
            QCOMPARE(told.last()[0].toString(), QString::fromStdString(landmarks[i].name));
            QVERIFY(model->landmarks()[i].spread_mm.value() < kExact_mm);
        }
        QVERIFY(!model->nextLandmark());
        QCOMPARE(model->task(SiteStep::Touch).state, TaskState::Done);
        QCOMPARE(model->nextStep(), SiteStep::Fit);
        const auto count = told.count();
        site.hold(*model, site.X_TA * Vec3{0.0, -0.2, 0.0}); // nothing is asked for
        QCOMPARE(told.count(), count);
    }

    void laysTheAnatomyOnTheManikin()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        QVERIFY(model->problem().isEmpty());
        const SiteRegistration& registration = *model->site().registration;
        QVERIFY(isInverse(registration.X_AT, site.X_TA));
        QVERIFY(registration.rms < kExact);
        for (const LandmarkRow& row : model->landmarks()) {
            QVERIFY(row.residual_mm.value() < kExact_mm);
            QVERIFY(row.leftOut_mm.value() < kExact_mm);
        }
        // The chin probe knows the manikin: X_AM X_MJ X_JT is the tracker in the anatomy.
        QVERIFY(isInverse(registration.X_AM * registration.X_JM->inverse() * site.X_TJ.inverse(),
                          registration.X_AT.inverse()));
        QVERIFY(!registration.X_BM); // no body probe is there
    }

    void isDoneWhenItIsVerified()
    {
        RegistrationSite site;
        const auto model = site.model();
        model->setOperator(QStringLiteral("  A. Frei "));
        site.fitAll(*model);
        site.verifyAll(*model);
        QCOMPARE(model->task(SiteStep::Verify).state, TaskState::Begun);
        QCOMPARE(model->verifying().suggestion(), Verdict::Good);
        model->verifying().record(Verdict::Good);
        QCOMPARE(model->nextStep(), SiteStep::Overview);
        const auto kept = RegistrationModel::siteOf(site.file(), site.patient());
        QCOMPARE(kept->verification->verdict, Verdict::Good);
        QCOMPARE(kept->verification->points.size(), std::size_t{3});
        QCOMPARE(kept->verification->operatorName, std::string{"A. Frei"});
        QCOMPARE(kept->registration->operatorName, std::string{"A. Frei"});
        QCOMPARE(kept->registration->madeAt, std::string{"2004-03-27T10:15:00Z"});
    }

    void tellsWhereTheStylusIsOnTheAnatomy()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        model->enter(SiteStep::Verify);
        const Landmark xiphoid = site.landmarks()[1];
        site.tipAt(site.X_TA * Vec3{xiphoid.p_AQ + Vec3{0.0, -0.003, 0.004}});
        model->look();
        QCOMPARE(model->stylusOnAnatomy()->nearestLandmark, QStringLiteral("Xiphoid process"));
        QVERIFY(std::abs(model->stylusOnAnatomy()->landmark_mm - 5.0) < kExact_mm);
        QVERIFY(model->stylusOnAnatomy()->surface_mm > 0.0);
        site.m_now += std::chrono::seconds{1}; // and nothing more is seen
        model->look();
        QVERIFY(!model->stylusOnAnatomy());
    }

    void takesAPointByAKey()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.prepare(*model);
        const Vec3 p_TQ = site.X_TA * site.landmarks()[0].p_AQ;
        site.holdFor(*model, 20, p_TQ); // a third of what it takes by itself
        QVERIFY(model->site().touched.empty());
        model->takeNow();
        QCOMPARE(model->site().touched.size(), std::size_t{1});
        QVERIFY((model->site().touched[0].p_TQ - p_TQ).norm() < kExact);
        for (const SiteStep step : {SiteStep::Touch, SiteStep::Verify}) {
            model->enter(step);
            site.m_now += std::chrono::seconds{1}; // the stylus is seen no more
            model->takeNow();
            QCOMPARE(model->site().touched.size(), std::size_t{1});
            QCOMPARE(model->problem().isEmpty(), step == SiteStep::Verify); // nothing to verify
        }
    }

    void touchesOneLandmarkAgain()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.touchAll(*model);
        model->touching().choose(2);
        QCOMPARE(model->nextLandmark(), std::optional<std::size_t>{2});
        const Vec3 p_TQ = site.X_TA * Vec3{0.07, -0.1, -0.1};
        site.hold(*model, p_TQ);
        QVERIFY(!model->nextLandmark());
        QCOMPARE(model->site().touched.size(), std::size_t{8});
        QVERIFY((model->site().touched.back().p_TQ - p_TQ).norm() < kExact);
        QCOMPARE(model->site().touched.back().landmark, site.landmarks()[2].name);
    }

    void marksThePlacesToCheckOnTheModel()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        QCOMPARE(model->places().size(), std::size_t{8});
        model->enter(SiteStep::Verify);
        const auto places = model->places();
        QCOMPARE(places.size(), std::size_t{3});
        QVERIFY(places[0].isNext && !places[1].isNext);
        QVERIFY(places[0].p_AQ == site.patient().landmarks().p_A_incisors);
    }

    void undoesOneChangeAtATime()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        model->undo();
        QVERIFY(!model->site().registration);
        QCOMPARE(model->step(), SiteStep::Touch);
        model->undo();
        QCOMPARE(model->nextLandmark(), std::optional<std::size_t>{7});
        QCOMPARE(RegistrationModel::siteOf(site.file(), site.patient())->touched.size(),
                 std::size_t{7});
        for (int i = 0; i < 9; ++i) // seven touches, landmarks, tip
            model->undo();
        QCOMPARE(model->step(), SiteStep::Stylus);
        QVERIFY(model->stylus().isLookingForTip());
        model->undo();
        QVERIFY(!model->canUndo());
        QCOMPARE(model->task(SiteStep::Tracker).state, TaskState::Open);
    }

    /// As when it goes on with another tracker.
    void undoesWhatWasDoneInAModelBefore()
    {
        RegistrationSite site;
        auto model = site.model();
        model->setOperator(QStringLiteral("A. Frei"));
        model->setOperator(QStringLiteral("M. Keller"));
        site.m_past = model->past();
        model = site.model();
        QVERIFY(model->canUndo());
        model->undo();
        QCOMPARE(model->site().operatorName, std::string{"A. Frei"});
        model->undo();
        QVERIFY(model->site().operatorName.empty());
        QVERIFY(!model->canUndo());
    }

    /// A tracker that was made of the site's devices has to be made anew once they are others.
    void tellsThatTheDevicesChanged()
    {
        RegistrationSite site;
        std::ofstream{site.beside("tracker.json")}
            << R"({"schema": "carina.tracker/1", "kind": "openigtlink",)"
               R"( "address": "192.0.2.8:18944", "tools": [{"name": "Chin", "role": "jaw"}]})";
        const auto other = site.model();
        QSignalSpy unasked{other.get(), &RegistrationModel::devicesChanged};
        other->devices().setFirst({"tracker.json"});
        QCOMPARE(other->devices().count(), 1U);
        QCOMPARE(unasked.count(), 0); // its tracker is none of them
        site.m_trackedDevices = other->site().devices;
        const auto model = site.model();
        QSignalSpy changed{model.get(), &RegistrationModel::devicesChanged};
        model->setOperator(QStringLiteral("A. Frei"));
        QCOMPARE(changed.count(), 0);
        model->devices().remove(0);
        QVERIFY(changed.count() > 0);
    }

    void saysHowItsToolsAreSeen()
    {
        RegistrationSite site;
        const auto model = site.model();
        QVERIFY(!model->tools()[0].isVisible);
        for (int i = 0; i < 70; ++i)
            site.tipAt({0.0, 0.0, -1.0});
        site.m_now += std::chrono::milliseconds{9};
        QVERIFY(model->tools()[0].isVisible);
        QCOMPARE(model->tools()[0].text, QStringLiteral("visible, 60\u00a0Hz, 9\u00a0ms old"));
        QCOMPARE(model->tools()[1].name, QStringLiteral("Chin probe"));
        site.m_tracker.m_stylus.push({.time = site.m_now, .X_FO = {}, .validity = Validity::Lost});
        QVERIFY(!model->tools()[0].isVisible);
        site.m_now += std::chrono::milliseconds{400};
        QVERIFY(!model->tools()[1].isVisible);
    }
};

CARINA_TEST(TestRegistrationModel)

} // namespace carina::registration_model_test

#include "tst_registration_model.moc"
