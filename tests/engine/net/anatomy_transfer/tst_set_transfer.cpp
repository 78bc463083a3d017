#include "tests/engine/net/anatomy_transfer/transfer_ends.h"
#include "tests/support/test_class.h"

namespace carina::set_transfer_test
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
        QVERIFY(comes(fetch));
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
        QVERIFY(comes(fetch));
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
            QVERIFY(soon([&] { return stopped.status().fault.has_value(); }));
        }
        BreakingRelay second{host.port(), {}};
        const SetFetch fetch{doorAt(second.port()), kSetHash, m_cache};
        QVERIFY(comes(fetch));
        QVERIFY(second.toClient[0] < 3 * host.bytes.size() / 4);
        QCOMPARE(contentOf(CarriedSets{m_cache}.file(fetch.status().set.digest)), host.bytes);
    }

    void isNotSentAgain()
    {
        ServingHost host;
        {
            const SetFetch first{doorAt(host.port()), kSetHash, m_cache};
            QVERIFY(comes(first));
        }
        BreakingRelay relay{host.port(), {}};
        const SetFetch second{doorAt(relay.port()), kSetHash, m_cache};
        QVERIFY(comes(second));
        QVERIFY(relay.toClient[0] < 4000);
        QCOMPARE(second.status().received, std::uint64_t(host.bytes.size()));
    }

    void comesForTwoProgramsThatShareACache()
    {
        ServingHost host;
        const SetFetch one{doorAt(host.port()), kSetHash, m_cache};
        const SetFetch other{doorAt(host.port()), kSetHash, m_cache};
        QVERIFY(comes(one) && comes(other));
        QCOMPARE(contentOf(CarriedSets{m_cache}.file(one.status().set.digest)), host.bytes);
    }

    void damagedRemainsAreReplaced()
    {
        ServingHost host;
        const std::string digest = CarriedSets{host.cache()}.prepare(kSetHash)->digest;
        auto part = CarriedSets{m_cache}.file(digest);
        putContent(part.replace_extension(".part"), QByteArray(100'000, '\0'));
        const SetFetch fetch{doorAt(host.port()), kSetHash, m_cache};
        QVERIFY(comes(fetch));
        QCOMPARE(contentOf(CarriedSets{m_cache}.file(digest)), host.bytes);
    }

    void strangerIsTurnedAway()
    {
        KeyOffer guessed = traineesOffer();
        guessed.key = keyFilledWith(8);
        KeyOffer unknown = traineesOffer();
        unknown.identity.who.participant = ParticipantId{3};
        KeyOffer elsewhere = traineesOffer();
        elsewhere.identity.sessionId = std::string(32, '0');
        ServingHost host;
        // All at once: a client believes it only after some tries.
        const SetFetch byAnotherKey{doorAt(host.port(), guessed), kSetHash, m_cache};
        const SetFetch asNobodyKnown{doorAt(host.port(), unknown), kSetHash, m_cache};
        const SetFetch ofAnotherSession{doorAt(host.port(), elsewhere), kSetHash, m_cache};
        QVERIFY(fails(byAnotherKey, Errc::WrongCode));
        QVERIFY(fails(asNobodyKnown, Errc::WrongCode));
        QVERIFY(fails(ofAnotherSession, Errc::WrongCode));
        QVERIFY(!std::filesystem::exists(m_cache));
    }

    void setThatNoStationHasIsRefused()
    {
        ServingHost host;
        const SetFetch other{doorAt(host.port()), std::string(64, 'b'), m_cache};
        QVERIFY(fails(other, Errc::SetNotNamed));
        host.isNamed = false;
        const SetFetch fetch{doorAt(host.port()), kSetHash, m_cache};
        QVERIFY(fails(fetch, Errc::SetNotNamed));
    }

    void setThatIsGoneIsRefused()
    {
        ServingHost host;
        {
            const SetFetch before{doorAt(host.port()), kSetHash, m_cache};
            QVERIFY(comes(before));
        }
        std::filesystem::remove_all(host.cache());
        const SetFetch fetch{doorAt(host.port()), kSetHash, m_cache};
        QVERIFY(fails(fetch, Errc::SetWithdrawn));
    }

    void hostThatDoesNotAnswerIsAskedUntilItDoes()
    {
        ServingHost host;
        const std::uint16_t port = host.port();
        host.server.reset();
        const SetFetch fetch{doorAt(port), kSetHash, m_cache};
        QVERIFY(soon([&] { return fetch.status().fault.has_value(); }));
        QVERIFY(fetch.status().fault->code == Errc::HostSilent);
        QVERIFY(fetch.status().state == FetchStatus::State::Asking);
        host.open(port);
        QVERIFY(comes(fetch));
    }

    void portThatIsTakenIsNamed()
    {
        ServingHost host;
        const auto second = SetServer::listen(host.port(), false, host.cache());
        QVERIFY(!second && second.error().code == Errc::AddressInUse);
        QCOMPARE(second.error().detail, "TCP " + std::to_string(host.port()));
    }

private:
    static bool fails(const SetFetch& fetch, Errc code)
    {
        return soon([&] {
            const FetchStatus status = fetch.status();
            return status.state == FetchStatus::State::Failed && status.fault->code == code;
        });
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_cache;
};

CARINA_TEST(TestSetTransfer)

} // namespace carina::set_transfer_test

#include "tst_set_transfer.moc"
