#include "tests/models/registration_site.h"

#include <QSignalSpy>
#include <QTest>

namespace carina
{
namespace
{

constexpr double kExact = 1e-9;    // m, of exact samples
constexpr double kExact_mm = 1e-6; // the same on a screen

} // namespace

class TestRegistrationModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beginsWithTheTracker()
    {
        RegistrationSite site;
        const auto model = site.model();
        QCOMPARE(model->step(), SiteStep::Tracker);
        QVERIFY(model->canEnter(SiteStep::Tracker));
        for (const SiteStep step : {SiteStep::Stylus, SiteStep::Landmarks, SiteStep::Touch,
                                    SiteStep::Fit, SiteStep::Verify}) {
            QVERIFY(!model->canEnter(step));
            QVERIFY(!model->whyNot(step).isEmpty());
            model->enter(step);
            QCOMPARE(model->step(), SiteStep::Tracker);
        }
        QVERIFY(!model->canUndo());
        QVERIFY(!std::filesystem::exists(site.file()));
    }

    void findsTheTipBySwinging()
    {
        RegistrationSite site;
        const auto model = site.model();
        model->useTracker();
        QCOMPARE(model->step(), SiteStep::Stylus);
        QVERIFY(model->isDone(SiteStep::Tracker));
        model->startSwing();
        QVERIFY(model->isSwinging());
        QCOMPARE(model->progress(), 0.0);
        for (int i = 0; i < 240; ++i) {
            site.tipAt({0.1, 0.0, -1.0});
            model->look();
        }
        QCOMPARE(model->progress(), 0.5);
        model->cancelSwing();
        QVERIFY(!model->isSwinging());
        QCOMPARE(model->progress(), 0.0);
        site.swing(*model);
        QVERIFY(!model->isSwinging());
        QVERIFY(model->isDone(SiteStep::Stylus));
        QVERIFY((model->site().stylus->p_SQ - site.p_SQ).norm() < kExact);
        QVERIFY(model->problem().isEmpty());
    }

    void saysWhatIsWrongWithASwing()
    {
        RegistrationSite site;
        const auto model = site.model();
        model->useTracker();
        model->startSwing();
        for (int i = 0; i < 480; ++i) {
            site.tipAt({0.1, 0.0, -1.0}); // never turned
            model->look();
        }
        QVERIFY(!model->isSwinging());
        QVERIFY(!model->isDone(SiteStep::Stylus));
        QVERIFY(!model->problem().isEmpty());
        site.swing(*model);
        QVERIFY(model->problem().isEmpty());
    }

