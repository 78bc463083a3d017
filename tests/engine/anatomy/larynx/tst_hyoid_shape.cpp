#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "tests/engine/anatomy/shapes/people.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::hyoid_shape_test
{

using test::named;

/// The hyoid bone among its neighbours, in grown people and children.
class TestHyoidShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasItsSizeInAMan();
    void liesAtTheFourthVertebraAndHigherInChildren();
    void liesBeforeTheEpiglottisAndAboveTheThyroid_data() { test::people(); }
    void liesBeforeTheEpiglottisAndAboveTheThyroid();
    void entersNeitherBoneNorAir_data() { test::people(); }
    void entersNeitherBoneNorAir();
    void restsWithTheEpiglottis();
};

namespace
{

constexpr double kMm = 1e-3;

Box hyoidOf(const Anatomy& anatomy) { return boundsOf(named(anatomy, "Hyoid bone")); }

/// Where a height lies among the cervical vertebrae: 3 at the upper end of the third, 4 at that of
/// the fourth.
double cervicalLevel(const Anatomy& anatomy, double z)
{
    const auto heightOf = [&](const char* vertebra) {
        return boundsOf(named(anatomy, vertebra)).max.z();
    };
    const double third = heightOf("Third cervical vertebra");
    const double fourth = heightOf("Fourth cervical vertebra");
    return 3.0 + (third - z) / (third - fourth);
}

} // namespace

/// 41.8 +- 5.1 mm wide, 36.3 +- 3.3 mm long (Monteiro and Jaseemudheen, 34 men).
void TestHyoidShape::hasItsSizeInAMan()
{
    const Vec3 size = hyoidOf(test::personCalled("man")).size();
    QVERIFY2(std::abs(size.x() - 41.8 * kMm) < 2.0 * 5.1 * kMm,
             qPrintable(QString::number(size.x() / kMm)));
    QVERIFY2(std::abs(size.y() - 36.3 * kMm) < 2.0 * 3.3 * kMm,
             qPrintable(QString::number(size.y() / kMm)));
}

/// The third cervical vertebra at rest; lower with the mouth open.
void TestHyoidShape::liesAtTheFourthVertebraAndHigherInChildren()
{
    const auto level = [](const char* who) {
        const Anatomy& anatomy = test::personCalled(who);
        return cervicalLevel(anatomy, hyoidOf(anatomy).centre().z());
    };
    for (const char* grown : {"man", "woman"})
        QVERIFY2(level(grown) > 3.0 && level(grown) < 4.8,
                 qPrintable(QString::number(level(grown))));
    QVERIFY2(level("6 years") < level("man") - 0.2, qPrintable(QString::number(level("6 years"))));
}

void TestHyoidShape::liesBeforeTheEpiglottisAndAboveTheThyroid()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    const Vec3 up = anatomy.landmarks.p_A_glottis.normalized();
    const Box hyoid = hyoidOf(anatomy);
    QVERIFY(hyoid.min.y() < boundsOf(named(anatomy, "Epiglottis")).min.y());
    QVERIFY(std::abs(hyoid.centre().x()) < kMm);
    const Box thyroid = boundsOf(named(anatomy, "Thyroid cartilage"));
    QVERIFY((hyoid.centre() - thyroid.centre()).dot(up) > 0.2 * thyroid.size().z());
}

/// Its body lies in the root of the tongue, with the mucosa that is hidden there.
void TestHyoidShape::entersNeitherBoneNorAir()
{
    QFETCH(QString, name);
    const Anatomy& anatomy = test::personCalled(name.toStdString());
    const TriangleMesh& hyoid = named(anatomy, "Hyoid bone");
    for (const char* other : {"Mandible", "Thyroid cartilage", "Epiglottis", "Laryngeal mucosa",
                              "Middle pharyngeal constrictor", "Inferior pharyngeal constrictor",
                              "Median glosso-epiglottic fold", "Third cervical vertebra",
                              "Left palatopharyngeal arch", "Right palatopharyngeal arch"})
        QCOMPARE(test::verticesWithin(hyoid, named(anatomy, other)), 0);
    // The way of a tube keeps clear of it.
    const SurfaceTree bone{hyoid};
    for (const Vec3& p_A : anatomy.landmarks.path_A)
        QVERIFY(bone.distanceTo(p_A) > 2.0 * kMm);
}

/// At rest the epiglottis leans back, and the hyoid bone lies as far in front of it as held.
void TestHyoidShape::restsWithTheEpiglottis()
{
    const Anatomy rest = patientFor(parametersOf(BuiltinPatient::Adult), Posture::Rest).value();
    const Anatomy& held = test::personCalled("man");
    QVERIFY(hyoidOf(rest).min.y() > hyoidOf(held).min.y() + 5.0 * kMm);
    const double level = cervicalLevel(rest, hyoidOf(rest).centre().z());
    QVERIFY2(level > 2.5 && level < 4.0, qPrintable(QString::number(level)));
    QCOMPARE(test::verticesWithin(named(rest, "Hyoid bone"), named(rest, "Thyroid cartilage")), 0);
    QCOMPARE(test::verticesWithin(named(rest, "Hyoid bone"), named(rest, "Epiglottis")), 0);
}

CARINA_TEST(TestHyoidShape)

} // namespace carina::hyoid_shape_test

#include "tst_hyoid_shape.moc"
