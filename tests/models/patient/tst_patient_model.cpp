#include "engine/anatomy/chest/chest_region.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "models/patient/patient_model.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <array>

namespace carina::patient_model_test
{
namespace
{

constexpr double kVoxel_m = 1.5e-3; ///< shapes are meshed anew: two meshes of one differ by less
constexpr Length kTube = millimetres(6.0);

const AnatomyPart& jawOf(const Anatomy& anatomy)
{
    return *std::ranges::find(anatomy.parts, PartRole::Mandible, &AnatomyPart::role);
}

const PatientSurface& jawOf(const PatientModel& patient)
{
    return *std::ranges::find(patient.surfaces(), PartRole::Mandible,
                              [](const PatientSurface& s) { return s.description.role; });
}

double farthest_m(const TriangleMesh& mesh, const SurfaceTree& from)
{
    double farthest = 0.0;
    for (const Vec3f& p : mesh.positions)
        farthest = std::max(farthest, from.distanceTo(p.cast<double>()));
    return farthest;
}

} // namespace

/// Built-in patients are made with the mouth held open; the same patient made with it shut is the
/// truth of where the jaw goes.
class TestPatientModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        const auto who = parametersOf(BuiltinPatient::TwelveYears);
        m_shut = patientFor(who, Posture::Rest).value();
        Anatomy open = builtinPatient(BuiltinPatient::TwelveYears).value();
        m_patient = PatientModel::of(std::move(open), kTube).value();
    }

    void shutsTheMouthThatItsSurfacesHoldOpen()
    {
        const SurfaceTree truth{jawOf(m_shut).levels.front()};
        const PatientSurface& jaw = jawOf(*m_patient);
        QVERIFY(farthest_m(*jaw.levels.front(), truth) > 10 * kVoxel_m);
        QVERIFY(farthest_m(*m_patient->shutMesh(jaw), truth) < kVoxel_m);
        TriangleMesh drawn = *jaw.levels.front();
        const RigidTransform X = m_patient->throat(RigidTransform{}).X_AJ;
        for (Vec3f& p : drawn.positions)
            p = (X * p.cast<double>()).cast<float>();
        QVERIFY(farthest_m(drawn, truth) < kVoxel_m);
    }

    void drawsTheMouthAsItsSurfacesHaveItWithoutAChinProbe()
    {
        const FollowingThroat throat = m_patient->throat(std::nullopt);
        const Vec3 chin{0.0, -0.08, 0.12};
        QCOMPARE((throat.X_AJ * chin - chin).norm(), 0.0);
    }

    /// The mouth of the surfaces is open by 20 mm; one that a probe opens farther stops as well.
    void opensTheMouthNoFartherThanTrismusLets()
    {
        const Vec3& incisors = m_patient->landmarks().p_A_incisors;
        const RigidTransform heldInverse = m_patient->throat(RigidTransform{}).X_AJ;
        const auto opening_mm = [&](const std::optional<RigidTransform>& X_AJ, double severity) {
            const AirwayEvents events{{AirwayEventKind::Trismus, severity}};
            const RigidTransform drawn =
                m_patient->throat(X_AJ, {}, events).X_AJ * heldInverse.inverse();
            return 1e3 * (drawn * incisors - incisors).norm();
        };
        const double size = (m_patient->landmarks().p_A_glottis - incisors).norm() / 87.6e-3;
        QVERIFY(std::abs(opening_mm({}, 1.0) - 10.0 * size) < 1e-6);
        const RigidTransform wide = heldInverse.inverse() * heldInverse.inverse();
        QVERIFY(opening_mm(wide, 0.0) > 25.0);
        QVERIFY(std::abs(opening_mm(wide, 1.0) - 10.0 * size) < 1e-6);
        QVERIFY(opening_mm(RigidTransform{}, 1.0) < 1e-9);
        const Vec3 chin{0.0, -0.08, 0.12};
        const RigidTransform unlimited =
            m_patient->throat({}, {}, {{AirwayEventKind::Trismus, 0.01}}).X_AJ;
        QVERIFY((unlimited * chin - chin).norm() < 1e-12);
    }

    /// However the jaw is held; what is out of reach is drawn as the nearest that is not.
    void laysHeadAndNeckAsItIsTold()
    {
        QVERIFY(!m_patient->throat(std::nullopt).neck.isBent());
        for (const auto& jaw : {std::optional<RigidTransform>{}, std::optional{RigidTransform{}}}) {
            const FollowingThroat throat = m_patient->throat(jaw, kSniffing);
            QVERIFY(throat.neck.position() == kSniffing);
            QCOMPARE((throat.X_AJ.matrix() - m_patient->throat(jaw).X_AJ.matrix()).norm(), 0.0);
        }
        const HeadPosition far{degrees(90.0), {}};
        QVERIFY(m_patient->neck(far).position() == (HeadPosition{kMostFlexion, {}}));
    }

    /// What hangs from the jaw is where it is drawn; all else is where it was made.
    void movesWithTheJawWhatHangsFromIt()
    {
        const FollowingThroat shut = m_patient->throat(RigidTransform{});
        int following = 0;
        for (const PatientSurface& surface : m_patient->surfaces()) {
            if (surface.body != SurfaceBody::Anatomy)
                continue;
            const auto mesh = m_patient->shutMesh(surface);
            const auto tissue = tissueOf(regionOf(surface.description));
            following += tissue ? 1 : 0;
            if (tissue)
                QVERIFY(mesh->positions
                        == deformed(*surface.levels.front(), shut, *tissue).positions);
            else
                QCOMPARE(mesh, surface.levels.front());
        }
        QVERIFY(following > 5);
    }

    void holdsNoOtherMouthOpen()
    {
        Anatomy scanned = m_shut;
        scanned.contentHash = "0123456789abcdef";
        const PatientModel patient = PatientModel::of(std::move(scanned), kTube).value();
        const Vec3 chin{0.0, -0.08, 0.12};
        QCOMPARE((patient.throat(RigidTransform{}).X_AJ * chin - chin).norm(), 0.0);
        const PatientSurface& jaw = jawOf(patient);
        QVERIFY(patient.shutMesh(jaw)->positions == jaw.levels.front()->positions);
    }

    /// Only the tube is another, and in place its tip lies where that of the other does.
    void takesATubeOfAnotherShape()
    {
        const std::array straight{Vec3{0.0, 0.0, 0.0}, Vec3{0.0, 0.0, -0.1}, Vec3{0.0, 0.0, -0.2}};
        const PatientModel other = m_patient->withTube(straight, millimetres(9.0));
        QCOMPARE(other.surfaces().size(), m_patient->surfaces().size());
        QCOMPARE(other.contentHash(), m_patient->contentHash());
        QVERIFY((other.tube().p_E_tip - straight.back()).norm() < 1e-12);
        QVERIFY((other.tube().X_AE * other.tube().p_E_tip
                 - m_patient->tube().X_AE * m_patient->tube().p_E_tip)
                    .norm()
                < 1e-12);
        for (std::size_t i = 0; i < other.surfaces().size(); ++i) {
            const PatientSurface& was = m_patient->surfaces()[i];
            const PatientSurface& is = other.surfaces()[i];
            QCOMPARE(is.name, was.name);
            QCOMPARE(is.levels.front() == was.levels.front(), is.body != SurfaceBody::Tube);
        }
        const Box wall = boundsOf(
            *std::ranges::find(other.surfaces(), std::string{"Tube"}, &PatientSurface::name)
                 ->levels.front());
        QVERIFY(std::abs(wall.min.z() + 0.2) < 1e-4 && std::abs(wall.max.x() - 0.0045) < 1e-4);
    }

private:
    Anatomy m_shut;
    std::optional<PatientModel> m_patient;
};

CARINA_TEST(TestPatientModel)

} // namespace carina::patient_model_test

#include "tst_patient_model.moc"
