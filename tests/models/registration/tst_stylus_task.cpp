#include "tests/models/registration/registration_site.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <functional>

namespace carina::stylus_task_test
{
namespace
{

constexpr double kExact = 1e-9; // m, and of a direction
const Vec3 kDivot{0.1, 0.0, -1.0};
const Vec3 kShaft_S = Vec3{0.05, -0.1, -0.99}.normalized(); // of the stylus, towards its tip

using Turn = std::function<Quat(double)>; ///< after so many seconds

/// The stylus with its tip in the divot, for so long.
void move(RegistrationSite& site, RegistrationModel& model, double seconds, const Turn& turn)
{
    for (int i = 0; i < 60.0 * seconds; ++i) {
        site.tipAt(kDivot, turn(i / 60.0));
        model.look();
    }
}

const Turn kAtRest = [](double) { return Quat::Identity(); };
const Turn kNodding = [](double t) {
    return rotationFromVector({degrees(30.0).si * std::sin(3.0 * t), 0.0, 0.0});
};

/// To and fro about the shaft, by this much to either side.
Turn spinning(Angle reach)
{
    return [reach](double t) {
        return rotationFromVector(Vec3{reach.si * std::sin(2.0 * t) * kShaft_S});
    };
}

struct Desk {
    RegistrationSite site;
    std::unique_ptr<RegistrationModel> model = site.model();
    QSignalSpy told{model.get(), &RegistrationModel::told};

    Desk() { model->useTracker(); }
    void calibrate() { site.swing(*model); }
    [[nodiscard]] StylusTask& stylus() const { return model->stylus(); }
};

} // namespace

class TestStylusTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beginsAndEndsByItself()
    {
        Desk desk;
        QVERIFY(desk.stylus().isLookingForTip());
        move(desk.site, *desk.model, 3.0, kAtRest);
        QCOMPARE(desk.stylus().pivot().stage, PivotStage::Waiting);
        desk.calibrate();
        QVERIFY(!desk.stylus().isLookingForTip());
        const StylusTip& tip = *desk.stylus().tip();
        QVERIFY((tip.p_SQ - desk.site.p_SQ).norm() < kExact);
        QVERIFY(tip.poses > 100);
        QCOMPARE(tip.outliers, 0);
        QCOMPARE(desk.told.count(), 1);
        desk.site.swingFor(*desk.model, 600); // nothing more is taken
        QCOMPARE(desk.told.count(), 1);
    }

    void knowsHowUncertainTheTipIs()
    {
        Desk desk;
        desk.site.m_noise = millimetres(0.35);
        desk.calibrate();
        const StylusTip& tip = *desk.stylus().tip();
        const double rms = std::sqrt(tip.covariance_S.trace());
        QVERIFY(rms > 0.01e-3 && rms <= 0.15e-3);
        QVERIFY((tip.p_SQ - desk.site.p_SQ).norm() < 3.0 * rms);
        QVERIFY(tip.rms > 0.2e-3 && tip.rms < 0.5e-3);
    }

    void saysWhatIsMissing_data()
    {
        QTest::addColumn<Turn>("turn");
        QTest::addColumn<PivotNeed>("need");
        QTest::addColumn<QString>("word");
        QTest::newRow("at rest") << kAtRest << PivotNeed::Swing << QStringLiteral("divot");
        QTest::newRow("about one axis")
            << kNodding << PivotNeed::Directions << QStringLiteral("other direction");
        QTest::newRow("too little") << Turn{[](double t) {
            return rotationFromVector(
                Vec3{degrees(5.5).si * Vec3{std::cos(3.0 * t), std::sin(3.0 * t), 0.0}});
        }} << PivotNeed::Motion << QStringLiteral("further");
    }
    void saysWhatIsMissing()
    {
        QFETCH(Turn, turn);
        QFETCH(PivotNeed, need);
        QFETCH(QString, word);
        Desk desk;
        desk.site.m_noise = millimetres(0.35);
        move(desk.site, *desk.model, 6.0, turn);
        QCOMPARE(desk.stylus().pivot().need, need);
        QVERIFY2(desk.model->instruction().contains(word), qPrintable(desk.model->instruction()));
        QVERIFY(!desk.stylus().tip());
    }

    void stopsAndBeginsAgainWhenItIsTold()
    {
        Desk desk;
        desk.site.swingFor(*desk.model, 150);
        desk.stylus().stop();
        QVERIFY(!desk.stylus().isLookingForTip());
        desk.stylus().findTip();
        QCOMPARE(desk.stylus().pivot().poses, 0);
        desk.calibrate();
        QVERIFY(desk.stylus().tip());
    }

    void looksForATipOnlyOnItsPage()
    {
        Desk desk;
        desk.model->enter(SiteStep::Landmarks);
        QVERIFY(!desk.stylus().isLookingForTip());
        desk.model->enter(SiteStep::Stylus);
        QVERIFY(desk.stylus().isLookingForTip());
        desk.calibrate();
        desk.model->enter(SiteStep::Landmarks);
        desk.model->enter(SiteStep::Stylus);
        QVERIFY(!desk.stylus().isLookingForTip()); // it is known
    }

    /// A bent stylus: its old tip is good until the new one is found.
    void keepsTheOldTipUntilANewOneIsFound()
    {
        Desk desk;
        desk.calibrate();
        desk.site.m_today = desk.site.m_today.addDays(1);
        desk.stylus().findTip();
        desk.site.swingFor(*desk.model, 100);
        QCOMPARE(desk.stylus().tip()->calibratedAt, std::string{"2004-03-27T10:15:00Z"});
        desk.calibrate();
        QCOMPARE(desk.stylus().tip()->calibratedAt, std::string{"2004-03-28T10:15:00Z"});
        QCOMPARE(desk.model->site().styluses.size(), std::size_t{1});
        desk.model->undo();
        QCOMPARE(desk.stylus().tip()->calibratedAt, std::string{"2004-03-27T10:15:00Z"});
    }

    void findsTheAxisBySpinning()
    {
        Desk desk;
        desk.calibrate();
        desk.stylus().findAxis();
        QVERIFY(desk.stylus().isSpinning());
        move(desk.site, *desk.model, 3.0, spinning(degrees(100.0)));
        QVERIFY(std::abs(desk.model->progress() - 0.5) < 0.01);
        move(desk.site, *desk.model, 3.1, spinning(degrees(100.0)));
        QVERIFY(!desk.stylus().isSpinning());
        QVERIFY(desk.model->problem().isEmpty());
        QVERIFY((desk.stylus().tip()->axis->axis_S - kShaft_S).norm() < 1e-6);
        QCOMPARE(desk.told.count(), 2);
    }

    void saysWhyASpinTellsNoAxis()
    {
        Desk desk;
        desk.calibrate();
        desk.stylus().findAxis();
        move(desk.site, *desk.model, 6.2, spinning(degrees(10.0)));
        QVERIFY(!desk.stylus().isSpinning());
        QVERIFY(!desk.model->problem().isEmpty());
        QVERIFY(!desk.stylus().tip()->axis);
        desk.stylus().findAxis();
        move(desk.site, *desk.model, 6.2, spinning(degrees(100.0)));
        QVERIFY(desk.model->problem().isEmpty());
        QVERIFY(desk.stylus().tip()->axis.has_value());
    }
};

CARINA_TEST(TestStylusTask)

} // namespace carina::stylus_task_test

#include "tst_stylus_task.moc"
