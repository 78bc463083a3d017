#include "apps/program/played_intubation.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/tracking/simulated/scripted_hands.h"
#include "models/intubation/intubation_watch.h"
#include "models/patient/patient_source.h"
#include "models/tracker/played_hands.h"
#include "models/vitals/stethoscope.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::program::played_intubation_test
{
namespace
{

using test::FakeSessionNode;
using namespace std::chrono_literals;

const PatientModel& boy()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return *made;
}

/// A trainee's program that plays, and the monitor that watches its poses.
struct Played {
    explicit Played(MotionKind kind) : motion{playOf({.kind = kind})(boy()).value()}
    {
        node.decide(fact::ObjectShared{
            {}, FakeSessionNode::kTrainee, ObjectKind::Laryngoscope, motion.laryngoscope});
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        watch.lieIn(boy());
    }

    PlayedMotion motion;
    FakeSessionNode node{FakeSessionNode::kTrainee};
    PlayedHands hands{node, motion};
    IntubationWatch watch{
        node, FakeSessionNode::kStation, {.at = [this](ObjectKind kind, SessionTime t) {
            return poseOf(kind, t);
        }}};

    [[nodiscard]] std::optional<PoseSample> poseOf(ObjectKind kind, SessionTime t) const
    {
        const HandledTools held = hands.at(t);
        switch (kind) {
        case ObjectKind::Tube:
            return PoseSample{.time = t, .X_FO = held.X_UE};
        case ObjectKind::Laryngoscope:
            return PoseSample{.time = t, .X_FO = held.X_UL};
        case ObjectKind::Jaw:
            return PoseSample{.time = t, .X_FO = held.X_UJ};
        default:
            return std::nullopt;
        }
    }
    void goOn(Duration time)
    {
        const SessionTime until = *node.now() + time;
        while (*node.now() < until) {
            node.advance(20ms);
            hands.look(FakeSessionNode::kStation);
            watch.look();
        }
    }
    [[nodiscard]] bool isNoted(IntubationStep step) const
    {
        const auto state = node.state();
        const auto& station = state->stations().at(FakeSessionNode::kStation);
        return std::ranges::any_of(
            station.respiration.tube().notes(),
            [step](const NotedStep& note) { return note.event.step == step; });
    }
};

} // namespace

