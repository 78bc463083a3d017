#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/lungs/mechanics/respiratory_fold.h"
#include "engine/lungs/mechanics/respiratory_system.h"

#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <array>
#include <numbers>

namespace carina::respiratory_system_test
{

namespace
{

constexpr double kTolerance_l = 1e-9;

PatientBuild adult() { return {metres(1.75), 77.0, 40.0, Sex::Male}; }
PatientBuild child() { return {metres(1.50), 40.0, 12.0, Sex::Female}; }

/// What a small pressure at the opening adds to both sides at rest.
double complianceAtRest(const RespiratorySystem& system)
{
    double sum = 0.0;
    for (const LungMechanics& lung : system.lungs) {
        const double ofLung = inLitresPerCmH2O(lung.curve.complianceAt(lung.wallVolume));
        const double ofWall = inLitresPerCmH2O(lung.wall);
        sum += 1.0 / (1.0 / ofLung + 1.0 / ofWall);
    }
    return sum;
}

double resistanceOf(const RespiratorySystem& system)
{
    const double bronchi = system.lungs[0].bronchi.si + system.lungs[1].bronchi.si;
    return inCmH2OSecondsPerLitre({system.upperLaminar.si + 1.0 / bronchi});
}

/// The tetrahedra from a point to each triangle.
double volumeWithin(const TriangleMesh& mesh)
{
    const Vec3 apex = mesh.positions.front().cast<double>();
    double sum = 0.0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const auto from = [&](std::uint32_t vertex) -> Vec3 {
            return mesh.positions[vertex].cast<double>() - apex;
        };
        sum += from(i).dot(from(j).cross(from(k))) / 6.0;
    }
    return sum;
}

/// Pressure that a tube alone takes at 1 L/s.
double lossAt1LitrePerSecond(double diameter_mm)
{
    RespiratorySystem system = healthySystem(adult());
    intubate(system, millimetres(diameter_mm));
    return inCmH2O({system.upperLaminar.si * 1e-3 + system.upperTurbulent * 1e-6});
}

} // namespace

class TestRespiratorySystem : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasTheVolumesOfTheTable_data();
    void hasTheVolumesOfTheTable();
    void fatAddsNoLungAndTakesReserve();
    void aSlimPatientHasTheLungsOfTheHeight();
    void restsAtWhatTheSurfacesEnclose_data();
    void restsAtWhatTheSurfacesEnclose();
    void hasThePublishedComplianceAtRest();
    void restsWithARecoilOf5AndHoldsItsCapacity();
    void takesTheBuildOfABuiltinPatient();
    void hasTheResistanceOfTheTable();
    void narrowsWithYouth();
    void isAsCompliantAsInfantsAre_data();
    void isAsCompliantAsInfantsAre();
    void hasASoftChestInInfancy();
    void breathesAtTheMedianRateOfInfants_data();
    void breathesAtTheMedianRateOfInfants();
    void breathesQuietlyAsTheTableSays_data();
    void breathesQuietlyAsTheTableSays();
    void boundsABreathByTheCapacity();
    void relaxesToWhatAVentilatorMeets();
    void replacesTheUpperAirwayByATube();
    void losesMoreInANarrowTube();
    void approachesATargetByAShare();
};

void TestRespiratorySystem::hasTheVolumesOfTheTable_data()
{
    QTest::addColumn<double>("weight_kg");
    QTest::addColumn<double>("height_m");
    QTest::addColumn<double>("residual_l");
    QTest::addColumn<double>("rest_l");
    QTest::addColumn<double>("capacity_l");
    QTest::addColumn<double>("years");
    QTest::newRow("adult") << 77.0 << 1.75 << 1.232 << 2.31 << 6.16 << 30.0;
    QTest::newRow("12 years") << 40.0 << 1.50 << 0.64 << 1.2 << 3.2 << 12.0;
}

void TestRespiratorySystem::hasTheVolumesOfTheTable()
{
    QFETCH(const double, weight_kg);
    QFETCH(const double, height_m);
    QFETCH(const double, residual_l);
    QFETCH(const double, rest_l);
    QFETCH(const double, capacity_l);
    QFETCH(const double, years);
    const PatientBuild build{metres(height_m), weight_kg, years, Sex::Female};
    const LungVolumes volumes = lungVolumesOf(build);
    VERIFY_WITHIN(inLitres(volumes.residual), residual_l, kTolerance_l);
    VERIFY_WITHIN(inLitres(volumes.functionalResidual), rest_l, kTolerance_l);
    VERIFY_WITHIN(inLitres(volumes.totalCapacity), capacity_l, kTolerance_l);
    const RespiratorySystem system = healthySystem(build);
    VERIFY_WITHIN(inLitres(system.lungs[0].wallVolume), 0.525 * rest_l, kTolerance_l);
    VERIFY_WITHIN(inLitres(system.lungs[1].wallVolume), 0.475 * rest_l, kTolerance_l);
}

