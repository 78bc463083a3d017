#include "tests/engine/net/node/free_port.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/join/join_dialog.h"
#include "ui/panels/patient/actions_panel.h"
#include "ui/panels/people/participants_panel.h"
#include "ui/panels/people/remove_dialog.h"
#include "ui/panels/session/station_bar.h"

#include <QLabel>
#include <QToolButton>
#include <QToolTip>

namespace carina::foreign_texts_test
{
namespace
{

using test::FakeSessionNode;

/// Of a participant. As rich text it is a picture without end, which used up the memory.
constexpr const char* kPicture = "<img src=/dev/zero>";
const QString kPictureText = QString::fromLatin1(kPicture);

/// What no screen may do with it.
bool isShownAsItIs(const QWidget& screen)
{
    // A form makes labels without a name, of fixed words.
    for (const QLabel* label : screen.findChildren<QLabel*>())
        if (label->textFormat() != Qt::PlainText
            && (!label->objectName().isEmpty() || label->text().contains(QLatin1Char('<'))))
            return false;
    for (const QWidget* widget : screen.findChildren<QWidget*>())
        if (widget->toolTip().contains(QStringLiteral("<img")))
            return false;
    return true;
}

} // namespace

/// One who takes part under a name that Qt takes for rich text.
class TestForeignTexts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesInThePanelOfActions()
    {
        FakeSessionNode node{FakeSessionNode::kInstructor};
        const ParticipantId picture = enter(node);
        node.sharePatient(picture);
        node.decide(fact::ParticipantJoined{{}, Role::Trainee, "<img src=/dev/random>"});
        node.decide(fact::ObjectWanted{FakeSessionNode::kPatient},
                    ParticipantId{std::uint16_t(picture.value + 1)});
        SessionModel session{node};
        SharedObjectModel object{session, FakeSessionNode::kStation};
        ObjectActionModel model{object};
        ActionsPanel panel;
        panel.setModel(model);
        QVERIFY(isShownAsItIs(panel));
        auto& owner = *panel.findChild<QLabel*>(QStringLiteral("owner"));
        QVERIFY(owner.text().contains(kPictureText));
        QVERIFY(panel.findChild<QLabel*>(QStringLiteral("wish"))
                    ->text()
                    .contains(QStringLiteral("<img")));
        panel.show();
        QVERIFY(!panel.grab().isNull());
    }

    /// A station that cannot be closed says who is there.
    void namesInATooltip()
    {
        FakeSessionNode node{FakeSessionNode::kInstructor};
        enter(node);
        node.addStation(kPicture);
        SessionModel session{node};
        StationsModel stations{session};
        StationBar bar;
        bar.setModel(stations);
        const auto& close = *bar.findChild<QToolButton*>(QStringLiteral("close"));
        QVERIFY(close.toolTip().contains(kPictureText.toHtmlEscaped()));
        QVERIFY(isShownAsItIs(bar));
        QToolTip::showText({}, close.toolTip(), &bar);
        QToolTip::hideText();
    }

    void reasonsInTheTableOfParticipants()
    {
        FakeSessionNode node{FakeSessionNode::kInstructor};
        const ParticipantId picture = enter(node);
        node.decide(fact::ParticipantRemoved{picture, false, kPicture},
                    FakeSessionNode::kInstructor);
        SessionModel session{node};
        ParticipantsModel participants{session};
        bool isSaid = false;
        for (int row = 0; row < participants.rowCount(); ++row)
            for (int column = 0; column < participants.columnCount(); ++column) {
                const QString tip =
                    participants.index(row, column).data(Qt::ToolTipRole).toString();
                QVERIFY(!tip.contains(QStringLiteral("<img")));
                isSaid |= tip.contains(kPictureText.toHtmlEscaped());
            }
        QVERIFY(isSaid);
    }

    void namesInTheQuestionWhetherToRemove()
    {
        RemoveDialog dialog{kPictureText};
        QVERIFY(isShownAsItIs(dialog));
        dialog.show();
        QVERIFY(!dialog.grab().isNull());
    }

    /// What a host that one joins says.
    void reasonsOfARefusalToJoin()
    {
        Entrance entrance{{}};
        FoundSessionsModel sessions{freePort()};
        const JoinDialog dialog{sessions, entrance, {}};
        QVERIFY(isShownAsItIs(dialog));
    }

private:
    static ParticipantId enter(FakeSessionNode& node)
    {
        node.decide(fact::ParticipantJoined{{}, Role::Trainee, kPicture});
        const auto state = node.state();
        return state->participants().rbegin()->first;
    }
};

CARINA_SCREEN_TEST(TestForeignTexts)

} // namespace carina::foreign_texts_test

#include "tst_foreign_texts.moc"
