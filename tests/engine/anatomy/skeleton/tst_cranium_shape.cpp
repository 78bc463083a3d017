#include "engine/anatomy/skeleton/cranium_shape.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "tests/engine/anatomy/shapes/people.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/support/test_class.h"

#include <array>
#include <cmath>

namespace carina::cranium_shape_test
{

using test::named;

/// The skull above maxilla and lower jaw.
class TestCraniumShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isAsLongAndBroadAsPublished_data();
    void isAsLongAndBroadAsPublished();
    void isLargerForTheFaceOfAChild();
    void hasOrbitsAndAnOpenNose_data() { test::people(); }
    void hasOrbitsAndAnOpenNose();
    void standsOnTheAtlas_data() { test::people(); }
    void standsOnTheAtlas();
    void holdsTheJawsJointsAndMeetsTheMaxilla_data() { test::people(); }
    void holdsTheJawsJointsAndMeetsTheMaxilla();
    void isWithinNothingElse_data() { test::people(); }
    void isWithinNothingElse();
    void endsWithinItsBounds_data();
    void endsWithinItsBounds();
};

namespace
{

constexpr double kMm = 1e-3;

const TriangleMesh& craniumOf(const Anatomy& anatomy) { return named(anatomy, "Cranium"); }

/// A place in millimetres of this patient's face, of which the place of the first molars tells the
/// size.
struct Face {
    Vec3 p_A_incisors;
    double unit;

    explicit Face(const Anatomy& anatomy)
        : p_A_incisors(anatomy.landmarks.p_A_incisors),
          unit(boundsOf(named(anatomy, "Left upper first secondary molar tooth")).centre().x()
               / 24.3)
    {
    }
    [[nodiscard]] Vec3 place(double x, double y, double z) const
    {
        return p_A_incisors + unit * Vec3{x, y, z};
    }
};

/// The length of the braincase: the farthest back from the brow.
double lengthOf(const Anatomy& anatomy)
{
    const Box box = boundsOf(craniumOf(anatomy));
    double brow = box.max.y();
    for (const Vec3f& p : craniumOf(anatomy).positions)
        if (double(p.z()) > anatomy.landmarks.p_A_incisors.z() + 0.5 * box.size().z())
            brow = std::min(brow, double(p.y()));
    return box.max.y() - brow;
}

/// The least of what is 0 on the surface, on the six faces of the bounds; reference millimetres.
double leastOnFaces(const Cranium& bone)
{
    constexpr int kSteps = 60;
    const Box box = bone.bounds();
    double least = 1e3;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i <= kSteps; ++i)
            for (int j = 0; j <= kSteps; ++j)
                for (const double end : {0.0, 1.0}) {
                    Vec3 share;
                    share[axis] = end;
                    share[(axis + 1) % 3] = double(i) / kSteps;
                    share[(axis + 2) % 3] = double(j) / kSteps;
                    least = std::min(
                        least, bone.distance(box.min + share.cwiseProduct(box.max - box.min)));
                }
    return least;
}

} // namespace

/// Heads with skin: 189.2 mm long in grown males, 182.7 in females, 142.7 broad in females (Farkas
/// 1992, 1537 people of 1 to 18 years). The scalp is taken for 5 mm thick.
void TestCraniumShape::isAsLongAndBroadAsPublished_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("length_mm");
    QTest::addColumn<double>("tolerance_mm");
    QTest::newRow("man") << "man" << 189.2 - 10.0 << 8.0;
    QTest::newRow("woman") << "woman" << 182.7 - 10.0 << 8.0;
    // Boys of twelve and six: 97 and 94 % of a man's; the drawn face of the older is large.
    QTest::newRow("12 years") << "12 years" << 0.97 * 189.2 - 10.0 << 16.0;
    QTest::newRow("6 years") << "6 years" << 0.94 * 189.2 - 10.0 << 10.0;
}

void TestCraniumShape::isAsLongAndBroadAsPublished()
{
    QFETCH(QString, name);
    QFETCH(double, length_mm);
    QFETCH(double, tolerance_mm);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    const double length = lengthOf(anatomy) / kMm;
    QVERIFY2(std::abs(length - length_mm) < tolerance_mm, qPrintable(QString::number(length)));
    // Between a long and a round head.
    const double index = boundsOf(craniumOf(anatomy)).size().x() / kMm / length;
    QVERIFY2(index > 0.70 && index < 0.85, qPrintable(QString::number(index)));
}

void TestCraniumShape::isLargerForTheFaceOfAChild()
{
    const auto share = [](const char* who) {
        const Anatomy& anatomy = test::personCalled(who);
        return lengthOf(anatomy) / boundsOf(named(anatomy, "Mandible")).size().x();
    };
    QVERIFY(share("6 years") > 1.08 * share("man"));
    QVERIFY(share("12 years") > 1.01 * share("man"));
}

