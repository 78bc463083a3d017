#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_landmarks.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina::patient_landmarks_test
{

/// Claims about the places that depth is judged by, held against the surfaces.
class TestPatientLandmarks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void incisorsAreTheEdgeOfTheUpperTeeth_data() { patients(); }
    void incisorsAreTheEdgeOfTheUpperTeeth();
    void incisorPlaneTouchesTheUpperTeeth_data() { patients(); }
    void incisorPlaneTouchesTheUpperTeeth();
    void glottisLiesBetweenTheCords_data() { patients(); }
    void glottisLiesBetweenTheCords();
    void carinaIsWhereTheTracheaEnds_data() { patients(); }
    void carinaIsWhereTheTracheaEnds();
    void ribsEndWhereTheirCartilagesBegin_data() { patients(); }
    void ribsEndWhereTheirCartilagesBegin();
    void sternumReachesFromNotchToTip_data() { patients(); }
    void sternumReachesFromNotchToTip();
    void aTubeHasItsWayFree_data() { patients(); }
    void aTubeHasItsWayFree();
    void theMiddleOfASolidIsNotFree();

private:
    static void patients();
};

namespace
{

constexpr double kMillimetre = 1e-3;
/// Surfaces are made of voxels; edges sharper than one are rounded.
constexpr double kVoxel = 1.3 * kMillimetre;

struct Patient {
    Anatomy anatomy;
    PatientDimensions dimensions;
    PatientLandmarks marks;
};

Patient make(BuiltinPatient which)
{
    const PatientDimensions d = dimensionsOf(which);
    return {builtinPatient(which).value(), d, landmarksOf(bodyPlanOf(d, Posture::Laryngoscopy))};
}

const Patient& patientOf(int which)
{
    static const Patient adult = make(BuiltinPatient::Adult);
    static const Patient child = make(BuiltinPatient::TwelveYears);
    return which == 0 ? adult : child;
}

const TriangleMesh& named(const Patient& patient, const std::string& name)
{
    return std::ranges::find(patient.anatomy.parts, name, &AnatomyPart::name)->levels[0];
}

/// The vertex that lies furthest along a direction.
Vec3 furthest(const TriangleMesh& mesh, const Vec3& along)
{
    return std::ranges::max(mesh.positions, {},
                            [&](const Vec3f& p) { return p.cast<double>().dot(along); })
        .cast<double>();
}

double nearestVertex(const TriangleMesh& mesh, const Vec3& p_A)
{
    double nearest = 1e9;
    for (const Vec3f& p : mesh.positions)
        nearest = std::min(nearest, (p.cast<double>() - p_A).norm());
    return nearest;
}

/// How far a place is from a closed surface; negative inside it.
double distanceOutside(const SurfaceTree& surface, const Vec3& p_A)
{
    const SurfacePoint nearest = surface.nearestTo(p_A).value();
    const double distance = (nearest.p - p_A).norm();
    return nearest.normal.dot(p_A - nearest.p) < 0.0 ? -distance : distance;
}

const std::array kOrdinals{"first",   "second", "third", "fourth", "fifth",    "sixth",
                           "seventh", "eighth", "ninth", "tenth",  "eleventh", "twelfth"};

} // namespace

void TestPatientLandmarks::patients()
{
    QTest::addColumn<int>("which");
    QTest::newRow("adult") << 0;
    QTest::newRow("twelve years") << 1;
}

void TestPatientLandmarks::incisorsAreTheEdgeOfTheUpperTeeth()
{
    QFETCH(int, which);
    const Patient& patient = patientOf(which);
    const Vec3& p_A = patient.marks.airway.p_A_incisors;
    QCOMPARE(p_A, patient.anatomy.landmarks.p_A_incisors);
    for (const char* side : {"Left", "Right"}) {
        const TriangleMesh& tooth =
            named(patient, std::string{side} + " upper central secondary incisor tooth");
        const Vec3 edge = furthest(tooth, -Vec3::UnitZ());
        QVERIFY2(std::abs(edge.z() - p_A.z()) < kVoxel, side);
        QVERIFY(std::abs(edge.y() - p_A.y()) < 2.0 * kVoxel);
        QVERIFY((side[0] == 'L') == (edge.x() > 0.0));
        QVERIFY(std::abs(edge.x()) < 8.0 * kMillimetre);
    }
}

