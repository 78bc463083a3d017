#include "engine/io/site/site_file.h"
#include "models/site/site_changes.h"
#include "tests/models/registration/registration_site.h"
#include "tests/support/test_class.h"

namespace carina::registration_site_file_test
{
namespace
{

constexpr double kExact = 1e-9; // m, and as coefficients of a rotation

} // namespace

/// What a registration keeps in its file, and where it goes on.
class TestRegistrationSiteFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void goesOnWhereItStood_data()
    {
        QTest::addColumn<int>("step");
        for (int step = 0; step <= int(SiteStep::Verify); ++step)
            QTest::addRow("page %d", step + 1) << step;
    }
    /// The model is dropped without a goodbye; a new one reads the file.
    void goesOnWhereItStood()
    {
        QFETCH(int, step);
        RegistrationSite site;
        auto model = site.model();
        site.fitAll(*model);
        model->enter(static_cast<SiteStep>(step));
        const Site before = model->site();
        model.reset();
        model = site.model();
        QCOMPARE(int(model->step()), step);
        QCOMPARE(model->site().touched.size(), before.touched.size());
        QCOMPARE(model->stylus().tip()->calibratedAt, before.styluses[0].calibratedAt);
        QCOMPARE(model->site().catalogue->landmarks.size(), std::size_t{8});
        QVERIFY(model->site().registration->X_AT.matrix().isApprox(
            before.registration->X_AT.matrix(), kExact));
        QCOMPARE(model->nextStep(), SiteStep::Verify);
        QVERIFY(!model->canUndo());
    }

    void goesOnInTheMiddleOfTouching()
    {
        RegistrationSite site;
        auto model = site.model();
        site.prepare(*model);
        site.touchFirst(*model, 3);
        model.reset();
        model = site.model();
        QCOMPARE(model->step(), SiteStep::Touch);
        QCOMPARE(model->nextLandmark(), std::optional<std::size_t>{3});
        site.hold(*model, site.X_TA * site.landmarks()[3].p_AQ); // at once, without a click
        QCOMPARE(freshTouches(model->site()).size(), std::size_t{4});
    }

    void goesOnInTheMiddleOfVerifying()
    {
        RegistrationSite site;
        auto model = site.model();
        site.fitAll(*model);
        model->enter(SiteStep::Verify);
        site.hold(*model, site.X_TA * model->verifying().points()[0].p_AQ);
        model.reset();
        model = site.model();
        QCOMPARE(model->step(), SiteStep::Verify);
        QCOMPARE(model->verifying().next(), std::optional<std::size_t>{1});
        QVERIFY(model->verifying().points()[0].error_mm.has_value());
        site.hold(*model, site.X_TA * model->verifying().points()[1].p_AQ);
        QCOMPARE(model->verifying().suggestion(), Verdict::Good);
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
        model->enter(SiteStep::Stylus);
        site.swing(*model);
        QVERIFY(!model->problem().isEmpty());
        QVERIFY(!model->stylus().tip()); // nothing is done that is not kept
        QCOMPARE(model->task(SiteStep::Tracker).state, TaskState::Done);
    }

    void refusesTheSiteOfAnotherPatient()
    {
        RegistrationSite site;
        const auto model = site.model();
        model->useTracker();
        Site foreign = model->site();
        foreign.catalogue = ribCageCatalogue(metres(1.7), "somebody else");
        foreign.patient = "Somebody Else";
        QVERIFY(writeSiteFile(site.file(), foreign).has_value());
        const auto refused = RegistrationModel::siteOf(site.file(), site.patient());
        QCOMPARE(refused.error().code, Errc::OtherPatient);
        QVERIFY(refused.error().detail.find("\"Somebody Else\"") != std::string::npos);
        QVERIFY(refused.error().detail.find(site.patient().name()) != std::string::npos);
        model->importSite(QString::fromStdString(site.file().string()));
        QVERIFY(model->problem().contains(QStringLiteral("Somebody Else")));
        QVERIFY(!model->site().catalogue);
    }

    void takesOverAnotherFile()
    {
        RegistrationSite site;
        auto model = site.model();
        site.fitAll(*model);
        QCOMPARE(model->site().patient, site.patient().name());
        const QString copy = QString::fromStdString(site.beside("copy.json").string());
        model->exportSite(copy);
        QVERIFY(model->problem().isEmpty());
        model.reset();
        std::filesystem::remove(site.file());
        model = site.model();
        QVERIFY(!model->site().registration);
        model->importSite(copy);
        QCOMPARE(model->step(), SiteStep::Overview);
        QCOMPARE(model->nextStep(), SiteStep::Verify);
        QVERIFY(readSiteFile(site.file())->registration);
        model->undo();
        QVERIFY(!model->site().registration);
        model->importSite(QStringLiteral("/nowhere.json"));
        QVERIFY(!model->problem().isEmpty());
        model->exportSite(QStringLiteral("/proc/none/site.json"));
        QVERIFY(!model->problem().isEmpty());
    }

    /// A file of the first version has one stylus without a name and a fit without its error.
    void goesOnFromAFileOfTheVersionBefore()
    {
        RegistrationSite site;
        auto model = site.model();
        site.fitAll(*model);
        Site old = model->site();
        old.styluses[0].tool.clear();
        old.styluses[0].covariance_S.setZero();
        old.registration->covariance_A.setZero();
        old.registration->degrees = 0.0;
        old.registration->madeAt.clear();
        model.reset();
        QVERIFY(writeSiteFile(site.file(), old));
        model = site.model();
        QVERIFY(model->stylus().tip());
        QVERIFY(model->fitting().expected().empty());
        QCOMPARE(model->nextStep(), SiteStep::Verify);
        QVERIFY(!model->health().isEmpty());
        model->fitting().fit();
        QVERIFY(!model->fitting().expected().empty());
    }
};

CARINA_TEST(TestRegistrationSiteFile)

} // namespace carina::registration_site_file_test

#include "tst_registration_site_file.moc"
