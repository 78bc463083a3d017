#include "engine/anatomy/builtin_patient.h"
#include "tests/engine/anatomy/section.h"
#include "tests/engine/anatomy/surface_checks.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

using namespace carina;

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

const PartRole kRoles[] = {PartRole::Trachea,          PartRole::RightMainBronchus,
                           PartRole::LeftMainBronchus, PartRole::Larynx,
                           PartRole::Epiglottis,       PartRole::RightLung,
                           PartRole::LeftLung,         PartRole::Mandible};

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
    std::multiset<PartRole> roles;
    for (const AnatomyPart& part : anatomy.parts) {
        roles.insert(part.role);
        QVERIFY(!part.name.empty());
        QVERIFY(part.conceptId.starts_with("FMA"));
    }
    for (const PartRole role : kRoles)
        QCOMPARE(roles.count(role), std::size_t{1});
    QCOMPARE(roles.size(), std::size(kRoles));
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
    for (const AnatomyPart& part : patientOf(which).parts) {
        QCOMPARE(part.levels.size(), std::size_t{3});
        const double whole = double(part.levels[0].triangles.size());
        for (int k = 1; k < 3; ++k) {
            const double asked = whole / (k == 1 ? 4.0 : 16.0);
            const double got = double(part.levels[std::size_t(k)].triangles.size());
            QVERIFY2(std::abs(got / asked - 1.0) < kTolerance, part.name.c_str());
        }
    }
}

void TestBuiltinPatient::lungsHoldTheResidualCapacity()
{
    QFETCH(int, which);
    constexpr double kVolumeTolerance = 0.05e-6; // m^3: 0.05 ml
    constexpr double kShareTolerance = 0.005;
    const AnatomyPart& right = partWith(patientOf(which), PartRole::RightLung);
    const AnatomyPart& left = partWith(patientOf(which), PartRole::LeftLung);
    for (std::size_t k = 0; k < right.levels.size(); ++k) {
        const double r = signedVolume(right.levels[k]);
        const double both = r + signedVolume(left.levels[k]);
        QVERIFY(std::abs(both - publishedOf(which).residualCapacity) < kVolumeTolerance);
        QVERIFY(std::abs(r / both - 0.525) < kShareTolerance);
    }
}

void TestBuiltinPatient::rightLungIsOnTheRightWiderAndShorter()
{
    QFETCH(int, which);
    const Box right = boundsOf(partWith(patientOf(which), PartRole::RightLung).levels[0]);
    const Box left = boundsOf(partWith(patientOf(which), PartRole::LeftLung).levels[0]);
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
    for (const PartRole role : {PartRole::RightLung, PartRole::LeftLung}) {
        const TriangleMesh& lung = partWith(patientOf(which), role).levels[0];
        const Box box = boundsOf(lung);
        // The apex is above the carina, most of the lung below it.
        QVERIFY(box.max.z() > 0.0);
        QVERIFY(-box.min.z() > box.max.z());
        // The base is hollow: a plane a little above the lowest point meets a rim, not the middle.
        const Vec3 above{0.0, 0.0, box.min.z() + 0.1 * box.size().z()};
        const test::Section rim = test::sectionOf(lung, {above, Vec3::UnitZ()});
        const Vec3 middle{box.centre().x(), box.centre().y(), above.z()};
        QVERIFY(rim.area > 0.0);
        QVERIFY(test::windingNumber(lung, middle) < 0.5);
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
    for (const PartRole lungRole : {PartRole::RightLung, PartRole::LeftLung}) {
        const TriangleMesh& lung = partWith(anatomy, lungRole).levels[1];
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
    const Box larynx = boundsOf(partWith(anatomy, PartRole::Larynx).levels[0]);
    QVERIFY(jaw.min.y() < larynx.min.y());
    QVERIFY(std::abs(jaw.centre().x()) < 1e-3);
    // Behind the chin two halves with room between them; the jaw lies below the upper incisors and
    // its condyles above.
    const test::Section halves = test::sectionOf(
        mandible, {Vec3{0.0, jaw.min.y() + 0.4 * jaw.size().y(), 0.0}, Vec3::UnitY()});
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
    QVERIFY(builtinOfHash(again.contentHash) == BuiltinPatient::TwelveYears);
    QVERIFY(builtinOfHash(patientOf(0).contentHash) == BuiltinPatient::Adult);
    QVERIFY(!builtinOfHash("builtin-adult-0"));
    for (std::size_t i = 0; i < again.parts.size(); ++i)
        QVERIFY(again.parts[i].levels[2].positions == patientOf(1).parts[i].levels[2].positions);
}

QTEST_APPLESS_MAIN(TestBuiltinPatient)
#include "tst_builtin_patient.moc"
