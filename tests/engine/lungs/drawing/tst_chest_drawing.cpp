#include "engine/lungs/drawing/chest_drawing.h"

#include "tests/engine/lungs/drawing/drawn_chest.h"
#include "tests/support/test_class.h"

namespace carina::chest_drawing_test
{

using namespace carina::test;

class TestChestDrawing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void restsInHealth();
    void enclosesWhatTheMechanicsSay_data();
    void enclosesWhatTheMechanicsSay();
    void movesTheRibsByTheirShare_data();
    void movesTheRibsByTheirShare();
    void fallsInFromAWallThatStandsOut();
    void saysWhatItCannotDraw();
    void leansOnTheOtherLung();
    void shiftsNoFurtherThanItMay();
    void leavesALungThatTensionHasClosed_data();
    void leavesALungThatTensionHasClosed();
    void neverJumps_data();
    void neverJumps();
    void drawsTheNearestOfWhatCannotBe();
    void hasNothingToDrawWithoutLungs();
};

void TestChestDrawing::restsInHealth()
{
    const ChestPose pose = drawnPose(childLungs(), restingShape(), 0);
    for (const LungPose& lung : pose.lungs) {
        QVERIFY(std::abs(lung.diaphragm) < 1e-9);
        QVERIFY(std::abs(lung.ribs) < 1e-9);
        QVERIFY(std::abs(lung.collapse) < 1e-9);
    }
    QCOMPARE(pose.mediastinalShift, 0.0);
}

void TestChestDrawing::enclosesWhatTheMechanicsSay_data()
{
    QTest::addColumn<LungCondition>("condition");
    QTest::addColumn<VentilationMode>("mode");
    using enum ConditionKind;
    using enum ConditionSide;
    const auto row = [](const char* name, const LungCondition& condition) {
        QTest::addRow("%s", name) << condition << VentilationMode::Spontaneous;
        QTest::addRow("%s, ventilated", name) << condition << VentilationMode::VolumeControl;
    };
    row("health", {});
    row("ARDS", {Ards, 1.0, Both});
    row("COPD", {Copd, 1.0, Both});
    row("asthma", {Asthma, 1.0, Both});
    row("half a pneumothorax", {SimplePneumothorax, 0.5, Right});
    row("a pneumothorax", {SimplePneumothorax, 1.0, Right});
    row("tension on the left", {TensionPneumothorax, 1.0, Left});
    row("atelectasis", {Atelectasis, 1.0, Left});
    row("a tube in the right bronchus", {MainstemIntubation, 1.0, Right});
    row("obstruction", {Obstruction, 0.95, Both});
    row("stiff chest", {StiffChest, 1.0, Both});
}

void TestChestDrawing::enclosesWhatTheMechanicsSay()
{
    QFETCH(LungCondition, condition);
    QFETCH(VentilationMode, mode);
    RespiratorySettings settings = childWith(condition);
    settings.ventilator.mode = mode;
    verifyEnclosed(settings);
}

void TestChestDrawing::movesTheRibsByTheirShare_data()
{
    QTest::addColumn<double>("ribShare");
    QTest::newRow("a man's") << 0.35;
    QTest::newRow("a woman's") << 0.45;
    QTest::newRow("none") << 0.0;
}

/// Of a small breath, what the ribs alone make room for; the rest is the diaphragm's.
void TestChestDrawing::movesTheRibsByTheirShare()
{
    QFETCH(double, ribShare);
    ChestShape shape = restingShape();
    shape.ribShare = ribShare;
    for (LungShape& lung : shape.lungs) {
        lung.gas = lung.gas + millilitres(10.0);
        lung.room = lung.gas;
    }
    const LungPair& lungs = childLungs();
    const ChestPose pose = drawnPose(lungs, shape, 0);
    ChestPose ribsAlone;
    for (std::size_t i = 0; i < 2; ++i)
        ribsAlone.lungs[i].ribs = pose.lungs[i].ribs;
    for (const Side side : {Side::Right, Side::Left}) {
        const double gained =
            volumeDrawn_ml(lungs, side, 0, ribsAlone) - volumeDrawn_ml(lungs, side, 0, {});
        QVERIFY2(std::abs(gained - 10.0 * ribShare) < 0.2, qPrintable(QString::number(gained)));
    }
}

/// Gas beside the lung: the wall goes out, the lung away from it, the other side stays.
void TestChestDrawing::fallsInFromAWallThatStandsOut()
{
    ChestShape shape = restingShape();
    shape.lungs[0].gas = litres(0.33);
    shape.lungs[0].room = litres(0.73);
    const ChestPose pose = drawnPose(childLungs(), shape, 0);
    QVERIFY(pose.lungs[0].ribs > 0.1);
    QVERIFY(pose.lungs[0].diaphragm > 0.1);
    QVERIFY(pose.lungs[0].collapse > 0.1);
    QVERIFY(std::abs(pose.lungs[1].ribs) + std::abs(pose.lungs[1].collapse) < 1e-9);
    QVERIFY(std::abs(volumeDrawn_ml(childLungs(), Side::Right, 0, pose)
                     - inMillilitres(drawnVolume(childLungs(), shape, Side::Right)))
            < kVolumeTolerance_ml);
}

