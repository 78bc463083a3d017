#include "engine/net/discovery/session_beacon.h"
#include "engine/net/entry/session_identity.h"
#include "engine/net/entry/token_folder.h"
#include "models/errors/error_text.h"
#include "tests/engine/net/node/free_port.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"
#include "ui/join/join_dialog.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QTemporaryDir>

namespace carina::join_dialog_test
{

namespace
{

const QString kLink =
    QStringLiteral("carina:join?address=192.0.2.7&port=45000&role=observer&code=7K3QM-XW2PD");

/// What is kept of one who was in a session before.
struct LastTime {
    LastTime()
    {
        TokenFolder kept{tokens(), Role::Trainee, "Anna"};
        QVERIFY(kept.keep(session, {}));
        QVERIFY(kept.keepVisit({session, "192.0.2.7", 45001}));
        keepLastTime(tokens(), {.name = QStringLiteral("Anna")});
    }
    [[nodiscard]] std::filesystem::path tokens() const { return folder.path().toStdString(); }
    [[nodiscard]] JoinSettings settings() const
    {
        JoinSettings known;
        known.tokens = tokens();
        return known;
    }
    [[nodiscard]] JoinForm form() const
    {
        return withLastPlace(withLastPerson({}, tokens()), tokens());
    }

    QTemporaryDir folder;
    std::string session = std::string(32, 'a');
};

} // namespace

class TestJoinDialog : public QObject
{
    Q_OBJECT

private:
    static JoinForm complete()
    {
        return {QStringLiteral("192.0.2.7"), QStringLiteral("45000"), QStringLiteral("7K3QM-XW2PD"),
                QStringLiteral("Anna"), Role::Observer};
    }
    /// A host that answers when the test says so.
    Entrance::Join join()
    {
        return [this](const JoinSettings&) -> Result<std::unique_ptr<SessionNode>> {
            ++m_tries;
            auto node = std::make_unique<test::FakeSessionNode>(kNobody);
            m_node = node.get();
            return node;
        };
    }
    template <class Widget> static Widget& find(const QWidget& window, const char* name)
    {
        return *window.findChild<Widget*>(QLatin1String{name});
    }
    static SessionNotice ward()
    {
        SessionNotice notice{{}, "Ward 3", 45000};
        notice.session.fill(std::byte{1});
        return notice;
    }

    test::FakeSessionNode* m_node = nullptr;
    int m_tries = 0;

private Q_SLOTS:
    void init() { m_tries = 0; }

    void joinsASessionThatIsFoundByKeyboardAlone()
    {
        const std::uint16_t port = freePort();
        const auto beacon = SessionBeacon::open(ward(), false, port);
        FoundSessionsModel sessions{port};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, {}};
        dialog.show();
        QTRY_COMPARE_WITH_TIMEOUT(sessions.rowCount(), 1, kPatience_ms);
        QVERIFY(sessions.index(0).data().toString().contains(QStringLiteral("Ward 3")));
        auto& list = find<QListView>(dialog, "sessions");
        list.setFocus();
        QTest::keyClick(&list, Qt::Key_Down);
        QTest::keyClick(&list, Qt::Key_Home);
        QCOMPARE(find<QLineEdit>(dialog, "port").text(), QStringLiteral("45000"));
        QVERIFY(!find<QPushButton>(dialog, "join").isEnabled());
        QTest::keyClicks(&find<QLineEdit>(dialog, "name"), QStringLiteral("Anna"));
        QTest::keyClicks(&find<QLineEdit>(dialog, "code"), QStringLiteral("7K3QM-XW2PD"));
        QCOMPARE(find<QLabel>(dialog, "missing").text(), QString{});
        QTest::keyClick(&find<QLineEdit>(dialog, "name"), Qt::Key_Return);
        QCOMPARE(find<QLabel>(dialog, "missing").text(), entrance.progress());
        m_node->becomes(ParticipantId{7});
        entrance.look();
        QCOMPARE(dialog.result(), static_cast<int>(QDialog::Accepted));
        QVERIFY(entrance.isIn());
        QCOMPARE(dialog.form().name, QStringLiteral("Anna"));
        QCOMPARE(dialog.form().address, QStringLiteral("127.0.0.1"));
        QVERIFY(dialog.form().role == Role::Trainee);
    }

