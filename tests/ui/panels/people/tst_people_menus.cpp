#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/panels/people/people_menus.h"

#include <QSignalSpy>

namespace carina::people_menus_test
{
namespace
{

using test::FakeSessionNode;
constexpr ParticipantId kTom = FakeSessionNode::kTrainee;
constexpr ParticipantId kTess{4};

struct Seat {
    FakeSessionNode node;
    SessionModel session{node};
    PeopleModel people{session, FakeSessionNode::kStation};

    explicit Seat(ParticipantId self) : node{self}
    {
        node.decide(fact::ParticipantJoined{{}, Role::Trainee, "T & T"});
    }
    void shareHead(ParticipantId owner)
    {
        node.decide(fact::ObjectShared{{}, owner, ObjectKind::Head, "Head"});
    }
    [[nodiscard]] ParticipantId worker() const
    {
        return node.state()->atWork(FakeSessionNode::kStation);
    }
};

/// As a person reads it when the menu opens; what cannot be chosen in brackets, what is chosen with
/// a star.
QStringList opened(QMenu& menu)
{
    Q_EMIT menu.aboutToShow();
    QStringList texts;
    for (const QAction* action : menu.actions()) {
        QString text = action->isEnabled() ? action->text()
                                           : QLatin1Char('(') + action->text() + QLatin1Char(')');
        texts += action->isChecked() ? QLatin1Char('*') + text : text;
    }
    return texts;
}

} // namespace

class TestPeopleMenus : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void looksThroughTheEyesOfThoseWhoseHeadsAreShared()
    {
        Seat seat{kTom};
        EyesMenu menu{seat.people, QStringLiteral("Eyes")};
        QCOMPARE(opened(menu), (QStringList{QStringLiteral("*&Own view"),
                                            QStringLiteral("(Nobody else shares a head)")}));
        seat.shareHead(kTom); // the own one
        seat.shareHead(kTess);
        std::optional<ParticipantId> chosen;
        connect(&menu, &EyesMenu::chosen, this,
                [&chosen](std::optional<ParticipantId> whom) { chosen = whom; });
        QCOMPARE(opened(menu), (QStringList{QStringLiteral("*&Own view"),
                                            QStringLiteral("Through the eyes of T && T")}));
        menu.actions()[1]->trigger();
        QVERIFY(chosen == kTess);
        QCOMPARE(opened(menu), (QStringList{QStringLiteral("&Own view"),
                                            QStringLiteral("*Through the eyes of T && T")}));
        menu.actions()[0]->trigger();
        QVERIFY(!chosen);
        menu.setChosen(kTess);
        QCOMPARE(opened(menu).last(), QStringLiteral("*Through the eyes of T && T"));
    }

    void handsOverToThoseWhoMayWork()
    {
        Seat seat{kTom};
        WorkMenu menu{seat.people, QStringLiteral("Work")};
        QCOMPARE(opened(menu), (QStringList{QStringLiteral("(● You are at work)"),
                                            QStringLiteral("Hand over to Ina"),
                                            QStringLiteral("Hand over to T && T")}));
        menu.actions()[2]->trigger();
        QVERIFY(seat.worker() == kTess);
        QCOMPARE(opened(menu), (QStringList{QStringLiteral("(● At work: T && T)")}));
    }

    void takesUpWhatNobodyDoes()
    {
        Seat seat{kTess};
        WorkMenu menu{seat.people, QStringLiteral("Work")};
        QCOMPARE(opened(menu), (QStringList{QStringLiteral("(● At work: Tom)")}));
        seat.node.decide(fact::ParticipantLeft{kTom});
        QCOMPARE(opened(menu), (QStringList{QStringLiteral("(○ Nobody is at work)"),
                                            QStringLiteral("&Take up the work")}));
        menu.actions()[1]->trigger();
        QVERIFY(seat.worker() == kTess);
    }

    void placesByTheOwnHead()
    {
        Seat seat{kTess};
        seat.shareHead(kTess);
        PoseSample head;
        head.X_FO = RigidTransform::translation({0.6, 0.0, 0.0}); // at the patient's left
        PlaceMenu menu{seat.people, [] { return kTess; }, [&head] { return head; },
                       QStringLiteral("Place")};
        QCOMPARE(opened(menu).size(), 5);
        QVERIFY(menu.actions()[1]->isEnabled());
        menu.actions()[1]->trigger(); // at the patient's head
        QCOMPARE(qRound(inDegrees(seat.node.state()->participants().at(kTess).turn)), -90);
    }
};

CARINA_SCREEN_TEST(TestPeopleMenus)

} // namespace carina::people_menus_test

#include "tst_people_menus.moc"
