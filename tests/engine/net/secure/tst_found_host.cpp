#include "engine/net/discovery/session_beacon.h"
#include "engine/net/entry/session_identity.h"
#include "tests/engine/net/node/free_port.h"
#include "tests/engine/net/secure/transports.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

namespace carina::found_host_test
{
namespace
{

constexpr ParticipantId kAnna{4};
constexpr int kTriesOfImpostor = 6;

std::unique_ptr<SessionBeacon> announce(std::uint16_t hostPort, std::uint16_t discoveryPort)
{
    auto beacon =
        SessionBeacon::open({sessionKey(kSession), "Ward 3", hostPort}, false, discoveryPort);
    return beacon ? *std::move(beacon) : nullptr;
}

/// A client whose host goes away.
struct LeftAlone {
    /// Lets the client in and gives it a token; then the host is gone without a word.
    [[nodiscard]] bool leave()
    {
        if (!QTest::qWaitFor([this] { return !client.heard.paths.empty(); }, kPatience_ms))
            return false;
        client.credentials.keepToken({kAnna, token});
        host.reset();
        return true;
    }
    [[nodiscard]] bool isBack() const { return client.heard.paths.size() > 1; }
    /// The host again, at a port of its own.
    std::unique_ptr<TestHost> anew() const
    {
        auto again = std::make_unique<TestHost>();
        again->tokens = {{kAnna, token}};
        return again;
    }

    std::uint16_t discoveryPort = freePort();
    AccessKey token = randomKey();
    std::unique_ptr<TestHost> host = std::make_unique<TestHost>();
    TestClient client{host->port(), host->keys.at(Role::Trainee), Role::Trainee, {}, discoveryPort};
};

/// The program of one who was in the session before, in a folder with her tokens.
struct StartedAgain {
    StartedAgain()
    {
        TokenFolder kept{tokens(), Role::Trainee, "Anna"};
        static_cast<void>(kept.keep(kSession, {kAnna, token}));
    }
    [[nodiscard]] std::filesystem::path tokens() const { return folder.path().toStdString(); }
    /// Started with the place that was told the last time, too.
    [[nodiscard]] std::unique_ptr<TestClient> client(std::uint16_t port) const
    {
        const std::string address = kLoopback.toString().toStdString();
        const TokenFolder kept{tokens(), Role::Trainee, "Anna"};
        static_cast<void>(kept.keepVisit({kSession, address, port}));
        auto made = std::make_unique<TestClient>(port, AccessKey{}, Role::Trainee,
                                                 std::optional<ExpectedCertificate>{},
                                                 discoveryPort, tokens());
        made->credentials.setPlace(address, port);
        return made;
    }

    QTemporaryDir folder;
    std::uint16_t discoveryPort = freePort();
    AccessKey token = randomKey();
};

} // namespace

class TestFoundHost : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hostThatComesBackAtAnotherPortIsFound()
    {
        LeftAlone anna;
        QVERIFY(anna.leave());
        std::uint16_t movedTo = 0;
        anna.client.transport.onMoved(
            [&](const std::string&, std::uint16_t port) { movedTo = port; });
        const auto again = anna.anew();
        const auto beacon = announce(again->port(), anna.discoveryPort);
        QVERIFY(beacon);
        QTRY_VERIFY_WITH_TIMEOUT(anna.isBack(), kPatience_ms);
        QCOMPARE(movedTo, again->port());
        QVERIFY(again->heard.paths.begin()->second.participant == kAnna);
        anna.client.send("here again");
        QTRY_COMPARE_WITH_TIMEOUT(again->heard.received.size(), std::size_t{1}, kPatience_ms);
    }

    /// Her program is started again while the host is away, by the same words as before.
    void hostIsFoundByAProgramThatIsStartedAgain()
    {
        const StartedAgain anna;
        const std::uint16_t known = freePort(); // where nobody is any more
        TestHost host;
        host.tokens = {{kAnna, anna.token}};
        const auto beacon = announce(host.port(), anna.discoveryPort);
        QVERIFY(beacon);
        const auto client = anna.client(known);
        QTRY_COMPARE_WITH_TIMEOUT(client->heard.paths.size(), std::size_t{1}, kPatience_ms);
        QVERIFY(host.heard.paths.begin()->second.participant == kAnna);
        QCOMPARE(client->credentials.session(), kSession);
    }

    /// Somebody is where she was told to go, however long that takes: nobody else is asked.
    void whoAnswersAtThePlaceThatWasToldIsNotPassedBy()
    {
        const StartedAgain anna;
        TestHost slow;
        slow.transport->admit(kSession, [&slow](const PskIdentity&) {
            ++slow.asked;
            return HostTransport::KeyAnswer{HostTransport::KeyAnswer::State::NotYet, {}};
        });
        TestHost elsewhere;
        elsewhere.tokens = {{kAnna, anna.token}};
        const auto beacon = announce(elsewhere.port(), anna.discoveryPort);
        const auto client = anna.client(slow.port());
        QVERIFY(!QTest::qWaitFor([&] { return elsewhere.asked > 0; },
                                 2 * int(ClientTransport::kSearchAfter / 1ms)));
        QVERIFY(slow.asked > 0);
    }

    /// Anybody can answer in the name of a session: with keys of their own they are nobody, with
    /// none they keep nobody from the host, and nothing that they say ends the search.
    void impostorGetsNowhere()
    {
        LeftAlone anna;
        QVERIFY(anna.leave());
        TestHost impostor;
        impostor.tokens = {{kAnna, randomKey()}};
        TestHost refuser; // who says that the token is wrong
        const auto first = announce(impostor.port(), anna.discoveryPort);
        const auto second = announce(refuser.port(), anna.discoveryPort);
        const auto third = announce(freePort(), anna.discoveryPort);
        QVERIFY(first && second && third);
        QTRY_VERIFY_WITH_TIMEOUT(
            impostor.asked > kTriesOfImpostor && refuser.asked > kTriesOfImpostor, kPatience_ms);
        QVERIFY(!anna.isBack());
        QVERIFY(impostor.heard.paths.empty() && refuser.heard.paths.empty());
        QVERIFY(!anna.client.credentials.refusal() && anna.client.credentials.hasToken());

        const auto again = anna.anew();
        const auto beacon = announce(again->port(), anna.discoveryPort);
        QTRY_VERIFY_WITH_TIMEOUT(anna.isBack(), kPatience_ms);
        QCOMPARE(again->heard.paths.size(), std::size_t{1});
    }
};

CARINA_TEST(TestFoundHost)

} // namespace carina::found_host_test

#include "tst_found_host.moc"