    void takesLandmarksInTheirOrder()
    {
        RegistrationSite site;
        const auto model = site.model();
        QSignalSpy touched{model.get(), &RegistrationModel::touched};
        model->useTracker();
        site.swing(*model);
        QVERIFY(!model->canEnter(SiteStep::Touch)); // no landmarks yet
        QVERIFY(!model->nextLandmark());
        model->acceptLandmarks();
        QCOMPARE(model->step(), SiteStep::Touch);
        const auto landmarks = site.landmarks().landmarks;
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            QCOMPARE(model->nextLandmark(), std::optional{i});
            QVERIFY(model->landmarks()[i].isNext);
            QVERIFY(!model->landmarks()[i].spread_mm);
            QVERIFY(!model->canEnter(SiteStep::Fit));
            site.hold(*model, site.X_TA * landmarks[i].p_AQ);
            QCOMPARE(touched.size(), qsizetype(i + 1));
            QVERIFY(model->landmarks()[i].spread_mm.value() < kExact_mm);
        }
        QVERIFY(!model->nextLandmark());
        QVERIFY(model->isDone(SiteStep::Touch));
        QVERIFY(model->canEnter(SiteStep::Fit));
        site.hold(*model, site.X_TA * Vec3{0.0, -0.2, 0.0}); // nothing is asked for
        QCOMPARE(touched.size(), qsizetype{4});
    }

    void laysTheAnatomyOnTheManikin()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.touchAll(*model);
        model->fit();
        QCOMPARE(model->step(), SiteStep::Fit);
        QVERIFY(model->problem().isEmpty());
        const SiteRegistration& registration = *model->site().registration;
        QVERIFY((registration.X_AT * site.X_TA).matrix().isApprox(Mat4::Identity(), kExact));
        QVERIFY(registration.rms < kExact);
        for (const LandmarkRow& row : model->landmarks())
            QVERIFY(row.residual_mm.value() < kExact_mm);
        // The chin probe knows the manikin: X_AM X_MJ X_JT is the tracker in the anatomy.
        const RigidTransform X_AT =
            registration.X_AM * registration.X_JM->inverse() * site.X_TJ.inverse();
        QVERIFY(X_AT.matrix().isApprox(registration.X_AT.matrix(), kExact));
    }

    void tellsWhereTheStylusIsOnTheAnatomy()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.touchAll(*model);
        model->fit();
        model->enter(SiteStep::Verify);
        QVERIFY(!model->stylusOnAnatomy());
        const Landmark xiphoid = site.landmarks().landmarks[1];
        site.tipAt(site.X_TA * Vec3{xiphoid.p_AQ + Vec3{0.0, -0.003, 0.004}});
        model->look();
        QCOMPARE(model->stylusOnAnatomy()->nearestLandmark, QStringLiteral("Xiphoid process"));
        QVERIFY(std::abs(model->stylusOnAnatomy()->landmark_mm - 5.0) < kExact_mm);
        QVERIFY(model->stylusOnAnatomy()->surface_mm > 10.0);
        site.m_now += std::chrono::seconds{1}; // and nothing more is seen
        model->look();
        QVERIFY(!model->stylusOnAnatomy());
    }

    void goesOnWhereItStood_data()
    {
        QTest::addColumn<int>("step");
        for (int step = 0; step < 6; ++step)
            QTest::addRow("step %d", step + 1) << step;
    }
    /// The model is dropped without a goodbye; a new one reads the file.
    void goesOnWhereItStood()
    {
        QFETCH(int, step);
        RegistrationSite site;
        auto model = site.model();
        site.touchAll(*model);
        model->fit();
        model->enter(static_cast<SiteStep>(step));
        const Site before = model->site();
        model.reset();
        model = site.model();
        QCOMPARE(model->step(), static_cast<SiteStep>(step));
        QCOMPARE(model->site().touched.size(), before.touched.size());
        QCOMPARE(model->site().stylus->calibratedAt, before.stylus->calibratedAt);
        QVERIFY(model->site().catalogue->landmarks.size() == 4);
        QVERIFY(model->site().registration->X_AT.matrix().isApprox(
            before.registration->X_AT.matrix(), kExact));
        for (int i = 0; i < 6; ++i)
            QVERIFY(model->canEnter(static_cast<SiteStep>(i)));
    }

    void goesOnInTheMiddleOfTouching()
    {
        RegistrationSite site;
        auto model = site.model();
        model->useTracker();
        site.swing(*model);
        model->acceptLandmarks();
        site.hold(*model, site.X_TA * site.landmarks().landmarks[0].p_AQ);
        model.reset();
        model = site.model();
        QCOMPARE(model->step(), SiteStep::Touch);
        QCOMPARE(model->nextLandmark(), std::optional<std::size_t>{1});
    }

    void undoesOneChangeAtATime()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.touchAll(*model);
        model->fit();
        model->undo();
        QVERIFY(!model->isDone(SiteStep::Fit));
        QCOMPARE(model->step(), SiteStep::Touch);
        model->undo();
        QCOMPARE(model->nextLandmark(), std::optional<std::size_t>{3});
        QVERIFY(RegistrationModel::siteOf(site.file(), site.patient())->touched.size() == 3);
        for (int i = 0; i < 6; ++i)
            model->undo();
        QVERIFY(!model->canUndo());
        QVERIFY(!model->isDone(SiteStep::Tracker));
    }

    void touchesOneLandmarkAgain()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.touchAll(*model);
        model->choose(2);
        QCOMPARE(model->nextLandmark(), std::optional<std::size_t>{2});
        const Vec3 p_TQ = site.X_TA * Vec3{0.07, -0.1, -0.1};
        site.hold(*model, p_TQ);
        QVERIFY(!model->nextLandmark());
        QCOMPARE(model->site().touched.size(), std::size_t{4});
        QVERIFY((model->site().touched.back().p_TQ - p_TQ).norm() < kExact);
        QCOMPARE(model->site().touched.back().landmark, site.landmarks().landmarks[2].name);
    }

    void picksALandmarkOnTheModel()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.touchAll(*model);
        model->fit();
        model->enter(SiteStep::Landmarks);
        model->pick({0.05, -1.0, 0.0}, Vec3::UnitY()); // none is chosen
        QVERIFY(model->isDone(SiteStep::Fit));
        model->choose(2);
        model->pick({5.0, -1.0, 0.0}, Vec3::UnitY()); // far beside the patient
        QVERIFY(!model->problem().isEmpty());
        QVERIFY(model->isDone(SiteStep::Fit));
        model->pick({0.05, -1.0, 0.0}, 3.0 * Vec3::UnitY()); // the front of the left lung
        QVERIFY(model->problem().isEmpty());
        const Vec3 picked = model->landmarks()[2].p_AQ;
        QVERIFY(std::abs(picked.x() - 0.05) < kExact && std::abs(picked.z()) < kExact);
        QVERIFY(picked.y() < -0.02 && picked.y() > -0.07);
        QVERIFY(!model->isDone(SiteStep::Fit));
        QCOMPARE(model->site().touched.size(), std::size_t{3}); // the others stay
        model->useBuiltinLandmarks();
        QVERIFY(model->site().catalogue == site.landmarks());
    }

    void losesNothingWhenTheFileCannotBeWritten()
    {
        RegistrationSite site;
        const auto model = site.model();
        model->useTracker();
        std::filesystem::remove(site.file());
        std::filesystem::create_directory(site.file()); // a folder in its place
        model->enter(SiteStep::Tracker);
        QVERIFY(!model->problem().isEmpty());
        QCOMPARE(model->step(), SiteStep::Tracker); // pages can be looked at
        site.swing(*model);
        QVERIFY(!model->problem().isEmpty());
        QVERIFY(!model->isDone(SiteStep::Stylus)); // nothing is done that is not kept
        QVERIFY(model->isDone(SiteStep::Tracker));
    }

    void refusesTheSiteOfAnotherPatient()
    {
        RegistrationSite site;
        const auto model = site.model();
        model->useTracker();
        Site foreign = model->site();
        foreign.catalogue = ribCageCatalogue(metres(1.7), "somebody else");
        QVERIFY(writeSiteFile(site.file(), foreign).has_value());
        QCOMPARE(RegistrationModel::siteOf(site.file(), site.patient()).error().code,
                 Errc::OtherPatient);
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
        QCOMPARE(model->tools()[0].text, QStringLiteral("visible, 60 Hz, error 0.00 mm, 9 ms old"));
        QCOMPARE(model->tools()[1].name, QStringLiteral("Chin probe"));
        site.m_tracker.m_stylus.push({.time = site.m_now, .X_FO = {}, .validity = Validity::Lost});
        QVERIFY(!model->tools()[0].isVisible);
        site.m_now += std::chrono::milliseconds{400};
        QVERIFY(!model->tools()[1].isVisible);
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestRegistrationModel)
#include "tst_registration_model.moc"