/// A lung that holds five times what it does at rest is beyond what the field can show.
void TestChestDrawing::saysWhatItCannotDraw()
{
    ChestShape shape = restingShape();
    const ChestPose rest = drawnPose(childLungs(), shape, 0);
    QVERIFY(inMillilitres(notDrawn(childLungs(), shape, rest, 0)) < kVolumeTolerance_ml);
    for (LungShape& lung : shape.lungs)
        lung.gas = lung.room = 5.0 * lung.healthy;
    const ChestPose pose = drawnPose(childLungs(), shape, 0);
    double missing_ml = 0.0;
    for (const Side side : {Side::Right, Side::Left})
        missing_ml += inMillilitres(drawnVolume(childLungs(), shape, side))
                      - volumeDrawn_ml(childLungs(), side, 0, pose);
    QVERIFY(missing_ml > 100.0);
    QVERIFY(std::abs(inMillilitres(notDrawn(childLungs(), shape, pose, 0)) - missing_ml)
            < kVolumeTolerance_ml);
}

/// By so many millimetres as the mechanics say.
void TestChestDrawing::leansOnTheOtherLung()
{
    ChestShape shape = restingShape();
    shape.mediastinalShift = millimetres(10.0);
    const ChestField& field = childLungs().field();
    const ChestPose pose = drawnPose(childLungs(), shape, 0);
    const double halfWidth_mm = 1e3 / field.frame().perMetre.u;
    QVERIFY(std::abs(pose.mediastinalShift * halfWidth_mm - 10.0) < 1e-9);
    QVERIFY(pose.lungs[1].collapse < 0.0); // it keeps its volume all the same
}

void TestChestDrawing::shiftsNoFurtherThanItMay()
{
    ChestShape shape = restingShape();
    shape.mediastinalShift = millimetres(90.0);
    QCOMPARE(drawnPose(childLungs(), shape, 0).mediastinalShift, kDrawnShift);
    shape.mediastinalShift = millimetres(-90.0);
    QCOMPARE(drawnPose(childLungs(), shape, 0).mediastinalShift, -kDrawnShift);
}

void TestChestDrawing::leavesALungThatTensionHasClosed_data()
{
    QTest::addColumn<double>("shift_mm");
    for (const double shift_mm : {5.0, 10.0, 15.0, 20.0, 23.0})
        QTest::addRow("by %g mm", shift_mm) << shift_mm;
}

/// The mediastinum goes as far as the mechanics say beside a lung with a quarter of its gas: what
/// it leaves is no reason to go back.
void TestChestDrawing::leavesALungThatTensionHasClosed()
{
    QFETCH(double, shift_mm);
    ChestShape shape = restingShape();
    shape.lungs[0].gas = 0.255 * shape.lungs[0].healthy;
    shape.lungs[0].room = 2.0 * shape.lungs[0].healthy;
    shape.lungs[1].gas = 0.8 * shape.lungs[1].healthy;
    shape.mediastinalShift = millimetres(shift_mm);
    const LungPair& lungs = childLungs();
    const ChestPose pose = drawnPose(lungs, shape, 0);
    const double halfWidth_mm = 1e3 / lungs.field().frame().perMetre.u;
    QVERIFY2(std::abs(pose.mediastinalShift * halfWidth_mm - shift_mm) < 1e-9,
             qPrintable(QString::number(pose.mediastinalShift * halfWidth_mm)));
    for (const Side side : {Side::Right, Side::Left})
        QVERIFY(std::abs(volumeDrawn_ml(lungs, side, 0, pose)
                         - inMillilitres(drawnVolume(lungs, shape, side)))
                < kVolumeTolerance_ml);
    QVERIFY(rangeTaken(pose) <= 1.0 + 1e-9);
}

void TestChestDrawing::neverJumps_data()
{
    QTest::addColumn<double>("room_l");
    QTest::newRow("in a chest at rest") << 0.63;
    QTest::newRow("in a chest that stands out") << 1.1;
    QTest::newRow("in a chest drawn in") << 0.35;
}

/// From a full lung to a quarter of it, across the edge of the range, in steps of 1 ml.
void TestChestDrawing::neverJumps()
{
    constexpr double kMostStep = 0.03; // of any amplitude
    QFETCH(double, room_l);
    ChestShape shape = restingShape();
    shape.lungs[0].room = litres(room_l);
    std::optional<LungPose> last;
    for (double gas_ml = 700.0; gas_ml > 160.0; gas_ml -= 1.0) {
        shape.lungs[0].gas = millilitres(gas_ml);
        const LungPose pose = drawnPose(childLungs(), shape, 1).lungs[0];
        if (last) {
            QVERIFY(std::abs(pose.diaphragm - last->diaphragm) < kMostStep);
            QVERIFY(std::abs(pose.ribs - last->ribs) < kMostStep);
            QVERIFY(std::abs(pose.collapse - last->collapse) < kMostStep);
        }
        last = pose;
    }
}

void TestChestDrawing::drawsTheNearestOfWhatCannotBe()
{
    ChestShape shape = restingShape();
    shape.lungs[0].gas = litres(0.01);
    shape.lungs[1].gas = litres(9.0);
    shape.lungs[1].room = litres(9.0);
    const ChestPose pose = drawnPose(childLungs(), shape, 0);
    QVERIFY(std::abs(pose.lungs[0].collapse - kMostCollapseAlone) < 1e-6);
    QVERIFY(rangeTaken(pose) <= 1.0 + 1e-9);
    QVERIFY(volumeDrawn_ml(childLungs(), Side::Left, 0, pose) > 1500.0);
}

void TestChestDrawing::hasNothingToDrawWithoutLungs()
{
    const LungPair lungs = LungPair::of(Anatomy{}).value();
    QCOMPARE(drawnPose(lungs, restingShape(), 0).lungs[0], LungPose{});
}

CARINA_TEST(TestChestDrawing)

} // namespace carina::chest_drawing_test

#include "tst_chest_drawing.moc"
