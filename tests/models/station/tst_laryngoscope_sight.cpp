#include "models/station/laryngoscope_sight.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/rotation.h"
#include "models/patient/patient_source.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <array>
#include <random>
#include <set>

namespace carina::laryngoscope_sight_test
{
namespace
{

using test::FakeSessionNode;
using namespace std::chrono_literals;

constexpr SessionTime kNow{1000s};
constexpr ParticipantId kTom = FakeSessionNode::kTrainee; ///< at work
constexpr ParticipantId kTess{4};
constexpr ObjectId kFirst{2}; ///< of the laryngoscopes
constexpr ObjectId kSecond{3};
constexpr double kFloat_m = 1e-6;
constexpr double kSeen_m = 1e-4; ///< that a swelling moves tissue at least

const PatientModel& patient()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return *made;
}

LaryngoscopyPose poseIn(LaryngoscopyStep step)
{
    return Laryngoscopy::of(patient(), bladeOf(BladeKind::Macintosh3))->pose(step, kUsualLift);
}

/// Tom is at work; he or both have a laryngoscope under this name.
struct Station {
    explicit Station(const char* name = "Laryngoscope", ParticipantId owner = kTom)
    {
        node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tess"});
        node.decide(fact::ObjectShared{{}, owner, ObjectKind::Laryngoscope, name});
    }
    FakeSessionNode node;
    StationView view{node, FakeSessionNode::kStation, patient().lungs()};
    StationLaryngoscope laryngoscope{patient()};

    LaryngoscopeSight at(SessionTime t, const RigidTransform& X_AJ = {})
    {
        return laryngoscope.at(view.at(t, 0), patient().throat(X_AJ));
    }
};

/// How far forward the tip of the epiglottis is tilted.
double tilt_mm(const LaryngoscopeSight& sight)
{
    const auto airway = Laryngoscopy::of(patient(), sight.blade)->script().airway;
    const UpperAirway moved = followed(airway, sight.throat);
    const Vec3 d = larynxTilt<double>(sight.tissue.frame(), moved.p_A_epiglottisTip).d;
    return 1e3 * d.dot(moved.forward_A());
}

/// How far the cords are apart between their processes, as drawn while no blade moves them.
double widthAt(Station& station, SessionTime t, std::optional<double> inspiration)
{
    StationMoment moment = station.view.at(t, 0);
    for (PersonPose& person : moment.people)
        person.pose.validity = Validity::Tracked; // it stays in view
    moment.inspiration = inspiration;
    const AirwayFrame<double> frame = station.laryngoscope.changesAt(moment).frame();
    const auto airway =
        Laryngoscopy::of(patient(), bladeOf(BladeKind::Macintosh3))->script().airway;
    const Vec3 right_A = airway.up_A.cross(airway.forward_A());
    const Vec3 p_A_middle =
        airway.p_A_commissure + 0.6 * (airway.p_A_notch - airway.p_A_commissure);
    const Vec3 p_A_edge = p_A_middle + 0.1 * airway.glottis().si * right_A;
    const Vec3 moved = p_A_edge + airwayPull(frame, AirwayTissue::Larynx, p_A_edge).d;
    return (moved - p_A_middle).dot(right_A);
}

} // namespace

