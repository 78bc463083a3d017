#include "engine/lungs/chest_shape.h"

#include "engine/lungs/lung_condition.h"
#include "engine/lungs/respiratory_fold.h"
#include "tests/engine/lungs/within.h"

using namespace carina;

namespace
{

constexpr double kTolerance_mm = 1e-6;

ChestShape shapeOf(const RespiratorySystem& system, const ChestContent& content)
{
    return chestShape({}, system, content, chestMoment(system, content, {}, {}));
}

ChestShape shapeAtRest(const LungCondition& condition)
{
    const RespiratorySystem system = afflicted(healthySystem({}), condition);
    return shapeOf(system, restingContent(system));
}

} // namespace

class TestChestShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void restsWhereHealthRests();
    void descendsAsMeasured();
    void descendsNoFurtherThanMeasured();
    void movesAsQuietBreathingDoes();
    void flattensTheDiaphragmOfEmphysema();
    void followsTheWallWhereTheMediastinumGaveWay();
    void showsTheGasBesideALung();
    void shiftsAwayFromATension();
    void shiftsTowardsAnAtelectasis();
    void shiftsFurtherInASmallerChest();
    void sharesTheWorkByTheSex();
};

void TestChestShape::restsWhereHealthRests()
{
    const ChestShape shape = shapeAtRest({});
    for (std::size_t i = 0; i < 2; ++i) {
        VERIFY_WITHIN(inMillimetres(shape.lungs[i].diaphragmDescent), 0.0, kTolerance_mm);
        QCOMPARE(shape.lungs[i].collapse, 0.0);
    }
    VERIFY_WITHIN(inLitres(shape.lungs[0].gas), 0.525 * 2.31, 1e-6);
    VERIFY_WITHIN(inMillimetres(shape.mediastinalShift), 0.0, kTolerance_mm);
}

/// 16.6 (2.4) mm for a litre in both lungs, on both sides.
void TestChestShape::descendsAsMeasured()
{
    const RespiratorySystem system = healthySystem({});
    ChestContent content = restingContent(system);
    content[0].gas = content[0].gas + litres(0.525);
    content[1].gas = content[1].gas + litres(0.475);
    const ChestShape shape = shapeOf(system, content);
    // The sides press alike, but for what the mediastinum evens out.
    VERIFY_WITHIN(inMillimetres(shape.lungs[0].diaphragmDescent), 16.6, 0.01);
    VERIFY_WITHIN(inMillimetres(shape.lungs[1].diaphragmDescent), 16.6, 0.01);
}

void TestChestShape::descendsNoFurtherThanMeasured()
{
    const RespiratorySystem system = healthySystem({});
    ChestContent content = restingContent(system);
    content[0].gas = content[0].gas + litres(3.0);
    QCOMPARE(shapeOf(system, content).lungs[0].diaphragmDescent, kGreatestDescent);
}

/// In a quiet breath of 540 ml by 8 to 11 mm: 16.6 (2.4) mm/L.
void TestChestShape::movesAsQuietBreathingDoes()
{
    RespiratorySettings settings;
    settings.pattern = restingPattern(settings.build);
    RespiratoryFold fold{settings};
    double least = 1.0;
    double most = -1.0;
    for (int i = 0; i < 10000; ++i) {
        fold.step();
        const ChestShape shape =
            chestShape(settings.build, fold.system(), fold.content(), fold.moment());
        least = std::min(least, inMillimetres(shape.lungs[0].diaphragmDescent));
        most = std::max(most, inMillimetres(shape.lungs[0].diaphragmDescent));
    }
    const double perLitre = (most - least) / inLitres(fold.lastBreath().tidalVolume);
    QVERIFY2(perLitre > 14.2 && perLitre < 19.0, qPrintable(QString::number(perLitre)));
}

void TestChestShape::flattensTheDiaphragmOfEmphysema()
{
    const ChestShape shape = shapeAtRest({ConditionKind::Copd, 0.9, ConditionSide::Both});
    VERIFY_WITHIN(inMillimetres(shape.lungs[1].diaphragmDescent), 0.77 * 2.31 * 16.6, 0.01);
}

