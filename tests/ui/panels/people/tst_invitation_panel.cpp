#include "engine/net/discovery/addresses.h"
#include "engine/net/entry/join_link.h"
#include "tests/engine/net/node/nodes.h"
#include "tests/support/test_class.h"
#include "tests/ui/access/control_walk.h"
#include "ui/panels/people/invitation_panel.h"
#include "widgets/qr_code.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>

namespace carina::invitation_panel_test
{

class TestInvitationPanel : public QObject
{
    Q_OBJECT

private:
    template <class Widget> static Widget& find(const QWidget& window, const char* name)
    {
        return *window.findChild<Widget*>(QLatin1String{name});
    }
    /// What the picture holds, as a screen reader hears it.
    static Result<JoinLink> pictured(const InvitationPanel& panel)
    {
        return joinLink(
            find<QrCode>(panel, "picture").accessibleDescription().trimmed().toStdString());
    }

private Q_SLOTS:
    void pictureLeadsTraineesIntoThisSession()
    {
        MemoryDisk disk;
        const auto node = host(disk);
        InvitationPanel panel;
        panel.show(*node, SessionReach::ThisComputer);
        const auto link = pictured(panel);
        QVERIFY(link
                == (JoinLink{"127.0.0.1", node->port(), Role::Trainee,
                             node->joinCodes().at(Role::Trainee)}));
        JoinSettings settings{.participantName = "Anna", .derive = cheapKey};
        settings.address = link->address;
        settings.port = link->port;
        settings.role = link->role;
        settings.code = link->code;
        const auto anna = join(settings);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
    }

    void bothCodesAreShownAndOneIsPictured()
    {
        MemoryDisk disk;
        const auto node = host(disk);
        InvitationPanel panel;
        panel.show(*node, SessionReach::ThisComputer);
        QStringList shown;
        for (const QLabel* label : panel.findChildren<QLabel*>())
            shown << label->text();
        for (const Role role : {Role::Trainee, Role::Observer})
            QVERIFY(shown.contains(QString::fromStdString(node->joinCodes().at(role).text())));
        auto& observers = find<QRadioButton>(panel, "observers");
        observers.setFocus();
        QTest::keyClick(&observers, Qt::Key_Space);
        QVERIFY(pictured(panel)->role == Role::Observer);
        QVERIFY(pictured(panel)->code == node->joinCodes().at(Role::Observer));
        QVERIFY(find<QrCode>(panel, "picture").accessibleName().contains(tr("observers")));
        QTest::keyClick(&find<QRadioButton>(panel, "trainees"), Qt::Key_Space);
        QVERIFY(pictured(panel)->role == Role::Trainee);
    }

    void saysWhoReachesTheSession_data()
    {
        QTest::addColumn<int>("reach");
        QTest::addColumn<QByteArray>("told");
        QTest::addColumn<QByteArray>("neverTold");
        QTest::newRow("this computer")
            << int(SessionReach::ThisComputer) << QByteArray{"Only programs on this computer"}
            << QByteArray{"network"};
        QTest::newRow("network") << int(SessionReach::Network)
                                 << QByteArray{"find the session automatically"}
                                 << QByteArray{"by link"};
        QTest::newRow("by link") << int(SessionReach::ByLink)
                                 << QByteArray{"Nobody finds the session by searching"}
                                 << QByteArray{"automatically"};
    }
    void saysWhoReachesTheSession()
    {
        QFETCH(const int, reach);
        QFETCH(const QByteArray, told);
        QFETCH(const QByteArray, neverTold);
        MemoryDisk disk;
        const auto node = host(disk);
        InvitationPanel panel;
        panel.show(*node, SessionReach(reach));
        const QString words = find<QLabel>(panel, "reach").text();
        QVERIFY2(words.contains(QString::fromUtf8(told)), qPrintable(words));
        QVERIFY2(!words.contains(QString::fromUtf8(neverTold)), qPrintable(words));
        QVERIFY(words.contains(QString::number(node->port())));
    }

    void pictureTakesNoRoomUntilItIsWanted()
    {
        MemoryDisk disk;
        const auto node = host(disk);
        InvitationPanel panel;
        panel.show(*node, SessionReach::ThisComputer);
        panel.QWidget::show();
        auto& shows = find<QPushButton>(panel, "showPicture");
        QVERIFY(!find<QrCode>(panel, "picture").isVisible());
        const int without = panel.sizeHint().height();
        QTest::keyClick(&shows, Qt::Key_Space);
        QVERIFY(find<QrCode>(panel, "picture").isVisible());
        QVERIFY(panel.sizeHint().height() > without);
        QTest::keyClick(&shows, Qt::Key_Space);
        QVERIFY(!find<QrCode>(panel, "picture").isVisible());
    }

