#include "models/registration/manikin_task.h"

#include "engine/anatomy/airway/airway_measure.h"
#include "tests/models/registration/touch_desk.h"
#include "tests/support/test_class.h"

#include <QFile>

namespace carina::manikin_task_test
{
namespace
{

constexpr double kExact = 1e-9; // m

/// A fitted manikin whose airway the patient's is, or is not.
struct FittedDesk : test::Desk {
    FittedDesk()
    {
        register_();
        model->enter(SiteStep::Overview);
    }
    [[nodiscard]] ManikinTask& task() { return model->manikin(); }
    void touchAirway(AirwayPlace place, const Vec3& off_A = Vec3::Zero())
    {
        site.hold(*model, site.X_TA * Vec3{*task().placeInPatient(place) + off_A});
    }
    void touchWholeAirway(const Vec3& off_A = Vec3::Zero())
    {
        task().beginTouch();
        for (const AirwayPlace place : kAirwayPlaces)
            touchAirway(place, off_A);
    }
    [[nodiscard]] QString said() { return task().comparison().join(QLatin1Char('\n')); }
    [[nodiscard]] QByteArray bytes() const
    {
        QFile file{QString::fromStdString(site.file().string())};
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
    }
    void write(const char* name, const QByteArray& text) const
    {
        QFile file{QString::fromStdString(site.beside(name).string())};
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }
};

} // namespace

/// The child's airway is 232 mm from teeth to carina (0.12 of 150 cm, and 5.2 cm).
class TestManikinTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysThatNothingIsKnown()
    {
        FittedDesk desk;
        QVERIFY(desk.said().contains(QStringLiteral("is not known")));
    }

    void saysByWhatTubeDepthDiffers()
    {
        FittedDesk desk;
        desk.task().setMeasured(millimetres(245.0));
        QVERIFY2(desk.said().contains(QStringLiteral(
                     "manikin 245 mm (measured with a tube), patient 232 mm. A tube at the "
                     "patient's carina ends 13 mm above the manikin's.")),
                 qPrintable(desk.said()));
        QVERIFY(desk.said().contains(
            QStringLiteral("of that length: \"12 years, 150 cm, boy, airway 245 mm\"")));
        desk.task().setMeasured(millimetres(236.0));
        QVERIFY(!desk.said().contains(QStringLiteral("of that length")));
        desk.task().setMeasured(millimetres(300.0));
        QVERIFY(desk.said().contains(QStringLiteral("choose another height or age")));
        desk.task().setMeasured(std::nullopt);
        QVERIFY(desk.said().contains(QStringLiteral("is not known")));
    }

    /// The site's patient is the child; the second profile is of an adult's size, the first of a
    /// child's.
    void saysThatTheManikinIsOfAnotherPatientsSize()
    {
        FittedDesk desk;
        desk.task().choose(1);
        QVERIFY2(desk.said().contains(QStringLiteral("another patient: \"adult\"")),
                 qPrintable(desk.said()));
        QVERIFY(desk.said().contains(QStringLiteral("is not known")));
        desk.task().choose(0);
        QVERIFY(!desk.said().contains(QStringLiteral("another patient")));
    }

    void manikinIsKeptAndUndone()
    {
        FittedDesk desk;
        desk.task().choose(2);
        desk.task().setMeasured(millimetres(245.0));
        const auto again = desk.site.model();
        QCOMPARE(again->manikin().chosen(), std::optional<std::size_t>{2});
        QCOMPARE(again->manikin().measured(), std::optional{millimetres(245.0)});
        desk.model->undo();
        desk.model->undo();
        QVERIFY(!desk.task().chosen() && !desk.task().measured());
        desk.task().choose(0);
        desk.task().choose(std::nullopt);
        QVERIFY(!desk.bytes().contains("\"manikin\""));
    }

    void landmarksOfTheManikinAreTakenWhileNoneIsTouched()
    {
        test::Desk fresh;
        fresh.model->manikin().choose(0);
        QCOMPARE(fresh.model->landmarkTask().catalogue().landmarks.size(), 4U);
        QCOMPARE(fresh.model->landmarkTask().catalogue(), RegistrationSite::sets().back());
        FittedDesk fitted;
        fitted.task().choose(0);
        QCOMPARE(fitted.model->landmarkTask().catalogue().landmarks.size(), 8U);
        QVERIFY(!fitted.model->site().registration->stale);
    }