void TestRespiratorySystem::fatAddsNoLungAndTakesReserve()
{
    const PatientBuild lean{metres(1.75), 26.0 * 1.75 * 1.75, 40.0, Sex::Male};
    PatientBuild obese = lean;
    obese.weightInKilograms = 127.0;
    const LungVolumes usual = lungVolumesOf(lean);
    const LungVolumes left = lungVolumesOf(obese);
    QCOMPARE(left.totalCapacity.si, usual.totalCapacity.si);
    QCOMPARE(left.residual.si, usual.residual.si);
    // 11 ml/kg of 127 kg (Benumof).
    VERIFY_WITHIN(inLitres(left.functionalResidual), 0.011 * 127.0, 0.01);
    obese.weightInKilograms = 400.0; // no weight takes what cannot be breathed out
    QVERIFY(lungVolumesOf(obese).functionalResidual > usual.residual);
}

/// Lung volumes go with height, and do not fall with a low weight.
void TestRespiratorySystem::aSlimPatientHasTheLungsOfTheHeight()
{
    PatientBuild slim = adult();
    slim.weightInKilograms *= 0.8;
    QCOMPARE(lungVolumesOf(slim).functionalResidual.si,
             lungVolumesOf(adult()).functionalResidual.si);
    QCOMPARE(lungVolumesOf(slim).totalCapacity.si, lungVolumesOf(adult()).totalCapacity.si);
    QVERIFY(healthySystem(slim) == healthySystem(adult()));
    QVERIFY(restingPattern(slim) == restingPattern(adult()));
}

void TestRespiratorySystem::restsAtWhatTheSurfacesEnclose_data()
{
    QTest::addColumn<double>("height_m");
    QTest::addColumn<Habitus>("habitus");
    QTest::newRow("adult") << 1.75 << Habitus::Normal;
    QTest::newRow("slim") << 1.78 << Habitus::Slim;
    QTest::newRow("obese") << 1.75 << Habitus::Obese;
}

/// The gas of each lung at rest, beside the volume within its surfaces: the mesh of whoever is
/// drawn, added up here.
void TestRespiratorySystem::restsAtWhatTheSurfacesEnclose()
{
    QFETCH(const double, height_m);
    QFETCH(const Habitus, habitus);
    const PatientParameters person{30.0, metres(height_m), Sex::Male, habitus};
    const Anatomy made = patientFor(person).value();
    std::array<double, 2> enclosed_m3{};
    for (const AnatomyPart& part : made.parts)
        if (const auto side = lungSide(part.role))
            enclosed_m3[*side == Side::Right ? 0 : 1] += volumeWithin(part.levels.front());
    const RespiratorySystem system = healthySystem(buildOf(dimensionsFor(person).value()));
    const ChestContent rest = restingContent(system);
    for (std::size_t i = 0; i < rest.size(); ++i)
        VERIFY_WITHIN(rest[i].gas.si / enclosed_m3[i], 1.0, 0.01);
}

/// The system of an adult 0.1, of a child of 12 about 0.05 L/cmH2O; the right side of an adult
/// 0.05.
void TestRespiratorySystem::hasThePublishedComplianceAtRest()
{
    VERIFY_WITHIN(complianceAtRest(healthySystem(adult())), 0.1, 1e-9);
    VERIFY_WITHIN(complianceAtRest(healthySystem(child())), 0.1 * 40.0 / 77.0, 1e-9);
    VERIFY_WITHIN(complianceAtRest(healthySystem(child())), 0.05, 0.005);
}

void TestRespiratorySystem::restsWithARecoilOf5AndHoldsItsCapacity()
{
    for (const PatientBuild& build : {adult(), child()}) {
        const RespiratorySystem system = healthySystem(build);
        Volume capacity;
        for (const LungMechanics& lung : system.lungs) {
            VERIFY_WITHIN(inCmH2O(lung.curve.pressureAt(lung.wallVolume)), 5.0, 1e-9);
            QCOMPARE(lung.wallRecoil, cmH2O(5.0));
            VERIFY_WITHIN(lung.curve.floor / lung.wallVolume, 0.25, 1e-12);
            capacity = capacity + lung.curve.floor + lung.curve.span;
        }
        VERIFY_WITHIN(inLitres(capacity), 0.08 * build.weightInKilograms, kTolerance_l);
    }
}

