#include "evaluation/anatomy/measured_dimensions.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "evaluation/anatomy/published_dimensions.h"
#include "tests/evaluation/anatomy/known_airway.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace carina::measured_dimensions_test
{
namespace
{

constexpr double kExact = 1e-3; ///< mm, ml or percent

AnatomyPart boxPart(const char* name, PartRole role, const Vec3& low, const Vec3& high)
{
    return {.name = name, .role = role, .conceptId = {}, .levels = {test::boxOf(low, high)}};
}

bool isNear(double value, double expected, double tolerance = kExact)
{
    return std::abs(value - expected) < tolerance;
}

} // namespace

class TestMeasuredDimensions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Boxes, whose sizes are known; nothing of an airway, of which there is none.
    void measuresWhatIsThere()
    {
        Anatomy boxes;
        boxes.parts = {
            boxPart("Tongue", PartRole::Tongue, {0.0, 0.0, 0.0}, {0.04, 0.05, 0.03}),
            boxPart("Mandible", PartRole::Mandible, {-0.045, 0.0, 0.0}, {0.045, 0.08, 0.05}),
            boxPart("Right lung", PartRole::RightLung, {-0.2, 0.0, 0.0}, {-0.1, 0.1, 0.3}),
            boxPart("Left lung", PartRole::LeftLung, {0.1, 0.0, 0.0}, {0.2, 0.1, 0.1})};
        const auto found = measuredDimensions(boxes);
        QCOMPARE(found.size(), std::size_t{3});
        QVERIFY(isNear(found.at("tongue_ml"), 60.0));
        QVERIFY(isNear(found.at("bigonial_mm"), 90.0));
        QVERIFY(isNear(found.at("right_lung_percent"), 75.0));
    }

    /// What the formulas have: the surfaces are meshes of them, to a voxel.
    void agreesWithWhatAManIsMadeBy()
    {
        constexpr double kVoxel_mm = 1.5;
        constexpr double kAngle_deg = 1.5;
        const auto man = builtinPatient(BuiltinPatient::Adult);
        QVERIFY(man.has_value());
        const PatientDimensions made = dimensionsOf(BuiltinPatient::Adult);
        const auto found = measuredDimensions(*man);
        QVERIFY(found.size() >= 20);
        for (const auto& [name, value] : found)
            QVERIFY2(std::isfinite(value) && value > 0.0, name.c_str());
        QVERIFY(
            isNear(found.at("trachea_length_mm"), inMillimetres(made.tracheaLength), kVoxel_mm));
        QVERIFY(
            isNear(found.at("teeth_to_carina_mm"), inMillimetres(made.teethToCarina), kVoxel_mm));
        QVERIFY(isNear(found.at("cords_to_carina_mm"), inMillimetres(made.cordsToCarina),
                       2.0 * kVoxel_mm));
        QVERIFY(isNear(found.at("right_bronchus_deg"), inDegrees(made.rightBronchus.fromTrachea),
                       kAngle_deg));
        QVERIFY(isNear(found.at("left_bronchus_deg"), inDegrees(made.leftBronchus.fromTrachea),
                       kAngle_deg));
        QVERIFY(found.at("trachea_lumen_coronal_mm") < inMillimetres(made.tracheaCoronal));
        QVERIFY(found.at("cricoid_lamina_mm") > found.at("cricoid_arch_mm"));
        QVERIFY(isNear(found.at("right_lung_percent"), 100.0 * made.rightLungShare, 0.1));
    }

    /// 0.0070 h + 0.05 and 0.0065 h + 0.18 cm, h being the height (Griscom et al., CT of 34
    /// children up to six years). From there on the air is that of older children.
    void findsTheAirOfInfantsAsPublished()
    {
        for (const auto& [age, height_cm, tolerance_mm] :
             {std::tuple{0.0, 50.0, 0.3}, std::tuple{1.0, 75.0, 0.3}, std::tuple{3.0, 96.0, 0.3},
              std::tuple{6.0, 116.0, 0.6}}) {
            const auto found = measuredDimensions(
                patientFor({.ageInYears = age, .height = metres(height_cm / 100.0)}).value());
            for (const auto& [name, published_mm] :
                 {std::pair{"trachea_lumen_sagittal_mm", 0.070 * height_cm + 0.5},
                  std::pair{"trachea_lumen_coronal_mm", 0.065 * height_cm + 1.8}})
                QVERIFY2(isNear(found.at(name), published_mm, tolerance_mm),
                         qPrintable(QString::number(found.at(name))));
        }
    }

    void asksTheFiguresOfTheAgeAndSex()
    {
        const PatientParameters woman{
            .ageInYears = 30.0, .height = metres(1.62), .sex = Sex::Female};
        const PatientParameters child{.ageInYears = 6.0, .height = metres(1.16)};
        for (const PublishedDimension& published : publishedDimensions()) {
            QVERIFY(!published.source.empty() && published.meanFor(woman) > 0.0);
            QVERIFY(!published.deviation || *published.deviation > 0.0);
            QVERIFY(!(published.holdsFor(woman) && published.holdsFor(child)));
            if (published.sex == Sex::Male)
                QVERIFY(!published.holdsFor(woman));
        }
        const auto all = publishedDimensions();
        const auto tongue = std::ranges::find_if(all, [&](const PublishedDimension& published) {
            return published.name == "tongue_ml" && published.holdsFor(woman);
        });
        QCOMPARE(tongue->meanFor(woman), 68.9);
        // 0.12 of 116 cm and 5.2 cm.
        const auto teeth = std::ranges::find_if(all, [&](const PublishedDimension& published) {
            return published.name == "teeth_to_carina_mm" && published.holdsFor(child);
        });
        QVERIFY(isNear(teeth->meanFor(child), 191.2));
    }

    /// Nothing is published under a name that is not measured.
    void measuresEachPublishedDimension()
    {
        const auto found = measuredDimensions(builtinPatient(BuiltinPatient::TwelveYears).value());
        for (const PublishedDimension& published : publishedDimensions())
            QVERIFY2(found.contains(std::string{published.name}), published.name.data());
    }
};

CARINA_TEST(TestMeasuredDimensions)

} // namespace carina::measured_dimensions_test

#include "tst_measured_dimensions.moc"
