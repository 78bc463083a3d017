#include "engine/anatomy/organ_group.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/role_recognition.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/engine/anatomy/shapes/surface_checks.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace carina::builtin_patient_test
{

class TestBuiltinPatient : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasThePartsADoctorLooksFor_data() { patients(); }
    void hasThePartsADoctorLooksFor();
    void everyLevelIsClosedAndFacesOutward_data() { patients(); }
    void everyLevelIsClosedAndFacesOutward();
    void coarserLevelsHaveAQuarterEach_data() { patients(); }
    void coarserLevelsHaveAQuarterEach();
    void lungsHoldTheResidualCapacity_data() { patients(); }
    void lungsHoldTheResidualCapacity();
    void rightLungIsOnTheRightWiderAndShorter_data() { patients(); }
    void rightLungIsOnTheRightWiderAndShorter();
    void lungsReachAboveAndAroundTheDome_data() { patients(); }
    void lungsReachAboveAndAroundTheDome();
    void lungsKeepClearOfTracheaAndBronchi_data() { patients(); }
    void lungsKeepClearOfTracheaAndBronchi();
    void mandibleIsAHorseshoeInFrontOfTheLarynx_data() { patients(); }
    void mandibleIsAHorseshoeInFrontOfTheLarynx();
    void sameBuildMakesTheSamePatient();

private:
    static void patients();
};

namespace
{

/// How many surfaces there are of each role.
const std::map<PartRole, std::size_t> kRoles{
    {PartRole::Trachea, 1},
    {PartRole::RightMainBronchus, 1},
    {PartRole::LeftMainBronchus, 1},
    {PartRole::BronchialTree, 19}, // segments
    {PartRole::Larynx, 6},         // thyroid, cricoid, two arytenoids, two cords
    {PartRole::Hyoid, 1},
    {PartRole::Epiglottis, 1},
    {PartRole::RightUpperLobe, 1},
    {PartRole::RightMiddleLobe, 1},
    {PartRole::RightLowerLobe, 1},
    {PartRole::LeftUpperLobe, 1},
    {PartRole::LeftLowerLobe, 1},
    {PartRole::Diaphragm, 1},
    {PartRole::Mandible, 1},
    {PartRole::Tooth, 28},
    {PartRole::Tongue, 2}, // with the muscles from which it comes
    // Three constrictors, hard and soft palate, uvula, four arches and two tonsils, mucosa.
    {PartRole::Pharynx, 13},
    {PartRole::Mucosa, 6}, // the fold in the vallecula, gums, lips and cheeks
    // The lining, two vestibular and two aryepiglottic folds, four tubercles and the vallecula.
    {PartRole::LaryngealMucosa, 10},
    {PartRole::VocalFold, 2},
    {PartRole::Skull, 2}, // cranium and maxilla
    {PartRole::Oesophagus, 1},
    {PartRole::Heart, 1},
    {PartRole::Vessel, 4},            // aorta, venae cavae, pulmonary trunk
    {PartRole::Spine, 19},            // seven cervical, twelve thoracic
    {PartRole::Rib, 24 + 14 + 3 + 2}, // ribs, cartilages, sternum, clavicles
    {PartRole::Skin, 1}};

struct Published {
    double residualCapacity; ///< m^3
};

const Anatomy& patientOf(int which)
{
    static const Anatomy adult = builtinPatient(BuiltinPatient::Adult).value();
    static const Anatomy child = builtinPatient(BuiltinPatient::TwelveYears).value();
    return which == 0 ? adult : child;
}

Published publishedOf(int which) { return {which == 0 ? 2.31e-3 : 1.2e-3}; }

double lungVolume(const Anatomy& anatomy, Side side, std::size_t level)
{
    double volume = 0.0;
    for (const AnatomyPart& part : anatomy.parts)
        if (lungSide(part.role) == side)
            volume += signedVolume(part.levels[level]);
    return volume;
}

Box lungBox(const Anatomy& anatomy, Side side)
{
    Box box;
    for (const AnatomyPart& part : anatomy.parts)
        if (lungSide(part.role) == side)
            box.include(boundsOf(part.levels[0]));
    return box;
}

const AnatomyPart& partWith(const Anatomy& anatomy, PartRole role)
{
    return *std::find_if(anatomy.parts.begin(), anatomy.parts.end(),
                         [role](const AnatomyPart& part) { return part.role == role; });
}

} // namespace