void TestRespiratorySystem::takesTheBuildOfABuiltinPatient()
{
    QVERIFY(buildOf(dimensionsOf(BuiltinPatient::Adult)) == PatientBuild{});
    QVERIFY(buildOf(dimensionsOf(BuiltinPatient::TwelveYears))
            == (PatientBuild{metres(1.5), 40.0, 12.0, Sex::Male}));
}

/// 1.125 above the carina and 0.45 cmH2O s/L in all bronchi; each lung has its share of them.
void TestRespiratorySystem::hasTheResistanceOfTheTable()
{
    const RespiratorySystem system = healthySystem(adult());
    VERIFY_WITHIN(inCmH2OSecondsPerLitre(system.upperLaminar), 1.125, 1e-12);
    QCOMPARE(system.upperTurbulent, 0.0);
    VERIFY_WITHIN(resistanceOf(system), 1.575, 1e-12);
    VERIFY_WITHIN(system.lungs[0].bronchi.si / system.lungs[1].bronchi.si, 0.525 / 0.475, 1e-12);
}

/// 13 cmH2O s/L at 2 years, 3 at 18, about 5 at 12, and never less than the table's adult.
void TestRespiratorySystem::narrowsWithYouth()
{
    const auto resistanceAt = [](double years) {
        PatientBuild build = adult();
        build.ageInYears = years;
        return resistanceOf(healthySystem(build));
    };
    VERIFY_WITHIN(resistanceAt(0.0), 25.0, 5.0); // 20 to 30 in textbooks
    VERIFY_WITHIN(resistanceAt(2.0), 13.0, 1e-9);
    QVERIFY(resistanceAt(1.0) < resistanceAt(0.5));
    VERIFY_WITHIN(resistanceAt(1.9999), 13.0, 1e-3);
    VERIFY_WITHIN(resistanceAt(10.0), std::sqrt(13.0 * 3.0), 1e-9);
    VERIFY_WITHIN(resistanceAt(12.0), 5.0, 0.25);
    VERIFY_WITHIN(resistanceAt(18.0), 3.0, 1e-9);
    VERIFY_WITHIN(resistanceAt(25.0), 1.582, 0.005);
    VERIFY_WITHIN(resistanceAt(26.0), 1.575, 1e-12);
    VERIFY_WITHIN(resistanceAt(80.0), 1.575, 1e-12);
}

void TestRespiratorySystem::isAsCompliantAsInfantsAre_data()
{
    QTest::addColumn<double>("months");
    QTest::addColumn<double>("length_cm");
    QTest::newRow("newborn") << 0.0 << 50.0;
    QTest::newRow("3 months") << 3.0 << 60.0;
    QTest::newRow("8 months") << 8.0 << 70.0;
    QTest::newRow("1 year") << 12.0 << 75.0;
}

/// Of 34 infants in the first year 1.58e-4 L^3.13 ml/kPa, L the length in cm (Bull Eur
/// Physiopathol Respir 1985;21:411).
void TestRespiratorySystem::isAsCompliantAsInfantsAre()
{
    constexpr double kTolerance = 0.2;
    QFETCH(const double, months);
    QFETCH(const double, length_cm);
    const PatientParameters who{
        months / 12.0, metres(0.01 * length_cm), Sex::Male, Habitus::Normal, {}};
    const RespiratorySystem system = healthySystem(buildOf(dimensionsFor(who).value()));
    const double published = 1.58e-4 * std::pow(length_cm, 3.13) * 0.0980665e-3; // L/cmH2O
    VERIFY_WITHIN(complianceAtRest(system) / published, 1.0, kTolerance);
}

/// The wall is 2.86 (1.06) times as compliant as the lung below one year and 1.33 (0.36) times from
/// one to three and a half years (J Appl Physiol 1995;78:179).
void TestRespiratorySystem::hasASoftChestInInfancy()
{
    const auto wallToLung = [](double years) {
        const PatientBuild build{metres(0.7), 8.0, years, Sex::Female};
        const LungMechanics lung = healthySystem(build).lungs[0];
        return lung.wall.si / lung.curve.complianceAt(lung.wallVolume).si;
    };
    VERIFY_WITHIN(wallToLung(0.4), 2.86, 1.06);
    VERIFY_WITHIN(wallToLung(2.2), 1.33, 0.36);
    VERIFY_WITHIN(wallToLung(6.0), 1.0, 1e-9);
}