    void newCodeIsAskedForOnceMore()
    {
        MemoryDisk disk;
        const auto node = host(disk);
        InvitationPanel panel;
        panel.show(*node, SessionReach::ThisComputer);
        QSignalSpy wanted{&panel, &InvitationPanel::newCodeWanted};
        find<QRadioButton>(panel, "observers").click();
        QTest::keyClick(&find<QPushButton>(panel, "newCode"), Qt::Key_Space);
        auto* question = panel.findChild<QMessageBox*>();
        QVERIFY(question && wanted.isEmpty());
        QVERIFY(question->informativeText().contains(
            QString::fromStdString(node->joinCodes().at(Role::Observer).text())));
        QTest::keyClick(&find<QPushButton>(*question, "change"), Qt::Key_Space);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.first().first().value<Role>(), Role::Observer);
        const JoinCode old = node->joinCodes().at(Role::Observer);
        node->propose(kStation, fact::RoleCodeChanged{Role::Observer});
        QTRY_VERIFY_WITH_TIMEOUT(node->joinCodes().at(Role::Observer) != old, kPatience_ms);
        panel.show(*node, SessionReach::ThisComputer);
        QVERIFY(pictured(panel)->code == node->joinCodes().at(Role::Observer));
    }

    void newCodeAfterABanSaysWhy()
    {
        MemoryDisk disk;
        const auto node = host(disk);
        InvitationPanel panel;
        panel.show(*node, SessionReach::ThisComputer);
        QSignalSpy wanted{&panel, &InvitationPanel::newCodeWanted};
        for (const Role role : {Role::Instructor, Role::Trainee, Role::Observer}) {
            panel.askForNewCode(role, QStringLiteral("Somebody was removed."));
            auto* question = panel.findChildren<QMessageBox*>().last();
            test::verifyControls(*question);
            QVERIFY(question->informativeText().startsWith(QLatin1String("Somebody was removed.")));
            QVERIFY(question->informativeText().contains(
                QString::fromStdString(node->joinCodes().at(role).text())));
            find<QPushButton>(*question, "change").click();
            QCOMPARE(wanted.takeFirst().first().value<Role>(), role);
        }
    }

    void lockedSessionInvitesNobody()
    {
        MemoryDisk disk;
        const auto node = host(disk);
        InvitationPanel panel;
        panel.QWidget::show();
        const auto shown = [&](bool isLocked) {
            node->propose(kStation, fact::SessionLocked{isLocked});
            return QTest::qWaitFor([&] { return node->state()->isLocked() == isLocked; },
                                   kPatience_ms);
        };
        QVERIFY(shown(true));
        panel.show(*node, SessionReach::ThisComputer);
        QVERIFY(find<QLabel>(panel, "locked").isVisible());
        for (const char* button : {"showPicture", "copy", "newCode"})
            QVERIFY(!find<QPushButton>(panel, button).isVisible());
        for (const QRadioButton* choice : panel.findChildren<QRadioButton*>())
            QVERIFY(!choice->isVisible());
        QVERIFY(shown(false));
        panel.show(*node, SessionReach::ThisComputer);
        QVERIFY(!find<QLabel>(panel, "locked").isVisible());
        QVERIFY(find<QPushButton>(panel, "copy").isVisible());
    }

    void linkIsCopiedByKeyboard()
    {
        MemoryDisk disk;
        const auto node = host(disk);
        InvitationPanel panel;
        panel.show(*node, SessionReach::ThisComputer);
        find<QRadioButton>(panel, "observers").click();
        QTest::keyClick(&find<QPushButton>(panel, "copy"), Qt::Key_Space);
        QVERIFY(joinLink(QGuiApplication::clipboard()->text().toStdString()) == pictured(panel));
        QVERIFY(pictured(panel)->role == Role::Observer);
    }

    void sessionThatIsOpenIsPicturedAtAnAddressOfThisComputer()
    {
        if (ownAddresses().empty())
            QSKIP("this computer is in no network");
        MemoryDisk disk;
        HostSettings settings = hostSettings(disk);
        settings.open = true;
        const auto node = *SessionNode::host(settings, std::make_unique<MemoryStore>(disk));
        InvitationPanel panel;
        panel.show(*node, SessionReach::ThisComputer);
        QCOMPARE(pictured(panel)->address, ownAddresses().front());
    }
};

CARINA_SCREEN_TEST(TestInvitationPanel)

} // namespace carina::invitation_panel_test

#include "tst_invitation_panel.moc"
