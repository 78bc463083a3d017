#include "engine/sync/wire/datagram_codec.h"
#include "tests/engine/sync/wire/datagram_samples.h"
#include "tests/support/test_class.h"

#include <chrono>

namespace carina::leave_later_test
{

using namespace std::chrono_literals;

/// Datagrams that wait for others to leave.
class TestLeaveLater : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavingLaterIsSaidInTheHeaderAlone()
    {
        BundleHeader expected = goldenHeader();
        expected.echo->hold = 1ms;
        auto bytes = encodeHeader(expected);
        bytes.push_back(std::byte{0x0b});
        leaveLater(bytes, 250us);
        const auto datagram = decodeDatagram(bytes);
        QVERIFY(datagram);
        expected.sentAt += 250us;
        expected.echo->hold += 250us;
        QVERIFY(datagram->header == expected);
        QCOMPARE(datagram->records.size(), std::size_t{1});

        // The longest hold there is, and a nanosecond more.
        leaveLater(bytes, kLongestHold - expected.echo->hold);
        QCOMPARE(decodeDatagram(bytes)->header.echo->hold, kLongestHold);
        leaveLater(bytes, 1ns);
        QVERIFY(!decodeDatagram(bytes)->header.echo);
        leaveLater(bytes, 1ns);
        QCOMPARE(decodeDatagram(bytes)->header.sentAt,
                 goldenHeader().sentAt + 250us + kLongestHold - expected.echo->hold + 2ns);
    }

    void onlyADatagramCanLeaveLater()
    {
        auto token = fromHex("43 54 03 02");
        token.resize(60);
        auto older = fromHex(kGoldenHeaderHex);
        older[2] = std::byte{2};
        auto cut = fromHex(kGoldenHeaderHex);
        cut.pop_back();
        for (const auto& bytes : {token, older, cut, std::vector<std::byte>{}}) {
            auto later = bytes;
            leaveLater(later, 1ms);
            QVERIFY(later == bytes);
        }
    }
};

CARINA_TEST(TestLeaveLater)

} // namespace carina::leave_later_test

#include "tst_leave_later.moc"
