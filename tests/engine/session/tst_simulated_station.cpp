#include "engine/anatomy/airway/airway_measure.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "engine/geometry/rotation.h"
#include "engine/session/simulated_station.h"
#include "engine/session/simulated_tools.h"
#include "engine/tracking/simulated/scripted_hands.h"

#include "tests/support/test_class.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>

namespace carina::simulated_station_test
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kPeriod = 20s;
constexpr Duration kStep = 100ms;
constexpr double kHeadsApart = 0.15;        // m, between their middles
constexpr double kTubesApart = 0.01;        // m
constexpr double kIntoFloorOfMouth = 0.012; // m, of a rigid tube into the mandible

/// A surface of the patient, and whether the jaw carries it.
struct Obstacle {
    std::string name;
    SurfaceTree surface;
    bool onJaw;
};

bool isOfJaw(const AnatomyPart& part)
{
    return part.role == PartRole::Mandible
           || (part.role == PartRole::Tooth && part.name.find("lower") != std::string::npos);
}

std::vector<Obstacle> bonesOfMouth(const Anatomy& patient)
{
    std::vector<Obstacle> bones;
    for (const AnatomyPart& part : patient.parts)
        if (part.name == "Hard palate" || part.role == PartRole::Tooth
            || part.role == PartRole::Mandible)
            bones.push_back({part.name, SurfaceTree{part.levels.front()}, isOfJaw(part)});
    return bones;
}

/// How far a ball about p reaches into a closed surface; negative where it does not touch it.
double depthIn(const SurfaceTree& surface, const Vec3& p, double radius)
{
    const std::optional<SurfacePoint> nearest = surface.nearestTo(p);
    const double distance = (nearest->p - p).norm();
    const bool inside = nearest->normal.dot(p - nearest->p) < 0.0;
    return radius + (inside ? distance : -distance);
}

/// The deepest that the tube reaches into each bone in a period, metres.
std::map<std::string, double> deepest(const Anatomy& patient, const TubeShape& tube)
{
    const auto station =
        simulatedStation(patient.landmarks, tube, [] { return std::optional<SessionTime>{}; });
    const std::vector<Obstacle> bones = bonesOfMouth(patient);
    const RigidTransform X_AT = station->X_TA.inverse();
    const RigidTransform X_JA = heldJaw(patient.contentHash).inverse();
    std::map<std::string, double> deepest;
    for (Duration t = 0s; t < kPeriod; t += kStep) {
        const RigidTransform X_AE = X_AT * station->truth(ToolRole::Tube, SessionTime{t}).value();
        const RigidTransform X_AJ = X_AT * station->truth(ToolRole::Jaw, SessionTime{t}).value()
                                    * station->exactly.X_JA.value() * X_JA;
        for (const Obstacle& bone : bones)
            for (const Vec3& p_E : tube.p_E_centre) {
                const Vec3 p_A = X_AE * p_E;
                const Vec3 p = bone.onJaw ? X_AJ.inverse() * p_A : p_A;
                const double depth = depthIn(bone.surface, p, 0.5 * tube.outerDiameter.si);
                double& most = deepest.try_emplace(bone.name, -1.0).first->second;
                most = std::max(most, depth);
            }
    }
    return deepest;
}

/// A station of the adult whose tracker has a laryngoscope.
struct WithLaryngoscope {
    Anatomy patient = builtinPatient(BuiltinPatient::Adult).value();
    TubeShape tube = makeTube(dimensionsOf(BuiltinPatient::Adult).tubeInnerDiameter,
                              patient.landmarks.path_A, patient.landmarks.p_A_incisors)
                         .value();
    LaryngoscopyScript script{.airway = upperAirwayOf(patient.parts, patient.landmarks).value(),
                              .throat = {patient.landmarks.p_A_carina,
                                         patient.landmarks.p_A_glottis,
                                         patient.landmarks.p_A_incisors},
                              .held = heldJaw(patient.contentHash)};

    [[nodiscard]] SimulatedStation made(const std::optional<StationRegistration>& place = {},
                                        const SimulatedHead& head = {}) const
    {
        SimulatedTrackerSettings device;
        device.laryngoscope = true;
        const auto noClock = [] { return std::optional<SessionTime>{}; };
        return simulatedStation(patient.landmarks, tube, noClock, place, {}, {}, device, script,
                                head)
            .value();
    }
};

} // namespace