void TestBuiltinPatient::patients()
{
    QTest::addColumn<int>("which");
    QTest::newRow("adult") << 0;
    QTest::newRow("twelve years") << 1;
}

void TestBuiltinPatient::hasThePartsADoctorLooksFor()
{
    QFETCH(int, which);
    const Anatomy& anatomy = patientOf(which);
    std::map<PartRole, std::size_t> roles;
    std::set<std::string> names;
    for (const AnatomyPart& part : anatomy.parts) {
        ++roles[part.role];
        names.insert(part.name);
        QVERIFY(!part.name.empty());
        // Of surfaces of mucosa, and of muscles drawn as one, no number is known.
        QVERIFY(part.conceptId.starts_with("FMA")
                || (part.conceptId.empty() && groupOf(part.role) == OrganGroup::Airway));
        // What a part is called says what it is, as in an imported set.
        QVERIFY2(recogniseRole(part.conceptId, part.name) == part.role, part.name.c_str());
    }
    QVERIFY(roles == kRoles);
    QCOMPARE(names.size(), anatomy.parts.size());
}

void TestBuiltinPatient::everyLevelIsClosedAndFacesOutward()
{
    QFETCH(int, which);
    for (const AnatomyPart& part : patientOf(which).parts) {
        for (const TriangleMesh& level : part.levels) {
            QVERIFY2(test::edgesWithoutPartner(level) == 0, part.name.c_str());
            QVERIFY2(signedVolume(level) > 0.0, part.name.c_str());
            QVERIFY2(test::worstNormalLength(level) < 1e-5, part.name.c_str());
        }
    }
}

void TestBuiltinPatient::coarserLevelsHaveAQuarterEach()
{
    QFETCH(int, which);
    constexpr double kTolerance = 0.1; // of the number asked for
    constexpr double kFewest = 64.0;
    int more = 0; // surfaces that would fold with so few
    for (const AnatomyPart& part : patientOf(which).parts) {
        QCOMPARE(part.levels.size(), std::size_t{3});
        const double whole = double(part.levels[0].triangles.size());
        const double got =
            double(part.levels[2].triangles.size()) / std::max(whole / 16.0, kFewest);
        const double middle = 4.0 * double(part.levels[1].triangles.size()) / whole;
        QVERIFY2(got > 1.0 - kTolerance && middle > 1.0 - kTolerance, part.name.c_str());
        QVERIFY2(got < 4.0 && middle < 4.0, part.name.c_str());
        more += got > 1.0 + kTolerance || middle > 1.0 + kTolerance ? 1 : 0;
    }
    QVERIFY2(more < 5, qPrintable(QString::number(more)));
}

void TestBuiltinPatient::lungsHoldTheResidualCapacity()
{
    QFETCH(int, which);
    constexpr double kVolumeTolerance = 0.05e-6; // m^3: 0.05 ml
    constexpr double kShareTolerance = 0.005;
    for (std::size_t k = 0; k < 3; ++k) {
        const double r = lungVolume(patientOf(which), Side::Right, k);
        const double both = r + lungVolume(patientOf(which), Side::Left, k);
        QVERIFY(std::abs(both - publishedOf(which).residualCapacity) < kVolumeTolerance);
        QVERIFY(std::abs(r / both - 0.525) < kShareTolerance);
    }
}

void TestBuiltinPatient::rightLungIsOnTheRightWiderAndShorter()
{
    QFETCH(int, which);
    const Box right = lungBox(patientOf(which), Side::Right);
    const Box left = lungBox(patientOf(which), Side::Left);
    QVERIFY(right.max.x() < 0.0);
    QVERIFY(left.min.x() > 0.0);
    QVERIFY(right.size().z() < left.size().z());
    const Box rightBronchus =
        boundsOf(partWith(patientOf(which), PartRole::RightMainBronchus).levels[0]);
    QVERIFY(rightBronchus.centre().x() < 0.0);
}