class TestLaryngoscopeSight : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasTheBladeWhereItIsTracked()
    {
        Station station;
        const LaryngoscopyPose lifted = poseIn(LaryngoscopyStep::Full);
        station.node.sees(kFirst, lifted.X_AL, kNow);
        const LaryngoscopeSight sight = station.at(kNow, lifted.X_AJ);
        QCOMPARE(sight.state, LaryngoscopeState::Live);
        QVERIFY((sight.X_AL.translation() - lifted.X_AL.translation()).norm() < kFloat_m);
        QVERIFY(sight.tissue.isThere());
        QVERIFY(tilt_mm(sight) > 5.0);
    }

    void movesNothingFromFarAway()
    {
        Station station;
        station.node.sees(kFirst, RigidTransform::translation({0.0, -0.5, 0.5}), kNow);
        const LaryngoscopeSight sight = station.at(kNow);
        QCOMPARE(sight.state, LaryngoscopeState::Outside);
        QVERIFY(tilt_mm(sight) < 1e-3);
        const Vec3 tongue =
            0.5 * (patient().landmarks().p_A_incisors + patient().landmarks().p_A_glottis);
        QVERIFY(bladePush<double>(sight.tissue.frame(), tongue).d.norm() < 1e-4);
    }

    void isInTheMouthInEveryStep()
    {
        for (const LaryngoscopyStep step : kLaryngoscopySteps) {
            Station station;
            const LaryngoscopyPose pose = poseIn(step);
            station.node.sees(kFirst, pose.X_AL, kNow);
            QCOMPARE(station.at(kNow, pose.X_AJ).state, LaryngoscopeState::Live);
        }
    }

    void isNotInTheMouthElsewhere_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("half a metre in front") << 0.0 << -0.5;
        QTest::newRow("beside the neck on the left") << 0.08 << 0.0;
        QTest::newRow("beside the neck on the right") << -0.08 << 0.0;
        QTest::newRow("at the back of the neck") << 0.0 << 0.1;
    }
    /// Moved from where its tip is in the vallecula.
    void isNotInTheMouthElsewhere()
    {
        QFETCH(const double, x);
        QFETCH(const double, y);
        Station station;
        const LaryngoscopyPose pose = poseIn(LaryngoscopyStep::Full);
        station.node.sees(kFirst, RigidTransform::translation({x, y, 0.0}) * pose.X_AL, kNow);
        QCOMPARE(station.at(kNow, pose.X_AJ).state, LaryngoscopeState::Outside);
    }

    void saysThatThereIsNone()
    {
        Station station;
        QCOMPARE(station.at(kNow).state, LaryngoscopeState::None); // it was never seen
        QVERIFY(!station.at(kNow).tissue.isThere());
    }

    /// No sample for longer than can be predicted.
    void doesNotTakeAStalePoseForALiveOne()
    {
        Station station;
        station.node.sees(kFirst, poseIn(LaryngoscopyStep::Full).X_AL, kNow);
        QCOMPARE(station.at(kNow + 100ms).state, LaryngoscopeState::Live);
        const LaryngoscopeSight stale = station.at(kNow + 1s);
        QCOMPARE(stale.state, LaryngoscopeState::Lost);
        QVERIFY(!stale.tissue.isThere());
    }

    void needsThePatientInItsPlace()
    {
        Station station;
        station.node.sees(kFirst, poseIn(LaryngoscopyStep::Full).X_AL, kNow);
        StationMoment moment = station.view.at(kNow, 0);
        moment.patient.emplace().acted = {RigidTransform::translation({0.2, 0.0, 0.0}), 1.0};
        const auto sight = station.laryngoscope.at(moment, patient().throat(std::nullopt));
        QCOMPARE(sight.state, LaryngoscopeState::Away);
        QVERIFY(!sight.tissue.isThere());
    }

    void needsALarynx()
    {
        Anatomy anatomy = builtinPatient(BuiltinPatient::TwelveYears).value();
        std::erase_if(anatomy.parts,
                      [](const AnatomyPart& part) { return part.role == PartRole::Epiglottis; });
        const SharedPatientModel without = patientOf(std::move(anatomy)).value();
        Station station;
        station.node.sees(kFirst, poseIn(LaryngoscopyStep::Full).X_AL, kNow);
        station.laryngoscope.lieIn(*without);
        QCOMPARE(station.at(kNow).state, LaryngoscopeState::NoLarynx);
        station.laryngoscope.lieIn(patient());
        QCOMPARE(station.at(kNow).state, LaryngoscopeState::Live);
    }

    /// Also where nobody has a laryngoscope; a set without a larynx stays as it is.
    void changesTheAirwayByItsEvents()
    {
        FakeSessionNode node;
        const StationView view{node, FakeSessionNode::kStation, patient().lungs()};
        StationLaryngoscope laryngoscope{patient()};
        QVERIFY(!laryngoscope.changesAt(view.at(kNow, 0)).isThere());
        node.decide(fact::AirwayEventsSet{{{AirwayEventKind::TongueOedema, 1.0}}, 10s});
        const SessionTime effect = kNow + kShortestLead;
        QVERIFY(!laryngoscope.changesAt(view.at(effect, 0)).isThere());
        QVERIFY(laryngoscope.changesAt(view.at(effect + 5s, 0)).isThere());
        Anatomy anatomy = builtinPatient(BuiltinPatient::TwelveYears).value();
        std::erase_if(anatomy.parts,
                      [](const AnatomyPart& part) { return part.role == PartRole::Epiglottis; });
        const SharedPatientModel without = patientOf(std::move(anatomy)).value();
        laryngoscope.lieIn(*without);
        QVERIFY(!laryngoscope.changesAt(view.at(effect + 5s, 0)).isThere());
    }

    /// As long as the event is there.
    void seesThePlacesOfTheChangedAirway()
    {
        Station station;
        const LaryngoscopyPose lifted = poseIn(LaryngoscopyStep::Full);
        station.node.sees(kFirst, lifted.X_AL, kNow);
        const auto glottisNow = [&] {
            const LaryngoscopeSight sight = station.at(kNow, lifted.X_AJ);
            return station.laryngoscope.glottisAt(sight.throat, sight.tissue);
        };
        const GlotticLine healthy = glottisNow();
        Laryngoscopy swollen = Laryngoscopy::of(patient(), bladeOf(kUsualBlade)).value();
        const AirwayEvents events{{AirwayEventKind::LaryngealOedema, 1.0}};
        swollen.changeAirway(events);
        StationMoment moment = station.view.at(kNow, 0);
        moment.airwayEvents = events;
        const FollowingThroat throat = patient().throat(lifted.X_AJ);
        const LaryngoscopeSight sight = station.laryngoscope.at(moment, throat);
        const GlotticLine seen = station.laryngoscope.glottisAt(throat, sight.tissue);
        const GlotticLine expected =
            swollen.glottisAt(throat, swollen.tissueAt(sight.X_AL, throat));
        QVERIFY((seen.p_A_notch - expected.p_A_notch).norm() < kFloat_m);
        QVERIFY((seen.p_A_notch - healthy.p_A_notch).norm() > kSeen_m);
        QVERIFY((glottisNow().p_A_notch - healthy.p_A_notch).norm() < kFloat_m); // it has gone
    }

    /// Tissue and glottis are of the throat of the moment, whatever was seen before.
    void worksInAHeadAsItLies()
    {
        Station station;
        Laryngoscopy laid = Laryngoscopy::of(patient(), bladeOf(kUsualBlade)).value();
        laid.layHead(kSniffing);
        const LaryngoscopyPose lifted = laid.pose(LaryngoscopyStep::Full, kUsualLift);
        station.node.sees(kFirst, lifted.X_AL, kNow);
        const StationMoment moment = station.view.at(kNow, 0);
        const LaryngoscopeSight neutral =
            station.laryngoscope.at(moment, patient().throat(lifted.X_AJ));
        const GlotticLine before = station.laryngoscope.glottisAt(neutral.throat, neutral.tissue);
        const FollowingThroat throat = patient().throat(lifted.X_AJ, kSniffing);
        const LaryngoscopeSight sight = station.laryngoscope.at(moment, throat);
        QCOMPARE(sight.state, LaryngoscopeState::Live);
        const GlotticLine seen = station.laryngoscope.glottisAt(sight.throat, sight.tissue);
        const GlotticLine expected = laid.glottisAt(lifted);
        QVERIFY((seen.p_A_notch - expected.p_A_notch).norm() < kSeen_m);
        QVERIFY((seen.p_A_commissure - expected.p_A_commissure).norm() < kSeen_m);
        QVERIFY((before.p_A_notch - expected.p_A_notch).norm() > 10.0 * kSeen_m);
    }

    /// The teeth are where the head takes them, and it lies otherwise in each frame.
    void seesLeveringWhileTheHeadMoves()
    {
        constexpr int kTipped_deg = 14;
        const Angle most = degrees(1.0);
        Station station;
        Laryngoscopy scope = Laryngoscopy::of(patient(), bladeOf(kUsualBlade)).value();
        SessionTime t = kNow;
        BladeEffort effort;
        for (int tipped_deg = 0; tipped_deg <= kTipped_deg; ++tipped_deg, t += 20ms) {
            const HeadPosition head{{}, double(tipped_deg) / kTipped_deg * most};
            scope.layHead(head);
            const LaryngoscopyPose pose =
                scope.leveredPose(LaryngoscopyStep::Full, degrees(tipped_deg));
            station.node.sees(kFirst, pose.X_AL, t);
            const FollowingThroat throat = patient().throat(pose.X_AJ, head);
            effort = station.laryngoscope.at(station.view.at(t, 0), throat).effort;
        }
        QCOMPARE(effort.handling, BladeHandling::Levering);
        QVERIFY(effort.leveringShare > kLeversFrom);
        QVERIFY(inNewtons(effort.teeth) > 5.0);
    }

    /// As a rigid body, from one frame to the next.
    void goesOnLeveringInAHeadThatTakesTheBladeAlong()
    {
        constexpr int kTipped_deg = 14;
        constexpr double kShare = 1e-3;
        Station station;
        const auto scope = Laryngoscopy::of(patient(), bladeOf(kUsualBlade)).value();
        SessionTime t = kNow;
        const auto effortAt = [&](int tipped_deg, const HeadPosition& head) {
            const LaryngoscopyPose pose =
                scope.leveredPose(LaryngoscopyStep::Full, degrees(tipped_deg));
            t += 20ms;
            station.node.sees(kFirst, patient().neck(head).X_AU() * pose.X_AL, t);
            return station.laryngoscope.at(station.view.at(t, 0), patient().throat(pose.X_AJ, head))
                .effort;
        };
        BladeEffort levered;
        for (int tipped_deg = 0; tipped_deg <= kTipped_deg; ++tipped_deg)
            levered = effortAt(tipped_deg, {});
        QCOMPARE(levered.handling, BladeHandling::Levering);
        const BladeEffort laidAnew = effortAt(kTipped_deg, {{}, degrees(1.0)});
        QCOMPARE(laidAnew.handling, BladeHandling::Levering);
        QVERIFY(std::abs(laidAnew.leveringShare - levered.leveringShare) < kShare);
        QVERIFY(inNewtons(laidAnew.teeth) > 5.0);
    }

    /// Wider with the patient's inspiration than with expiration, by what was seen in people.
    void partsTheCordsWithEachBreath()
    {
        Station station;
        station.node.sees(kFirst, poseIn(LaryngoscopyStep::Full).X_AL, kNow);
        QVERIFY(station.view.at(kNow, 0).inspiration.has_value());
        const double made_m = widthAt(station, kNow, std::nullopt);
        const double inspired_m = widthAt(station, kNow + 1s, 1.0);
        const double expired_m = widthAt(station, kNow + 2s, 0.0);
        QVERIFY(std::abs(inspired_m / made_m - 10.1 / 9.0) < 0.01);
        QVERIFY(std::abs(expired_m / made_m - 5.7 / 9.0) < 0.01);
    }

    void letsNoCordJumpWhereABreathEnds()
    {
        Station station;
        station.node.sees(kFirst, poseIn(LaryngoscopyStep::Full).X_AL, kNow);
        const double expired_m = widthAt(station, kNow, 0.0);
        const double next_m = widthAt(station, kNow + 16ms, std::nullopt);
        QVERIFY(next_m > expired_m);
        QVERIFY(next_m - expired_m < 0.13 * expired_m);
        QVERIFY(widthAt(station, kNow + kCordsGo, std::nullopt) > 1.5 * expired_m);
    }

    void movesNoCordsThatNobodySees()
    {
        Station station;
        QVERIFY(!station.laryngoscope.changesAt(station.view.at(kNow, 0)).isThere());
    }

    void takesThatOfWhoIsAtWork()
    {
        Station station{"Laryngoscope", kTess};
        station.node.decide(fact::ObjectShared{{}, kTom, ObjectKind::Laryngoscope, "Laryngoscope"});
        const RigidTransform X_AL_tess = RigidTransform::translation({0.1, 0.0, 0.2});
        const RigidTransform X_AL_tom = RigidTransform::translation({-0.1, 0.0, 0.2});
        station.node.sees(kFirst, X_AL_tess, kNow);
        QVERIFY(station.at(kNow).X_AL.translation().x() > 0.0); // he has not shown his yet
        station.node.sees(kSecond, X_AL_tom, kNow);
        QVERIFY(station.at(kNow).X_AL.translation().x() < 0.0);
    }

    /// One tool can have been shared under the names of several blades.
    void takesTheOneThatIsSeen()
    {
        Station station{"Laryngoscope macintosh-4"};
        station.node.decide(
            fact::ObjectShared{{}, kTom, ObjectKind::Laryngoscope, "Laryngoscope miller-2"});
        station.node.sees(kFirst, {}, kNow);
        QCOMPARE(std::string{station.at(kNow).blade.name}, std::string{"macintosh-4"});
        station.node.sees(kSecond, {}, kNow + 5s);
        QCOMPARE(std::string{station.at(kNow + 5s).blade.name}, std::string{"miller-2"});
    }

    void hasTheBladeOfItsName_data()
    {
        QTest::addColumn<std::string>("name");
        QTest::addColumn<std::string>("blade");
        QTest::newRow("as this program names it")
            << std::string{"Laryngoscope macintosh-4"} << std::string{"macintosh-4"};
        QTest::newRow("as a person does")
            << std::string{"Blade Miller 2"} << std::string{"miller-2"};
        QTest::newRow("one of a kind")
            << std::string{"hyperangulated"} << std::string{"hyperangulated"};
        QTest::newRow("none") << std::string{"Laryngoscope"} << std::string{"macintosh-3"};
    }
    void hasTheBladeOfItsName()
    {
        QFETCH(const std::string, name);
        QFETCH(const std::string, blade);
        Station station{name.c_str()};
        station.node.sees(kFirst, {}, kNow);
        QCOMPARE(std::string{station.at(kNow).blade.name}, blade);
    }

    /// A straight one, 155 mm long: it lifts the epiglottis itself.
    void hasTheOwnBladeAsItWasTouched()
    {
        const Blade touched = touchedBlade({.heelWidth = millimetres(13.0),
                                            .handle = millimetres(150.0),
                                            .p_L_tip = {0.0, 0.004, -0.155},
                                            .p_L_half = {0.0, 0.0, -0.0775}});
        QCOMPARE(touched.lift, EpiglottisLift::Direct);
        QCOMPARE(touched.form.reach, 0.155);
        QVERIFY(std::abs(touched.form.sag - 0.002) < 1e-6); // measured across the line to the tip
        Station station;
        station.node.sees(kFirst, {}, kNow);
        station.laryngoscope.takeOwnBlade(touched);
        QCOMPARE(station.at(kNow).blade.form.reach, bladeOf(kUsualBlade).form.reach); // of another
        PersonPose own;
        own.kind = ObjectKind::Laryngoscope;
        own.isOwn = true;
        QCOMPARE(station.laryngoscope.bladeOf(own).form, touched.form);
    }

    void saysInOneSentenceWhatToDo()
    {
        std::set<QString> told;
        for (const LaryngoscopeState state :
             {LaryngoscopeState::None, LaryngoscopeState::Lost, LaryngoscopeState::Away,
              LaryngoscopeState::NoLarynx, LaryngoscopeState::Outside}) {
            const QString text = laryngoscopeText(state);
            QVERIFY(text.endsWith(QLatin1Char{'.'}));
            QCOMPARE(text.count(QLatin1Char{'.'}), 1);
            told.insert(text);
        }
        QCOMPARE(told.size(), 5U);
        QVERIFY(laryngoscopeText(LaryngoscopeState::Live).isEmpty());
    }

    void gradesThatOfWhoIsAtWork()
    {
        const LaryngoscopyPose lifted = poseIn(LaryngoscopyStep::Full);
        const GlotticView view{.opening = 0.43, .grade = CormackLehane::Grade2a};
        Station toms{"macintosh-3", kTom};
        toms.node.sees(kFirst, lifted.X_AL, kNow);
        const LaryngoscopeSight graded = toms.at(kNow, lifted.X_AJ);
        QVERIFY(graded.isGraded());
        const QString effort = bladeEffortText(graded.effort);
        QCOMPARE(laryngoscopeText(graded, view),
                 QStringLiteral("Grade 2a · 43 % of the glottis\n") + effort);
        QCOMPARE(laryngoscopeText(graded, GlotticView{}),
                 QStringLiteral("Grade 4 · 0 % of the glottis\n") + effort);
        Station hers{"macintosh-3", kTess}; // he has none
        hers.node.sees(kFirst, lifted.X_AL, kNow);
        const LaryngoscopeSight shown = hers.at(kNow, lifted.X_AJ);
        QCOMPARE(shown.state, LaryngoscopeState::Live);
        QVERIFY(!shown.isGraded());
        QCOMPARE(laryngoscopeText(shown, view),
                 QStringLiteral("Only the laryngoscope of whoever is at work is graded."));
    }

    void saysWhyThereIsNoGrade()
    {
        const LaryngoscopyPose lifted = poseIn(LaryngoscopyStep::Full);
        Station station{"macintosh-3"};
        station.node.sees(kFirst, lifted.X_AL, kNow);
        const LaryngoscopeSight sight = station.at(kNow, lifted.X_AJ);
        const GlotticView hidden{.underTube = 0.6};
        const GlotticView outside{.empty = 0.7};
        std::set<QString> told;
        for (const auto& read :
             {std::optional<GlotticView>{}, std::optional{hidden}, std::optional{outside}}) {
            const QStringList lines = laryngoscopeText(sight, read).split(QLatin1Char{'\n'});
            QCOMPARE(lines.mid(1).join(QLatin1Char{'\n'}), bladeEffortText(sight.effort));
            QVERIFY(lines.front().startsWith(QStringLiteral("No grade")));
            QVERIFY(lines.front().endsWith(QLatin1Char{'.'}));
            told.insert(lines.front());
        }
        QCOMPARE(told.size(), 3U);
        QVERIFY(laryngoscopeText(sight, hidden).contains(QStringLiteral("tube")));
    }

    /// The mouth is drawn as in the surfaces then, while the blade holds it open.
    void gradesNothingWhileTheJawIsLost()
    {
        const LaryngoscopyPose lifted = poseIn(LaryngoscopyStep::Full);
        Station station{"macintosh-3"};
        station.node.sees(kFirst, lifted.X_AL, kNow);
        StationMoment moment = station.view.at(kNow, 0);
        const FollowingThroat throat = patient().throat(lifted.X_AJ);
        moment.jaw.emplace();
        moment.jaw->validity = Validity::Tracked;
        QVERIFY(station.laryngoscope.at(moment, throat).isGraded());
        moment.jaw->validity = Validity::Lost;
        const LaryngoscopeSight lost = station.laryngoscope.at(moment, throat);
        QCOMPARE(lost.state, LaryngoscopeState::Live);
        QVERIFY(!lost.isGraded());
        const QString text = laryngoscopeText(lost, GlotticView{});
        QVERIFY(text.contains(QStringLiteral("chin probe")));
        QCOMPARE(text.count(QLatin1Char{'.'}), 1);
        moment.jaw.reset(); // no probe: the mouth stays so, and whoever looks knows it
        QVERIFY(station.laryngoscope.at(moment, throat).isGraded());
    }

    /// As one that fell off, or whose trainee sends anything: the mouth is as in the surfaces.
    void takesNoJawThatIsAstray()
    {
        constexpr int kJaws = 60;
        Station station{"macintosh-3"};
        station.node.decide(fact::ObjectShared{{}, kTom, ObjectKind::Jaw, "Chin"});
        station.node.sees(kFirst, poseIn(LaryngoscopyStep::Full).X_AL, kNow);
        const FollowingThroat held = patient().throat(std::nullopt);
        std::mt19937 random{24};
        std::uniform_real_distribution<double> share{-1.0, 1.0};
        const auto vector = [&] { return Vec3{share(random), share(random), share(random)}; };
        int astray = 0;
        for (int n = 0; n < kJaws; ++n) {
            const SessionTime t = kNow + n * 10ms;
            const RigidTransform X_AJ =
                n == 0 ? RigidTransform::translation({0.0, 0.0, -0.5})
                       : RigidTransform{rotationFromVector(vector()), 0.5 * vector()};
            station.node.sees(kFirst, poseIn(LaryngoscopyStep::Full).X_AL, t);
            station.node.sees(kSecond, X_AJ, t);
            const StationMoment moment = station.view.at(t, 0);
            QVERIFY(moment.jaw.has_value());
            const FollowingThroat throat = throatAt(moment, patient());
            const LaryngoscopeSight sight = station.laryngoscope.at(moment, throat);
            QVERIFY(sight.tissue.isThere());
            QVERIFY(sight.tissue.frame().tilt.allFinite());
            if (sight.jaw != JawSight::Astray)
                continue;
            ++astray;
            QVERIFY(!sight.isGraded());
            QCOMPARE((throat.X_AJ.translation() - held.X_AJ.translation()).norm(), 0.0);
        }
        QVERIFY(astray > kJaws / 2);
    }

    void saysThatAJawIsAstray()
    {
        const LaryngoscopyPose lifted = poseIn(LaryngoscopyStep::Full);
        Station station{"macintosh-3"};
        station.node.sees(kFirst, lifted.X_AL, kNow);
        StationMoment moment = station.view.at(kNow, 0);
        moment.jaw = PoseSample{.X_FO = lifted.X_AJ};
        QCOMPARE(jawSightAt(moment, patient()), JawSight::Seen);
        moment.jaw->X_FO = RigidTransform::translation({0.0, 0.0, -0.5});
        const LaryngoscopeSight sight =
            station.laryngoscope.at(moment, throatAt(moment, patient()));
        QCOMPARE(sight.jaw, JawSight::Astray);
        const QString text = laryngoscopeText(sight, GlotticView{});
        QVERIFY(text.contains(QStringLiteral("where no jaw can be")));
        QCOMPARE(text.count(QLatin1Char{'.'}), 1);
    }

    void saysWhichBladeItTakes()
    {
        const LaryngoscopyPose lifted = poseIn(LaryngoscopyStep::Full);
        Station station{"Laryngoscope"};
        station.node.sees(kFirst, lifted.X_AL, kNow);
        const LaryngoscopeSight sight = station.at(kNow, lifted.X_AJ);
        QVERIFY(!sight.isBladeKnown);
        const QString told =
            bladeEffortText(sight.effort) + QStringLiteral("\nBlade taken as Macintosh 3");
        QVERIFY(laryngoscopeText(sight, std::nullopt).endsWith(told));
        QCOMPARE(laryngoscopeText(sight, GlotticView{}),
                 QStringLiteral("Grade 4 · 0 % of the glottis\n") + told);
    }

    void saysWhatTheBladeDoes()
    {
        BladeEffort effort{.contact = {.teethClearance = millimetres(4.2), .tongue = newtons(37.8)},
                           .handling = BladeHandling::Lifting};
        QCOMPARE(bladeEffortText(effort),
                 QStringLiteral("Lifting · tongue about 38 N (estimate) · epiglottis not touched\n"
                                "Teeth free (4 mm)"));
        effort.handling = BladeHandling::Levering;
        effort.isOnTeeth = true;
        effort.teeth = newtons(12.3);
        QCOMPARE(bladeEffortText(effort),
                 QStringLiteral("Levering · tongue about 38 N (estimate) · epiglottis not touched\n"
                                "▲ Teeth pressed: about 12 N (estimate)"));
        effort.teeth = kMostForce;
        effort.contact.epiglottis = newtons(37.8);
        QCOMPARE(bladeEffortText(effort),
                 QStringLiteral(
                     "Levering · tongue about 38 N (estimate) · epiglottis about 38 N (estimate)\n"
                     "▲ Teeth pressed: over 100 N (estimate)"));
        QCOMPARE(
            bladeEffortText({}),
            QStringLiteral("Not lifting · tongue about 0 N (estimate) · epiglottis not touched\n"
                           "Teeth free"));
    }

    void warnsEarlierOfLooseTeeth_data()
    {
        QTest::addColumn<double>("clearance_mm");
        QTest::addColumn<double>("looseTeeth");
        QTest::addColumn<QString>("expected");
        QTest::newRow("firm") << 2.0 << 0.0 << QStringLiteral("Teeth free (2 mm)");
        QTest::newRow("near") << 2.0 << 1.0 << QStringLiteral("▲ Loose teeth near (2.0 mm)");
        QTest::newRow("far") << 4.26 << 1.0 << QStringLiteral("Loose teeth free (4.3 mm)");
        QTest::newRow("farther") << 7.3 << 1.0 << QStringLiteral("Loose teeth free (7 mm)");
        QTest::newRow("not so loose") << 2.0 << 0.5 << QStringLiteral("Loose teeth free (2.0 mm)");
        QTest::newRow("not so loose, near")
            << 1.4 << 0.5 << QStringLiteral("▲ Loose teeth near (1.4 mm)");
    }

    void warnsEarlierOfLooseTeeth()
    {
        QFETCH(double, clearance_mm);
        QFETCH(double, looseTeeth);
        QFETCH(QString, expected);
        BladeEffort effort{.contact = {.teethClearance = millimetres(clearance_mm)}};
        const UpperTeeth teeth = upperTeeth(effort.contact, looseTeeth, UpperTeeth::Loose);
        const auto line = [&] {
            return bladeEffortText(effort, teeth).section(QLatin1Char{'\n'}, 1);
        };
        QCOMPARE(line(), expected);
        const QString called =
            looseTeeth > 0.0 ? QStringLiteral("Loose teeth") : QStringLiteral("Teeth");
        effort.isOnTeeth = true;
        QCOMPARE(line(), QStringLiteral("▲ %1 touched").arg(called));
        effort.teeth = newtons(12.3);
        QCOMPARE(line(), QStringLiteral("▲ %1 pressed: about 12 N (estimate)").arg(called));
    }

    /// Half a millimetre of noise ends no warning.
    void warnsOfLooseTeethUntilTheyAreClearlyLeft()
    {
        UpperTeeth teeth = UpperTeeth::Loose;
        const auto isNearAt = [&teeth](double clearance_mm) {
            teeth = upperTeeth({.teethClearance = millimetres(clearance_mm)}, 1.0, teeth);
            return teeth == UpperTeeth::LooseAndNear;
        };
        QVERIFY(!isNearAt(3.4));
        QVERIFY(!isNearAt(3.1));
        QVERIFY(isNearAt(2.9));
        QVERIFY(isNearAt(3.4));
        QVERIFY(!isNearAt(3.6));
        QVERIFY(!isNearAt(3.4));
        QVERIFY(isNearAt(2.9));
        QCOMPARE(upperTeeth({}, 1.0, teeth), UpperTeeth::Loose); // away from them
        QCOMPARE(upperTeeth({.teethClearance = millimetres(2.0)}, 0.0, teeth), UpperTeeth::Firm);
    }

    /// Tipped back by an angle at which the blade comes near, and on from there.
    void remembersThatABladeIsNearLooseTeeth()
    {
        const auto scope = Laryngoscopy::of(patient(), bladeOf(BladeKind::Macintosh3)).value();
        Station station{"macintosh-3"};
        SessionTime t = kNow;
        const auto sightAt = [&](double tipped_deg) {
            const LaryngoscopyPose pose =
                scope.leveredPose(LaryngoscopyStep::Full, degrees(tipped_deg));
            t += 20ms;
            station.node.sees(kFirst, pose.X_AL, t);
            StationMoment moment = station.view.at(t, 0);
            moment.airwayEvents = {{AirwayEventKind::FragileTeeth, 1.0}};
            return station.laryngoscope.at(moment, patient().throat(pose.X_AJ));
        };
        double deg = 0.0;
        while (deg < 20.0 && sightAt(deg).teeth != UpperTeeth::LooseAndNear)
            deg += 0.2;
        QVERIFY(deg > 0.2 && deg < 20.0);
        const LaryngoscopeSight back = sightAt(deg - 0.2);
        QVERIFY(back.effort.contact.teethClearance > kNearLooseTeeth);
        QCOMPARE(back.teeth, UpperTeeth::LooseAndNear);
        QVERIFY(laryngoscopeText(back, std::nullopt).contains(QStringLiteral("Loose teeth near")));
    }

    void callsTeethLooseByTheEvent()
    {
        const LaryngoscopyPose lifted = poseIn(LaryngoscopyStep::Full);
        Station station{"macintosh-3"};
        station.node.sees(kFirst, lifted.X_AL, kNow);
        QCOMPARE(station.at(kNow, lifted.X_AJ).looseTeeth, 0.0);
        StationMoment moment = station.view.at(kNow, 0);
        moment.airwayEvents = {{AirwayEventKind::FragileTeeth, 0.5}};
        const LaryngoscopeSight sight =
            station.laryngoscope.at(moment, patient().throat(lifted.X_AJ));
        QCOMPARE(sight.looseTeeth, 0.5);
        QVERIFY(laryngoscopeText(sight, std::nullopt).contains(QStringLiteral("Loose teeth")));
    }

    void hasWhatLiesInTheThroat()
    {
        const LaryngoscopyPose lifted = poseIn(LaryngoscopyStep::Full);
        Station station{"macintosh-3"};
        station.node.sees(kFirst, lifted.X_AL, kNow);
        StationMoment moment = station.view.at(kNow, 0);
        const FollowingThroat throat = patient().throat(lifted.X_AJ);
        const auto contents = [&](const AirwayEvents& events) {
            moment.airwayEvents = events;
            const BladeField tissue = station.laryngoscope.at(moment, throat).tissue;
            return station.laryngoscope.contentsIn(moment, throat, tissue);
        };
        QVERIFY(contents({}).empty());
        const AirwayEvents both{{AirwayEventKind::Blood, 0.5}, {AirwayEventKind::ForeignBody, 1.0}};
        const auto found = contents(both);
        QCOMPARE(found.size(), 3U);
        const auto airway =
            Laryngoscopy::of(patient(), bladeOf(BladeKind::Macintosh3))->script().airway;
        QVERIFY(found[0].p_AF == fluidsIn(airway, both).front().p_AF);       // stays level
        const Vec3 lift = found[2].p_AF - foreignBodyIn(airway, both)->p_AF; // with the larynx
        QVERIFY(lift.dot(airway.forward_A()) > 2e-3);
        const Vec3 tilt = found[1].p_AF - valleculaFluidsIn(airway, both).front().p_AF;
        QVERIFY(found[1].place == ContentPlace::Vallecula && tilt.dot(airway.forward_A()) > 2e-3);
    }

    /// In the view of the whole patient.
    void hasWhatLiesInTheThroatWithoutALaryngoscope()
    {
        const FollowingThroat throat = patient().throat(std::nullopt);
        Station station;
        StationMoment moment = station.view.at(kNow, 0);
        const auto contents = [&] {
            (void)station.laryngoscope.changesAt(moment);
            return station.laryngoscope.contentsIn(moment, throat, {});
        };
        QVERIFY(contents().empty());
        moment.airwayEvents = {{AirwayEventKind::Vomit, 0.5}};
        QCOMPARE(contents().size(), 2U);
        moment.airwayEvents = {};
        QVERIFY(contents().empty());
    }

    /// Which teeth a blade has touched is forgotten while it is out of view.
    void watchesHowABladeIsHandled()
    {
        Station station;
        const auto laryngoscopy =
            Laryngoscopy::of(patient(), bladeOf(BladeKind::Macintosh3)).value();
        const auto tippedBack = [&](double deg) {
            return laryngoscopy.leveredPose(LaryngoscopyStep::Full, degrees(deg));
        };
        SessionTime t = kNow;
        for (int deg = 0; deg <= 20; ++deg, t += 20ms) {
            const LaryngoscopyPose pose = tippedBack(deg);
            station.node.sees(kFirst, pose.X_AL, t);
            const LaryngoscopeSight sight = station.at(t, pose.X_AJ);
            QCOMPARE(sight.state, LaryngoscopeState::Live);
            if (deg == 0)
                QVERIFY(!sight.effort.isOnTeeth);
            if (deg == 20)
                QVERIFY(sight.effort.handling == BladeHandling::Levering);
        }
        station.at(t + 5s); // lost
        const LaryngoscopyPose pose = tippedBack(20.0);
        station.node.sees(kFirst, pose.X_AL, t + 10s);
        QVERIFY(station.at(t + 10s, pose.X_AJ).effort.handling == BladeHandling::Lifting);
    }
};

CARINA_TEST(TestLaryngoscopeSight)

} // namespace carina::laryngoscope_sight_test

#include "tst_laryngoscope_sight.moc"
