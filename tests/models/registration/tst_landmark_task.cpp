#include "engine/geometry/mesh/surface_feature.h"
#include "engine/io/site/landmark_exchange.h"
#include "models/site/site_changes.h"
#include "tests/models/registration/registration_site.h"
#include "tests/support/test_class.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>

namespace carina::landmark_task_test
{
namespace
{

constexpr double kExact = 1e-9;      // m
constexpr double kInFile = 1e-7;     // m: what a file of six decimals of a millimetre keeps
const Vec3 kBefore{0.05, -1.0, 0.0}; // in front of the left side of the chest

struct Desk {
    RegistrationSite site;
    std::unique_ptr<RegistrationModel> model = site.model();

    Desk() { model->enter(SiteStep::Landmarks); }
    [[nodiscard]] LandmarkTask& task() const { return model->landmarkTask(); }
    [[nodiscard]] Vec3 place(std::size_t landmark) const
    {
        return task().catalogue().landmarks[landmark].p_AQ;
    }
};

/// FLE^2 / N (1 + 1/3 sum_k d_k^2 / f_k^2) at a target (Fitzpatrick, West, Maurer 1998), mm for an
/// FLE of 1 mm.
double rmsByFitzpatrick(const std::vector<Landmark>& landmarks, const Vec3& target)
{
    const double count = double(landmarks.size());
    Vec3 mean = Vec3::Zero();
    for (const Landmark& landmark : landmarks)
        mean += landmark.p_AQ / count;
    Mat3 scatter = Mat3::Zero();
    for (const Landmark& landmark : landmarks)
        scatter += (landmark.p_AQ - mean) * (landmark.p_AQ - mean).transpose() / count;
    const Eigen::SelfAdjointEigenSolver<Mat3> principal{scatter};
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
        sum += (target - mean).cross(Vec3{principal.eigenvectors().col(k)}).squaredNorm()
               / (principal.eigenvalues().sum() - principal.eigenvalues()[k]);
    return std::sqrt((1.0 + sum / 3.0) / count);
}

} // namespace

class TestLandmarkTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void offersTheRecommendedSetFirst()
    {
        const Desk desk;
        QCOMPARE(desk.task().offered().size(), std::size_t{3});
        QCOMPARE(desk.task().chosenSet(), std::optional<std::size_t>{0});
        QCOMPARE(desk.task().catalogue().landmarks.size(), std::size_t{8});
        QVERIFY(!desk.model->site().catalogue); // nobody has taken it yet
        desk.task().chooseSet(0);
        QVERIFY(!desk.model->canUndo());
    }

    void changesToAnotherSet()
    {
        Desk desk;
        desk.site.touchAll(*desk.model);
        desk.task().chooseSet(1);
        QCOMPARE(desk.task().chosenSet(), std::optional<std::size_t>{1});
        QCOMPARE(desk.model->site().catalogue->landmarks.size(), std::size_t{6});
        QCOMPARE(freshTouches(desk.model->site()).size(),
                 std::size_t{6}); // they are where they were
        desk.model->undo();
        QCOMPARE(freshTouches(desk.model->site()).size(), std::size_t{8});
    }

    /// The eighth is chosen, and an undo leaves six.
    void forgetsAChoiceThatAnUndoTakesAway()
    {
        Desk desk;
        desk.task().chooseSet(1);
        desk.task().chooseSet(0);
        desk.task().choose(7);
        desk.model->undo();
        QVERIFY(!desk.task().chosen());
        QVERIFY(!desk.model->instruction().isEmpty());
    }

    void goesOnToTouchingWithThem()
    {
        Desk desk;
        desk.task().choose(3);
        desk.task().accept();
        QCOMPARE(desk.model->step(), SiteStep::Touch);
        QVERIFY(desk.model->site().catalogue == desk.site.sets()[0]);
        QVERIFY(!desk.task().chosen());
    }

