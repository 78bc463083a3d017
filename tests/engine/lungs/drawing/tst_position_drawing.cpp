#include "tests/engine/lungs/drawing/drawn_chest.h"
#include "tests/support/test_class.h"

namespace carina::position_drawing_test
{

using namespace carina::test;

/// What is drawn of a patient who does not lie on the back.
class TestPositionDrawing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void enclosesWhatTheMechanicsSay_data();
    void enclosesWhatTheMechanicsSay();
    void letsTheInsideSinkAsFarAsThereIsRoom();
};

void TestPositionDrawing::enclosesWhatTheMechanicsSay_data()
{
    QTest::addColumn<BodyPosition>("position");
    QTest::addColumn<LungCondition>("condition");
    using enum ConditionKind;
    const auto row = [](const char* name, BodyPosition position) {
        QTest::addRow("%s", name) << position << LungCondition{};
        QTest::addRow("%s, COPD", name)
            << position << LungCondition{Copd, 1.0, ConditionSide::Both};
        QTest::addRow("%s, a pneumothorax", name)
            << position << LungCondition{SimplePneumothorax, 1.0, ConditionSide::Right};
        QTest::addRow("%s, atelectasis", name)
            << position << LungCondition{Atelectasis, 1.0, ConditionSide::Left};
    };
    row("sitting", BodyPosition::Sitting);
    row("prone", BodyPosition::Prone);
    row("right side", BodyPosition::RightLateral);
    row("left side", BodyPosition::LeftLateral);
}

void TestPositionDrawing::enclosesWhatTheMechanicsSay()
{
    QFETCH(BodyPosition, position);
    QFETCH(LungCondition, condition);
    RespiratorySettings settings = childWith(condition);
    settings.position = position;
    verifyEnclosed(settings);
}

/// Sunk to the front by a whole amplitude, and less where the mediastinum leans on the lung.
void TestPositionDrawing::letsTheInsideSinkAsFarAsThereIsRoom()
{
    ChestShape shape = restingShape();
    shape.sag = -1.0;
    const ChestPose prone = drawnPose(childLungs(), shape, 0);
    for (const LungPose& lung : prone.lungs)
        QVERIFY(std::abs(lung.gravity + 1.0) < 0.02);
    shape.mediastinalShift = millimetres(90.0);
    const ChestPose leant = drawnPose(childLungs(), shape, 0);
    QVERIFY(std::abs(leant.lungs[0].gravity + 1.0) < 0.05);
    QVERIFY(leant.lungs[1].gravity > -0.5);
    QVERIFY(rangeTaken(leant) <= 1.0 + kRounding);
}

CARINA_TEST(TestPositionDrawing)

} // namespace carina::position_drawing_test

#include "tst_position_drawing.moc"
