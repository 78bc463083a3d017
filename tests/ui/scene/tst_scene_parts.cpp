#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_source.h"
#include "tests/support/test_class.h"
#include "tests/support/throat_motion.h"
#include "ui/scene/scene_parts.h"

#include <numbers>

namespace carina::scene_parts_test
{

class TestSceneParts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    // Events move those of the upper jaw.
    void keepsTheLowerTeethWithTheirJaw()
    {
        const auto patient = patientOf(builtinPatient(BuiltinPatient::TwelveYears).value());
        QVERIFY(patient.has_value());
        int teeth = 0;
        for (const ScenePart& part : sceneParts(**patient)) {
            const QString name = QString::fromStdString(part.name);
            if (!name.endsWith(QStringLiteral(" tooth")))
                continue;
            const bool isLower = name.contains(QStringLiteral(" lower "));
            QCOMPARE(part.body == "mandible", isLower);
            const bool isLoose = name.startsWith(QStringLiteral("Right upper central "));
            QVERIFY(part.region
                    == (isLower   ? ChestRegion::Still
                        : isLoose ? ChestRegion::LooseTooth
                                  : ChestRegion::Teeth));
            ++teeth;
        }
        QCOMPARE(teeth, 28);
    }

    void opensTheMouthNoFartherThanEventsLet()
    {
        const auto patient = patientOf(builtinPatient(BuiltinPatient::TwelveYears).value());
        QVERIFY(patient.has_value());
        const Vec3& incisors = (*patient)->landmarks().p_A_incisors;
        StationMoment moment;
        const auto moved = [&] {
            const RigidTransform X = throatAt(moment, **patient).X_AJ;
            return (X * incisors - incisors).norm();
        };
        QCOMPARE(moved(), 0.0);
        moment.airwayEvents = {{AirwayEventKind::Trismus, 1.0}};
        QVERIFY(moved() > 0.003); // shut from 20 mm to some 10
    }

    void drawsThePatientInItsPlaceUntilItIsActedOn()
    {
        const SceneFrame frame = sceneFrame({}, ChestField{});
        QCOMPARE(drawnAt(frame, "patient", kPoint), kPoint);
        QCOMPARE(drawnAt(frame, "mandible", kPoint), kPoint);
        QVERIFY(!frame.bodies.contains("tube"));
    }

    void drawsTheThroatWithTheJawThatIsDrawn()
    {
        const FollowingThroat throat{{Vec3::Zero(), {0.0, -0.03, 0.12}, {0.0, -0.1, 0.17}},
                                     RigidTransform::translation({0.0, -0.01, 0.0})};
        const Vec3 tongue{0.0, -0.06, 0.16};
        const auto movedBy = [&tongue](const FollowingThroat& following) {
            return test::throatAt(following.field, tongue, following.X_AJ, ThroatTissue::Airway)
                .d_A.y();
        };
        QVERIFY(movedBy(sceneFrame({}, {}, throat).throat) < -0.005);
        QCOMPARE(movedBy(sceneFrame({}, {}).throat), 0.0);
    }

    void movesThePatientAndItsJawAndNoTool()
    {
        constexpr double kSmall_m = 1e-12;
        StationMoment moment;
        // A quarter turn about z at twice the size, then a metre up: (x, y, z) to 2 (-y, x, z) +
        // e_z.
        const Quat quarter{Eigen::AngleAxisd{std::numbers::pi / 2.0, Vec3::UnitZ()}};
        moment.patient.emplace().acted = {RigidTransform{quarter, Vec3::UnitZ()}, 2.0};
        moment.tube.emplace().X_FO = RigidTransform::translation({0.5, 0.0, 0.0});
        moment.tube->validity = Validity::Tracked;
        const SceneFrame frame =
            sceneFrame(moment, ChestField{}, {{}, RigidTransform::translation({0.0, 0.1, 0.0})});
        const auto moved = [](const Vec3& p) {
            return Vec3{2.0 * -p.y(), 2.0 * p.x(), 2.0 * p.z() + 1.0};
        };
        QVERIFY((drawnAt(frame, "patient", kPoint) - moved(kPoint)).norm() < kSmall_m);
        const Vec3 inJaw = kPoint + Vec3{0.0, 0.1, 0.0};
        QVERIFY((drawnAt(frame, "mandible", kPoint) - moved(inJaw)).norm() < kSmall_m);
        QVERIFY((drawnAt(frame, "tube", kPoint) - (kPoint + Vec3{0.5, 0.0, 0.0})).norm()
                < kSmall_m);
    }