    /// The message of three lines takes its own room.
    void growsForWhatItSays()
    {
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, complete()};
        dialog.show();
        QCoreApplication::sendPostedEvents();
        dialog.accept();
        for (int i = 0; i < Entrance::kPatience; ++i)
            entrance.look();
        QTRY_VERIFY_WITH_TIMEOUT(
            dialog.height() >= dialog.layout()->totalHeightForWidth(dialog.width()), kPatience_ms);
        const auto& missing = find<QLabel>(dialog, "missing");
        const auto& more = find<QPushButton>(dialog, "more");
        QVERIFY(missing.text().contains(QStringLiteral("not answered yet")));
        QVERIFY(missing.height() >= missing.heightForWidth(missing.width()));
        QVERIFY(more.height() >= more.sizeHint().height());
        QVERIFY(more.parentWidget()->rect().contains(more.geometry()));
    }

    /// Nothing is left to choose.
    void theOnlySessionIsChosen()
    {
        const std::uint16_t port = freePort();
        const auto beacon = SessionBeacon::open(ward(), false, port);
        FoundSessionsModel sessions{port};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, {.name = QStringLiteral("Anna")}};
        dialog.show();
        QTRY_COMPARE_WITH_TIMEOUT(find<QLineEdit>(dialog, "port").text(), QStringLiteral("45000"),
                                  kPatience_ms);
        QCOMPARE(find<QLineEdit>(dialog, "address").text(), QStringLiteral("127.0.0.1"));
        QCOMPARE(dialog.focusWidget()->objectName(), QStringLiteral("code"));
    }

    /// As it is while the console is away: where it was, and a press of Join.
    void sessionOfTheLastTimeIsFilledIn()
    {
        FoundSessionsModel sessions{freePort()};
        const LastTime last;
        Entrance entrance{last.settings(), join()};
        JoinDialog dialog{sessions, entrance, last.form()};
        QCOMPARE(dialog.form().address, QStringLiteral("192.0.2.7"));
        QVERIFY(find<QPushButton>(dialog, "join").isEnabled());
        dialog.accept();
        QCOMPARE(m_tries, 1);
    }

    /// Whatever else is found, and although it is joined by link.
    void sessionOfTheLastTimeIsChosenOnceItIsFound()
    {
        const std::uint16_t port = freePort();
        const LastTime last;
        FoundSessionsModel sessions{port};
        sessions.lookFor(*lastSession(last.form(), last.tokens()));
        Entrance entrance{last.settings(), join()};
        JoinDialog dialog{sessions, entrance, last.form()};
        dialog.show();
        const auto another = SessionBeacon::open(ward(), false, port);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.form().port, QStringLiteral("45000"), kPatience_ms);
        const auto known = SessionBeacon::open({sessionKey(last.session), "Ward 4", 45004}, false,
                                               port, Announced::ToThoseWhoKnowIt);
        QVERIFY(another && known);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.form().port, QStringLiteral("45004"), kPatience_ms);
        QCOMPARE(dialog.form().address, QStringLiteral("127.0.0.1"));
        QCOMPARE(dialog.focusWidget()->objectName(), QStringLiteral("join"));
        QVERIFY(sessions.index(*sessions.knownRow())
                    .data()
                    .toString()
                    .contains(QStringLiteral("you were here last")));
    }

    /// Who types the code of another one is not led away from it.
    void sessionOfTheLastTimeComesTooLate()
    {
        const std::uint16_t port = freePort();
        const LastTime last;
        FoundSessionsModel sessions{port};
        sessions.lookFor(*lastSession(last.form(), last.tokens()));
        Entrance entrance{last.settings(), join()};
        JoinDialog dialog{sessions, entrance, last.form()};
        dialog.show();
        const auto another = SessionBeacon::open(ward(), false, port);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.form().port, QStringLiteral("45000"), kPatience_ms);
        find<QLineEdit>(dialog, "code").setText(QStringLiteral("7K3QM-XW2PD"));
        const auto known = SessionBeacon::open({sessionKey(last.session), "Ward 4", 45004}, false,
                                               port, Announced::ToThoseWhoKnowIt);
        QTRY_COMPARE_WITH_TIMEOUT(sessions.rowCount(), 2, kPatience_ms);
        QCOMPARE(dialog.form().port, QStringLiteral("45000"));
    }

    void tabGoesFromAboveToBelow()
    {
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, complete()};
        dialog.show();
        const QStringList wanted{
            QStringLiteral("sessions"), QStringLiteral("address"), QStringLiteral("port"),
            QStringLiteral("code"),     QStringLiteral("name"),    QStringLiteral("role"),
            QStringLiteral("station"),  QStringLiteral("more"),    QStringLiteral("join")};
        find<QListView>(dialog, "sessions").setFocus();
        QStringList passed;
        while (passed.size() < wanted.size()) {
            passed += dialog.focusWidget()->objectName();
            QTest::keyClick(dialog.focusWidget(), Qt::Key_Tab);
        }
        QCOMPARE(passed, wanted);
    }

    void whatWasTypedIsNotReplacedByASession()
    {
        const std::uint16_t port = freePort();
        const auto beacon = SessionBeacon::open(ward(), false, port);
        FoundSessionsModel sessions{port};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, complete()};
        QTRY_COMPARE_WITH_TIMEOUT(sessions.rowCount(), 1, kPatience_ms);
        QCOMPARE(dialog.form().address, complete().address);
    }

    /// Few sessions have one.
    void certificateIsBehindMore()
    {
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, complete()};
        dialog.show();
        auto& certificate = find<QLineEdit>(dialog, "certificate");
        QVERIFY(!certificate.isVisible());
        find<QPushButton>(dialog, "more").click();
        QVERIFY(certificate.isVisible());
    }

    void saysWhatIsMissingUntilNothingIs()
    {
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{{}, join()};
        JoinDialog dialog{
            sessions, entrance, {.name = QStringLiteral("Anna"), .role = Role::Observer}};
        const auto& missing = find<QLabel>(dialog, "missing");
        QVERIFY(missing.text().contains(QStringLiteral("address")));
        find<QLineEdit>(dialog, "address").setText(QStringLiteral("192.0.2.7"));
        QVERIFY(missing.text().contains(QStringLiteral("port")));
        find<QLineEdit>(dialog, "port").setText(QStringLiteral("45000"));
        QVERIFY(missing.text().contains(QStringLiteral("code of your role")));
        QVERIFY(!find<QPushButton>(dialog, "join").isEnabled());
        find<QLineEdit>(dialog, "code").setText(QStringLiteral("7K3QM-XW2PD"));
        QCOMPARE(missing.text(), QString{});
        QVERIFY(find<QPushButton>(dialog, "join").isEnabled());
        find<QLineEdit>(dialog, "code").setText(QStringLiteral("7K3"));
        QVERIFY(missing.text().contains(QStringLiteral("code")));
        QVERIFY(!find<QPushButton>(dialog, "join").isEnabled());
        QVERIFY(dialog.form().role == Role::Observer);
    }

    void whatIsIncompleteIsNotTried()
    {
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{{}, join()};
        JoinForm form = complete();
        form.code.clear();
        JoinDialog dialog{sessions, entrance, form};
        dialog.accept();
        QCOMPARE(m_tries, 0);
        QVERIFY(!entrance.isTrying());
    }

    void refusalLeadsBackToTheFieldThatIsWrong_data()
    {
        QTest::addColumn<Errc>("why");
        QTest::addColumn<QString>("field");
        QTest::newRow("code") << Errc::WrongCode << QStringLiteral("code");
        QTest::newRow("name") << Errc::NameTaken << QStringLiteral("name");
        QTest::newRow("station") << Errc::StationUnknown << QStringLiteral("station");
        QTest::newRow("certificate") << Errc::CertificateNeeded << QStringLiteral("certificate");
        QTest::newRow("version") << Errc::VersionMismatch << QStringLiteral("address");
    }

    void refusalLeadsBackToTheFieldThatIsWrong()
    {
        QFETCH(const Errc, why);
        QFETCH(const QString, field);
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, complete()};
        dialog.show();
        dialog.accept();
        QVERIFY(!find<QLineEdit>(dialog, "code").isEnabled());
        QVERIFY(!find<QPushButton>(dialog, "join").isEnabled());
        m_node->isRefused({why, {}});
        for (int i = 0; i < Entrance::kTakenBelieved; ++i)
            entrance.look();
        QVERIFY(dialog.isVisible());
        QCOMPARE(find<QLabel>(dialog, "missing").text(), errorText({why, {}}));
        QCOMPARE(dialog.focusWidget()->objectName(), field);
        QCOMPARE(dialog.form().name, complete().name);
        QCOMPARE(dialog.form().code, complete().code);
        QCOMPARE(dialog.form().address, complete().address);
        QVERIFY(dialog.form().role == Role::Observer);
        QVERIFY(find<QPushButton>(dialog, "join").isEnabled());
        find<QLineEdit>(dialog, "name").setText(QStringLiteral("Anne"));
        QCOMPARE(find<QLabel>(dialog, "missing").text(), QString{});
        dialog.accept();
        QCOMPARE(m_tries, 2);
    }

    void refusalStaysWhenASessionIsFound()
    {
        const std::uint16_t port = freePort();
        FoundSessionsModel sessions{port};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, complete()};
        dialog.show();
        dialog.accept();
        m_node->isRefused({Errc::WrongCode, {}});
        entrance.look();
        const auto beacon = SessionBeacon::open(ward(), false, port);
        QTRY_COMPARE_WITH_TIMEOUT(sessions.rowCount(), 1, kPatience_ms);
        QCOMPARE(find<QLabel>(dialog, "missing").text(), errorText({Errc::WrongCode, {}}));
    }

    void cancelStopsJoiningAndThenLeaves()
    {
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, complete()};
        dialog.show();
        dialog.accept();
        dialog.reject();
        QVERIFY(dialog.isVisible() && !entrance.isTrying());
        QVERIFY(find<QLineEdit>(dialog, "code").isEnabled());
        dialog.reject();
        QVERIFY(!dialog.isVisible());
        QCOMPARE(dialog.result(), static_cast<int>(QDialog::Rejected));
    }

    void linkThatIsPastedFillsInWhatItSays()
    {
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, {.name = QStringLiteral("Anna")}};
        auto& address = find<QLineEdit>(dialog, "address");
        QGuiApplication::clipboard()->setText(kLink);
        address.setFocus();
        QTest::keySequence(&address, QKeySequence::Paste);
        QCOMPARE(address.text(), QStringLiteral("192.0.2.7"));
        QCOMPARE(find<QLineEdit>(dialog, "port").text(), QStringLiteral("45000"));
        QCOMPARE(find<QLineEdit>(dialog, "code").text(), QStringLiteral("7K3QM-XW2PD"));
        QVERIFY(dialog.form().role == Role::Observer);
        QCOMPARE(dialog.form().name, QStringLiteral("Anna"));
        QCOMPARE(find<QLabel>(dialog, "missing").text(), QString{});
    }

    void linkThatTheProgramWasGivenFillsInWhatItSays()
    {
        FoundSessionsModel sessions{freePort()};
        const QString link = kLink + QStringLiteral("&certificate=carina.example");
        Entrance entrance{{}, join()};
        const JoinDialog dialog{
            sessions, entrance, {.address = link, .name = QStringLiteral("Anna")}};
        QCOMPARE(dialog.form().address, QStringLiteral("192.0.2.7"));
        QCOMPARE(dialog.form().certificate, QStringLiteral("carina.example"));
        QVERIFY(dialog.form().role == Role::Observer);
        QVERIFY(find<QPushButton>(dialog, "join").isEnabled());
    }

    void wrongLinkIsSaidToBeOneAndFillsInNothing()
    {
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, {.name = QStringLiteral("Anna")}};
        find<QLineEdit>(dialog, "address").setText(QString{kLink}.remove(QStringLiteral("-XW2PD")));
        const QString missing = find<QLabel>(dialog, "missing").text();
        QVERIFY2(missing.contains(QStringLiteral("link")), qPrintable(missing));
        QVERIFY2(missing.contains(QStringLiteral("ten letters")), qPrintable(missing));
        QCOMPARE(find<QLineEdit>(dialog, "port").text(), QString{});
        QVERIFY(!find<QPushButton>(dialog, "join").isEnabled());
    }

    void sessionThatIsGoneLeavesTheList()
    {
        const std::uint16_t port = freePort();
        auto beacon = SessionBeacon::open(ward(), false, port);
        FoundSessionsModel sessions{port};
        Entrance entrance{{}, join()};
        JoinDialog dialog{sessions, entrance, {}};
        QTRY_COMPARE_WITH_TIMEOUT(sessions.rowCount(), 1, kPatience_ms);
        beacon->reset();
        QTRY_COMPARE_WITH_TIMEOUT(sessions.rowCount(), 0, kPatience_ms);
        QVERIFY(find<QLabel>(dialog, "searching").text().contains(QStringLiteral("Looking")));
    }

    void everyControlHasANameForAScreenReader()
    {
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{{}, join()};
        const JoinDialog dialog{sessions, entrance, {}};
        for (const QLineEdit* edit : dialog.findChildren<QLineEdit*>())
            QVERIFY(!edit->accessibleName().isEmpty());
        QVERIFY(!find<QListView>(dialog, "sessions").accessibleName().isEmpty());
        QVERIFY(!find<QComboBox>(dialog, "role").accessibleName().isEmpty());
    }
};

CARINA_SCREEN_TEST(TestJoinDialog)

} // namespace carina::join_dialog_test

#include "tst_join_dialog.moc"
