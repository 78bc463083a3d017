#include "tests/engine/net/carriage/carriage_ends.h"

namespace carina
{

using namespace test;

namespace
{

constexpr std::size_t kLarge = 60'000; ///< 3 MB: more than is under way at once

} // namespace

/// A server and those who fetch from it, over real sockets on loopback.
class TestSetTransfer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_cache = m_folder->path().toStdString() + "/here";
    }

    void comesWholeAndUnderItsName()
    {
        ServingHost host;
        const SetFetch fetch{doorAt(host.port()), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(isHere(fetch), kSoon_ms);
        const FetchStatus status = fetch.status();
        QCOMPARE(status.received, std::uint64_t(host.bytes.size()));
        QCOMPARE(status.set.bytes, std::uint64_t(host.bytes.size()));
        QCOMPARE(status.set.licence, std::string{"CC0\nby Somebody"});
        QVERIFY(!status.fault);
        QCOMPARE(contentOf(CarriedSets{m_cache}.file(status.set.digest)), host.bytes);
        QVERIFY(CarriedSets{m_cache}.load(status.set.digest, kSetHash));
    }

    void goesOnWhereTheConnectionBroke()
    {
        ServingHost host{kLarge};
        const qint64 third = host.bytes.size() / 3;
        BreakingRelay relay{host.port(), {third, third}};
        const SetFetch fetch{doorAt(relay.port()), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(isHere(fetch), kSoon_ms);
        QCOMPARE(relay.toClient.size(), std::size_t{3});
        // What was on its way when it broke may come again, and TLS adds a little.
        const qint64 all = relay.toClient[0] + relay.toClient[1] + relay.toClient[2];
        QVERIFY(all < host.bytes.size() + (1 << 20));
        QVERIFY(relay.toClient[2] < 2 * host.bytes.size() / 3);
        QCOMPARE(contentOf(CarriedSets{m_cache}.file(fetch.status().set.digest)), host.bytes);
    }

    void goesOnWhenTheProgramIsStartedAgain()
    {
        ServingHost host{kLarge};
        BreakingRelay relay{host.port(), {host.bytes.size() / 2}};
        {
            const SetFetch stopped{doorAt(relay.port()), kSetHash, m_cache};
            QTRY_VERIFY_WITH_TIMEOUT(stopped.status().fault.has_value(), kSoon_ms);
        }
        BreakingRelay second{host.port(), {}};
        const SetFetch fetch{doorAt(second.port()), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(isHere(fetch), kSoon_ms);
        QVERIFY(second.toClient[0] < 3 * host.bytes.size() / 4);
        QCOMPARE(contentOf(CarriedSets{m_cache}.file(fetch.status().set.digest)), host.bytes);
    }

    void isNotSentAgain()
    {
        ServingHost host;
        {
            const SetFetch first{doorAt(host.port()), kSetHash, m_cache};
            QTRY_VERIFY_WITH_TIMEOUT(isHere(first), kSoon_ms);
        }
        BreakingRelay relay{host.port(), {}};
        const SetFetch second{doorAt(relay.port()), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(isHere(second), kSoon_ms);
        QVERIFY(relay.toClient[0] < 4000);
        QCOMPARE(second.status().received, std::uint64_t(host.bytes.size()));
    }

    void comesForTwoProgramsThatShareACache()
    {
        ServingHost host;
        const SetFetch one{doorAt(host.port()), kSetHash, m_cache};
        const SetFetch other{doorAt(host.port()), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(isHere(one) && isHere(other), kSoon_ms);
        QCOMPARE(contentOf(CarriedSets{m_cache}.file(one.status().set.digest)), host.bytes);
    }

    void damagedRemainsAreReplaced()
    {
        ServingHost host;
        const std::string digest = CarriedSets{host.cache()}.prepare(kSetHash)->digest;
        auto part = CarriedSets{m_cache}.file(digest);
        putContent(part.replace_extension(".part"), QByteArray(100'000, '\0'));
        const SetFetch fetch{doorAt(host.port()), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(isHere(fetch), kSoon_ms);
        QCOMPARE(contentOf(CarriedSets{m_cache}.file(digest)), host.bytes);
    }

    void strangerIsTurnedAway_data()
    {
        QTest::addColumn<KeyOffer>("offer");
        KeyOffer offer = traineesOffer();
        offer.key = keyFilledWith(8);
        QTest::newRow("another key") << offer;
        offer = traineesOffer();
        offer.identity.who.participant = ParticipantId{3};
        QTest::newRow("a participant the host does not know") << offer;
        offer = traineesOffer();
        offer.identity.sessionId = std::string(32, '0');
        QTest::newRow("another session") << offer;
    }
    void strangerIsTurnedAway()
    {
        QFETCH(const KeyOffer, offer);
        ServingHost host;
        const SetFetch fetch{doorAt(host.port(), offer), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, Errc::WrongCode), kSoon_ms);
        QVERIFY(!std::filesystem::exists(m_cache));
    }

    void setThatNoStationHasIsRefused()
    {
        ServingHost host;
        const SetFetch other{doorAt(host.port()), std::string(64, 'b'), m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(other, Errc::SetNotNamed), kSoon_ms);
        host.isNamed = false;
        const SetFetch fetch{doorAt(host.port()), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, Errc::SetNotNamed), kSoon_ms);
    }

    void setThatIsGoneIsRefused()
    {
        ServingHost host;
        {
            const SetFetch before{doorAt(host.port()), kSetHash, m_cache};
            QTRY_VERIFY_WITH_TIMEOUT(isHere(before), kSoon_ms);
        }
        std::filesystem::remove_all(host.cache());
        const SetFetch fetch{doorAt(host.port()), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, Errc::SetWithdrawn), kSoon_ms);
    }

    void hostThatDoesNotAnswerIsAskedUntilItDoes()
    {
        ServingHost host;
        const std::uint16_t port = host.port();
        host.server.reset();
        const SetFetch fetch{doorAt(port), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(fetch.status().fault.has_value(), kSoon_ms);
        QVERIFY(fetch.status().fault->code == Errc::HostSilent);
        QVERIFY(fetch.status().state == FetchStatus::State::Asking);
        host.open(port);
        QTRY_VERIFY_WITH_TIMEOUT(isHere(fetch), kSoon_ms);
    }

    void portThatIsTakenIsNamed()
    {
        ServingHost host;
        const auto second = SetServer::listen(host.port(), false, host.cache());
        QVERIFY(!second && second.error().code == Errc::AddressInUse);
        QCOMPARE(second.error().detail, "TCP " + std::to_string(host.port()));
    }

private:
    static bool isHere(const SetFetch& fetch)
    {
        return fetch.status().state == FetchStatus::State::Here;
    }
    static bool failedWith(const SetFetch& fetch, Errc code)
    {
        const FetchStatus status = fetch.status();
        return status.state == FetchStatus::State::Failed && status.fault->code == code;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_cache;
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestSetTransfer)
#include "tst_set_transfer.moc"
