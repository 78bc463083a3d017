#include "engine/net/secure/dtls_record.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <vector>

namespace carina::dtls_record_test
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

/// RFC 6347, 4.1: type, version, epoch, sequence number, length, fragment.
Bytes record(std::uint8_t type, std::uint16_t epoch, const Bytes& fragment)
{
    Bytes bytes(13 + fragment.size());
    bytes[0] = type;
    bytes[1] = 0xFE;
    bytes[2] = 0xFD;
    bytes[3] = std::uint8_t(epoch >> 8);
    bytes[4] = std::uint8_t(epoch & 0xFF);
    bytes[11] = std::uint8_t(fragment.size() >> 8);
    bytes[12] = std::uint8_t(fragment.size() & 0xFF);
    std::ranges::copy(fragment, bytes.begin() + 13);
    return bytes;
}

Bytes operator+(Bytes a, const Bytes& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

const Bytes kHello{1, 0, 0};

} // namespace

class TestDtlsRecord : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void headersAreRead()
    {
        const Bytes bytes = record(23, 0x0102, Bytes(300)) + record(21, 1, {1, 0});
        const auto first = firstRecord(bytes);
        QVERIFY(first);
        QCOMPARE(first->type, DtlsRecord::Type::ApplicationData);
        QCOMPARE(int{first->epoch}, 0x0102);
        QCOMPARE(first->size, std::size_t{313});
    }

    void otherBytesAreNoRecord()
    {
        const Bytes good = record(22, 0, kHello);
        QVERIFY(firstRecord(good));
        QVERIFY(!firstRecord({}));
        QVERIFY(!firstRecord(record(22, 0, {})));
        QVERIFY(!firstRecord(Bytes(good.begin(), good.end() - 1)));
        for (const std::uint8_t type : {std::uint8_t{19}, std::uint8_t{24}}) {
            Bytes bad = good;
            bad[0] = type;
            QVERIFY(!firstRecord(bad));
        }
        for (const std::size_t i : {1U, 2U}) {
            Bytes bad = good;
            bad[i] = 3; // TLS over TCP
            QVERIFY(!firstRecord(bad));
        }
        Bytes oldest = good;
        oldest[2] = 0xFF; // DTLS 1.0, in which a first hello comes
        QVERIFY(firstRecord(oldest));
    }

    void helloIsToldFromTheRest()
    {
        QVERIFY(isClientHello(record(22, 0, kHello)));
        QVERIFY(!isClientHello(record(22, 1, kHello))); // encrypted
        QVERIFY(!isClientHello(record(22, 0, {2, 0}))); // the host's
        QVERIFY(!isClientHello(record(23, 0, kHello)));
    }

    /// RFC 6347, 4.2.1: version, random, session id, cookie; the last two with their lengths.
    void cookieIsFoundBehindTheSessionId()
    {
        const Bytes before = Bytes{1} + Bytes(11) + Bytes(34);
        for (const std::uint8_t length : {std::uint8_t{0}, std::uint8_t{32}}) {
            const Bytes hello = before + Bytes{length} + Bytes(length, 7);
            QVERIFY(holdsCookie(record(22, 0, hello + Bytes{1, 99})));
            QVERIFY(!holdsCookie(record(22, 0, hello + Bytes{0, 99})));
            QVERIFY(!holdsCookie(record(22, 0, hello))); // cut off
        }
        QVERIFY(!holdsCookie(record(22, 0, before)));
        QVERIFY(!holdsCookie(record(22, 0, before + Bytes{255, 1})));
    }

    void finishedIsFoundBehindOtherRecords()
    {
        const Bytes keyExchange = record(22, 0, {16, 0});
        const Bytes change = record(20, 0, {1});
        const Bytes finished = record(22, 1, Bytes(40));
        QVERIFY(holdsFinished(keyExchange + change + finished));
        QVERIFY(holdsFinished(finished));
        QVERIFY(!holdsFinished(keyExchange + change));
        QVERIFY(!holdsFinished(record(23, 1, Bytes(40))));
    }

    void alertIsARecordInTheClear()
    {
        const auto alert = firstRecord(wrongKeyAlert());
        QVERIFY(alert);
        QCOMPARE(alert->type, DtlsRecord::Type::Alert);
        QCOMPARE(int{alert->epoch}, 0);
        QVERIFY(isWrongKeyAlert(wrongKeyAlert()));
        QVERIFY(!isWrongKeyAlert(record(21, 0, {2, 51})));
    }

    void alertOfAHostThatSpeaksNoneOfTheCiphersIsKnown()
    {
        // As OpenSSL 3.0 sends it: handshake_failure(40) of RFC 5246, 7.2.
        QVERIFY(isNoCipherAlert(record(21, 0, {2, 40})));
        QVERIFY(!isNoCipherAlert(record(21, 0, {1, 40})));
        QVERIFY(!isNoCipherAlert(record(21, 0, {2, 41})));
        QVERIFY(!isNoCipherAlert(record(21, 1, {2, 40})));
        QVERIFY(!isNoCipherAlert(record(22, 0, {2, 40})));
        QVERIFY(!isNoCipherAlert(record(21, 0, {2, 40, 0})));
        QVERIFY(!isNoCipherAlert(record(21, 0, {2})));
        QVERIFY(!isNoCipherAlert({}));
    }
};

CARINA_TEST(TestDtlsRecord)

} // namespace carina::dtls_record_test

#include "tst_dtls_record.moc"
