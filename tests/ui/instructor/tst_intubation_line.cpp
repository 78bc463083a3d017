#include "models/intubation/intubation_timeline.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/instructor/intubation_line.h"

#include <QFontMetrics>

namespace carina::intubation_line_test
{
namespace
{

using test::FakeSessionNode;
using namespace std::chrono_literals;

struct Shown {
    FakeSessionNode node;
    SessionModel session{node};
    IntubationTimeline timeline{session, FakeSessionNode::kStation};
    QWidget window;
    IntubationLine line{&window};

    Shown()
    {
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        line.setTimeline(timeline);
        line.resize(line.sizeHint());
    }
    void notes(IntubationStep step)
    {
        node.advance(2s);
        node.decide(fact::IntubationNoted{.event = {.step = step, .at = *node.now()}});
        QCoreApplication::sendPostedEvents();
    }
};

} // namespace

class TestIntubationLine : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesNoRoomBeforeTheFirstStep()
    {
        Shown shown;
        QVERIFY(shown.line.isHidden());
        shown.notes(IntubationStep::BladeIn);
        QVERIFY(!shown.line.isHidden());
    }

    void isAsHighAsItsSteps()
    {
        Shown shown;
        const int row = shown.line.fontMetrics().height();
        QVERIFY(shown.line.sizeHint().height() >= IntubationLine::kShownSteps * row);
        QVERIFY(shown.line.sizeHint().height() < (IntubationLine::kShownSteps + 3) * row);
    }

    void tellsTheNewestToAScreenReader()
    {
        Shown shown;
        QCOMPARE(shown.line.accessibleName(), QStringLiteral("Steps of the intubation"));
        shown.notes(IntubationStep::BladeIn);
        shown.notes(IntubationStep::TubePastTeeth);
        QVERIFY(shown.line.accessibleDescription().contains(QLatin1String{"Tube past the teeth"}));
    }

    void choosesTheStepOfAMoment()
    {
        Shown shown;
        shown.window.resize(400, 300);
        shown.window.show();
        shown.line.choose(*shown.node.now()); // there is none yet
        for (int i = 0; i < 5; ++i) {
            shown.notes(IntubationStep::BladeIn);
            shown.notes(IntubationStep::BladeOut);
        }
        const SessionTime second = *shown.node.now() - 16s;
        QCOMPARE(shown.timeline.rowAt(second), 1);
        shown.line.choose(second);
        QCOMPARE(shown.line.currentIndex().row(), 1);
        QVERIFY(shown.line.selectionModel()->isRowSelected(1));
        QVERIFY(shown.line.viewport()->rect().contains(
            shown.line.visualRect(shown.line.currentIndex())));
    }

    void goesWithTheStation()
    {
        Shown shown;
        shown.notes(IntubationStep::BladeIn);
        shown.timeline.setStation(StationId{7});
        QVERIFY(shown.line.isHidden());
        shown.timeline.setStation(FakeSessionNode::kStation);
        QVERIFY(!shown.line.isHidden());
    }
};

CARINA_SCREEN_TEST(TestIntubationLine)

} // namespace carina::intubation_line_test

#include "tst_intubation_line.moc"
