#include "models/vitals/station_vitals.h"

#include "engine/session/respiration/introduced_patient.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <algorithm>
#include <cmath>

namespace carina::station_vitals_test
{

using test::FakeSessionNode;

namespace
{

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    StationVitals vitals{session, FakeSessionNode::kStation};
    VitalsModel& model = vitals.model();

    void start() { node.decide(fact::PhaseChanged{SessionPhase::Running}); }

    void pass(double seconds)
    {
        for (double t = 0.0; t < seconds; t += 0.02) {
            node.advance(std::chrono::milliseconds{20});
            model.look();
        }
    }
};

/// How loud the right lung of a patient who breathes quietly is heard at most.
double loudestOf(const PatientBuild& build)
{
    Desk desk;
    desk.vitals.setStethoscope([] { return AuscultationGains{.right = 1.0}; });
    for (const FactBody& fact : introducedPatient(build))
        desk.node.decide(fact);
    desk.start();
    double loudest = 0.0;
    for (int i = 0; i < 60; ++i) {
        desk.pass(0.1);
        loudest = std::max(loudest, desk.model.heard().loudness.right);
    }
    return loudest;
}

} // namespace

/// From the facts of a session to the bedside monitor.
class TestStationVitals : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresNothingBeforeTheSessionRuns()
    {
        Desk desk;
        desk.pass(2.0);
        QCOMPARE(desk.model.numbers(), VitalsModel::Numbers{});
        desk.start();
        desk.pass(3.0);
        QVERIFY(desk.model.numbers().heartRate_perMin);
    }

    void showsWhatThePatientHas()
    {
        Desk desk;
        desk.start();
        desk.pass(5.0);
        RespirationFollower follower;
        const auto state = desk.node.state();
        const auto& timeline = state->stations().at(FakeSessionNode::kStation).respiration;
        const SessionTime whole = std::chrono::floor<std::chrono::seconds>(*desk.node.now());
        const Vitals vitals = follower.at(timeline, whole).vitals();
        QCOMPARE(desk.model.numbers().heartRate_perMin,
                 int(std::lround(inPerMinute(vitals.heartRate))));
        QCOMPARE(desk.model.numbers().pressure->systolic_mmHg,
                 int(std::lround(inMmHg(vitals.systolic))));
    }

    void isHeardThroughTheStethoscope()
    {
        Desk desk;
        desk.vitals.setStethoscope([] { return AuscultationGains{.right = 1.0, .left = 1.0}; });
        desk.start();
        double right = 0.0;
        double left = 0.0;
        for (int i = 0; i < 60; ++i) {
            desk.pass(0.1);
            right = std::max(right, desk.model.heard().loudness.right);
            left = std::max(left, desk.model.heard().loudness.left);
        }
        QVERIFY(desk.model.heard().isOnChest);
        QVERIFY(right > 0.05 && left > 0.05);
        QVERIFY(!desk.model.heard().wheezes);
    }

    void wheezesWithNarrowAirways_data()
    {
        QTest::addColumn<LungConditions>("conditions");
        QTest::addColumn<bool>("hasKinkedTube");
        QTest::addColumn<bool>("doesWheeze");
        const auto obstruction = [](ConditionSide side) {
            return LungConditions{{ConditionKind::Obstruction, 0.6, side}};
        };
        QTest::newRow("asthma") << LungConditions{{ConditionKind::Asthma, 0.8}} << false << true;
        QTest::newRow("the right bronchus") << obstruction(ConditionSide::Right) << false << true;
        QTest::newRow("the left one") << obstruction(ConditionSide::Left) << false << false;
        QTest::newRow("the trachea") << obstruction(ConditionSide::Both) << false << false;
        QTest::newRow("a kink and the left one")
            << obstruction(ConditionSide::Left) << true << false;
    }
    /// Over the right lung. What is above the carina sounds elsewhere.
    void wheezesWithNarrowAirways()
    {
        QFETCH(const LungConditions, conditions);
        QFETCH(const bool, hasKinkedTube);
        QFETCH(const bool, doesWheeze);
        Desk desk;
        desk.vitals.setStethoscope([] { return AuscultationGains{.right = 1.0}; });
        desk.node.decide(fact::LungConditionsSet{conditions});
        if (hasKinkedTube) {
            desk.node.decide(fact::TubePlaced{{TubeSeat::Trachea, millimetres(6.5)}});
            desk.node.decide(fact::TubeObstructed{0.5});
        }
        desk.start();
        bool wheezed = false;
        for (int i = 0; i < 60; ++i) {
            desk.pass(0.1);
            wheezed = wheezed || desk.model.heard().wheezes;
        }
        QCOMPARE(wheezed, doesWheeze);
    }

    // In an infant's lung some 60 ml/s move, and 300 in that of a grown person.
    void hearsAnInfantAsWellAsAGrownPerson()
    {
        const double grown = loudestOf({metres(1.75), 77.0, 30.0, Sex::Male});
        const double infant = loudestOf({metres(0.75), 9.0, 0.8, Sex::Female});
        QVERIFY2(infant > 0.5 * grown && infant < 2.0 * grown,
                 qPrintable(QStringLiteral("%1 and %2").arg(infant).arg(grown)));
    }

    // Only who has another age has other limits; the built-in child is twelve.
    void beginsAfreshForAnotherPatient()
    {
        Desk desk;
        const QSignalSpy afresh{&desk.model, &VitalsModel::startedAfresh};
        desk.node.decide(fact::PatientBuildSet{{metres(0.75), 9.0, 0.8, Sex::Female}});
        QCoreApplication::sendPostedEvents();
        QCOMPARE(afresh.count(), 1);
        QCOMPARE(desk.model.limits(), alarmLimits(0.8));
        const StationId another{FakeSessionNode::kStation.value + 1};
        desk.node.addStation("Station 2");
        desk.vitals.setStation(another);
        QCOMPARE(afresh.count(), 2);
        desk.vitals.setStation(another); // the same
        QCOMPARE(afresh.count(), 2);
    }
};

CARINA_TEST(TestStationVitals)

} // namespace carina::station_vitals_test

#include "tst_station_vitals.moc"
