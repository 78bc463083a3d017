#include "tests/engine/net/anatomy_transfer/transfer_ends.h"
#include "tests/support/test_class.h"

namespace carina::set_fetch_test
{

using namespace test;

/// The client before hosts that do as they like.
class TestSetFetch : public QObject
{
    Q_OBJECT

private:
    static inline const std::string kSomeDigest = std::string(64, 'a');

    static bool failedWith(const SetFetch& fetch, Errc code)
    {
        const FetchStatus status = fetch.status();
        return status.state == FetchStatus::State::Failed && status.fault->code == code;
    }
    [[nodiscard]] SetFetch fetchFrom(const ScriptedHost& host) const
    {
        return SetFetch{doorAt(host.port()), kSetHash, m_cache};
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_cache;

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_cache = m_folder->path().toStdString() + "/here";
    }

    void wantsTheSetByName()
    {
        std::vector<Frame> asked;
        ScriptedHost host{[&](RawPeer&, const Frame& frame) { asked.push_back(frame); }};
        const auto fetch = fetchFrom(host);
        QTRY_VERIFY_WITH_TIMEOUT(!asked.empty(), kSoon_ms);
        QCOMPARE(std::get<Want>(asked[0]).contentHash, kSetHash);
        QVERIFY(fetch.status().state == FetchStatus::State::Asking);
    }

    void tellsWhyTheHostRefused_data()
    {
        QTest::addColumn<Reason>("reason");
        QTest::addColumn<Errc>("code");
        QTest::newRow("not named") << Reason::NotNamed << Errc::SetNotNamed;
        QTest::newRow("withdrawn") << Reason::Withdrawn << Errc::SetWithdrawn;
        QTest::newRow("version") << Reason::OtherVersion << Errc::VersionMismatch;
    }
    void tellsWhyTheHostRefused()
    {
        QFETCH(const Reason, reason);
        QFETCH(const Errc, code);
        ScriptedHost host{[&](RawPeer& peer, const Frame&) {
            peer.say(Refusal{reason});
            peer.socket().disconnectFromHost();
        }};
        const auto fetch = fetchFrom(host);
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, code), kSoon_ms);
        QCOMPARE(host.connections, 1);
    }

    void comesAgainToAHostThatIsBusy()
    {
        ScriptedHost host{[&](RawPeer& peer, const Frame&) {
            peer.say(Refusal{host.connections < 3 ? Reason::Busy : Reason::Withdrawn});
        }};
        const auto fetch = fetchFrom(host);
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, Errc::SetWithdrawn), kSoon_ms);
        QCOMPARE(host.connections, 3);
    }

    void setThatIsWithdrawnUnderWayIsGivenUp()
    {
        ScriptedHost host{[&](RawPeer& peer, const Frame& frame) {
            if (std::holds_alternative<Want>(frame))
                return peer.say(Offer{1000, kSomeDigest, {}});
            peer.say(Chunk{bytesOf(QByteArray(100, 'x'))});
            peer.say(Refusal{Reason::Withdrawn});
        }};
        const auto fetch = fetchFrom(host);
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, Errc::SetWithdrawn), kSoon_ms);
        QCOMPARE(fetch.status().received, std::uint64_t{100});
    }

    void refusesALengthBeyondTheLimit_data()
    {
        QTest::addColumn<quint64>("bytes");
        QTest::newRow("nothing") << quint64{0};
        QTest::newRow("a byte too many") << quint64{(256u << 20) + 1};
        QTest::newRow("as many as can be said") << ~quint64{0};
    }
    void refusesALengthBeyondTheLimit()
    {
        QFETCH(const quint64, bytes);
        ScriptedHost host{[&](RawPeer& peer, const Frame&) {
            peer.say(Offer{bytes, kSomeDigest, {}});
        }};
        const auto fetch = fetchFrom(host);
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, Errc::OutOfRange), kSoon_ms);
        QVERIFY(!std::filesystem::exists(m_cache));
    }

    void refusesWhatBreaksTheRules_data()
    {
        QTest::addColumn<int>("rule");
        QTest::newRow("more than was offered") << 0;
        QTest::newRow("bytes that nobody offered") << 1;
        QTest::newRow("offering twice") << 2;
        QTest::newRow("wanting") << 3;
        QTest::newRow("noise") << 4;
    }
    void refusesWhatBreaksTheRules()
    {
        QFETCH(const int, rule);
        ScriptedHost host{[&](RawPeer& peer, const Frame& frame) {
            const Offer offer{10, kSomeDigest, {}};
            const bool wants = std::holds_alternative<Want>(frame);
            if (rule == 0)
                wants ? peer.say(offer) : peer.say(Chunk{bytesOf(QByteArray(11, 'x'))});
            else if (rule == 1)
                peer.say(Chunk{bytesOf(QByteArray(10, 'x'))});
            else if (rule == 2)
                peer.say(offer);
            else if (rule == 3)
                peer.say(Want{kVersion, kSetHash});
            else
                peer.say(std::vector<std::byte>(100, std::byte{0xff}));
        }};
        const auto fetch = fetchFrom(host);
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, Errc::PacketMalformed), kSoon_ms);
        QVERIFY(!CarriedSets{m_cache}.has({kSomeDigest, 10}));
    }

    void keepsNothingThatIsNotAsPromised()
    {
        ScriptedHost host{[&](RawPeer& peer, const Frame& frame) {
            std::holds_alternative<Want>(frame) ? peer.say(Offer{10, kSomeDigest, {}})
                                                : peer.say(Chunk{bytesOf(QByteArray(10, 'x'))});
        }};
        const auto fetch = fetchFrom(host);
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, Errc::FileMalformed), kSoon_ms);
        QCOMPARE(host.connections, 1); // all of it came just now: nothing else is to be hoped for
        QVERIFY(std::filesystem::is_empty(m_cache / "carried"));
    }

    void saysThatNothingCanBeWritten()
    {
        putContent(m_cache, "a file where the folder should be");
        ScriptedHost host{[&](RawPeer& peer, const Frame&) {
            peer.say(Offer{10, kSomeDigest, {}});
        }};
        const auto fetch = fetchFrom(host);
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, Errc::FileUnwritable), kSoon_ms);
    }

    void tellsAHostOfAnotherSessionNothingOfItsKey()
    {
        ScriptedHost host{[](RawPeer&, const Frame&) {}};
        KeyOffer offer = traineesOffer();
        offer.identity.sessionId = std::string(32, '0');
        const SetFetch fetch{doorAt(host.port(), offer), kSetHash, m_cache};
        QTRY_VERIFY_WITH_TIMEOUT(failedWith(fetch, Errc::WrongCode), kSoon_ms);
        QCOMPARE(host.connections, 0);
    }
};

CARINA_TEST(TestSetFetch)

} // namespace carina::set_fetch_test

#include "tst_set_fetch.moc"