class TestSimulatedStation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bringsTheTubeInThroughTheMouth_data()
    {
        QTest::addColumn<BuiltinPatient>("who");
        QTest::newRow("the adult") << BuiltinPatient::Adult;
        QTest::newRow("twelve years") << BuiltinPatient::TwelveYears;
    }

    /// A rigid tube with the shape of its final place cannot keep clear of both the palate and the
    /// mandible on its way: what it does not reach into the palate it reaches into the floor of the
    /// mouth. Along its path it touches the edge of the upper incisors, where the path begins.
    void bringsTheTubeInThroughTheMouth()
    {
        QFETCH(BuiltinPatient, who);
        const auto patient = builtinPatient(who);
        QVERIFY(patient);
        const auto tube = makeTube(dimensionsOf(who).tubeInnerDiameter, patient->landmarks.path_A,
                                   patient->landmarks.p_A_incisors);
        QVERIFY(tube);
        const auto into = deepest(*patient, *tube);
        QVERIFY(into.contains("Hard palate"));
        QVERIFY(into.at("Hard palate") <= 0.0);
        const double radius = 0.5 * tube->outerDiameter.si;
        for (const auto& [name, depth] : into)
            if (name.find("upper") != std::string::npos)
                QVERIFY2(depth < radius, name.c_str()); // its centreline stays outside
        QVERIFY(into.at("Mandible") < kIntoFloorOfMouth);
    }

    /// A site that has its tube calibrated: the tracker sees its markers, and the calibration leads
    /// back to the connector.
    void holdsTheTubeByItsMarkersWhereItIsCalibrated()
    {
        const auto patient = builtinPatient(BuiltinPatient::Adult);
        const auto tube = makeTube(dimensionsOf(BuiltinPatient::Adult).tubeInnerDiameter,
                                   patient->landmarks.path_A, patient->landmarks.p_A_incisors);
        const auto noClock = [] { return std::optional<SessionTime>{}; };
        const auto plain = simulatedStation(patient->landmarks, *tube, noClock);
        StationRegistration registration = plain->exactly;
        registration.X_NE = simulatedTools(*tube).X_NE;
        const auto marked = simulatedStation(patient->landmarks, *tube, noClock, registration);
        constexpr double kExact = 1e-12;
        for (const SessionTime t : {SessionTime{1s}, SessionTime{7s}}) {
            const RigidTransform X_TN = marked->truth(ToolRole::Tube, t).value();
            const RigidTransform X_TE = plain->truth(ToolRole::Tube, t).value();
            QVERIFY(((X_TN * *registration.X_NE).matrix() - X_TE.matrix()).norm() < kExact);
            QVERIFY((X_TN.translation() - X_TE.translation()).norm() > 0.02);
        }
    }

    /// The tip of the blade goes from the teeth to the vallecula and back within a period, without
    /// a jump: at 60 exposures a second less than 3 mm, or 18 cm/s, from one to the next.
    void showsTheLarynxInEachPeriod()
    {
        constexpr double kMostMove_m = 3e-3;
        constexpr double kMostTurn = 0.1; // of the matrix: 4 degrees
        const WithLaryngoscope station;
        const SimulatedStation made = station.made();
        const Vec3 p_L_tip = middleOfBlade(station.script.blade.form, 1.0);
        const auto at = [&](Duration t) {
            return made.X_TA.inverse() * made.truth(ToolRole::Laryngoscope, SessionTime{t}).value();
        };
        const auto toVallecula = [&](Duration t) {
            return (at(t) * p_L_tip - station.script.airway.p_A_vallecula).norm();
        };
        QVERIFY(toVallecula(0s) > 0.05);
        QVERIFY(toVallecula(10s) < 0.04); // lifted, as the jaw is
        QVERIFY((at(3s).matrix() - at(3s + kPeriod).matrix()).norm() < 1e-9);
        for (Duration t = 0s; t < 2 * kPeriod; t += kStep / 6) {
            const RigidTransform now = at(t);
            const RigidTransform next = at(t + kStep / 6);
            QVERIFY((now * p_L_tip - next * p_L_tip).norm() < kMostMove_m);
            QVERIFY((now.rotation().toRotationMatrix() - next.rotation().toRotationMatrix()).norm()
                    < kMostTurn);
            const Vec3 p_T = made.truth(ToolRole::Laryngoscope, SessionTime{t})->translation();
            QVERIFY(WorkingVolume{}.contains(p_T));
        }
    }

    /// The mouth is open while the blade is in it, and the tube is brought in once it is lifted.
    void opensTheMouthForTheBlade()
    {
        const WithLaryngoscope station;
        const SimulatedStation made = station.made();
        const auto plain = simulatedStation(station.patient.landmarks, station.tube,
                                            [] { return std::optional<SessionTime>{}; });
        for (Duration t = 0s; t < kPeriod; t += kStep) {
            const RigidTransform X_AJ = made.X_TA.inverse()
                                        * made.truth(ToolRole::Jaw, SessionTime{t}).value()
                                        * made.exactly.X_JA.value();
            const double opened = Eigen::AngleAxisd{X_AJ.rotation().toRotationMatrix()}.angle();
            QVERIFY(opened > degrees(15.0).si && opened < degrees(21.0).si);
            const Duration later = std::chrono::round<Duration>(kTubeAfterBlade * kPeriod);
            const auto tube = made.truth(ToolRole::Tube, SessionTime{t + later});
            QVERIFY(
                (tube->translation() - plain->truth(ToolRole::Tube, SessionTime{t})->translation())
                    .norm()
                < 1e-9);
        }
    }

    /// Wherever the tube's tip is between the incisors and the cords, and going on.
    void liftsWhileTheTubeComesIn()
    {
        constexpr int kLeastTimes = 10;
        const WithLaryngoscope station;
        const SimulatedStation made = station.made();
        const std::vector<Vec3>& path_A = station.patient.landmarks.path_A;
        const auto nearest = [&path_A](const Vec3& p_A) {
            return std::ranges::min_element(
                path_A, {}, [&p_A](const Vec3& q_A) { return (q_A - p_A).squaredNorm(); });
        };
        const auto incisors = nearest(station.patient.landmarks.p_A_incisors);
        const auto cords = nearest(station.patient.landmarks.p_A_glottis);
        const auto tipAt = [&](Duration t) {
            const RigidTransform X_TE = made.truth(ToolRole::Tube, SessionTime{t}).value();
            return nearest(made.X_TA.inverse() * (X_TE * station.tube.p_E_tip));
        };
        int times = 0;
        for (Duration t = 0s; t < kPeriod; t += kStep) {
            const auto tip = tipAt(t);
            if (tip < incisors || tip > cords || tipAt(t + kStep) <= tip)
                continue;
            ++times;
            const LaryngoscopyPose blade = scriptedLaryngoscopy(station.script, SessionTime{t});
            QVERIFY(blade.lift.si >= 0.7 * station.script.lift.si);
        }
        QVERIFY(times > kLeastTimes);
    }

    /// The jaw as it is in the head, and the blade where it is in a mouth that lies so.
    void worksInAHeadAsItLies()
    {
        constexpr double kExact = 1e-9;
        const WithLaryngoscope station;
        const SimulatedStation neutral = station.made();
        const SimulatedStation sniffing = station.made({}, [] { return kSniffing; });
        const NeckField neck{station.patient.landmarks.p_A_glottis,
                             station.patient.landmarks.p_A_incisors, kSniffing};
        const RigidTransform X_AT = neutral.X_TA.inverse();
        for (const SessionTime t : {SessionTime{1s}, SessionTime{5s}, SessionTime{8s}}) {
            const auto poseIn = [&](const SimulatedStation& made, ToolRole tool) {
                return X_AT * made.truth(tool, t).value();
            };
            QVERIFY((poseIn(sniffing, ToolRole::Jaw).matrix()
                     - (neck.X_AU() * poseIn(neutral, ToolRole::Jaw)).matrix())
                        .norm()
                    < kExact);
            const RigidTransform X_AL = scriptedLaryngoscopy(station.script, t, neck).X_AL;
            QVERIFY((poseIn(sniffing, ToolRole::Laryngoscope).matrix() - X_AL.matrix()).norm()
                    < kExact);
            QCOMPARE((poseIn(sniffing, ToolRole::Head).matrix()
                      - poseIn(neutral, ToolRole::Head).matrix())
                         .norm(),
                     0.0);
        }
    }

    void bringsTheTubeIntoAHeadAsItLies_data()
    {
        QTest::addColumn<double>("flexion_deg");
        QTest::addColumn<double>("extension_deg");
        QTest::newRow("sniffing") << inDegrees(kSniffing.flexion) << inDegrees(kSniffing.extension);
        QTest::newRow("extended") << 0.0 << inDegrees(kHeadExtended.extension);
        QTest::newRow("flexed") << inDegrees(kNeckFlexed.flexion) << 0.0;
        QTest::newRow("everything to the back")
            << inDegrees(kLeastFlexion) << inDegrees(kMostExtension);
        QTest::newRow("everything to the front")
            << inDegrees(kMostFlexion) << inDegrees(kLeastExtension);
    }

    /// In place it lies along the middle of the airway as the neck has taken it, tip and connector
    /// where the neck has taken theirs, and on the way there nothing jumps.
    void bringsTheTubeIntoAHeadAsItLies()
    {
        QFETCH(const double, flexion_deg);
        QFETCH(const double, extension_deg);
        constexpr double kAlong_m = 1e-3;
        constexpr double kMostMove_m = 5e-3; // in a sixtieth of a second: 30 cm/s
        const HeadPosition position{degrees(flexion_deg), degrees(extension_deg)};
        const WithLaryngoscope station;
        const SimulatedStation made = station.made({}, [position] { return position; });
        const AirwayLandmarks& neutral = station.patient.landmarks;
        const NeckField neck{neutral.p_A_glottis, neutral.p_A_incisors, position};
        const AirwayLandmarks airway = bent(neutral, neck);
        const TubeShape tube = bent(station.tube, neck);
        const auto at = [&](Duration t) {
            return made.X_TA.inverse() * made.truth(ToolRole::Tube, SessionTime{t}).value();
        };
        const RigidTransform inPlace = at(17s); // 12 s, and as much later as the blade needs
        for (const Vec3& p_E : tube.p_E_centre) {
            const double beside = distanceFrom(airway.path_A, inPlace * p_E).si;
            QVERIFY2(beside < kAlong_m, qPrintable(QString::number(beside)));
        }
        const Vec3 p_A_tip = station.tube.X_AE * station.tube.p_E_tip;
        QVERIFY((inPlace * tube.p_E_tip - neck.placed(p_A_tip)).norm() < kAlong_m);
        const Vec3 p_A_connector = neck.placed(station.tube.X_AE.translation());
        QVERIFY((inPlace.translation() - p_A_connector).norm() < kAlong_m);
        for (Duration t = 0s; t < kPeriod; t += kStep / 6)
            QVERIFY((at(t) * tube.p_E_tip - at(t + kStep / 6) * tube.p_E_tip).norm() < kMostMove_m);
    }

    /// Back to neutral, too.
    void followsAHeadThatIsLaidAnew()
    {
        constexpr double kExact = 1e-9;
        const WithLaryngoscope station;
        const auto position = std::make_shared<HeadPosition>();
        const SimulatedStation made = station.made({}, [position] { return *position; });
        const SimulatedStation still = station.made();
        const auto apart = [&](ToolRole tool) {
            return (made.truth(tool, SessionTime{17s})->matrix()
                    - still.truth(tool, SessionTime{17s})->matrix())
                .norm();
        };
        QVERIFY(apart(ToolRole::Tube) < kExact);
        *position = kSniffing;
        QVERIFY(apart(ToolRole::Tube) > 0.1);
        QVERIFY(apart(ToolRole::Hand) > 0.1);
        QVERIFY(apart(ToolRole::Stylus) < kExact);
        *position = {};
        QVERIFY(apart(ToolRole::Tube) < kExact);
        QVERIFY(apart(ToolRole::Hand) < kExact);
    }

    /// A tube as it is sold is rigid; its tip comes to where that of a fitting one does.
    void bendsNoTubeThatWasTouched()
    {
        const WithLaryngoscope station;
        const TubeRest sold = simulatedTools(station.tube).tube;
        const TubeShape tube = tubeAlong(station.tube, centrelineOfTube(sold), sold.outerDiameter);
        const AirwayLandmarks& airway = station.patient.landmarks;
        const NeckField neck{airway.p_A_glottis, airway.p_A_incisors, kSniffing};
        const TubeShape same = bent(tube, neck);
        QCOMPARE(same.p_E_tip, tube.p_E_tip);
        QVERIFY(same.p_E_centre == tube.p_E_centre);
        const auto made = simulatedStation(
            airway, tube, [] { return std::optional<SessionTime>{}; }, {}, {}, {}, {}, {},
            [] { return kSniffing; });
        QVERIFY(made.has_value());
        const RigidTransform X_TE = made->truth(ToolRole::Tube, SessionTime{12s}).value();
        const Vec3 p_A_tip = made->X_TA.inverse() * (X_TE * tube.p_E_tip);
        QVERIFY((p_A_tip - neck.placed(station.tube.X_AE * station.tube.p_E_tip)).norm() < 2e-3);
    }

    void hasNoLaryngoscopeUnlessAskedFor()
    {
        const WithLaryngoscope station;
        const auto plain = simulatedStation(station.patient.landmarks, station.tube,
                                            [] { return std::optional<SessionTime>{}; });
        QVERIFY(!plain->truth(ToolRole::Laryngoscope, SessionTime{1s}));
        QVERIFY(plain->tracking->toolName(ToolRole::Laryngoscope).empty());
        QVERIFY(!station.made().tracking->toolName(ToolRole::Laryngoscope).empty());
    }

    void holdsTheLaryngoscopeByItsMarkersWhereItIsCalibrated()
    {
        constexpr double kExact = 1e-12;
        const WithLaryngoscope station;
        const SimulatedStation plain = station.made();
        StationRegistration registration = plain.exactly;
        registration.X_NL = simulatedTools(station.tube).X_NL;
        const SimulatedStation marked = station.made(registration);
        for (const SessionTime t : {SessionTime{1s}, SessionTime{7s}}) {
            const RigidTransform X_TN = marked.truth(ToolRole::Laryngoscope, t).value();
            const RigidTransform X_TL = plain.truth(ToolRole::Laryngoscope, t).value();
            QVERIFY(((X_TN * *registration.X_NL).matrix() - X_TL.matrix()).norm() < kExact);
            QVERIFY(WorkingVolume{}.contains(X_TN.translation()));
        }
    }

    /// Not shaped as this airway is: its tip comes to the same place all the same.
    void bringsInATubeAsItIsSold()
    {
        for (const BuiltinPatient who : {BuiltinPatient::Adult, BuiltinPatient::TwelveYears}) {
            const auto patient = builtinPatient(who);
            const auto fitting =
                makeTube(dimensionsOf(who).tubeInnerDiameter, patient->landmarks.path_A,
                         patient->landmarks.p_A_incisors);
            const TubeRest sold = simulatedTools(*fitting).tube;
            const TubeShape tube = tubeAlong(*fitting, centrelineOfTube(sold), sold.outerDiameter);
            const auto station = simulatedStation(patient->landmarks, tube,
                                                  [] { return std::optional<SessionTime>{}; });
            QVERIFY2(station.has_value(), station ? "" : station.error().detail.c_str());
            const RigidTransform X_TE =
                station->truth(ToolRole::Tube, SessionTime{12s}).value(); // it is in place
            const Vec3 p_A_tip = station->X_TA.inverse() * (X_TE * tube.p_E_tip);
            QVERIFY((p_A_tip - fitting->X_AE * fitting->p_E_tip).norm() < 2e-3);
        }
    }

    /// Their heads are apart at all times, their tubes at most times: two of them are in the
    /// patient one after the other.
    void keepsSeveralPeopleApart()
    {
        const auto patient = builtinPatient(BuiltinPatient::Adult);
        const auto tube = makeTube(dimensionsOf(BuiltinPatient::Adult).tubeInnerDiameter,
                                   patient->landmarks.path_A, patient->landmarks.p_A_incisors);
        const auto noClock = [] { return std::optional<SessionTime>{}; };
        const auto truthOf = [&](unsigned number) {
            return simulatedStation(patient->landmarks, *tube, noClock, {}, {},
                                    [number] { return number; })
                ->truth;
        };
        const auto alone = simulatedStation(patient->landmarks, *tube, noClock)->truth;
        const std::array people{truthOf(0), truthOf(1), truthOf(2), truthOf(3), truthOf(4)};
        const auto p_T = [](const TrueToolPose& truth, ToolRole tool, Duration t) {
            return truth(tool, SessionTime{t}).value().translation();
        };
        int together = 0;
        int times = 0;
        for (Duration t = 0s; t < kPeriod; t += kStep) {
            QCOMPARE(p_T(people[0], ToolRole::Tube, t), p_T(alone, ToolRole::Tube, t));
            QCOMPARE(p_T(people[0], ToolRole::Head, t), p_T(alone, ToolRole::Head, t));
            for (std::size_t k = 0; k < people.size() * people.size(); ++k) {
                const std::size_t i = k / people.size();
                const std::size_t j = k % people.size();
                if (i >= j)
                    continue;
                const auto apart = [&](ToolRole tool) {
                    return (p_T(people[i], tool, t) - p_T(people[j], tool, t)).norm();
                };
                QVERIFY(apart(ToolRole::Head) > kHeadsApart);
                together += apart(ToolRole::Tube) < kTubesApart ? 1 : 0;
                ++times;
            }
        }
        QVERIFY(together < times / 3);
    }

    /// A motion of hands in place of the scripted ones, at rest here: in the frame of the head.
    void letsAMotionMoveTubeJawAndBladeWithTheHead()
    {
        constexpr double kExact = 1e-12;
        const WithLaryngoscope station;
        const HandledTools held{.X_UE = RigidTransform::translation({0.01, -0.12, 0.1}),
                                .X_UL = RigidTransform::translation({0.02, -0.15, 0.12}),
                                .X_UJ = {rotationFromVector({0.2, 0.0, 0.0}), {0.0, -0.01, 0.0}}};
        SimulatedTrackerSettings device;
        device.laryngoscope = true;
        const auto noClock = [] { return std::optional<SessionTime>{}; };
        const NeckField flexed{station.patient.landmarks.p_A_glottis,
                               station.patient.landmarks.p_A_incisors, kNeckFlexed};
        const auto plain = simulatedStation(station.patient.landmarks, station.tube, noClock);
        for (const NeckField& neck : {NeckField{}, flexed})
            for (const unsigned person : {0U, 2U}) {
                const auto made = simulatedStation(
                    station.patient.landmarks, station.tube, noClock, {}, {},
                    [person] { return person; }, device, {}, [neck] { return neck.position(); },
                    [held](SessionTime) { return held; });
                const RigidTransform X_TU = made->X_TA * neck.X_AU();
                const auto isAt = [&](ToolRole tool, const RigidTransform& X_UO) {
                    const auto X_TO = made->truth(tool, SessionTime{7s});
                    return X_TO
                           && ((X_TU * X_UO).inverse() * *X_TO)
                                  .matrix()
                                  .isApprox(Mat4::Identity(), kExact);
                };
                QVERIFY(isAt(ToolRole::Tube, held.X_UE));
                QVERIFY(isAt(ToolRole::Hand, held.X_UE * handOnTube()));
                QVERIFY(isAt(ToolRole::Laryngoscope, held.X_UL));
                QVERIFY(isAt(ToolRole::Jaw, held.X_UJ * made->exactly.X_JA->inverse()));
                QCOMPARE(made->truth(ToolRole::Stylus, SessionTime{7s})->translation(),
                         plain->truth(ToolRole::Stylus, SessionTime{7s})->translation());
            }
    }

    /// On the torso, however the head lies.
    void letsAMotionMoveTheStylusOverTheChest()
    {
        const WithLaryngoscope station;
        const RigidTransform X_AS{rotationFromVector({1.5, 0.0, 0.0}), {-0.06, -0.12, -0.1}};
        const auto made = simulatedStation(
            station.patient.landmarks, station.tube, [] { return std::optional<SessionTime>{}; },
            {}, {}, {}, {}, {}, [] { return kNeckFlexed; },
            [&X_AS](SessionTime) { return HandledTools{.X_AS = X_AS}; });
        const auto X_TS = made->truth(ToolRole::Stylus, SessionTime{7s});
        QVERIFY(X_TS.has_value());
        QVERIFY((made->X_TA * X_AS).matrix().isApprox(X_TS->matrix(), 1e-12));
    }

    void seesEverybodysToolsAtAllTimes_data()
    {
        QTest::addColumn<BuiltinPatient>("who");
        QTest::newRow("the adult") << BuiltinPatient::Adult;
        QTest::newRow("twelve years") << BuiltinPatient::TwelveYears;
    }

    /// Nobody stands where the simulated tracker never sees their head.
    void seesEverybodysToolsAtAllTimes()
    {
        QFETCH(BuiltinPatient, who);
        const auto patient = builtinPatient(who);
        const auto tube = makeTube(dimensionsOf(who).tubeInnerDiameter, patient->landmarks.path_A,
                                   patient->landmarks.p_A_incisors);
        const auto noClock = [] { return std::optional<SessionTime>{}; };
        for (unsigned number = 0; number < 7; ++number) {
            const auto truth =
                simulatedStation(patient->landmarks, *tube, noClock, {}, {}, [number] {
                    return number;
                })->truth;
            for (Duration t = 0s; t < kPeriod; t += kStep)
                for (const ToolRole tool : {ToolRole::Head, ToolRole::Tube, ToolRole::Hand}) {
                    const Vec3 p_T = truth(tool, SessionTime{t}).value().translation();
                    QVERIFY2(WorkingVolume{}.contains(p_T), qPrintable(QString::number(number)));
                }
        }
    }
};

CARINA_TEST(TestSimulatedStation)

} // namespace carina::simulated_station_test

#include "tst_simulated_station.moc"
