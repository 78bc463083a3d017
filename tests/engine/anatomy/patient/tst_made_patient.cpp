#include "engine/anatomy/airway/airway_measure.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::made_patient_test
{

/// Somebody who is not built in: an obese woman of 45 years and 162 cm.
class TestMadePatient : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noSurfaceMeetsItself();
    void lungsHoldWhatFatLeavesThem();
    void skinStandsOffTheRibsByTheFat();
    void isCalledByAgeAndHeight();
    void airwayOfEitherExtremeIsWhole_data();
    void airwayOfEitherExtremeIsWhole();
    void isRefusedBeforeBirth();

private:
    static const Anatomy& woman()
    {
        static const Anatomy made =
            patientFor({45.0, metres(1.62), Sex::Female, Habitus::Obese}).value();
        return made;
    }

    static Box boxOf(PartRole role)
    {
        Box box;
        for (const AnatomyPart& part : woman().parts)
            if (part.role == role && part.name.find("clavicle") == std::string::npos)
                box.include(boundsOf(part.levels.front()));
        return box;
    }
};

void TestMadePatient::noSurfaceMeetsItself()
{
    for (const AnatomyPart& part : woman().parts)
        for (const TriangleMesh& level : part.levels)
            QVERIFY2(SurfaceTree{level}.selfIntersections() == 0, part.name.c_str());
}

void TestMadePatient::airwayOfEitherExtremeIsWhole_data()
{
    QTest::addColumn<int>("teethToCarina_mm");
    QTest::newRow("the shortest of a man of 175 cm") << 205; // 0.85 and 1.15 of 240.1
    QTest::newRow("the longest") << 276;
}

/// The lungs stay as they are, and no surface meets itself.
void TestMadePatient::airwayOfEitherExtremeIsWhole()
{
    QFETCH(int, teethToCarina_mm);
    const Anatomy made =
        patientFor({30.0, metres(1.75), Sex::Male, Habitus::Normal, millimetres(teethToCarina_mm)})
            .value();
    QVERIFY(std::abs(inMillimetres(teethToCarina(made.landmarks)) - teethToCarina_mm) < 0.1);
    double volume = 0.0;
    for (const AnatomyPart& part : made.parts) {
        QVERIFY2(SurfaceTree{part.levels.front()}.selfIntersections() == 0, part.name.c_str());
        if (lungSide(part.role))
            volume += signedVolume(part.levels.front());
    }
    QVERIFY(std::abs(volume - 30e-6 * 77.0) < 0.05e-6);
}

void TestMadePatient::lungsHoldWhatFatLeavesThem()
{
    // 25.1 kg/m2 is usual; an obese patient weighs 1.65 times that and keeps 11 ml/kg.
    const double weight = 1.65 * 77.0 / (1.75 * 1.75) * 1.62 * 1.62;
    double volume = 0.0;
    for (const AnatomyPart& part : woman().parts)
        if (lungSide(part.role))
            volume += signedVolume(part.levels.front());
    QVERIFY(std::abs(volume / (11e-6 * weight) - 1.0) < 0.005);
}

void TestMadePatient::skinStandsOffTheRibsByTheFat()
{
    constexpr double kFat = 0.038;
    const Box ribs = boxOf(PartRole::Rib);
    const Box skin = boxOf(PartRole::Skin);
    QVERIFY(ribs.min.y() - skin.min.y() > 0.5 * kFat);
    QVERIFY(skin.max.y() - ribs.max.y() > 0.5 * kFat);
    QVERIFY(skin.max.x() - ribs.max.x() > 0.5 * kFat);
    QVERIFY(skin.max.z() > boxOf(PartRole::Mandible).max.z());
}

void TestMadePatient::isCalledByAgeAndHeight()
{
    QCOMPARE(woman().name, std::string{"45 years, 162 cm, woman, obese"});
    QCOMPARE(woman().contentHash, std::string{"builtin-45y-162cm-female-obese-12"});
}

void TestMadePatient::isRefusedBeforeBirth()
{
    const auto unborn = patientFor({-0.1, metres(0.45), Sex::Male, Habitus::Normal});
    QVERIFY(!unborn.has_value());
    QVERIFY(unborn.error().code == Errc::OutOfRange);
}

CARINA_TEST(TestMadePatient)

} // namespace carina::made_patient_test

#include "tst_made_patient.moc"
