#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "tests/engine/anatomy/shapes/people.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::heart_shape_test
{

using test::named;

/// Heart and great vessels between the lungs.
class TestHeartShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasItsSizeInAMan();
    void liesToTheLeftWithItsApex_data() { test::people(); }
    void liesToTheLeftWithItsApex();
    void aortaArchesOverTheLeftMainBronchus_data() { test::people(); }
    void aortaArchesOverTheLeftMainBronchus();
    void vesselsLeaveTheHeart_data() { test::people(); }
    void vesselsLeaveTheHeart();
    void isWithinNothingElse_data() { test::people(); }
    void isWithinNothingElse();
    void vesselsKeepApart_data() { test::people(); }
    void vesselsKeepApart();
};

namespace
{

constexpr double kMm = 1e-3;
const std::vector<std::string> kVessels{"Aorta", "Superior vena cava", "Inferior vena cava",
                                        "Pulmonary trunk"};

Vec3 farthest(const TriangleMesh& mesh, const Vec3& direction)
{
    return std::ranges::max(mesh.positions, {},
                            [&](const Vec3f& p) { return p.cast<double>().dot(direction); })
        .cast<double>();
}

double diameterAt(const TriangleMesh& mesh, const Vec3& p_A, const Vec3& along)
{
    return 2.0 * std::sqrt(test::sectionOf(mesh, {p_A, along}).area / 3.14159265);
}

} // namespace

/// 12 cm long and 8 to 9 cm broad (Gray); of the descending aorta, which a level cuts alone below
/// the arch, 24.4 +- 3.5 mm in Koreans (Radiol Soc 1989), and 20 mm in the man of BodyParts3D.
void TestHeartShape::hasItsSizeInAMan()
{
    const Anatomy& man = test::personCalled("man");
    const Box heart = boundsOf(named(man, "Heart"));
    QVERIFY(std::abs(heart.size().norm() - 130.0 * kMm) < 25.0 * kMm);
    QVERIFY(std::abs(heart.size().x() - 95.0 * kMm) < 12.0 * kMm);
    const double volume = signedVolume(named(man, "Heart"));
    QVERIFY2(volume > 200e-6 && volume < 800e-6, qPrintable(QString::number(1e6 * volume)));
    const Vec3 low{0.0, 0.0, heart.min.z() + 0.2 * heart.size().z()};
    const double descending = diameterAt(named(man, "Aorta"), low, Vec3::UnitZ());
    QVERIFY2(descending > 17.0 * kMm && descending < 28.0 * kMm,
             qPrintable(QString::number(descending / kMm)));
}

/// +x is the patient's left. Two thirds of it lie there.
void TestHeartShape::liesToTheLeftWithItsApex()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    const TriangleMesh& heart = named(anatomy, "Heart");
    const Box box = boundsOf(heart);
    QVERIFY(box.min.x() < 0.0);
    QVERIFY(box.max.x() > 1.5 * -box.min.x());
    const Vec3 apex = farthest(heart, Vec3{1.0, -0.4, -0.8}.normalized());
    QVERIFY(apex.x() > 0.6 * box.max.x());
    QVERIFY(apex.y() < box.centre().y());
    QVERIFY(apex.z() < box.centre().z());
    // Below the carina, above the diaphragm.
    QVERIFY(box.max.z() < 0.0);
}

void TestHeartShape::aortaArchesOverTheLeftMainBronchus()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    const Box aorta = boundsOf(named(anatomy, "Aorta"));
    QVERIFY(aorta.max.z() > 10.0 * kMm);
    QVERIFY(aorta.centre().x() > 0.0);
    const Box heart = boundsOf(named(anatomy, "Heart"));
    QVERIFY(aorta.min.z() < heart.centre().z());
    QVERIFY(aorta.max.y() > heart.max.y());
    // A level through the carina cuts it twice: before and behind the bronchus.
    const test::Section level =
        test::sectionOf(named(anatomy, "Aorta"), {Vec3::Zero(), Vec3::UnitZ()});
    int before = 0;
    int behind = 0;
    for (const Vec3& p : level.points)
        ++(p.y() < 0.0 ? before : behind);
    QVERIFY(before > 4 && behind > 4);
}

void TestHeartShape::vesselsLeaveTheHeart()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    for (const std::string& vessel : kVessels)
        QVERIFY2(test::verticesWithin(named(anatomy, vessel), named(anatomy, "Heart")) > 0,
                 vessel.c_str());
    // The venae cavae lie to the right, the upper one before the trachea's level of the carina.
    QVERIFY(boundsOf(named(anatomy, "Superior vena cava")).max.x() < 0.0);
    QVERIFY(boundsOf(named(anatomy, "Inferior vena cava")).max.x() < 0.0);
    QVERIFY(boundsOf(named(anatomy, "Superior vena cava")).max.z()
            > boundsOf(named(anatomy, "Heart")).max.z());
}

void TestHeartShape::isWithinNothingElse()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    std::vector<std::string> all = kVessels;
    all.emplace_back("Heart");
    for (const std::string& own : all)
        for (const AnatomyPart& part : anatomy.parts) {
            if (std::ranges::find(all, part.name) != all.end() || part.role == PartRole::Skin)
                continue;
            const std::string both = own + ", " + part.name;
            const int within =
                int(test::verticesWithin(named(anatomy, own), part.levels.front())
                    + test::verticesWithin(part.levels.front(), named(anatomy, own)));
            QVERIFY2(within == 0, both.c_str());
        }
}

void TestHeartShape::vesselsKeepApart()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    for (const std::string& own : kVessels)
        for (const std::string& other : kVessels)
            if (own != other)
                QVERIFY2(test::verticesWithin(named(anatomy, own), named(anatomy, other)) == 0,
                         (own + ", " + other).c_str());
}

CARINA_TEST(TestHeartShape)

} // namespace carina::heart_shape_test

#include "tst_heart_shape.moc"
