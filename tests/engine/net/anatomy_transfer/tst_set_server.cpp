#include "tests/engine/net/anatomy_transfer/transfer_ends.h"
#include "tests/support/test_class.h"

namespace carina::set_server_test
{

using namespace test;

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

    void refusesWhoComesBesidesTooMany()
    {
        ServingHost host{1};
        std::deque<RawPeer> clients;
        for (std::size_t i = 0; i < SetServer::kMostTransfers; ++i) {
            RawPeer& client = clients.emplace_back(host.port());
            client.say(Want{kVersion, kSetHash});
            QTRY_VERIFY_WITH_TIMEOUT(!client.heard().empty(), kSoon_ms);
            QVERIFY(std::holds_alternative<Offer>(client.heard().at(0)));
        }
        RawPeer more{host.port()};
        QTRY_VERIFY_WITH_TIMEOUT(!more.heard().empty(), kSoon_ms);
        QVERIFY(std::get<Refusal>(more.heard().at(0)).reason == Reason::Busy);
        clients.pop_front(); // one leaves
        const auto isTaken = [&] {
            RawPeer next{host.port()};
            next.say(Want{kVersion, kSetHash});
            const bool came = QTest::qWaitFor([&] { return !next.heard().empty(); }, kSoon_ms);
            return came && std::holds_alternative<Offer>(next.heard().at(0));
        };
        QTRY_VERIFY_WITH_TIMEOUT(isTaken(), kSoon_ms);
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
