#include "tests/engine/net/anatomy_transfer/transfer_ends.h"
#include "tests/support/test_class.h"

#include <QTimer>

#include <algorithm>
#include <chrono>

namespace carina::set_server_test
{

using namespace test;
using namespace std::chrono_literals;

/// The server before clients that do as they like.
class TestSetServer : public QObject
{
    Q_OBJECT

private:
    static QSslConfiguration speaking(QSsl::SslProtocol protocol, const char* cipher)
    {
        QSslConfiguration configuration = tlsConfiguration({});
        configuration.setProtocol(protocol);
        configuration.setCiphers(QString::fromLatin1(cipher));
        return configuration;
    }

    /// What a client is told that asks for the set.
    static std::optional<Frame> told(RawPeer& client)
    {
        client.say(Want{kVersion, kSetHash});
        if (!soon([&] { return !client.heard().empty(); }))
            return std::nullopt;
        return client.heard().at(0);
    }
    static bool isOffered(RawPeer& client)
    {
        const auto answer = told(client);
        return answer && std::holds_alternative<Offer>(*answer);
    }
    static bool isBusy(RawPeer& client)
    {
        const auto answer = told(client);
        const auto* refusal = answer ? std::get_if<Refusal>(&*answer) : nullptr;
        return refusal && refusal->reason == Reason::Busy;
    }
    static bool comesIn(const ServingHost& host, const KeyOffer& offer = traineesOffer())
    {
        RawPeer client{host.port(), offer};
        return isOffered(client);
    }

private Q_SLOTS:
    void speaksTls12WithOneSuite()
    {
        ServingHost host{1};
        RawPeer client{host.port()};
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn(), kSoon_ms);
        QVERIFY(client.socket().sessionProtocol() == QSsl::TlsV1_2);
        QCOMPARE(client.socket().sessionCipher().name(),
                 QStringLiteral("ECDHE-PSK-CHACHA20-POLY1305"));
        QVERIFY(client.socket().peerCertificate().isNull());
    }

    void speaksNothingElse_data()
    {
        QTest::addColumn<QSslConfiguration>("configuration");
        QTest::newRow("a key without an exchange")
            << speaking(QSsl::TlsV1_2, "PSK-CHACHA20-POLY1305");
        QTest::newRow("another cipher") << speaking(QSsl::TlsV1_2, "ECDHE-PSK-AES128-CBC-SHA256");
        QTest::newRow("another version") << speaking(QSsl::TlsV1_3, "TLS_CHACHA20_POLY1305_SHA256");
    }
    void speaksNothingElse()
    {
        QFETCH(const QSslConfiguration, configuration);
        ServingHost host{1};
        RawPeer client{host.port(), traineesOffer(), configuration};
        QTRY_VERIFY_WITH_TIMEOUT(client.isOut(), kSoon_ms);
        QVERIFY(client.socket().error() != QAbstractSocket::UnknownSocketError);
    }