void TestRespiratorySystem::breathesAtTheMedianRateOfInfants_data()
{
    QTest::addColumn<double>("months");
    QTest::addColumn<double>("rate_perMin");
    // Medians of ages (Fleming et al., Lancet 2011;377:1011).
    QTest::newRow("0 to 3 months") << 1.5 << 43.0;
    QTest::newRow("3 to 6 months") << 4.5 << 41.0;
    QTest::newRow("6 to 9 months") << 7.5 << 39.0;
    QTest::newRow("9 to 12 months") << 10.5 << 37.0;
    QTest::newRow("12 to 18 months") << 15.0 << 35.0;
    QTest::newRow("18 to 24 months") << 21.0 << 31.0;
}

void TestRespiratorySystem::breathesAtTheMedianRateOfInfants()
{
    constexpr double kTolerance_perMin = 3.0;
    QFETCH(const double, months);
    QFETCH(const double, rate_perMin);
    const PatientBuild build{metres(0.7), 8.0, months / 12.0, Sex::Male};
    VERIFY_WITHIN(inPerMinute(restingPattern(build).rate), rate_perMin, kTolerance_perMin);
}

void TestRespiratorySystem::breathesQuietlyAsTheTableSays_data()
{
    QTest::addColumn<double>("years");
    QTest::addColumn<double>("height_m");
    QTest::addColumn<double>("weight_kg");
    QTest::addColumn<double>("rate_perMin");
    QTest::addColumn<double>("tidalVolume_ml");
    QTest::addColumn<double>("fraction");
    QTest::newRow("adult") << 40.0 << 1.75 << 77.0 << 16.0 << 539.0 << 0.375;
    QTest::newRow("obese") << 40.0 << 1.75 << 127.0 << 16.0 << 539.0 << 0.375;
    QTest::newRow("12 years") << 12.0 << 1.50 << 40.0 << 19.0 << 280.0 << 0.4125;
    // A body mass index of 15.8 and 13.3 kg/m^2 (WHO growth standards); 44 breaths a minute at
    // birth (Fleming).
    QTest::newRow("2 years") << 2.0 << 0.90 << 12.0 << 26.0 << 7.0 * 15.8 * 0.81 << 0.5;
    QTest::newRow("newborn") << 0.0 << 0.50 << 3.3 << 44.0 << 7.0 * 13.3 * 0.25 << 0.5;
}

void TestRespiratorySystem::breathesQuietlyAsTheTableSays()
{
    QFETCH(const double, years);
    QFETCH(const double, weight_kg);
    QFETCH(const double, rate_perMin);
    QFETCH(const double, tidalVolume_ml);
    QFETCH(const double, fraction);
    QFETCH(const double, height_m);
    const BreathingPattern quiet = restingPattern({metres(height_m), weight_kg, years, Sex::Male});
    VERIFY_WITHIN(inPerMinute(quiet.rate), rate_perMin, 1e-9);
    VERIFY_WITHIN(inMillilitres(quiet.tidalVolume), tidalVolume_ml, 1e-9);
    VERIFY_WITHIN(quiet.inspiratoryFraction, fraction, 1e-12);
}

/// Half of 80 - 30 ml/kg.
void TestRespiratorySystem::boundsABreathByTheCapacity()
{
    VERIFY_WITHIN(inMillilitres(largestTidalVolume(adult())), 1925.0, 1e-9);
    VERIFY_WITHIN(inMillilitres(largestTidalVolume(child())), 1000.0, 1e-9);
}

