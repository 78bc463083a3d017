#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/engine/anatomy/shapes/people.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::skin_shape_test
{

using test::named;

/// The skin, and the face in it.
class TestSkinShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void coversTheBonesOfHeadAndNeck_data() { test::people(); }
    void coversTheBonesOfHeadAndNeck();
    void hasANoseBeforeTheFace_data() { test::people(); }
    void hasANoseBeforeTheFace();
    void hasHollowEyesWithShutLids_data() { test::people(); }
    void hasHollowEyesWithShutLids();
    void hasEarsThatStandOff_data() { test::people(); }
    void hasEarsThatStandOff();
    void isFinerInTheFace();
};

namespace
{

constexpr double kMm = 1e-3;

/// Millimetres of a patient's face, of which the place of the first molars tells the size.
double unitOfFace(const Anatomy& anatomy)
{
    return boundsOf(named(anatomy, "Left upper first secondary molar tooth")).centre().x() / 24.3;
}

bool isInside(const Anatomy& anatomy, double x, double y, double z)
{
    const Vec3 p_A = anatomy.landmarks.p_A_incisors + unitOfFace(anatomy) * Vec3{x, y, z};
    return test::windingNumber(named(anatomy, "Skin"), p_A) > 0.5;
}

/// Where the face begins on a line from before it to the back, in its millimetres.
double surfaceAt(const Anatomy& anatomy, double x, double z)
{
    double y = -40.0;
    while (y < 60.0 && !isInside(anatomy, x, y, z))
        y += 0.5;
    return y;
}

} // namespace

void TestSkinShape::coversTheBonesOfHeadAndNeck()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    for (const char* bone : {"Cranium", "Maxilla", "Mandible", "Hyoid bone", "Atlas", "Axis",
                             "Third cervical vertebra", "Fifth cervical vertebra"}) {
        QVERIFY2(test::verticesOutside(named(anatomy, bone), named(anatomy, "Skin")) == 0, bone);
    }
}

void TestSkinShape::hasANoseBeforeTheFace()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    const double tip = surfaceAt(anatomy, 0.0, 33.0);
    QVERIFY2(tip < surfaceAt(anatomy, 26.0, 33.0) - 10.0, qPrintable(QString::number(tip)));
    QVERIFY(tip < surfaceAt(anatomy, 0.0, 75.0) - 8.0);
    QVERIFY(tip < surfaceAt(anatomy, 0.0, 16.0) - 4.0);
}

/// The lids lie behind brow and bridge of the nose, and bulge before the outer edge of the orbit.
void TestSkinShape::hasHollowEyesWithShutLids()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    for (const double side : {-1.0, 1.0}) {
        const double lids = surfaceAt(anatomy, side * 32.0, 66.0);
        QVERIFY2(lids > surfaceAt(anatomy, side * 28.0, 85.0) + 3.0,
                 qPrintable(QString::number(lids)));
        QVERIFY(lids > surfaceAt(anatomy, 0.0, 66.0) + 6.0);
        const double edge = surfaceAt(anatomy, side * 47.0, 66.0);
        QVERIFY2(lids < edge - 3.0, qPrintable(QString::number(lids - edge)));
    }
}

void TestSkinShape::hasEarsThatStandOff()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    const auto width = [&](double y, double z) {
        double x = 110.0;
        while (x > 0.0 && !isInside(anatomy, x, y, z))
            x -= 0.5;
        return x;
    };
    const double ear = std::max({width(108.0, 62.0), width(112.0, 62.0), width(116.0, 62.0)});
    QVERIFY2(ear > width(80.0, 62.0) + 6.0, qPrintable(QString::number(ear)));
    QVERIFY(ear > width(140.0, 62.0) + 6.0);
}

void TestSkinShape::isFinerInTheFace()
{
    const Anatomy& man = test::personCalled("man");
    const TriangleMesh& skin = named(man, "Skin");
    const Vec3 nose = man.landmarks.p_A_incisors + Vec3{0.0, -0.02, 0.035};
    const auto meanEdge = [&](const Vec3& p_A) {
        double sum = 0.0;
        int count = 0;
        for (const Triangle& t : skin.triangles) {
            const Vec3 a = skin.positions[t[0]].cast<double>();
            if ((a - p_A).norm() > 0.03)
                continue;
            sum += (a - skin.positions[t[1]].cast<double>()).norm();
            ++count;
        }
        return sum / std::max(count, 1);
    };
    const Vec3 belly{0.0, boundsOf(skin).min.y(), -0.15};
    QVERIFY(meanEdge(nose) > kMm);
    QVERIFY(meanEdge(nose) < 0.75 * meanEdge(belly));
}

CARINA_TEST(TestSkinShape)

} // namespace carina::skin_shape_test

#include "tst_skin_shape.moc"
