#include "tests/models/registration/made_desk.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::fit_task_test
{
namespace
{

using namespace test;

constexpr double kExact = 1e-9; // m
constexpr Length kHand = millimetres(1.0);

/// Touches each landmark at the place of another, and insists on it.
void touchInOrder(RegistrationSite& site, RegistrationModel& model,
                  const std::vector<std::size_t>& order)
{
    site.prepare(model);
    for (std::size_t i = 0; i < order.size(); ++i) {
        model.touching().choose(i);
        site.hold(model, site.X_TA * site.landmarks()[order[i]].p_AQ);
    }
}

double errorAt(const Site& site, const RigidTransform& X_TA, const Vec3& p_AQ)
{
    return (site.registration->X_AT * (X_TA * p_AQ) - p_AQ).norm();
}

/// Places on the front of a surface, where a stylus reaches it.
std::vector<Vec3> frontOf(const std::string& name, int count)
{
    std::vector<Vec3> front;
    for (const PatientSurface& surface : RegistrationSite::patient().surfaces()) {
        const TriangleMesh& mesh = *surface.levels.front();
        for (std::size_t i = 0; surface.name == name && i < mesh.positions.size(); ++i)
            if (mesh.normals[i].y() < -0.3F)
                front.push_back(mesh.positions[i].cast<double>());
    }
    std::mt19937 random{5};
    std::shuffle(front.begin(), front.end(), random);
    front.resize(std::min(front.size(), std::size_t(count)));
    return front;
}

} // namespace

class TestFitTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsNothingToSayOfGoodTouches()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.touchAll(*model);
        QVERIFY(model->fitting().findings().isEmpty());
        QVERIFY(model->fitting().expected().empty());
        model->fitting().fit();
        QVERIFY(model->fitting().findings().isEmpty());
        QCOMPARE(model->fitting().order(), TouchOrder::AsGiven);
    }

    /// Every hand strays. Of a hundred registrations by one that strays as usual one may be
    /// questioned.
    void seldomQuestionsAGoodFit()
    {
        std::mt19937 random{41};
        int questioned = 0;
        for (int i = 0; i < 200; ++i) {
            MadeDesk desk{touchedBy(random, kHand)};
            desk.fitting.fit();
            const QStringList findings = desk.fitting.findings();
            QVERIFY(findings[0].contains(QStringLiteral("chin probe was not seen")));
            questioned += findings.size() > 1 ? 1 : 0;
        }
        QVERIFY2(questioned <= 6, qPrintable(QString::number(questioned)));
    }

    void repairsExchangedLandmarks()
    {
        RegistrationSite site;
        const auto model = site.model();
        touchInOrder(site, *model, {0, 1, 3, 2, 4, 5, 6, 7}); // right for left
        QCOMPARE(model->fitting().order(), TouchOrder::Exchanged);
        QVERIFY(model->fitting().findings()[0].contains(QStringLiteral("exchanged")));
        model->fitting().fit();
        QCOMPARE(model->fitting().order(), TouchOrder::AsGiven);
        QVERIFY(model->fitting().findings().isEmpty());
        QVERIFY(errorAt(model->site(), site.X_TA, Vec3::Zero()) < kExact);
        model->undo();
        QCOMPARE(model->fitting().order(), TouchOrder::Exchanged);
        QVERIFY(!model->site().registration);
    }

    void leavesTouchesInOrderAsTheyAre()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.touchAll(*model);
        const auto before = model->site().touched;
        model->fitting().fit();
        QCOMPARE(model->site().touched.size(), before.size());
        for (std::size_t i = 0; i < before.size(); ++i) {
            QCOMPARE(model->site().touched[i].landmark, before[i].landmark);
            QVERIFY(model->site().touched[i].p_TQ == before[i].p_TQ);
        }
    }

    void namesALandmarkThatWasTouchedElsewhere_data()
    {
        QTest::addColumn<int>("landmark");
        for (int i = 0; i < 8; ++i)
            QTest::newRow(eightLandmarks().landmarks[std::size_t(i)].name.c_str()) << i;
    }
    void namesALandmarkThatWasTouchedElsewhere()
    {
        QFETCH(int, landmark);
        std::mt19937 random{unsigned(7 + landmark)};
        const Landmark wrong = eightLandmarks().landmarks[std::size_t(landmark)];
        const Vec3 off_A = 0.015 * anyError(random, metres(1.0)).normalized();
        MadeDesk desk{withTouch(touchedBy(random, kHand), wrong.name, touchAt(wrong.p_AQ, off_A))};
        desk.fitting.fit();
        const QString findings = desk.fitting.findings().join(QLatin1Char('\n'));
        for (const Landmark& each : eightLandmarks().landmarks)
            QVERIFY2(findings.contains(QString::fromStdString(each.name))
                         == (each.name == wrong.name),
                     qPrintable(findings));
    }

    /// A manikin 3 % larger: said with what to do about it, instead of a landmark that would stand
    /// out or an order that explains nothing.
    void saysThatTheManikinIsLargerThanThePatient_data()
    {
        QTest::addColumn<double>("size");
        QTest::addColumn<QString>("said");
        QTest::newRow("larger") << 1.03 << QStringLiteral("about 3\u00a0% larger");
        QTest::newRow("smaller") << 0.96 << QStringLiteral("about 4\u00a0% smaller");
    }
    void saysThatTheManikinIsLargerThanThePatient()
    {
        QFETCH(double, size);
        QFETCH(QString, said);
        std::mt19937 random{11};
        int found = 0;
        for (int i = 0; i < 20; ++i) {
            Site site = preparedSite();
            for (const Landmark& landmark : eightLandmarks().landmarks)
                site = withTouch(std::move(site), landmark.name,
                                 touchAt(size * landmark.p_AQ, anyError(random, kHand)));
            MadeDesk desk{site};
            desk.fitting.fit();
            QVERIFY(desk.editor.site().registration.has_value());
            const QStringList findings = desk.fitting.findings();
            found += findings[0].contains(said) ? 1 : 0;
            const QString all = findings.join(QLatin1Char('\n'));
            QVERIFY2(!all.contains(QStringLiteral("No order")), qPrintable(all));
        }
        QVERIFY2(found >= 18, qPrintable(QString::number(found)));
    }

    /// Its landmarks can be touched: none is taken for another or refused.
    void saysSoAfterALargerManikinWasTouched()
    {
        RegistrationSite site;
        site.m_hand = kHand;
        const auto model = site.model();
        site.prepare(*model);
        for (const Landmark& landmark : site.landmarks())
            site.hold(*model, site.X_TA * Vec3{1.03 * landmark.p_AQ});
        QVERIFY2(!model->touching().next(), qPrintable(model->problem()));
        model->fitting().fit();
        QVERIFY(model->site().registration.has_value());
        const QString first = model->fitting().findings().value(0);
        QVERIFY2(first.contains(QStringLiteral("larger than the patient")), qPrintable(first));
    }

    /// Earlier registrations by the same person sharpen the estimate of the error of a touch; the
    /// same touches, fitted again, do not.
    void estimatesTheErrorOfATouchFromEarlierRegistrationsToo()
    {
        std::mt19937 random{12};
        MadeDesk desk{touchedBy(random, kHand)};
        desk.fitting.fit();
        QCOMPARE(desk.fitting.localisation()->pooled, 0);
        QVERIFY(desk.fitting.localisationText().endsWith(QStringLiteral("from these touches.")));
        const double alone = desk.fitting.localisation()->limit / desk.fitting.localisation()->rms;
        desk.fitting.fit();
        QCOMPARE(desk.fitting.localisation()->pooled, 0);
        QCOMPARE(desk.editor.site().localisations.size(), std::size_t{1});
        const LandmarkCatalogue catalogue = eightLandmarks();
        const auto touchAgain = [&](Length hand, std::size_t count) {
            Site site = desk.editor.site();
            for (std::size_t i = 0; i < count; ++i) {
                const Landmark& landmark = catalogue.landmarks[i];
                site = withTouch(std::move(site), landmark.name,
                                 touchAt(landmark.p_AQ, anyError(random, hand)));
            }
            desk.editor.become(site);
            desk.fitting.fit();
        };
        touchAgain(kHand, 7); // one touch is in both
        QCOMPARE(desk.fitting.localisation()->pooled, 0);
        QCOMPARE(desk.editor.site().localisations.size(), std::size_t{1});
        touchAgain(kHand, 8);
        QCOMPARE(desk.fitting.localisation()->pooled, 1);
        QCOMPARE(desk.editor.site().registration->degrees, 36.0);
        QVERIFY(desk.fitting.localisation()->limit / desk.fitting.localisation()->rms < alone);
        touchAgain(kHand, 8);
        QCOMPARE(desk.fitting.localisation()->pooled, 2);
        QVERIFY(desk.fitting.localisationText().contains(QStringLiteral("2 earlier")));
        touchAgain(millimetres(6.0), 8);
        QCOMPARE(desk.fitting.localisation()->pooled, 0);
        QCOMPARE(desk.fitting.localisation()->disagreeing, 3);
        QVERIFY(desk.fitting.localisationText().contains(QStringLiteral("not used")));
    }

    void poolsOnlyRegistrationsByTheSamePerson()
    {
        std::mt19937 random{13};
        Site site = touchedBy(random, kHand);
        for (const char* name : {"A. Frei", "M. Keller", ""}) {
            site.operatorName = name;
            for (const Landmark& landmark : eightLandmarks().landmarks)
                site = withTouch(std::move(site), landmark.name,
                                 touchAt(landmark.p_AQ, anyError(random, kHand)));
            site = withFit(std::move(site), {.tool = kTool, .at = "2004-03-27T10:15:00Z"}).value();
            QCOMPARE(site.registration->pooled, 0);
        }
        QCOMPARE(site.localisations.size(), std::size_t{3});
    }

    /// Who touches some landmarks again, of those that another person touched, leaves the other's
    /// estimate as it is; who touches all of them gets one.
    void keepsTheEstimateOfWhoeverTouchedTheOthers()
    {
        std::mt19937 random{14};
        Site site = touchedBy(random, kHand);
        const auto fitBy = [&](const char* name, std::size_t from, std::size_t to) {
            site.operatorName = name;
            for (std::size_t i = from; i < to; ++i) {
                const Landmark& landmark = eightLandmarks().landmarks[i];
                site = withTouch(std::move(site), landmark.name,
                                 touchAt(landmark.p_AQ, anyError(random, kHand)));
            }
            site = withFit(std::move(site), {.tool = kTool, .at = "2004-03-27T10:15:00Z"}).value();
        };
        fitBy("A. Frei", 0, 8);
        const double first = site.localisations.back().rms;
        fitBy("M. Keller", 0, 2);
        QCOMPARE(site.localisations.size(), std::size_t{1});
        QCOMPARE(site.localisations.back().operatorName, std::string{"A. Frei"});
        QCOMPARE(site.localisations.back().rms, first);
        QVERIFY(site.registration->fle != first); // of the touches that were fitted
        fitBy("M. Keller", 2, 8);
        QCOMPARE(site.localisations.size(), std::size_t{2});
        QCOMPARE(site.localisations.back().operatorName, std::string{"M. Keller"});
        QCOMPARE(site.registration->pooled, 0);
        fitBy("A. Frei", 0, 8);
        QCOMPARE(site.registration->pooled, 1);
        QCOMPARE(site.localisations.front().rms, first);
    }

    /// A name that is given after the fit replaces nobody's.
    void givesAnEstimateOfNobodyAName()
    {
        std::mt19937 random{15};
        Site site = touchedBy(random, kHand);
        for (const char* name : {"", "A. Frei"}) {
            site.operatorName = name;
            site = withFit(std::move(site), {.tool = kTool, .at = "2004-03-27T10:15:00Z"}).value();
            QCOMPARE(site.localisations.size(), std::size_t{1});
            QCOMPARE(site.localisations.front().operatorName, std::string{name});
        }
    }

    void tellsWhatToExpectWhereItCounts()
    {
        std::mt19937 random{3};
        MadeDesk desk{touchedBy(random, kHand)};
        desk.fitting.fit();
        const auto expected = desk.fitting.expected();
        QCOMPARE(expected.size(), std::size_t{5});
        for (const ExpectedError& error : expected) {
            QVERIFY(error.rms_mm > 0.1 && error.rms_mm < 2.0);
            QVERIFY(error.bound_mm > 1.6 * error.rms_mm && error.bound_mm < 2.5 * error.rms_mm);
        }
    }

    void saysWhyItCannotFit()
    {
        MadeDesk desk{touchedSite(2)};
        desk.fitting.fit();
        QVERIFY(!desk.editor.problem().isEmpty());
        QVERIFY(!desk.editor.site().registration);
        desk.fitting.startSwab(); // there is nothing to refine
        QVERIFY(!desk.fitting.isSwabbing());
    }

    void saysWhyASwabIsOfNoUse()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.fitAll(*model);
        model->enter(SiteStep::Fit);
        const Site before = model->site();
        model->fitting().startSwab();
        QVERIFY(model->fitting().isSwabbing());
        site.hold(*model, site.X_TA * Vec3{0.0, -0.2, 0.0}); // at one point
        QCOMPARE(model->fitting().swabPoints(), std::size_t{1});
        model->fitting().refine(model->fitting().swabSurfaces()[0]);
        QVERIFY(!model->problem().isEmpty());
        QVERIFY(!model->fitting().isSwabbing());
        QVERIFY(!model->site().registration->swab);
        model->fitting().startSwab();
        model->fitting().cancelSwab();
        QCOMPARE(model->fitting().swabPoints(), std::size_t{0});
    }

    /// All landmarks were touched 3 mm too deep. The bone itself tells better.
    void refinesOnABone()
    {
        RegistrationSite site;
        const auto model = site.model();
        site.prepare(*model);
        for (const Landmark& landmark : site.landmarks())
            site.hold(*model, site.X_TA * Vec3{landmark.p_AQ + Vec3{0.0, 0.003, 0.0}});
        model->fitting().fit();
        model->enter(SiteStep::Fit);
        const Vec3 glottis = site.patient().landmarks().p_A_glottis;
        const double before = errorAt(model->site(), site.X_TA, glottis);
        QVERIFY(std::abs(before - 0.003) < kExact);
        const Mat6 covariance = model->site().registration->covariance_A;
        const QStringList surfaces = model->fitting().swabSurfaces();
        const auto bone = std::ranges::find_if(surfaces, [](const QString& name) {
            return name.contains(QStringLiteral("sternum"), Qt::CaseInsensitive);
        });
        QVERIFY2(bone != surfaces.end(), qPrintable(surfaces.join(QStringLiteral(", "))));
        model->fitting().startSwab();
        for (const Vec3& p_AQ : frontOf(bone->toStdString(), 150)) {
            site.tipAt(site.X_TA * p_AQ);
            model->look();
        }
        QVERIFY(model->fitting().swabPoints() > FitTask::kFewestPoints);
        model->fitting().refine(*bone);
        QVERIFY2(model->problem().isEmpty(), qPrintable(model->problem()));
        const double after = errorAt(model->site(), site.X_TA, glottis);
        qInfo("error at the glottis %.2f mm before the swab, %.2f mm after", before * 1e3,
              after * 1e3);
        QVERIFY(after < 0.5 * before);
        const SiteSwab& swab = *model->site().registration->swab;
        QVERIFY(swab.rms < 0.1 * swab.startRms);
        QVERIFY(pointCovariance(model->site().registration->covariance_A, glottis).trace()
                < pointCovariance(covariance, glottis).trace());
    }
};

CARINA_TEST(TestFitTask)

} // namespace carina::fit_task_test

#include "tst_fit_task.moc"