/// A relaxed wall stands out by its compliance times the pleural pressure above that at rest.
void TestChestShape::followsTheWallWhereTheMediastinumGaveWay()
{
    const RespiratorySystem system =
        afflicted(healthySystem({}), {ConditionKind::SimplePneumothorax, 0.8, ConditionSide::Left});
    const ChestContent rest = restingContent(system);
    const ChestMoment moment = chestMoment(system, rest, {}, {});
    const ChestShape shape = chestShape({}, system, rest, moment);
    QVERIFY(moment.mediastinum.si < 0.0);
    for (std::size_t i = 0; i < 2; ++i) {
        const double share = i == 0 ? 0.525 : 0.475;
        const double out_l = 0.2 * (inCmH2O(moment.pleural[i]) + 5.0); // both sides alike
        VERIFY_WITHIN(inLitresPerCmH2O(system.lungs[i].wall), 0.2 * share, 1e-9);
        VERIFY_WITHIN(inMillimetres(shape.lungs[i].diaphragmDescent), 16.6 * out_l, kTolerance_mm);
    }
}

void TestChestShape::showsTheGasBesideALung()
{
    const LungCondition condition{ConditionKind::SimplePneumothorax, 0.8, ConditionSide::Left};
    const ChestShape shape = shapeAtRest(condition);
    const RespiratorySystem system = afflicted(healthySystem({}), condition);
    const double lung = inLitres(restingContent(system)[1].gas);
    const double beside = inLitres(system.lungs[1].pleuralGas);
    VERIFY_WITHIN(shape.lungs[1].collapse, beside / (lung + beside), 1e-9);
    QVERIFY(shape.lungs[1].collapse > 0.5);
    QCOMPARE(shape.lungs[0].collapse, 0.0);
    QVERIFY(shape.lungs[1].diaphragmDescent.si > 0.0); // deep sulcus
    QVERIFY(shape.mediastinalShift.si < 0.0);          // away from it, to the right
}

/// Under a ventilator, by centimetres within minutes, 35 mm at the most.
void TestChestShape::shiftsAwayFromATension()
{
    RespiratorySettings settings;
    settings.pattern = restingPattern(settings.build);
    settings.ventilator.mode = VentilationMode::VolumeControl;
    settings.condition = {ConditionKind::TensionPneumothorax, 1.0, ConditionSide::Right};
    RespiratoryFold fold{settings};
    double shift = 0.0;
    for (int minute = 0; minute < 4; ++minute) {
        for (int i = 0; i < 30000; ++i)
            fold.step();
        const double now =
            inMillimetres(chestShape(settings.build, fold.system(), fold.content(), fold.moment())
                              .mediastinalShift);
        QVERIFY(now > shift);
        shift = now;
    }
    QVERIFY2(shift > 15.0 && shift <= 35.0, qPrintable(QString::number(shift)));
}

void TestChestShape::shiftsTowardsAnAtelectasis()
{
    QVERIFY(
        inMillimetres(
            shapeAtRest({ConditionKind::Atelectasis, 1.0, ConditionSide::Right}).mediastinalShift)
        < -5.0);
}

/// 200 cm2 in an adult of 77 kg; of a child of 40 kg (40/77)^(2/3) of it.
void TestChestShape::shiftsFurtherInASmallerChest()
{
    const PatientBuild child{metres(1.5), 40.0, 12.0, Sex::Male};
    for (const PatientBuild& build : {PatientBuild{}, child}) {
        const RespiratorySystem system = healthySystem(build);
        ChestMoment moment;
        moment.mediastinum = litres(0.2);
        const double area_m2 = 0.02 * std::pow(build.weightInKilograms / 77.0, 2.0 / 3.0);
        VERIFY_WITHIN(chestShape(build, system, restingContent(system), moment).mediastinalShift.si,
                      0.2e-3 / area_m2, 1e-9);
    }
}

void TestChestShape::sharesTheWorkByTheSex()
{
    const RespiratorySystem system = healthySystem({});
    const ChestContent rest = restingContent(system);
    PatientBuild woman;
    woman.sex = Sex::Female;
    const ChestMoment moment = chestMoment(system, rest, {}, {});
    const ChestShape ofMan = chestShape({}, system, rest, moment);
    const ChestShape ofWoman = chestShape(woman, system, rest, moment);
    VERIFY_WITHIN(0.5 * (ofMan.diaphragmShare + ofWoman.diaphragmShare), 0.6, 1e-12);
    QVERIFY(ofWoman.ribShare > ofMan.ribShare);
    VERIFY_WITHIN(ofWoman.ribShare + ofWoman.diaphragmShare, 1.0, 1e-12);
}

QTEST_APPLESS_MAIN(TestChestShape)
#include "tst_chest_shape.moc"