    void movesTheChosenLandmarkToAClick()
    {
        Desk desk;
        desk.task().setSnapping(false);
        desk.model->pick(kBefore, Vec3::UnitY()); // none is chosen
        QVERIFY(!desk.model->site().catalogue);
        desk.task().choose(2);
        QCOMPARE(desk.model->nextLandmark(), std::optional<std::size_t>{2});
        desk.model->pick({5.0, -1.0, 0.0}, Vec3::UnitY()); // far beside the patient
        QVERIFY(!desk.model->problem().isEmpty());
        QVERIFY(!desk.model->site().catalogue);
        desk.model->pick(kBefore, 3.0 * Vec3::UnitY()); // of whatever length
        QVERIFY(desk.model->problem().isEmpty());
        const Vec3 picked = desk.place(2);
        QVERIFY(std::abs(picked.x() - 0.05) < kExact && std::abs(picked.z()) < kExact);
        QVERIFY(picked.y() < 0.0 && picked.y() > -0.15);
        QVERIFY(!desk.task().chosenSet()); // none of those offered any more
        QVERIFY(desk.place(3) == desk.site.landmarks()[3].p_AQ);
        desk.task().chooseSet(0);
        QVERIFY(desk.task().catalogue() == desk.site.sets()[0]);
    }

    /// A click next to a bone's tip or ridge takes that: a vertex of its surface, near the click.
    void snapsToWhatAFingerFinds()
    {
        Desk desk;
        QVERIFY(desk.task().isSnapping());
        desk.task().choose(2);
        int snapped = 0;
        for (const double z : {-0.10, -0.08, -0.06, -0.04, -0.02}) {
            const Vec3 eye{0.05, -1.0, z};
            desk.task().setSnapping(false);
            desk.model->pick(eye, Vec3::UnitY());
            const Vec3 clicked = desk.place(2);
            desk.task().setSnapping(true);
            desk.model->pick(eye, Vec3::UnitY());
            const double moved = (desk.place(2) - clicked).norm();
            QVERIFY(moved <= FeatureSettings{}.radius.si);
            snapped += moved > kExact ? 1 : 0;
        }
        QVERIFY(snapped > 0);
    }

    void exportsAndImportsLandmarks_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"places.csv", "places.fcsv", "places.mrk.json"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void exportsAndImportsLandmarks()
    {
        QFETCH(QString, name);
        Desk desk;
        const auto file = desk.site.beside(qPrintable(name));
        desk.task().exportTo(file);
        QVERIFY2(desk.model->problem().isEmpty(), qPrintable(desk.model->problem()));
        desk.task().chooseSet(2);
        desk.task().choose(1);
        desk.task().importFrom(file);
        QVERIFY2(desk.model->problem().isEmpty(), qPrintable(desk.model->problem()));
        QVERIFY(!desk.task().chosen());
        const LandmarkCatalogue& imported = desk.task().catalogue();
        QCOMPARE(imported.anatomy, desk.site.patient().contentHash());
        QCOMPARE(imported.landmarks.size(), std::size_t{8});
        for (std::size_t i = 0; i < 8; ++i) {
            QCOMPARE(imported.landmarks[i].name, desk.site.landmarks()[i].name);
            QVERIFY((imported.landmarks[i].p_AQ - desk.site.landmarks()[i].p_AQ).norm() < kInFile);
        }
    }

    void changesNothingByWhatWasJustExported_data() { exportsAndImportsLandmarks_data(); }
    void changesNothingByWhatWasJustExported()
    {
        QFETCH(QString, name);
        Desk desk;
        desk.site.fitAll(*desk.model);
        desk.model->enter(SiteStep::Landmarks);
        const LandmarkCatalogue before = *desk.model->site().catalogue;
        const auto file = desk.site.beside(qPrintable(name));
        desk.task().exportTo(file);
        desk.task().importFrom(file);
        QVERIFY(!desk.model->notice().isEmpty());
        QVERIFY(desk.model->site().catalogue == before);
        QCOMPARE(freshTouches(desk.model->site()).size(), std::size_t{8});
        QVERIFY(!desk.model->site().registration->stale);
        desk.model->undo(); // the fit: there was nothing else to take back
        QVERIFY(!desk.model->site().registration);
    }