    // The mandible is not bent, as it moves with the head; the tube is where it is tracked.
    void movesTheJawWithTheHeadAndBendsThePatient()
    {
        constexpr double kSmall_m = 1e-12;
        const NeckField neck{{0.0, -0.03, 0.12}, {0.0, -0.1, 0.17}, kSniffing};
        const RigidTransform X_UJ = RigidTransform::translation({0.0, -0.01, 0.0});
        StationMoment moment;
        moment.tube.emplace().X_FO = RigidTransform::translation({0.5, 0.0, 0.0});
        moment.tube->validity = Validity::Tracked;
        const SceneFrame frame = sceneFrame(moment, ChestField{}, {{}, X_UJ, neck});
        QCOMPARE(frame.bends, std::string{kPatientBody});
        QCOMPARE(drawnAt(frame, "patient", kPoint), kPoint);
        QVERIFY((drawnAt(frame, "mandible", kPoint) - neck.X_AU() * (X_UJ * kPoint)).norm()
                < kSmall_m);
        QVERIFY((drawnAt(frame, "tube", kPoint) - (kPoint + Vec3{0.5, 0.0, 0.0})).norm()
                < kSmall_m);
    }

    /// Not one that was touched.
    void bendsTheTubeAsItsAirwayIs()
    {
        const auto patient = patientOf(builtinPatient(BuiltinPatient::TwelveYears).value());
        QVERIFY(patient.has_value());
        SceneFrame frame = sceneFrame({}, ChestField{});
        QVERIFY(frame.bentInPlace.empty());
        bendTube(frame, **patient);
        QCOMPARE(frame.bentInPlace.at("tube").translation(), (*patient)->tube().X_AE.translation());
        const PatientModel touched =
            (*patient)->withTube((*patient)->tube().p_E_centre, millimetres(8.0));
        SceneFrame rigid = sceneFrame({}, ChestField{});
        bendTube(rigid, touched);
        QVERIFY(rigid.bentInPlace.empty());
    }

    /// As an outline, where it is tracked.
    void showsWhereATubeWasMeasured()
    {
        const auto patient = patientOf(builtinPatient(BuiltinPatient::TwelveYears).value());
        QVERIFY(patient.has_value());
        const SceneFigure figure = measuredTubeFigure(**patient);
        QVERIFY(!figure.parts.empty());
        for (const ScenePart& part : figure.parts) {
            QCOMPARE(part.body, figure.body);
            QVERIFY(part.group == MaterialGroup::Ghost);
        }
        StationMoment moment;
        moment.tube.emplace().X_FO = RigidTransform::translation({0.5, 0.0, 0.0});
        SceneFrame frame = sceneFrame(moment, ChestField{});
        QVERIFY(!frame.bodies.contains(figure.body));
        addMeasuredTube(frame, **patient);
        QCOMPARE(frame.bodies.at(figure.body).X_AF.translation(), moment.tube->X_FO.translation());
    }

private:
    static inline const Vec3 kPoint{0.01, -0.02, 0.3};

    static Vec3 drawnAt(const SceneFrame& frame, const char* body, const Vec3& p_F)
    {
        const PlacedBody& placed = frame.bodies.at(body);
        return placed.X_AF * Vec3{placed.scale * p_F};
    }
};

CARINA_TEST(TestSceneParts)

} // namespace carina::scene_parts_test

#include "tst_scene_parts.moc"