void TestBuiltinPatient::lungsReachAboveAndAroundTheDome()
{
    QFETCH(int, which);
    const Anatomy& anatomy = patientOf(which);
    for (const Side side : {Side::Right, Side::Left}) {
        const Box box = lungBox(anatomy, side);
        // The apex is above the carina, most of the lung below it.
        QVERIFY(box.max.z() > 0.0);
        QVERIFY(-box.min.z() > box.max.z());
        // The base is hollow: a plane a little above the lowest point meets a rim, not the middle.
        const TriangleMesh& lower = partWith(anatomy, side == Side::Right ? PartRole::RightLowerLobe
                                                                          : PartRole::LeftLowerLobe)
                                        .levels[0];
        const Vec3 above{0.0, 0.0, box.min.z() + 0.1 * box.size().z()};
        const test::Section rim = test::sectionOf(lower, {above, Vec3::UnitZ()});
        const Vec3 middle{box.centre().x(), box.centre().y(), above.z()};
        QVERIFY(rim.area > 0.0);
        QVERIFY(test::windingNumber(lower, middle) < 0.5);
    }
}

void TestBuiltinPatient::lungsKeepClearOfTracheaAndBronchi()
{
    QFETCH(int, which);
    constexpr std::size_t kEvery = 50; // a sample of the vertices is enough
    const Anatomy& anatomy = patientOf(which);
    const std::pair<PartRole, double> reaches[] = {{PartRole::Trachea, 1.0},
                                                   {PartRole::RightMainBronchus, 0.023},
                                                   {PartRole::LeftMainBronchus, 0.040}};
    for (const AnatomyPart& part : anatomy.parts) {
        if (!lungSide(part.role))
            continue;
        const TriangleMesh& lung = part.levels[1];
        for (const auto& [role, reach] : reaches) {
            const TriangleMesh& airway = partWith(anatomy, role).levels[0];
            for (std::size_t i = 0; i < airway.positions.size(); i += kEvery) {
                const Vec3 p_A = airway.positions[i].cast<double>();
                if (p_A.norm() < reach) // beyond that way from the carina lies the hilum
                    QVERIFY2(test::windingNumber(lung, p_A) < 0.5, roleName(role));
            }
        }
    }
}

void TestBuiltinPatient::mandibleIsAHorseshoeInFrontOfTheLarynx()
{
    QFETCH(int, which);
    const Anatomy& anatomy = patientOf(which);
    const TriangleMesh& mandible = partWith(anatomy, PartRole::Mandible).levels[0];
    const Box jaw = boundsOf(mandible);
    const Box larynx = boundsOf(partWith(anatomy, PartRole::Larynx).levels[0]); // the thyroid
    QVERIFY(jaw.min.y() < larynx.min.y());
    QVERIFY(std::abs(jaw.centre().x()) < 1e-3);
    // Behind the chin two halves with room between them; the jaw lies below the upper incisors and
    // its condyles above.
    const test::Section halves = test::sectionOf(
        mandible, {Vec3{0.0, jaw.min.y() + 0.5 * jaw.size().y(), 0.0}, Vec3::UnitY()});
    const double nearest =
        std::abs(std::min_element(halves.points.begin(), halves.points.end(), [](auto& a, auto& b) {
                     return std::abs(a.x()) < std::abs(b.x());
                 })->x());
    QVERIFY(nearest > 0.2 * jaw.size().x());
    QVERIFY(jaw.max.z() > anatomy.landmarks.p_A_incisors.z());
    QVERIFY(jaw.min.z() < anatomy.landmarks.p_A_incisors.z());
}

void TestBuiltinPatient::sameBuildMakesTheSamePatient()
{
    const Anatomy again = builtinPatient(BuiltinPatient::TwelveYears).value();
    QCOMPARE(again.contentHash, patientOf(1).contentHash);
    QVERIFY(again.contentHash != patientOf(0).contentHash);
    for (std::size_t i = 0; i < again.parts.size(); ++i)
        QVERIFY(again.parts[i].levels[2].positions == patientOf(1).parts[i].levels[2].positions);
}

CARINA_TEST(TestBuiltinPatient)

} // namespace carina::builtin_patient_test

#include "tst_builtin_patient.moc"