    /// Rounded to three decimals of a millimetre, and one of them moved by 0.01 mm.
    void makesOnlyTheTouchStaleWhoseLandmarkAFileMoves()
    {
        Desk desk;
        desk.site.fitAll(*desk.model);
        LandmarkCatalogue rounded = *desk.model->site().catalogue;
        for (Landmark& landmark : rounded.landmarks)
            landmark.p_AQ = 1e-6 * (1e6 * landmark.p_AQ).array().round().matrix();
        rounded.landmarks[2].p_AQ.x() += 1e-5;
        const auto file = desk.site.beside("rounded.csv");
        QVERIFY(exportLandmarks(file, rounded));
        desk.task().importFrom(file);
        QVERIFY(desk.model->site().registration->stale == StaleCause::Landmarks);
        for (std::size_t i = 0; i < 8; ++i) {
            const TouchedPoint* touch = touchOf(desk.model->site(), desk.site.landmarks()[i].name);
            QCOMPARE(touch->stale.has_value(), i == 2);
            QCOMPARE(desk.place(i) == desk.site.landmarks()[i].p_AQ, i != 2);
        }
    }

    void saysWhyAFileIsOfNoUse()
    {
        Desk desk;
        desk.task().importFrom("/nowhere/places.csv");
        QVERIFY(!desk.model->problem().isEmpty());
        QVERIFY(!desk.model->canUndo());
        desk.model->enter(SiteStep::Landmarks);
        desk.task().exportTo("/proc/none/places.csv");
        QVERIFY(!desk.model->problem().isEmpty());
    }

    void forecastsByTheFormulaOfFitzpatrick()
    {
        const Desk desk;
        const AirwayLandmarks& airway = desk.site.patient().landmarks();
        const auto forecast = desk.task().forecast();
        QCOMPARE(forecast.size(), std::size_t{5});
        QCOMPARE(forecast[0].name, QStringLiteral("Glottis"));
        const std::array targets{airway.p_A_glottis, airway.p_A_carina, airway.p_A_incisors};
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const double expected = rmsByFitzpatrick(desk.site.landmarks(), targets[i]);
            QVERIFY(std::abs(forecast[i].rms_mm / expected - 1.0) < 1e-9);
            QVERIFY(forecast[i].bound_mm >= 1.6 * forecast[i].rms_mm);
            QVERIFY(!forecast[i].weakest.isEmpty());
        }
    }

    void forecastsNothingOfALine()
    {
        Desk desk;
        LandmarkCatalogue line = desk.site.sets()[2];
        line.landmarks.resize(3);
        for (std::size_t i = 0; i < 3; ++i)
            line.landmarks[i].p_AQ = {0.0, 0.0, 0.1 * double(i)};
        const auto file = desk.site.beside("line.csv");
        QVERIFY(exportLandmarks(file, line));
        desk.task().importFrom(file);
        QVERIFY(desk.task().forecast().empty());
        QVERIFY(!desk.task().wouldHelp());
    }

    /// The one more that makes the error at the worst target least, of all that are offered.
    void namesTheLandmarkThatWouldHelp()
    {
        Desk desk;
        QVERIFY(!desk.task().wouldHelp()); // all are there
        desk.task().chooseSet(2);
        const auto help = desk.task().wouldHelp();
        QVERIFY(help.has_value());
        const auto targets = registrationTargets(desk.site.patient());
        const auto worstWith = [&targets](const std::vector<Landmark>& landmarks) {
            double worst = 0.0;
            for (const RegistrationTarget& target : targets)
                worst = std::max(worst, rmsByFitzpatrick(landmarks, target.p_A));
            return worst;
        };
        double least = worstWith(desk.site.sets()[2].landmarks);
        std::string best;
        for (std::size_t i = 4; i < 8; ++i) {
            std::vector<Landmark> with = desk.site.sets()[2].landmarks;
            with.push_back(desk.site.landmarks()[i]);
            if (worstWith(with) < least) {
                least = worstWith(with);
                best = with.back().name;
            }
        }
        QCOMPARE(help->first, QString::fromStdString(best));
        QVERIFY(std::abs(help->second - least) < 1e-9);
    }
};

CARINA_TEST(TestLandmarkTask)

} // namespace carina::landmark_task_test

#include "tst_landmark_task.moc"
