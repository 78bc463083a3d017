#include "engine/lungs/drawing/chest_shape.h"

#include "engine/lungs/mechanics/lung_condition.h"
#include "engine/lungs/mechanics/respiratory_fold.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::chest_shape_test
{

namespace
{

constexpr double kTolerance_mm = 1e-6;
constexpr double kTolerance_l = 1e-7;

/// What a side of the chest has more room than at rest in health.
double more_l(const LungShape& lung) { return inLitres(lung.room - lung.healthy); }

ChestShape shapeOf(const RespiratorySystem& system, const ChestContent& content)
{
    return chestShape({}, system, content, chestMoment(system, content, {}, {}));
}

ChestShape shapeAtRest(const LungConditions& conditions)
{
    const RespiratorySystem system = afflicted(healthySystem({}), conditions);
    return shapeOf(system, restingContent(system));
}

} // namespace

class TestChestShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void restsWhereHealthRests();
    void makesRoomForWhatIsBreathedIn();
    void makesRoomForEmphysema();
    void followsTheWallWhereTheMediastinumGaveWay();
    void standsOutBesideAPneumothorax();
    void shiftsAwayFromATension_data();
    void shiftsAwayFromATension();
    void shiftsTowardsAnAtelectasis();
    void shiftsFurtherInASmallerChest();
    void sharesTheWorkByTheSex();
    void sharesTheWorkAlikeInChildren();
};

void TestChestShape::restsWhereHealthRests()
{
    const ChestShape shape = shapeAtRest({});
    for (std::size_t i = 0; i < 2; ++i) {
        VERIFY_WITHIN(more_l(shape.lungs[i]), 0.0, kTolerance_l);
    }
    VERIFY_WITHIN(inLitres(shape.lungs[0].gas), 0.525 * 2.31, 1e-6);
    VERIFY_WITHIN(inMillimetres(shape.mediastinalShift), 0.0, kTolerance_mm);
}

void TestChestShape::makesRoomForWhatIsBreathedIn()
{
    const RespiratorySystem system = healthySystem({});
    ChestContent content = restingContent(system);
    content[0].gas = content[0].gas + litres(0.525);
    content[1].gas = content[1].gas + litres(0.475);
    const ChestShape shape = shapeOf(system, content);
    // The sides press alike, but for what the mediastinum evens out.
    VERIFY_WITHIN(more_l(shape.lungs[0]), 0.525, 5e-4);
    VERIFY_WITHIN(more_l(shape.lungs[1]), 0.475, 5e-4);
}

/// 177 % of 2.31 L, 47.5 % of it on the left.
void TestChestShape::makesRoomForEmphysema()
{
    const ChestShape shape = shapeAtRest({{ConditionKind::Copd, 0.9, ConditionSide::Both}});
    VERIFY_WITHIN(more_l(shape.lungs[1]), 0.475 * 0.77 * 2.31, 5e-4);
}

/// A relaxed wall stands out by its compliance times the pleural pressure above that at rest.
void TestChestShape::followsTheWallWhereTheMediastinumGaveWay()
{
    const RespiratorySystem system =
        afflicted(healthySystem({}),
                  LungConditions{{ConditionKind::SimplePneumothorax, 0.8, ConditionSide::Left}});
    const ChestContent rest = restingContent(system);
    const ChestMoment moment = chestMoment(system, rest, {}, {});
    const ChestShape shape = chestShape({}, system, rest, moment);
    QVERIFY(moment.mediastinum.si < 0.0);
    for (std::size_t i = 0; i < 2; ++i) {
        const double share = i == 0 ? 0.525 : 0.475;
        const double out_l = 0.2 * (inCmH2O(moment.pleural[i]) + 5.0); // both sides alike
        VERIFY_WITHIN(inLitresPerCmH2O(system.lungs[i].wall), 0.2 * share, 1e-9);
        VERIFY_WITHIN(more_l(shape.lungs[i]), share * out_l, kTolerance_l);
    }
}

void TestChestShape::standsOutBesideAPneumothorax()
{
    const ChestShape shape =
        shapeAtRest({{ConditionKind::SimplePneumothorax, 0.8, ConditionSide::Left}});
    QVERIFY(more_l(shape.lungs[1]) > 0.0);
    QVERIFY(inLitres(shape.lungs[1].room - shape.lungs[1].gas) > 0.5);
    QVERIFY(shape.mediastinalShift.si < 0.0); // away from it, to the right
}

void TestChestShape::shiftsAwayFromATension_data()
{
    QTest::addColumn<VentilationMode>("mode");
    QTest::addColumn<double>("least_mm");
    QTest::newRow("ventilated") << VentilationMode::VolumeControl << 20.0;
    QTest::newRow("breathing alone") << VentilationMode::Spontaneous << 10.0;
}

/// By more with each minute, a ventilated patient's by centimetres, 35 mm at the most.
void TestChestShape::shiftsAwayFromATension()
{
    QFETCH(const VentilationMode, mode);
    QFETCH(const double, least_mm);
    RespiratorySettings settings;
    settings.pattern = restingPattern(settings.build);
    settings.ventilator.mode = mode;
    settings.conditions = {{ConditionKind::TensionPneumothorax, 0.3, ConditionSide::Right}};
    RespiratoryFold fold{settings};
    double shift = 0.0;
    for (int minute = 0; minute < 5; ++minute) {
        double farthest = 0.0; // of its last ten seconds
        for (int i = 0; i < 30000; ++i) {
            fold.step();
            if (i % 100 != 0 || i < 25000)
                continue;
            const ChestShape shape =
                chestShape(settings.build, fold.system(), fold.content(), fold.moment());
            farthest = std::max(farthest, inMillimetres(shape.mediastinalShift));
        }
        QVERIFY(farthest > shift);
        shift = farthest;
    }
    QVERIFY2(shift > least_mm && shift <= 35.0, qPrintable(QString::number(shift)));
}

void TestChestShape::shiftsTowardsAnAtelectasis()
{
    QVERIFY(
        inMillimetres(
            shapeAtRest({{ConditionKind::Atelectasis, 1.0, ConditionSide::Right}}).mediastinalShift)
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
    VERIFY_WITHIN(0.5 * (ofMan.ribShare + ofWoman.ribShare), 0.4, 1e-12);
    QVERIFY(ofWoman.ribShare > ofMan.ribShare);
}

/// The diaphragm makes 55 % of a child's breath, whatever the sex; boys differ from twelve years
/// on.
void TestChestShape::sharesTheWorkAlikeInChildren()
{
    const auto ribShare = [](double years, Sex sex) {
        PatientBuild build{metres(1.5), 40.0, years, sex};
        const RespiratorySystem system = healthySystem(build);
        const ChestContent rest = restingContent(system);
        return chestShape(build, system, rest, chestMoment(system, rest, {}, {})).ribShare;
    };
    for (const double years : {6.0, 12.0}) {
        VERIFY_WITHIN(ribShare(years, Sex::Female), 0.45, 1e-12);
        VERIFY_WITHIN(ribShare(years, Sex::Male), 0.45, 1e-12);
    }
    VERIFY_WITHIN(ribShare(15.0, Sex::Male), 0.40, 1e-12);
    VERIFY_WITHIN(ribShare(18.0, Sex::Male), 0.35, 1e-12);
}

CARINA_TEST(TestChestShape)

} // namespace carina::chest_shape_test

#include "tst_chest_shape.moc"