/// Motions of evaluation/intubation as a simulated tracker plays them.
class TestPlayedIntubation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsItsWordsAmongThoseOfTheTracker()
    {
        const auto said = simulatedWordsIn(
            QStringLiteral("rate=30,intubation=right_mainstem,seed=7,after=2.5,hidden=head"));
        QVERIFY2(said, said ? "" : said.error().detail.c_str());
        const PlayedIntubation wanted{MotionKind::RightMainstem, 7, 2500ms};
        QVERIFY(said->played == wanted);
        QCOMPARE(said->others, QStringLiteral("rate=30,hidden=head"));
        const auto none = simulatedWordsIn(QStringLiteral("rate=30"));
        QVERIFY(none && !none->played);
        QCOMPARE(none->others, QStringLiteral("rate=30"));
    }

    void knowsEveryScriptByName()
    {
        for (const NamedMotion& motion : kNamedMotions) {
            const QString name = QString::fromStdString(std::string{motion.name});
            const auto said = simulatedWordsIn(QStringLiteral("intubation=") + name);
            QVERIFY2(said && said->played && said->played->kind == motion.kind, motion.name.data());
        }
    }

    void refusesWhatItDoesNotKnow()
    {
        for (const char* words : {"intubation=perfect", "intubation=", "seed=3", "after=3",
                                  "intubation=good,seed=-1", "intubation=good,after=601"}) {
            const auto said = simulatedWordsIn(QString::fromLatin1(words));
            QVERIFY2(!said, words);
            QCOMPARE(said.error().code, Errc::WrongOption);
        }
    }

    void waitsBeforeItBegins()
    {
        const PlayedMotion soon = playOf({})(boy()).value();
        const PlayedMotion later = playOf({.after = 10s})(boy()).value();
        const Vec3 p_U_start = soon.at(0s).X_UL.translation();
        QCOMPARE(later.at(0s).X_UL.translation(), p_U_start);
        QCOMPARE(later.at(10s).X_UL.translation(), p_U_start);
        QCOMPARE(later.at(15s).X_UL.translation(), soon.at(5s).X_UL.translation());
        QVERIFY((soon.at(5s).X_UL.translation() - p_U_start).norm() > 0.05); // m: on its way
        QCOMPARE(later.controls.front().at - soon.controls.front().at, Duration{10s});
    }

    void staysWhereItEnded()
    {
        const PlayedMotion motion = playOf({})(boy()).value();
        const Vec3 p = motion.at(300s).X_UE * boy().tube().p_E_tip;
        QCOMPARE((motion.at(3000s).X_UE * boy().tube().p_E_tip).eval(), p);
        const Vec3 p_A_place = boy().tube().X_AE * boy().tube().p_E_tip;
        QVERIFY((p - p_A_place).norm() < 0.02); // m: in the trachea, about as deep as usual
    }

    /// Nothing before the cuff is inflated, then stomach, left and right lung, and nothing again.
    void listensToTheChest()
    {
        const PlayedMotion motion = playOf({.after = 10s})(boy()).value();
        const auto inflated =
            std::ranges::find_if(motion.controls, [](const PlayedMotion::Control& control) {
                return std::holds_alternative<fact::CuffSet>(control.body);
            });
        const ChestSites sites{boy()};
        std::vector<std::string> heard;
        for (Duration t = 0s; t < inflated->at + 60s; t += 100ms) {
            const auto gains = sites.heardAt(motion.at(t).X_AS->translation());
            std::string most;
            for (const auto& [name, gain] : {std::pair{"stomach", gains.stomach},
                                             {"left", gains.left},
                                             {"right", gains.right}})
                if (gain > 0.95)
                    most = name;
            QVERIFY(most.empty() || t > inflated->at);
            if (heard.empty() || heard.back() != most)
                heard.push_back(most);
        }
        QCOMPARE(heard, (std::vector<std::string>{"", "stomach", "", "left", "", "right", ""}));
    }

    void listensWhereItsTrackerSeesIt()
    {
        const RigidTransform X_TA = patientBeforeTracker(boy().landmarks().p_A_incisors);
        const PlayedMotion motion = playOf({})(boy()).value();
        for (Duration t = 0s; t < 90s; t += 500ms) {
            const Vec3 p_T = X_TA * motion.at(t).X_AS->translation();
            QVERIFY2(WorkingVolume{}.contains(p_T), qPrintable(QStringLiteral("%1 s: %2 %3 %4")
                                                                   .arg(toSeconds(t))
                                                                   .arg(p_T.x())
                                                                   .arg(p_T.y())
                                                                   .arg(p_T.z())));
        }
    }

    void isToldByTheMonitor_data()
    {
        QTest::addColumn<MotionKind>("kind");
        QTest::addColumn<TubeSeat>("seat");
        QTest::newRow("good") << MotionKind::Good << TubeSeat::Trachea;
        QTest::newRow("oesophageal") << MotionKind::Oesophageal << TubeSeat::Oesophagus;
        QTest::newRow("right_mainstem") << MotionKind::RightMainstem << TubeSeat::RightMain;
    }
    void isToldByTheMonitor()
    {
        QFETCH(const MotionKind, kind);
        QFETCH(const TubeSeat, seat);
        Played played{kind};
        played.goOn(played.motion.controls.back().at + 3s);
        QCOMPARE(played.watch.course().seat, seat);
        for (const IntubationStep step :
             {IntubationStep::BladeIn, IntubationStep::TubePastTeeth, IntubationStep::StyletOut,
              IntubationStep::BladeOut, IntubationStep::CuffInflated})
            QVERIFY2(played.isNoted(step), qPrintable(QString::number(int(step))));
        QCOMPARE(played.isNoted(IntubationStep::InOesophagus), seat == TubeSeat::Oesophagus);
        QCOMPARE(played.isNoted(IntubationStep::PastCarina), seat == TubeSeat::RightMain);
    }
};

CARINA_TEST(TestPlayedIntubation)

} // namespace carina::program::played_intubation_test

#include "tst_played_intubation.moc"
