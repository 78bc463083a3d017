#include "engine/net/entry/session_identity.h"
#include "engine/net/node/host_clock.h"
#include "tests/support/test_class.h"

namespace carina::host_clock_test
{
namespace
{

using namespace std::chrono_literals;

constexpr LocalTime kNow{500s};
const ClockAnchor kAnchor{"boot one", 7000s};
constexpr SessionTime kLast{7400s};

} // namespace

class TestHostClock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void newSessionsBeginAtAnArbitraryTime()
    {
        constexpr std::uint64_t kUnit = std::uint64_t{1} << 50; // ns: 13 days
        const auto start = [](std::uint64_t random) {
            const Duration offset =
                sessionClockOffset(std::nullopt, "boot one", std::nullopt, kNow, random);
            return (kNow.time_since_epoch() + offset).count();
        };
        QCOMPARE(start(0), static_cast<std::int64_t>(kUnit));
        QCOMPARE(start(12345), static_cast<std::int64_t>(kUnit + 12345));
        QCOMPARE(start(kUnit - 1), static_cast<std::int64_t>(2 * kUnit - 1));
        QCOMPARE(start(kUnit), static_cast<std::int64_t>(kUnit));
    }

    void crashOfTheHostDoesNotTouchTheClock()
    {
        QCOMPARE(sessionClockOffset(kAnchor, "boot one", kLast, kNow, 1), kAnchor.offset);
    }

    void rebootGoesOnFromTheLastFact()
    {
        const Duration offset = sessionClockOffset(kAnchor, "boot two", kLast, kNow, 1);
        QCOMPARE(SessionTime{kNow.time_since_epoch() + offset}, kLast);
    }

    void anchorThatContradictsTheLogIsNotBelieved_data()
    {
        QTest::addColumn<qint64>("offset_ns");
        QTest::addColumn<bool>("believed");
        const auto row = [](const char* name, Duration offset, bool believed) {
            QTest::newRow(name) << qint64{offset.count()} << believed;
        };
        const Duration last = kLast.time_since_epoch();
        const Duration running = kNow.time_since_epoch();
        row("at the last fact", last - running, true);
        row("since the machine started", last, true);
        row("a day before the machine started", last + 24h, true);
        row("before the last fact", last - running - 1ns, false);
        row("for longer than that", last + 24h + 1ns, false);
        row("largest number", Duration::max(), false);
        row("smallest number", Duration::min(), false);
    }
    void anchorThatContradictsTheLogIsNotBelieved()
    {
        QFETCH(const qint64, offset_ns);
        QFETCH(const bool, believed);
        const ClockAnchor anchor{"boot one", Duration{offset_ns}};
        QCOMPARE(contradictsLog(anchor, "boot one", kLast, kNow), !believed);
        const Duration offset = sessionClockOffset(anchor, "boot one", kLast, kNow, 1);
        QCOMPARE(offset,
                 believed ? anchor.offset : kLast.time_since_epoch() - kNow.time_since_epoch());
        QVERIFY(!contradictsLog(anchor, "boot two", kLast, kNow)); // nor needed
    }

    void unknownBootGoesOnFromTheLastFact()
    {
        const ClockAnchor nameless{"", 7000s};
        for (const auto& anchor : {std::optional<ClockAnchor>{}, std::optional{nameless}}) {
            const Duration offset = sessionClockOffset(anchor, "", kLast, kNow, 1);
            QCOMPARE(SessionTime{kNow.time_since_epoch() + offset}, kLast);
        }
    }

    void machineNamesItsBoot()
    {
        QCOMPARE(readBootId().size(), std::size_t{36}); // a UUID
        QCOMPARE(readBootId(), readBootId());
    }

    void sessionIdsTravelAsTheirBits()
    {
        const SessionKey key = sessionKey("000102030405060708090a0b0c0d0eff");
        QCOMPARE(key[0], std::byte{0x00});
        QCOMPARE(key[14], std::byte{0x0E});
        QCOMPARE(key[15], std::byte{0xFF});
        QVERIFY(sessionKey("00ff") != SessionKey{});
        QVERIFY(sessionKey("") == SessionKey{});
        // Longer than a key: cut.
        QVERIFY(sessionKey("000102030405060708090a0b0c0d0effAABB") == key);
        const std::string id = newSessionId();
        QCOMPARE(id.size(), std::size_t{32});
        QVERIFY(id != newSessionId());
        QVERIFY(sessionKey(id) != SessionKey{});
    }
};

CARINA_TEST(TestHostClock)

} // namespace carina::host_clock_test

#include "tst_host_clock.moc"