void TestPatientLandmarks::incisorPlaneTouchesTheUpperTeeth()
{
    QFETCH(int, which);
    const Patient& patient = patientOf(which);
    const AnatomyPlane& plane = patient.marks.incisors;
    QVERIFY(std::abs(plane.normal_A.norm() - 1.0) < 1e-12);
    double lowest = 1e9;
    for (const AnatomyPart& part : patient.anatomy.parts) {
        if (part.role != PartRole::Tooth || part.name.find(" upper ") == std::string::npos)
            continue;
        const Vec3 tip = furthest(part.levels[0], -plane.normal_A);
        const double above = (tip - plane.p_A).dot(plane.normal_A);
        QVERIFY2(above < 3.0 * kMillimetre, part.name.c_str());
        lowest = std::min(lowest, above);
    }
    // The premolars reach a little further down than incisors and second molars.
    QVERIFY(lowest > -2.5 * kMillimetre);
    QVERIFY(lowest < 0.0);
}

void TestPatientLandmarks::glottisLiesBetweenTheCords()
{
    QFETCH(int, which);
    const Patient& patient = patientOf(which);
    const AnatomyPlane& plane = patient.marks.glottis;
    double parted = 0.0;
    for (const char* side : {"Left", "Right"}) {
        const TriangleMesh& cord = named(patient, std::string{side} + " vocal ligament");
        // The plane runs along the middle of each cord.
        const double above = (furthest(cord, plane.normal_A) - plane.p_A).dot(plane.normal_A);
        const double below = (furthest(cord, -plane.normal_A) - plane.p_A).dot(-plane.normal_A);
        QVERIFY(std::abs(above - below) < kVoxel);
        QVERIFY(above > 0.5 * kMillimetre && above < 3.0 * kMillimetre);
        parted += std::abs(boundsOf(cord).centre().x());
        QVERIFY(test::windingNumber(cord, plane.p_A) < 0.5);
    }
    QVERIFY(parted > 6.0 * kMillimetre);
    const Vec3 up = plane.p_A.normalized();
    QVERIFY((up - plane.normal_A).norm() < 1e-9);
    QVERIFY(std::abs(plane.p_A.norm() - patient.dimensions.cordsToCarina.si) < 1e-12);
}

void TestPatientLandmarks::carinaIsWhereTheTracheaEnds()
{
    QFETCH(int, which);
    const Patient& patient = patientOf(which);
    const AnatomyPlane& plane = patient.marks.carina;
    QCOMPARE(plane.p_A, Vec3::Zero().eval());
    QCOMPARE(plane.normal_A, patient.marks.glottis.normal_A);
    const Vec3 lowest = furthest(named(patient, "Trachea"), -plane.normal_A);
    QVERIFY(std::abs(lowest.dot(plane.normal_A)) < kVoxel);
}

void TestPatientLandmarks::ribsEndWhereTheirCartilagesBegin()
{
    QFETCH(int, which);
    const Patient& patient = patientOf(which);
    const RibLandmarks& ribs = patient.marks.ribs;
    for (std::size_t i = 0; i < kOrdinals.size(); ++i) {
        const Vec3& left = ribs.p_A_leftEnds[i];
        QVERIFY((left
                 - Vec3{-ribs.p_A_rightEnds[i].x(), ribs.p_A_rightEnds[i].y(),
                        ribs.p_A_rightEnds[i].z()})
                    .norm()
                < 1e-12);
        const std::string name = std::string{"Left "} + kOrdinals[i];
        QVERIFY2(test::windingNumber(named(patient, name + " rib"), left) > 0.5, name.c_str());
        const std::string right = std::string{"Right "} + kOrdinals[i] + " rib";
        QVERIFY2(test::windingNumber(named(patient, right), ribs.p_A_rightEnds[i]) > 0.5,
                 right.c_str());
        if (i < 7)
            QVERIFY2(test::windingNumber(named(patient, name + " costal cartilage"), left) > 0.5,
                     name.c_str());
        // Nothing of the rib lies far in front of its end but what rounds it off.
        if (i > 0 && i < 10)
            QVERIFY(left.z() < ribs.p_A_leftEnds[i - 1].z());
    }
}

