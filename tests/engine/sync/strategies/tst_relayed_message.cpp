#include "engine/sync/strategies/relay_host.h"
#include "engine/sync/strategies/relayed_message.h"
#include "tests/engine/sync/wire/datagram_samples.h"
#include "tests/support/test_class.h"

namespace carina::relayed_message_test
{

class TestRelayedMessage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void laysOutItsBytes()
    {
        const std::vector<std::byte> probe = encodeRelayed(
            {ParticipantId{0x0102}, ParticipantId{0x0304}, DelayProbe{Duration{0x05060708}}});
        QCOMPARE(probe, fromHex("02 01  04 03  01  08 07 06 05 00 00 00 00"));
        const std::vector<std::byte> answer =
            encodeRelayed({ParticipantId{1}, kAllOthers, DelayAnswer{Duration{-1}}});
        QCOMPARE(answer, fromHex("01 00  ff ff  02  ff ff ff ff ff ff ff ff"));
    }

    void readsWhatItWrote()
    {
        const auto message =
            decodeRelayed(encodeRelayed({ParticipantId{1}, ParticipantId{2}, goldenEvent()}));
        QVERIFY(message);
        QCOMPARE(message->from, ParticipantId{1});
        QCOMPARE(message->to, ParticipantId{2});
        QCOMPARE(std::get<EventCpo>(message->content).action, goldenEvent().action);
        const auto answer = decodeRelayed(
            encodeRelayed({ParticipantId{1}, ParticipantId{2}, DelayAnswer{Duration{7}}}));
        QCOMPARE(std::get<DelayAnswer>(answer->content).sentAt, Duration{7});
    }

    void refusesWhatIsNoMessage_data()
    {
        QTest::addColumn<QByteArray>("hex");
        QTest::newRow("nothing") << QByteArray{""};
        QTest::newRow("cut short") << QByteArray{"01 00 02 00 01 08 07 06 05 00 00 00"};
        QTest::newRow("followed by a byte")
            << QByteArray{"01 00 02 00 01 08 07 06 05 00 00 00 00 00"};
        QTest::newRow("unknown kind") << QByteArray{"01 00 02 00 03 08 07 06 05 00 00 00 00"};
        QTest::newRow("time out of range") << QByteArray{"01 00 02 00 01 00 00 00 00 00 00 00 7f"};
    }
    void refusesWhatIsNoMessage()
    {
        QFETCH(QByteArray, hex);
        const auto message = decodeRelayed(fromHex(hex.constData()));
        QVERIFY(!message);
        QCOMPARE(message.error().code, Errc::PacketMalformed);
    }

    void hostPassesOnToWhomItIsFor()
    {
        RelayHost host{{ParticipantId{1}, ParticipantId{2}, ParticipantId{3}, ParticipantId{4}}};
        const auto destinations = [&](ParticipantId from, ParticipantId to, ParticipantId link) {
            const auto bytes = encodeRelayed({from, to, DelayProbe{}});
            host.receive(link, bytes, LocalTime{});
            std::vector<int> ids;
            for (const StarDatagram& datagram : host.take()) {
                ids.push_back(datagram.to.value);
                if (datagram.bytes != bytes)
                    ids.push_back(-1);
            }
            return ids;
        };
        QCOMPARE(destinations({2}, {4}, {2}), (std::vector<int>{4}));
        QCOMPARE(destinations({2}, kAllOthers, {2}), (std::vector<int>{1, 3, 4}));
        QCOMPARE(destinations({2}, {2}, {2}), (std::vector<int>{}));
        QCOMPARE(destinations({2}, {5}, {2}), (std::vector<int>{}));
        // Somebody who writes in another's name.
        QCOMPARE(destinations({2}, {4}, {3}), (std::vector<int>{}));
    }
};

CARINA_TEST(TestRelayedMessage)

} // namespace carina::relayed_message_test

#include "tst_relayed_message.moc"