    void profileOfAFileIsOfferedAndUsed()
    {
        FittedDesk desk;
        desk.write("head.json", R"({"schema": "carina.manikin/1", "name": "Our head",
            "teeth_to_carina": {"mm": 222, "source": "its maker"}})");
        desk.task().importFrom(desk.site.beside("head.json"));
        QCOMPARE(desk.task().offered().size(), builtinManikins().size() + 1);
        QCOMPARE(desk.task().chosen(), std::optional{builtinManikins().size()});
        QVERIFY(desk.said().contains(QStringLiteral("manikin 222 mm (its maker)")));
        QVERIFY(desk.said().contains(
            QStringLiteral("A tube at the manikin's carina ends 10 mm above")));
        desk.write("faulty.json", R"({"schema": "carina.manikin/1"})");
        desk.task().importFrom(desk.site.beside("faulty.json"));
        QVERIFY(desk.model->problem().contains(QStringLiteral("name: a text is expected")));
        desk.write("nobody.json", R"({"schema": "carina.manikin/1", "name": "x",
            "patient": "giant", "patient_source": "x"})");
        desk.task().importFrom(desk.site.beside("nobody.json"));
        QVERIFY(desk.model->problem().contains(QStringLiteral("'giant'")));
        QVERIFY(desk.said().contains(QStringLiteral("its maker")));
    }

    void airwayIsTouchedInTheManikinsFrame()
    {
        FittedDesk desk;
        desk.touchWholeAirway();
        QVERIFY(!desk.task().isTouching());
        for (const AirwayPlace place : kAirwayPlaces) {
            const auto p_A = desk.task().placeInManikin(place);
            QVERIFY(p_A && (*p_A - *desk.task().placeInPatient(place)).norm() < kExact);
        }
        QVERIFY2(
            desk.said().contains(QStringLiteral(
                "manikin 232 mm (from the places touched), patient 232 mm. Tube depths agree.")),
            qPrintable(desk.said()));
        // It goes with the manikin when that is moved.
        desk.model->touching().beginRelay();
        desk.touchChosen({0, 2, 7}, test::pushed(desk.site.X_TA));
        QVERIFY(!desk.model->touching().isRelaying());
        for (const AirwayPlace place : kAirwayPlaces)
            QVERIFY((*desk.task().placeInManikin(place) - *desk.task().placeInPatient(place)).norm()
                    < kExact);
    }

    void saysWhereTheAirwayIsFarthestFromThePatients()
    {
        FittedDesk desk;
        desk.task().beginTouch();
        desk.touchAirway(AirwayPlace::Incisors);
        desk.task().skip();
        desk.touchAirway(AirwayPlace::Glottis, {0.009, 0.0, 0.0});
        QVERIFY(desk.task().isTouching());
        desk.touchAirway(AirwayPlace::Carina, {0.004, 0.0, 0.0});
        // To the left of a path in the middle plane: by the whole of it.
        QVERIFY2(desk.said().contains(QStringLiteral("Between the vocal cords, 9 mm.")),
                 qPrintable(desk.said()));
    }

    void endsAloneGiveTheStraightLength()
    {
        FittedDesk desk;
        desk.task().beginTouch();
        desk.touchAirway(AirwayPlace::Incisors);
        desk.task().skip();
        desk.task().skip();
        desk.touchAirway(AirwayPlace::Carina);
        const AirwayLandmarks& airway = RegistrationSite::patient().landmarks();
        const QString straight =
            QString::number(std::lround(1000.0 * (airway.p_A_incisors - airway.p_A_carina).norm()));
        QVERIFY2(
            desk.said().contains(
                QStringLiteral("in a straight line: manikin %1 mm, patient %1 mm").arg(straight)),
            qPrintable(desk.said()));
    }

    void airwayOfTheFitBeforeIsTouchedAgain()
    {
        FittedDesk desk;
        desk.touchWholeAirway();
        desk.site.m_today = desk.site.m_today.addSecs(60);
        desk.model->fitting().fit();
        QVERIFY(desk.task().isStale());
        QVERIFY(!desk.task().placeInManikin(AirwayPlace::Carina));
        QVERIFY(desk.said().contains(QStringLiteral("touch it again")));
        desk.model->enter(SiteStep::Overview);
        desk.task().beginTouch();
        desk.touchAirway(AirwayPlace::Incisors);
        QCOMPARE(desk.model->site().manikin.airway.size(), 1U);
        QVERIFY(!desk.task().isStale());
    }

    void airwayIsNotTouchedBeforeAFit()
    {
        test::Desk desk;
        desk.model->enter(SiteStep::Overview);
        desk.model->manikin().beginTouch();
        QVERIFY(!desk.model->manikin().isTouching());
        QVERIFY(desk.model->problem().contains(QStringLiteral("Fit the patient first")));
    }

    void leavingThePageEndsTouching()
    {
        FittedDesk desk;
        desk.task().beginTouch();
        QVERIFY(desk.model->instruction().contains(QStringLiteral("Edge of the upper incisors")));
        QCOMPARE(desk.model->places().size(), kAirwayPlaces.size());
        desk.model->enter(SiteStep::Verify);
        desk.model->enter(SiteStep::Overview);
        QVERIFY(!desk.task().isTouching());
        desk.touchAirway(AirwayPlace::Incisors);
        QVERIFY(desk.model->site().manikin.airway.empty());
    }
};

CARINA_TEST(TestManikinTask)

} // namespace carina::manikin_task_test

#include "tst_manikin_task.moc"