void TestPatientLandmarks::sternumReachesFromNotchToTip()
{
    QFETCH(int, which);
    const Patient& patient = patientOf(which);
    const RibLandmarks& ribs = patient.marks.ribs;
    QVERIFY(nearestVertex(named(patient, "Manubrium"), ribs.p_A_sternalNotch) < 2.0 * kVoxel);
    QVERIFY(nearestVertex(named(patient, "Xiphoid process"), ribs.p_A_xiphoidTip) < 2.0 * kVoxel);
    QVERIFY(std::abs(furthest(named(patient, "Xiphoid process"), -Vec3::UnitZ()).z()
                     - ribs.p_A_xiphoidTip.z())
            < kVoxel);
    // The notch lies above the carina, at the height of the second and third thoracic vertebra.
    QVERIFY(ribs.p_A_sternalNotch.z() > 0.0);
    const Box third = boundsOf(named(patient, "Third thoracic vertebra"));
    const Box second = boundsOf(named(patient, "Second thoracic vertebra"));
    QVERIFY(ribs.p_A_sternalNotch.z() > third.min.z());
    QVERIFY(ribs.p_A_sternalNotch.z() < second.max.z());
}

/// Of each solid at the edge of the way the tube stays outside; only the teeth may touch it, for
/// the way begins at the edge of the upper incisors.
void TestPatientLandmarks::aTubeHasItsWayFree()
{
    QFETCH(int, which);
    const Patient& patient = patientOf(which);
    // Outer radius of the tube that fits: 8.0 mm inside is 10.9, 6.5 mm is 8.9 mm outside.
    const double radius = 0.5 * (which == 0 ? 10.9 : 8.9) * kMillimetre;
    const auto& path = patient.anatomy.landmarks.path_A;
    for (const AnatomyPart& part : patient.anatomy.parts) {
        const bool inTheWay = part.role == PartRole::Tongue || part.role == PartRole::Tooth
                              || part.role == PartRole::Epiglottis || part.name == "Soft palate"
                              || part.name == "Hard palate"
                              || part.name.find("arytenoid") != std::string::npos;
        if (!inTheWay)
            continue;
        const SurfaceTree surface{part.levels[0]};
        const double free = part.role == PartRole::Tooth ? 0.0 : radius;
        for (const Vec3& p_A : path) {
            const double outside = distanceOutside(surface, p_A);
            QVERIFY2(outside > free, qPrintable(QStringLiteral("%1: %2 mm")
                                                    .arg(QString::fromStdString(part.name))
                                                    .arg(1e3 * outside)));
        }
    }
}

/// Were the way to lead through the middle of a tongue, whose surface is far, it would be noticed.
void TestPatientLandmarks::theMiddleOfASolidIsNotFree()
{
    const Patient& patient = patientOf(0);
    const TriangleMesh& tongue =
        std::ranges::find(patient.anatomy.parts, PartRole::Tongue, &AnatomyPart::role)->levels[0];
    const Vec3 middle = boundsOf(tongue).centre();
    QVERIFY(test::windingNumber(tongue, middle) > 0.5);
    QVERIFY(distanceOutside(SurfaceTree{tongue}, middle) < -5.0 * kMillimetre);
}

CARINA_TEST(TestPatientLandmarks)

} // namespace carina::patient_landmarks_test

#include "tst_patient_landmarks.moc"