/// 25 ml/kg, the wall on its line, and in an adult 2 x 0.04 and 0.2 L/cmH2O in series: 57 ml/cmH2O,
/// within the 50 to 80 that are seen.
void TestRespiratorySystem::relaxesToWhatAVentilatorMeets()
{
    const RespiratorySystem before = healthySystem(adult());
    RespiratorySystem system = before;
    relax(system);
    for (std::size_t i = 0; i < 2; ++i) {
        const LungMechanics& lung = system.lungs[i];
        const LungMechanics& awake = before.lungs[i];
        const double share = i == 0 ? 0.525 : 0.475;
        VERIFY_WITHIN(inLitres(lung.wallVolume), share * 0.025 * 77.0, kTolerance_l);
        VERIFY_WITHIN(inCmH2O(lung.wallRecoil),
                      5.0 + inLitres(awake.wallVolume - lung.wallVolume) / (0.2 * share), 1e-9);
        VERIFY_WITHIN(inCmH2O(lung.curve.pressureAt(lung.wallVolume)), inCmH2O(lung.wallRecoil),
                      1e-9);
        QCOMPARE(lung.curve.floor, awake.curve.floor);
        VERIFY_WITHIN(inLitres(lung.curve.span), inLitres(awake.curve.span), kTolerance_l);
        QCOMPARE(lung.wall, awake.wall);
    }
    VERIFY_WITHIN(complianceAtRest(system), 1.0 / (1.0 / 0.08 + 1.0 / 0.2), 1e-9);
}

/// Laminar as Poiseuille says, 8 mu L / (pi r^4) with 18.5 uPa s; half the dead space is left.
void TestRespiratorySystem::replacesTheUpperAirwayByATube()
{
    const RespiratorySystem before = healthySystem(adult());
    RespiratorySystem system = before;
    intubate(system, millimetres(8.0));
    QVERIFY(system.lungs == before.lungs);
    VERIFY_WITHIN(system.upperLaminar.si,
                  8.0 * 1.85e-5 * 0.3 / (std::numbers::pi * std::pow(0.004, 4)), 1.0);
    VERIFY_WITHIN(inMillilitres(before.anatomicalDeadSpace), 2.2 * 77.0, 1e-9);
    VERIFY_WITHIN(inMillilitres(system.anatomicalDeadSpace), 1.1 * 77.0, 1e-9);
}

/// Darcy's law with Blasius' friction 0.316 / Re^0.25 of a smooth tube, and 1.5 heads for its ends:
/// about 7 cmH2O at 1 L/s through 8 mm.
void TestRespiratorySystem::losesMoreInANarrowTube()
{
    for (const double diameter_mm : {8.0, 6.5, 4.0}) {
        const double d = 1e-3 * diameter_mm;
        const double speed = 1e-3 / (std::numbers::pi / 4.0 * d * d);
        const double reynolds = 1.2 * speed * d / 1.85e-5;
        const double head = 0.5 * 1.2 * speed * speed;
        const double turbulent = (0.316 * std::pow(reynolds, -0.25) * 0.3 / d + 1.5) * head;
        const double laminar = 32.0 * 1.85e-5 * 0.3 * speed / (d * d);
        VERIFY_WITHIN(lossAt1LitrePerSecond(diameter_mm), (turbulent + laminar) / 98.0665, 1e-9);
    }
    VERIFY_WITHIN(lossAt1LitrePerSecond(8.0), 7.0, 0.5);
}

void TestRespiratorySystem::approachesATargetByAShare()
{
    RespiratorySystem system = healthySystem(adult());
    const RespiratorySystem from = system;
    RespiratorySystem target = healthySystem(child());
    intubate(target, millimetres(6.5));
    target.effort = 0.5;
    target.lungs[0].compression = 5.0;
    target.lungs[1].valve = {1e-9};
    target.lungs[1].uptake = hertz(0.1);
    target.lungs[0].uptakeEnd = litres(0.5);
    target.lungs[0].pleuralGas = litres(0.2);
    target.lungs[0].alveolarDeadSpace = litres(0.1);
    approach(system, target, 0.25);
    VERIFY_WITHIN(system.effort, 0.875, 1e-12);
    VERIFY_WITHIN(system.lungs[0].compression, 2.0, 1e-12);
    VERIFY_WITHIN(system.lungs[1].valve.si, 0.25e-9, 1e-20);
    VERIFY_WITHIN(system.lungs[1].uptake.si, 0.025, 1e-12);
    VERIFY_WITHIN(inLitres(system.lungs[0].wallVolume),
                  0.75 * inLitres(from.lungs[0].wallVolume)
                      + 0.25 * inLitres(target.lungs[0].wallVolume),
                  1e-12);
    RespiratorySystem fromNothing;
    approach(fromNothing, target, 1.0);
    QVERIFY(fromNothing == target);
    const RespiratorySystem arrived = target;
    RespiratorySystem still = arrived;
    approach(still, arrived, 0.001);
    QVERIFY(still == arrived); // what has arrived stays, bit for bit
}

CARINA_TEST(TestRespiratorySystem)

} // namespace carina::respiratory_system_test

#include "tst_respiratory_system.moc"
