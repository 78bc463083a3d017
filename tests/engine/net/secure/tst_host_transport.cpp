#include "engine/net/secure/dtls_record.h"
#include "evaluation/network/lossy_relay.h"
#include "tests/engine/net/secure/transports.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <thread>

namespace carina::host_transport_test
{

/// What may happen to the keys of a host while a handshake is under way.
enum class Change : std::uint8_t {
    Nothing,
    OtherRolesCode,
    Code,
    CodeUnderived,
    TokenReplaced,
    TokenRevoked
};

namespace
{

const std::string kNewTrainee = "trainee:" + kSession + ":new";

QByteArray firstHelloOf(QUdpSocket& catcher)
{
    RawClient client{catcher.localPort(), kNewTrainee, {}};
    if (!catcher.waitForReadyRead(kPatience_ms))
        return {};
    return readRaw(catcher)->bytes;
}

/// The first that holds a cookie.
std::optional<LossyRelay::Passed> provedHello(const LossyRelay& relay)
{
    for (const auto& passed : relay.toHost())
        if (isClientHello(octets(passed.bytes)) && holdsCookie(octets(passed.bytes)))
            return passed;
    return std::nullopt;
}

/// Another ClientHello with the same cookie, which is one of the address alone.
QByteArray withAnotherRandom(QByteArray hello, int round)
{
    constexpr qsizetype kRandom = 13 + 12 + 2; // after the headers and the version
    hello[kRandom] = static_cast<char>(round);
    hello[kRandom + 1] = static_cast<char>(round >> 8);
    return hello;
}

/// Waits until no datagram waits in the host's socket, while this thread, which is the host's,
/// reads none. @returns whether that came about
bool isReadElsewhere(const HostTransport& host)
{
    const LocalTime end = monotonicNow() + std::chrono::milliseconds{kPatience_ms};
    while (host.nextWake() == LocalTime::min() && monotonicNow() < end)
        std::this_thread::yield();
    return host.nextWake() != LocalTime::min();
}

const ParticipantId kAnna{1};
const std::string kAnnas = "trainee:" + kSession + ":1";

void apply(Change change, TestHost& host)
{
    switch (change) {
    case Change::Nothing:
        return;
    case Change::OtherRolesCode:
        host.keys[Role::Observer] = randomKey();
        return;
    case Change::Code:
        host.keys[Role::Trainee] = randomKey();
        return;
    case Change::CodeUnderived:
        host.keys.erase(Role::Trainee);
        return;
    case Change::TokenReplaced:
        host.tokens[kAnna] = randomKey();
        return;
    case Change::TokenRevoked:
        host.tokens.erase(kAnna);
        return;
    }
}

} // namespace

class TestHostTransport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rightKeyIsLetInAsItsRole()
    {
        TestHost host;
        RawClient client{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn() && !host.heard.paths.empty(), kPatience_ms);
        QVERIFY((host.heard.paths.begin()->second == Credential{Role::Trainee, std::nullopt}));
        client.send("hello");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kPatience_ms);
        QVERIFY(host.heard.received[0] == textBytes("hello"));
    }

    void anyOtherKeyIsToldSoAndForgotten_data()
    {
        QTest::addColumn<QByteArray>("identity");
        const QByteArray session = QByteArray::fromStdString(kSession);
        QTest::newRow("wrong key") << QByteArray{"trainee:" + session + ":new"};
        QTest::newRow("of another participant") << QByteArray{"trainee:" + session + ":1"};
        QTest::newRow("of another session")
            << QByteArray{"trainee:" + QByteArray(32, '0') + ":new"};
        QTest::newRow("nonsense") << QByteArray{"root"};
    }
    void anyOtherKeyIsToldSoAndForgotten()
    {
        QFETCH(const QByteArray, identity);
        TestHost host;
        RawClient client{host.port(), identity.toStdString(), host.keys.at(Role::Observer)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.answers.empty()
                                     && isWrongKeyAlert(octets(client.answers.back())),
                                 kPatience_ms);
        QVERIFY(host.heard.paths.empty());
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
    }

    /// A client that has sent its key share and keeps back its last word.
    void handshakeUnderWayIsHeldAgainstTheKeyAtItsEnd_data()
    {
        QTest::addColumn<QByteArray>("identity");
        QTest::addColumn<Change>("change");
        QTest::addColumn<bool>("comesIn");
        const QByteArray code = QByteArray::fromStdString(kNewTrainee);
        const QByteArray token = QByteArray::fromStdString(kAnnas);
        QTest::newRow("code as before") << code << Change::Nothing << true;
        QTest::newRow("another role's code changed") << code << Change::OtherRolesCode << true;
        QTest::newRow("code changed") << code << Change::Code << false;
        QTest::newRow("code changed, not derived yet") << code << Change::CodeUnderived << false;
        QTest::newRow("token as before") << token << Change::Nothing << true;
        QTest::newRow("token replaced") << token << Change::TokenReplaced << false;
        QTest::newRow("token revoked") << token << Change::TokenRevoked << false;
    }
    void handshakeUnderWayIsHeldAgainstTheKeyAtItsEnd()
    {
        QFETCH(const QByteArray, identity);
        QFETCH(const Change, change);
        QFETCH(const bool, comesIn);
        TestHost host;
        host.tokens[kAnna] = randomKey();
        HeldFinish between{host.port()};
        const bool hasToken = identity == QByteArray::fromStdString(kAnnas);
        RawClient client{between.port(), identity.toStdString(),
                         hasToken ? host.tokens.at(kAnna) : host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(between.isHeld() && host.asked == 1, kPatience_ms);
        QCOMPARE(host.transport->handshakes(), std::size_t{1});
        apply(change, host);
        between.letGo();
        QTRY_COMPARE_WITH_TIMEOUT(host.transport->handshakes(), std::size_t{0}, kPatience_ms);
        QCOMPARE(host.transport->paths(), std::size_t{comesIn ? 1U : 0U});
        QCOMPARE(!host.heard.paths.empty(), comesIn);
    }

    void oneWhoseKeyIsNotDerivedYetIsLeftWaiting()
    {
        TestHost host;
        host.keys.erase(Role::Trainee);
        RawClient client{host.port(), kNewTrainee, randomKey()};
        // Cookie request, then the host's part; no word about the key.
        QTRY_COMPARE_WITH_TIMEOUT(client.answers.size(), std::size_t{2}, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(host.transport->handshakes(), std::size_t{0}, kPatience_ms);
        QCOMPARE(client.answers.size(), std::size_t{2});
    }

    void strangerGetsACookieAndNothingElse()
    {
        TestHost host;
        QUdpSocket stranger;
        QVERIFY(stranger.bind(kLoopback, 0));
        const QByteArray hello = firstHelloOf(stranger);
        stranger.writeDatagram(hello, kLoopback, host.port());
        QTRY_VERIFY_WITH_TIMEOUT(stranger.hasPendingDatagrams(), kPatience_ms);
        const QByteArray answer = readRaw(stranger)->bytes;
        QVERIFY(answer.size() < hello.size()); // of no use for flooding others
        QCOMPARE(int{octets(answer)[13]}, 3);  // HelloVerifyRequest
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
    }

    /// As somebody sends them who forges the address of a neighbour.
    void floodOfHellosWithoutCookieKeepsNobodyOut()
    {
        TestHost host;
        QUdpSocket flood;
        QVERIFY(flood.bind(kLoopback, 0));
        const QByteArray hello = firstHelloOf(flood);
        for (int i = 0; i < 500; ++i) {
            flood.writeDatagram(hello, kLoopback, host.port());
            host.pump.serve();
        }
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
        // Had each been counted, this source could say hello again after 7 s only, and this client
        // says hello only once.
        RawClient client{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn() && !host.heard.paths.empty(), kPatience_ms);
    }

    /// As by somebody who saw it on its way, or who sits behind the same address.
    void stormOfOneHelloWithItsCookieKeepsNobodyOfThatAddressOut_data()
    {
        QTest::addColumn<bool>("isSame");
        QTest::newRow("the same datagram") << true;
        QTest::newRow("another random number each time") << false;
    }
    void stormOfOneHelloWithItsCookieKeepsNobodyOfThatAddressOut()
    {
        QFETCH(const bool, isSame);
        TestHost host;
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty() && !host.heard.paths.empty(),
                                 kPatience_ms);
        const auto captured = provedHello(relay);
        QVERIFY(captured);
        int round = 0;
        const auto replay = [&] {
            const QByteArray bytes =
                isSame ? captured->bytes : withAnotherRandom(captured->bytes, ++round);
            relay.replay({captured->clientPort, bytes});
        };
        for (int i = 0; i < 500; ++i) {
            replay();
            host.pump.serve();
        }
        // Of its own place alone, and the path there is as it was.
        QVERIFY(host.transport->handshakes() <= 1);
        QVERIFY(host.heard.ended.empty());
        QTimer storm;
        storm.callOnTimeout([&] {
            for (int i = 0; i < 10; ++i)
                replay();
        });
        storm.start(0);
        RawClient neighbour{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(neighbour.isIn(), kPatience_ms); // it says hello only once
    }

    void capturedHelloIsVoidOnceItsCookieIsOld_data()
    {
        QTest::addColumn<qint64>("age_s");
        QTest::addColumn<bool>("begins");
        QTest::newRow("at once") << qint64{0} << true;
        QTest::newRow("of the period before") << qint64{90} << true;
        QTest::newRow("of the one before that") << qint64{120} << false;
        QTest::newRow("an hour old") << qint64{3600} << false;
    }
    void capturedHelloIsVoidOnceItsCookieIsOld()
    {
        QFETCH(const qint64, age_s);
        QFETCH(const bool, begins);
        TestHost host;
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty() && !host.heard.paths.empty(),
                                 kPatience_ms);
        const auto captured = provedHello(relay);
        QVERIFY(captured);
        const LocalTime later = monotonicNow() + std::chrono::seconds{age_s};
        host.transport->end(host.heard.paths.begin()->first, host.heard, later);
        QCOMPARE(host.transport->paths() + host.transport->handshakes(), std::size_t{0});
        relay.replay(*captured); // on loopback it is there once it is sent
        host.transport->serve(host.heard, later);
        QCOMPARE(host.transport->handshakes(), std::size_t{begins ? 1U : 0U});
    }

    /// Six hundred come of one while the host's thread does other things, more than the system
    /// keeps of a socket; then one of another.
    void busyHostLosesNothingOfThoseWhoSendLittle()
    {
        TestHost host;
        RawClient flooder{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        RawClient other{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(flooder.isIn() && other.isIn(), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(host.transport->paths(), std::size_t{2}, kPatience_ms);
        for (int round = 0; round < 6; ++round) {
            for (int i = 0; i < 100; ++i)
                flooder.send("flood");
            QVERIFY(isReadElsewhere(*host.transport));
        }
        other.send("one");
        QTRY_VERIFY_WITH_TIMEOUT(std::ranges::count(host.heard.received, textBytes("one")) == 1,
                                 kPatience_ms);
        QVERIFY(std::ranges::count(host.heard.received, textBytes("flood"))
                >= std::ptrdiff_t(ArrivalQueue::kMostOfOne));
    }

    void pathIsEndedOnRequest()
    {
        TestHost host;
        RawClient client{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn() && !host.heard.paths.empty(), kPatience_ms);
        const std::size_t answers = client.answers.size();
        host.transport->end(host.heard.paths.begin()->first, host.heard, monotonicNow());
        QCOMPARE(host.transport->paths(), std::size_t{0});
        QTRY_COMPARE_WITH_TIMEOUT(client.answers.size(), answers + 1, kPatience_ms); // close_notify
    }

    void whatIsNotEncryptedIsNotHeard()
    {
        TestHost host;
        RawClient client{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn() && !host.heard.paths.empty(), kPatience_ms);
        QUdpSocket stranger;
        QVERIFY(stranger.bind(kLoopback, 0));
        QByteArray plain{23, '\0'}; // an application record in the clear
        plain.replace(0, 13, QByteArray::fromHex("17fefd0000000000000001000a"));
        QByteArray encrypted = plain; // and one that only pretends
        encrypted[4] = 1;
        for (const QByteArray& bytes : {QByteArray{}, QByteArray{"CA"}, QByteArray(1201, '\x16'),
                                        QByteArray(9000, 'C'), plain, encrypted})
            stranger.writeDatagram(bytes, kLoopback, host.port());
        client.send("hello");
        QTRY_VERIFY_WITH_TIMEOUT(!host.heard.received.empty(), kPatience_ms);
        QCOMPARE(host.heard.received.size(), std::size_t{1});
        QCOMPARE(host.heard.paths.size(), std::size_t{1});
        QVERIFY(!stranger.hasPendingDatagrams());
    }

    void replayedDatagramsChangeNothing()
    {
        TestHost host;
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kPatience_ms);
        client.send("once");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kPatience_ms);
        const auto captured = relay.toHost(); // from the first hello on
        for (int i = 0; i < 2; ++i)
            for (const auto& passed : captured)
                relay.replay(passed);
        client.send("again");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{2}, kPatience_ms);
        QVERIFY(host.heard.received[1] == textBytes("again"));
        QVERIFY(host.heard.ended.empty());
        QCOMPARE(host.heard.paths.size(), std::size_t{1});
        QVERIFY(client.heard.ended.empty());
    }

    void clientThatRestartsFromItsPortIsBackAtOnce()
    {
        TestHost host;
        std::optional<RawClient> client;
        client.emplace(host.port(), kNewTrainee, host.keys.at(Role::Trainee));
        QTRY_VERIFY_WITH_TIMEOUT(client->isIn(), kPatience_ms);
        const std::uint16_t port = client->port();
        client.reset(); // without a word
        client.emplace(host.port(), kNewTrainee, host.keys.at(Role::Trainee), port);
        QTRY_VERIFY_WITH_TIMEOUT(client->isIn(), kPatience_ms); // it says hello only once
        QCOMPARE(client->port(), port);
        QCOMPARE(host.transport->paths(), std::size_t{1});
        QVERIFY(host.heard.ended == std::vector<PeerAddress>{1});
        QVERIFY(host.heard.paths.contains(2));
        client->send("back");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kPatience_ms);
    }

    void pathIsReplacedOnlyByOneThatIsProved()
    {
        TestHost host;
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kPatience_ms);
        // A stranger at the same address and port, as the host sees it, with another key.
        const std::uint16_t clientPort = relay.toHost().back().clientPort;
        QUdpSocket catcher;
        QVERIFY(catcher.bind(kLoopback, 0));
        relay.replay({clientPort, firstHelloOf(catcher)});
        client.send("still here");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kPatience_ms);
        QVERIFY(host.heard.ended.empty());
    }

    void silentPathsAndHandshakesAreForgotten()
    {
        TestHost host;
        RawClient client{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_COMPARE_WITH_TIMEOUT(host.transport->paths(), std::size_t{1}, kPatience_ms);
        const LocalTime now = monotonicNow();
        host.transport->serve(host.heard, now + HostTransport::kPathTimeout - 1s);
        QCOMPARE(host.transport->paths(), std::size_t{1});
        host.transport->serve(host.heard, now + HostTransport::kPathTimeout);
        QCOMPARE(host.transport->paths(), std::size_t{0});
        QVERIFY(host.heard.ended == std::vector<PeerAddress>{1});
    }

    void takenPortIsNamed()
    {
        TestHost host;
        const auto other = HostTransport::bind(host.port(), false);
        QVERIFY(!other);
        QCOMPARE(other.error(), (Error{Errc::AddressInUse, std::to_string(host.port())}));
    }

    void hostIsReachedFromElsewhereOnlyWhenOpen()
    {
        const auto closed = HostTransport::bind(0, false);
        const auto open = HostTransport::bind(0, true);
        QVERIFY(closed && open);
        const auto answers = [](HostTransport& transport, const QHostAddress& address) {
            QUdpSocket other; // the port is free at this address if nobody listens there
            return !other.bind(address, transport.port(), QAbstractSocket::DontShareAddress);
        };
        const QHostAddress elsewhere{QStringLiteral("127.0.0.2")};
        QVERIFY(answers(**closed, kLoopback));
        QVERIFY(!answers(**closed, elsewhere));
        QVERIFY(answers(**open, elsewhere));
    }
};

CARINA_TEST(TestHostTransport)

} // namespace carina::host_transport_test

#include "tst_host_transport.moc"
