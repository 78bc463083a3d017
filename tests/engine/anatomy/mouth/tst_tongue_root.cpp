#include "engine/anatomy/mouth/tongue_root.h"

#include "engine/anatomy/airway/jaw_hinge.h"
#include "engine/anatomy/mouth/throat_air.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/anatomy/shapes/surface_mesher.h"
#include "engine/anatomy/skeleton/mandible_shape.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina::tongue_root_test
{
namespace
{

/// Tongue, root and mandible of a patient, as surfaces.
struct Mouth {
    BodyPlan plan;
    TriangleMesh tongue;
    TriangleMesh root;
    ImplicitShape mandible;

    Mouth(const QString& words, Posture posture)
        : plan(bodyPlanOf(dimensionsFor(patientFromWords(words.toStdString()).value()).value(),
                          posture)),
          mandible(onJaw(plan, mandibleShape(plan.inFace(kUpperToLowerIncisors), 1e3 * plan.face)))
    {
        const LarynxFrame larynx{plan.dimensions};
        const Epiglottis epiglottis{plan};
        const Tongue shape{plan, larynx, epiglottis};
        const Length voxel = 1e3 * plan.face * millimetres(1.6);
        tongue =
            meshOf({shape.bounds(), [&](const Vec3& p_A) { return shape.distance(p_A); }}, voxel);
        root = meshOf(tongueRoot(plan, larynx, epiglottis, shape).shape, voxel);
    }

    [[nodiscard]] double volume_ml() const
    {
        return 1e6 * (signedVolume(tongue) + signedVolume(root));
    }
};

double volumeAtRest_ml(const char* words)
{
    return Mouth{QString::fromLatin1(words), Posture::Rest}.volume_ml();
}

} // namespace

class TestTongueRoot : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void givesTheTongueItsVolume_data();
    void givesTheTongueItsVolume();
    void growsWithTheChild();
    void liesBelowTheFloorAndWithinTheMandible_data();
    void liesBelowTheFloorAndWithinTheMandible();
};

/// MRI of 70 (Liegeois, Albert and Limme 2010).
void TestTongueRoot::givesTheTongueItsVolume_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<double>("mean_ml");
    QTest::addColumn<double>("deviation_ml");
    QTest::newRow("man") << "adult" << 89.9 << 11.5;
    QTest::newRow("woman") << "30 years, 162 cm, woman" << 68.9 << 7.0;
}

void TestTongueRoot::givesTheTongueItsVolume()
{
    QFETCH(QString, words);
    QFETCH(double, mean_ml);
    QFETCH(double, deviation_ml);
    const double volume = Mouth{words, Posture::Rest}.volume_ml();
    QVERIFY2(std::abs(volume - mean_ml) < deviation_ml, qPrintable(QString::number(volume)));
}

void TestTongueRoot::growsWithTheChild()
{
    double before = 0.0;
    for (const char* words :
         {"newborn, 50 cm, girl", "1 year, 75 cm, boy", "6 years, 116 cm, boy", "child", "adult"}) {
        const double volume = volumeAtRest_ml(words);
        QVERIFY2(volume > before + 2.0, words);
        before = volume;
    }
}

void TestTongueRoot::liesBelowTheFloorAndWithinTheMandible_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<int>("posture");
    for (const char* words :
         {"adult", "45 years, 162 cm, woman, obese", "child", "6 years, 116 cm, boy",
          "1 year, 75 cm, girl", "newborn, 50 cm, girl"})
        for (const Posture posture : {Posture::Rest, Posture::Laryngoscopy})
            QTest::addRow("%s, %d", words, int(posture))
                << QString::fromLatin1(words) << int(posture);
}

void TestTongueRoot::liesBelowTheFloorAndWithinTheMandible()
{
    QFETCH(QString, words);
    QFETCH(int, posture);
    const Mouth mouth{words, Posture(posture)};
    QVERIFY(signedVolume(mouth.root) > 0.0);
    double highest = -std::numeric_limits<double>::infinity();
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3f& p : mouth.root.positions) {
        const Vec3 p_A = p.cast<double>();
        highest = std::max(highest, mouth.plan.fromThroat(p_A).z());
        nearest = std::min(nearest, mouth.mandible.distance(p_A) / mouth.plan.face);
    }
    QVERIFY2(highest < floorOfMouth_mm(mouth.plan.posture), qPrintable(QString::number(highest)));
    QVERIFY2(nearest > 0.0, qPrintable(QString::number(nearest)));
}

CARINA_TEST(TestTongueRoot)

} // namespace carina::tongue_root_test

#include "tst_tongue_root.moc"