void TestCraniumShape::hasOrbitsAndAnOpenNose()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    const Face face{anatomy};
    const TriangleMesh& bone = craniumOf(anatomy);
    const auto isBone = [&](double x, double y, double z) {
        return test::windingNumber(bone, face.place(x, y, z)) > 0.5;
    };
    for (const double side : {-1.0, 1.0}) {
        for (const double deep : {12.0, 25.0, 40.0})
            QVERIFY(!isBone(side * (35.0 - 0.32 * deep), deep, 65.0));
        QVERIFY(isBone(side * 30.0, 14.0, 88.0));  // the edge above
        QVERIFY(isBone(side * 52.5, 29.0, 68.0));  // outside
        QVERIFY(isBone(side * 63.0, 64.0, 52.5));  // the arch
        QVERIFY(!isBone(side * 50.0, 55.0, 50.0)); // within it
        QVERIFY(isBone(side * 50.5, 106.0, 42.0)); // mastoid process
    }
    QVERIFY(isBone(0.0, 9.0, 80.0));
    for (const double deep : {0.0, 20.0, 40.0})
        QVERIFY(!isBone(0.0, deep, 40.0));
}

/// Its condyles are less than 2.5 mm away from the atlas and do not enter it.
void TestCraniumShape::standsOnTheAtlas()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    const TriangleMesh& atlas = named(anatomy, "Atlas");
    QCOMPARE(test::verticesWithin(craniumOf(anatomy), atlas), 0);
    QCOMPARE(test::verticesWithin(atlas, craniumOf(anatomy)), 0);
    const SurfaceTree ring{atlas};
    double nearest = 1.0;
    for (const Vec3f& p : craniumOf(anatomy).positions)
        nearest = std::min(nearest, ring.distanceTo(p.cast<double>()));
    QVERIFY2(nearest < 2.5 * kMm, qPrintable(QString::number(nearest / kMm)));
    // And its back reaches beyond the neck's.
    QVERIFY(boundsOf(craniumOf(anatomy)).max.y() > boundsOf(atlas).max.y());
}

void TestCraniumShape::holdsTheJawsJointsAndMeetsTheMaxilla()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    const SurfaceTree bone{craniumOf(anatomy)};
    double joint = 1.0;
    for (const Vec3f& p : named(anatomy, "Mandible").positions)
        joint = std::min(joint, bone.distanceTo(p.cast<double>()));
    QVERIFY2(joint < 5.0 * kMm, qPrintable(QString::number(joint / kMm)));
    double suture = 1.0;
    for (const Vec3f& p : named(anatomy, "Maxilla").positions)
        suture = std::min(suture, bone.distanceTo(p.cast<double>()));
    QVERIFY2(suture < 1.5 * kMm, qPrintable(QString::number(suture / kMm)));
}

void TestCraniumShape::isWithinNothingElse()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    for (const char* other :
         {"Maxilla", "Mandible", "Axis", "Superior pharyngeal constrictor", "Pharyngeal mucosa",
          "Buccal mucosa", "Hard palate", "Soft palate", "Gingiva of upper jaw"}) {
        if (other == std::string_view{"Pharyngeal mucosa"})
            QEXPECT_FAIL("6 years", "two vertices touch the vault of the pharynx", Continue);
        const int within = int(test::verticesWithin(craniumOf(anatomy), named(anatomy, other))
                               + test::verticesWithin(named(anatomy, other), craniumOf(anatomy)));
        QVERIFY2(within == 0, other);
    }
}

void TestCraniumShape::endsWithinItsBounds_data()
{
    QTest::addColumn<QString>("words");
    for (const char* words : {"newborn, 50 cm, girl", "3 months, 60 cm, boy", "1 year, 75 cm, girl",
                              "2 years, 87 cm, boy", "6 years, 116 cm, boy", "child",
                              "30 years, 162 cm, woman", "adult"})
        QTest::newRow(words) << QString::fromLatin1(words);
}

/// Or its mesh would be cut off there.
void TestCraniumShape::endsWithinItsBounds()
{
    QFETCH(QString, words);
    const PatientParameters who = patientFromWords(words.toStdString()).value();
    const double least =
        leastOnFaces(Cranium{bodyPlanOf(dimensionsFor(who).value(), Posture::Laryngoscopy)});
    QVERIFY2(least > 0.0, qPrintable(QString::number(least)));
}

CARINA_TEST(TestCraniumShape)

} // namespace carina::cranium_shape_test

#include "tst_cranium_shape.moc"
