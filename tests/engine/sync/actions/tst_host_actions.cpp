#include "engine/sync/actions/host_actions.h"
#include "tests/support/test_class.h"

namespace carina::host_actions_test
{
namespace
{

using namespace std::chrono_literals;

constexpr LocalTime kStart{1h};
constexpr SessionTime kSession{2h};
constexpr ObjectId kObject{1};
constexpr PeerAddress kOwner = 101;
constexpr PeerAddress kFirst = 102;
constexpr PeerAddress kSecond = 103;

/// A host with an object of the first of three peers, whose action everybody has acknowledged.
HostActions hostOfThree()
{
    HostActions host;
    host.share(kObject, {ParticipantId{1}, 1});
    for (const PeerAddress address : {kOwner, kFirst, kSecond})
        host.join(address, ParticipantId{static_cast<std::uint16_t>(address - 100)}, kStart);
    EventCpo event;
    event.object = kObject;
    event.epoch = 1;
    event.action = 1;
    event.start = kSession;
    host.take(kOwner, event, kSession, kStart);
    for (const PeerAddress address : {kOwner, kFirst, kSecond}) {
        (void)host.takeDue(address, kStart);
        host.acknowledge(address, {kObject, 1, 1});
    }
    return host;
}

} // namespace

class TestHostActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void passesASignOfLifeOnToOneAfterTheOther()
    {
        HostActions host = hostOfThree();
        QCOMPARE(host.nextDue(), LocalTime::max());
        const LocalTime beat = kStart + 100ms;
        host.take(kOwner, EventBeat{kObject, 1, 1}, kSession + 100ms, beat);
        const auto acks = host.takeDue(kOwner, beat);
        QCOMPARE(acks.size(), 1U);
        QVERIFY(std::holds_alternative<EventAck>(acks.front()));

        QCOMPARE(host.takeDue(kFirst, beat).size(), 1U);
        QVERIFY(host.takeDue(kSecond, beat).empty());
        QCOMPARE(host.nextDue(), beat + 2ms);
        const auto turn = host.takeDue(kSecond, beat + 2ms);
        QCOMPARE(turn.size(), 1U);
        QVERIFY(std::holds_alternative<EventBeat>(turn.front()));
    }

    void passesAnActionOnToAllAtOnce()
    {
        HostActions host = hostOfThree();
        EventCpo event;
        event.object = kObject;
        event.epoch = 1;
        event.action = 2;
        event.start = kSession + 1s;
        host.take(kOwner, event, kSession + 1s, kStart + 1s);
        for (const PeerAddress address : {kFirst, kSecond})
            QCOMPARE(host.takeDue(address, kStart + 1s).size(), 1U);
    }

    /// Of the probes and answers that one participant sends another, and not what it sends others.
    void probesOfAPairAreLimited_data()
    {
        QTest::addColumn<bool>("areAnswers");
        QTest::newRow("probes") << false;
        QTest::newRow("answers") << true;
    }
    void probesOfAPairAreLimited()
    {
        QFETCH(const bool, areAnswers);
        HostActions host;
        host.setStrategy({.kind = StrategyKind::AsaAdaptive}, kStart);
        for (const PeerAddress address : {kOwner, kFirst, kSecond})
            host.join(address, ParticipantId{static_cast<std::uint16_t>(address - 100)}, kStart);
        const auto send = [&](std::uint16_t to, LocalTime now) {
            RelayedMessage message{ParticipantId{2}, ParticipantId{to}, DelayProbe{1s}};
            if (areAnswers)
                message.content = DelayAnswer{1s};
            host.take(kFirst, message, {encodeRelayed(message)}, false, now);
            return host.takeDue(static_cast<PeerAddress>(100 + to), now).size();
        };
        std::size_t passed = 0;
        for (int i = 0; i < 10'000; ++i) // 1000 a second
            passed += send(3, kStart + i * 1ms);
        QVERIFY(passed >= std::size_t(10.0 * kFastestProbes));
        QVERIFY(passed <= std::size_t(12.0 * kFastestProbes));
        QCOMPARE(send(1, kStart + 10s), 1U);
        QCOMPARE(send(99, kStart + 10s), 0U); // who is not there
    }
};

CARINA_TEST(TestHostActions)

} // namespace carina::host_actions_test

#include "tst_host_actions.moc"