    void sendsFromTheByteThatIsAskedFor()
    {
        ServingHost host;
        RawPeer client{host.port()};
        client.say(Want{kVersion, kSetHash});
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard().empty(), kSoon_ms);
        QCOMPARE(std::get<Offer>(client.heard().at(0)).bytes, std::uint64_t(host.bytes.size()));
        client.say(Get{100'000});
        QTRY_COMPARE_WITH_TIMEOUT((client.heard(), client.chunks.size()),
                                  host.bytes.size() - 100'000, kSoon_ms);
        QCOMPARE(client.chunks, host.bytes.sliced(100'000));
    }

    void sendsTheLastByteAlone()
    {
        ServingHost host{1};
        RawPeer client{host.port()};
        client.say(Want{kVersion, kSetHash});
        client.say(Get{std::uint64_t(host.bytes.size()) - 1});
        QTRY_COMPARE_WITH_TIMEOUT((client.heard(), client.chunks), host.bytes.last(1), kSoon_ms);
    }

    void endsWhatMakesNoSense_data()
    {
        QTest::addColumn<QByteArray>("said");
        const auto of = [](std::initializer_list<Frame> frames) {
            QByteArray bytes;
            for (const Frame& frame : frames) {
                const auto encoded = encode(frame);
                bytes += QByteArray{viewOf(encoded).constData(), qsizetype(encoded.size())};
            }
            return bytes;
        };
        const Want want{kVersion, kSetHash};
        QTest::newRow("noise") << QByteArray(100, '\xff');
        QTest::newRow("an unending frame") << QByteArray{"\5\0\0\1\0", 5} + QByteArray(5000, 'x');
        QTest::newRow("taking what nobody offered") << of({Get{0}});
        QTest::newRow("wanting twice") << of({want, want});
        QTest::newRow("taking from behind the end") << of({want, Get{1u << 30}});
        QTest::newRow("refusing") << of({Refusal{Reason::Busy}});
    }
    void endsWhatMakesNoSense()
    {
        QFETCH(const QByteArray, said);
        ServingHost host{1};
        RawPeer client{host.port()};
        client.socket().write(said);
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn(), kSoon_ms);
        QTRY_VERIFY_WITH_TIMEOUT(client.isOut(), kSoon_ms);
        client.heard();
        QVERIFY(client.chunks.isEmpty());
    }

    void refusesAnotherVersionInWords()
    {
        ServingHost host{1};
        RawPeer client{host.port()};
        const QByteArray later{"\1\5\0\0\0CS\2zz", 10};
        client.socket().write(later);
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard().empty(), kSoon_ms);
        QVERIFY(std::get<Refusal>(client.heard().at(0)).reason == Reason::OtherVersion);
        QTRY_VERIFY_WITH_TIMEOUT(client.isOut(), kSoon_ms);
    }

    void refusesWhoComesBesidesTooManyOfItsAddress()
    {
        ServingHost host{1};
        std::deque<RawPeer> clients;
        for (std::size_t i = 0; i < kMostTransfersOfAddress; ++i)
            QVERIFY(isOffered(clients.emplace_back(host.port())));
        RawPeer more{host.port()};
        QVERIFY(isBusy(more));
        clients.pop_front(); // one leaves
        QTRY_VERIFY_WITH_TIMEOUT(comesIn(host), kSoon_ms);
    }

    void tokenHasTwoAtATime()
    {
        ServingHost host{1};
        std::deque<RawPeer> clients;
        for (int i = 0; i < 2; ++i)
            QVERIFY(isOffered(clients.emplace_back(host.port(), tokenOffer(1))));
        RawPeer third{host.port(), tokenOffer(1)};
        QVERIFY(isBusy(third));
        RawPeer another{host.port(), tokenOffer(2)};
        QVERIFY(isOffered(another));
    }

    /// One person under many names from a few addresses keeps out nobody from elsewhere.
    void whoComesFromElsewhereHasAPlaceBesideAnyCrowd()
    {
        ServingHost host{1};
        std::deque<RawPeer> crowd;
        std::uint16_t name = 0;
        for (const char* address : {"127.0.0.2", "127.0.0.3", "127.0.0.4", "127.0.0.5"})
            for (std::size_t i = 0; i < kMostTransfersOfAddress; ++i)
                QVERIFY(isOffered(crowd.emplace_back(host.port(), tokenOffer(++name),
                                                     tlsConfiguration({}), kSoon_ms,
                                                     QHostAddress{QString::fromLatin1(address)})));
        QCOMPARE(crowd.size(), kMostTransfers);
        RawPeer newcomer{host.port()};
        QVERIFY(isOffered(newcomer));
        const auto areOut = [&] {
            return std::ranges::count_if(crowd, [](const RawPeer& peer) { return peer.isOut(); });
        };
        QTRY_COMPARE_WITH_TIMEOUT(areOut(), std::ptrdiff_t{1}, kSoon_ms);
    }

    /// Who takes a byte now and then, only to keep its place, loses it.
    void whoTakesTooLittleLosesItsPlace()
    {
        ServingHost host{60'000, {.window = 1s, .leastBytes = 64 << 10}};
        std::deque<RawPeer> idle;
        for (int i = 0; i < 2; ++i) {
            RawPeer& client = idle.emplace_back(host.port(), tokenOffer(1));
            QVERIFY(isOffered(client));
            client.socket().setReadBufferSize(1024);
            client.say(Get{0});
        }
        QTimer sips;
        sips.callOnTimeout([&] {
            for (RawPeer& client : idle)
                client.socket().read(1);
        });
        sips.start(20);
        RawPeer third{host.port(), tokenOffer(1)};
        QVERIFY(isBusy(third));
        QTRY_VERIFY_WITH_TIMEOUT(comesIn(host, tokenOffer(1)), kSoon_ms);
    }

    void whoAsksForNothingIsEnded()
    {
        ServingHost host{1, {.window = 300ms}};
        RawPeer silent{host.port()};
        QVERIFY(silent.isIn());
        QTRY_VERIFY_WITH_TIMEOUT(silent.isOut(), kSoon_ms);
    }

    void whoMayNotBeThereAnyMoreIsSentNoMore_data()
    {
        QTest::addColumn<bool>("isKeyVoid");
        QTest::newRow("removed from the session") << false;
        QTest::newRow("its code or token void") << true;
    }
    void whoMayNotBeThereAnyMoreIsSentNoMore()
    {
        QFETCH(const bool, isKeyVoid);
        ServingHost host;
        RawPeer client{host.port(), tokenOffer(1)};
        QVERIFY(isOffered(client));
        QVERIFY(!client.isOut());
        (isKeyVoid ? host.isKeyHeld : host.isWelcome) = false;
        QTRY_VERIFY_WITH_TIMEOUT(client.isOut(), kSoon_ms);
        RawPeer again{host.port(), tokenOffer(1)};
        QTRY_VERIFY_WITH_TIMEOUT(again.isOut(), kSoon_ms);
        QVERIFY(again.heard().empty());
    }

    void letsNobodyInBeforeTheSessionIsOpen()
    {
        const QTemporaryDir folder;
        const auto server = SetServer::listen(0, false, folder.path().toStdString());
        QVERIFY(server);
        RawPeer client{(*server)->port(), traineesOffer(), tlsConfiguration({}), 100};
        QVERIFY(!client.isIn());
        (*server)->admit(kCarriedSession, answerTo, [](const std::string&) { return false; });
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn(), kSoon_ms);
    }
};

CARINA_TEST(TestSetServer)

} // namespace carina::set_server_test

#include "tst_set_server.moc"
