#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/instructor/attention_bar.h"

#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace carina::attention_bar_test
{
namespace
{

using test::FakeSessionNode;

constexpr ParticipantId kTom = FakeSessionNode::kTrainee;

struct Shown {
    FakeSessionNode node;
    SessionModel session{node};
    AttentionModel model{session};
    AttentionBar bar;
    QPushButton& action = *bar.findChild<QPushButton*>(QStringLiteral("attend"));
    QLabel& text = *bar.findChild<QLabel*>(QStringLiteral("attention"));
    QToolButton& more = *bar.findChild<QToolButton*>(QStringLiteral("moreAttention"));

    Shown()
    {
        node.sharePatient(FakeSessionNode::kInstructor);
        node.linkReports = {{kTom, LinkState::Connected, {}, {}, {}},
                            {FakeSessionNode::kObserver, LinkState::Connected, {}, {}, {}}};
        model.look();
        bar.setModel(model);
        bar.resize(900, bar.height());
    }
    void look()
    {
        QCoreApplication::sendPostedEvents();
        model.look();
        QCoreApplication::sendPostedEvents();
    }
    void tomAsks()
    {
        node.decide(fact::ObjectWanted{FakeSessionNode::kPatient, true}, kTom);
        look();
    }
    /// This console showed something until it stopped.
    void breaksOff()
    {
        node.decide(
            fact::LessonShown{kNobody, {{true, LessonCut::All, {0.0, 1.0, 0.0}, 0.1}, true, {}}},
            FakeSessionNode::kInstructor);
        node.decide(fact::ParticipantJoined{{}, Role::Instructor, "Ina"});
        look();
    }
    void goesAway(std::size_t whom)
    {
        node.linkReports[whom].state = LinkState::Away;
        look();
    }
};

} // namespace

class TestAttentionBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isHiddenWhereNothingIsTheMatter()
    {
        Shown shown;
        QVERIFY(!shown.bar.isVisible());
        shown.tomAsks();
        QVERIFY(shown.bar.isVisible());
        QVERIFY(shown.action.isVisible());
        QVERIFY(shown.action.height() <= shown.bar.height());
        QTest::keyClick(&shown.action, Qt::Key_Space); // settles it
        QVERIFY(!shown.bar.isVisible());
    }

    void settlesAMatterByItsButton()
    {
        Shown shown;
        shown.tomAsks();
        QCOMPARE(shown.text.text(), QStringLiteral("▲ Tom asks for Adult"));
        QCOMPARE(shown.action.text(), QStringLiteral("Give"));
        QCOMPARE(shown.action.accessibleDescription(), QStringLiteral("Tom asks for Adult"));
        QVERIFY(!shown.more.isVisible());
        QTest::keyClick(&shown.action, Qt::Key_Space);
        QVERIFY(shown.node.state()->objects().at(FakeSessionNode::kPatient).owner == kTom);
        QVERIFY(!shown.text.isVisible());
    }

    void listsTheOthersInAMenu()
    {
        Shown shown;
        shown.tomAsks();
        shown.goesAway(1);
        QVERIFY(shown.more.isVisible());
        QCOMPARE(shown.more.menu()->actions().size(), 0); // filled as it opens
        Q_EMIT shown.more.menu()->aboutToShow();
        const auto others = shown.more.menu()->actions();
        QCOMPARE(others.size(), 1);
        QCOMPARE(others[0]->text(),
                 QStringLiteral("Show: Olga is away: their program is not heard of"));
    }

    void keepsWhatSomebodyIsAboutToPress()
    {
        Shown shown;
        shown.goesAway(0);
        shown.action.setFocus();
        QVERIFY(QTest::qWaitForWindowActive(&shown.bar));
        QVERIFY(shown.action.hasFocus());
        shown.tomAsks(); // more urgent
        QVERIFY(shown.text.text().contains(QStringLiteral("away")));
        QCOMPARE(shown.action.text(), QStringLiteral("Show"));
        shown.node.linkReports[0].state = LinkState::Connected;
        shown.look();
        QVERIFY(shown.text.text().contains(QStringLiteral("asks")));
    }

    void showsTheWholeSentenceHoweverNarrow()
    {
        Shown shown;
        shown.goesAway(0);
        const QString whole = QStringLiteral("Tom is away: their program is not heard of");
        const auto linesIn = [&shown](int width) {
            shown.bar.resize(shown.bar.sizeIn(width));
            QCoreApplication::sendPostedEvents();
            const int needed = shown.text.heightForWidth(shown.text.width());
            return shown.text.height() < needed
                       ? 0
                       : qRound(double(needed) / shown.text.fontMetrics().lineSpacing());
        };
        QCOMPARE(linesIn(900), 1);
        QVERIFY(shown.bar.width() < 900); // no more than it needs
        QVERIFY(linesIn(260) > 1);
        QCOMPARE(shown.bar.width(), 260);
        QCOMPARE(shown.text.text(), QStringLiteral("▲ ") + whole);
        QCOMPARE(shown.text.accessibleName(), whole);
    }

    void dismissesWhatIsNotToBeShownAgain()
    {
        Shown shown;
        auto& dismiss = *shown.bar.findChild<QPushButton*>(QStringLiteral("dismissAttention"));
        shown.breaksOff();
        QCOMPARE(shown.action.text(), QStringLiteral("Show again"));
        QVERIFY(dismiss.isVisible());
        QCOMPARE(dismiss.accessibleDescription(), shown.text.accessibleName());
        QTest::keyClick(&dismiss, Qt::Key_Space);
        QVERIFY(!shown.bar.isVisible());
        shown.tomAsks();
        QVERIFY(!dismiss.isVisible()); // somebody waits for an answer
        QTest::keyClick(&shown.action, Qt::Key_Space);
        QVERIFY(!shown.bar.isVisible());
    }

    void dismissesByTheMenu()
    {
        Shown shown;
        shown.tomAsks();
        shown.breaksOff();
        QCOMPARE(shown.action.text(), QStringLiteral("Give"));
        Q_EMIT shown.more.menu()->aboutToShow();
        const auto others = shown.more.menu()->actions();
        QCOMPARE(others.size(), 2);
        QVERIFY(others[1]->text().startsWith(QStringLiteral("Dismiss: Shown to everybody")));
        others[1]->trigger();
        QVERIFY(!shown.more.isVisible());
    }
};

CARINA_SCREEN_TEST(TestAttentionBar)

} // namespace carina::attention_bar_test

#include "tst_attention_bar.moc"
