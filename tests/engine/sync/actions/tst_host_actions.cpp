#include "engine/sync/actions/client_actions.h"
#include "engine/sync/actions/host_actions.h"
#include "tests/support/test_class.h"

#include <algorithm>

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

EventCpo actionOf(std::uint16_t epoch, std::uint32_t number)
{
    EventCpo event;
    event.object = kObject;
    event.epoch = epoch;
    event.action = number;
    event.start = kSession;
    return event;
}

/// A host with an object of the first of three peers, whose action everybody has acknowledged.
HostActions hostOfThree()
{
    HostActions host;
    host.share(kObject, {ParticipantId{1}, 1});
    for (const PeerAddress address : {kOwner, kFirst, kSecond})
        host.join(address, ParticipantId{static_cast<std::uint16_t>(address - 100)}, kStart);
    host.take(kOwner, actionOf(1, 1), kSession, kStart);
    for (const PeerAddress address : {kOwner, kFirst, kSecond}) {
        (void)host.takeDue(address, kStart);
        host.acknowledge(address, {kObject, 1, 1});
    }
    return host;
}

/// A host whose session interpolates, with eight objects of the first of two peers.
struct Relayed {
    static constexpr std::uint16_t kObjects = 8;

    HostActions host;

    Relayed()
    {
        host.setStrategy({.kind = StrategyKind::Interpolation}, kStart);
        for (std::uint16_t object = 1; object <= kObjects; ++object)
            host.share(ObjectId{object}, {ParticipantId{1}, 1});
        for (const PeerAddress address : {kOwner, kFirst})
            host.join(address, ParticipantId{static_cast<std::uint16_t>(address - 100)}, kStart);
    }
    void send(std::uint16_t object, std::uint32_t number, LocalTime now)
    {
        EventCpo event = actionOf(1, number);
        event.object = ObjectId{object};
        const RelayedMessage message{ParticipantId{1}, kAllOthers, event};
        host.take(kOwner, message, {StrategyKind::Interpolation, encodeRelayed(message)}, true,
                  now);
    }
    /// How many messages go to the other peer now.
    std::size_t heard(LocalTime now)
    {
        host.advance(kSession, now);
        const auto records = host.takeDue(kFirst, now);
        const auto isMessage = [](const WireRecord& record) {
            return std::holds_alternative<StrategyMessage>(record);
        };
        return static_cast<std::size_t>(std::ranges::count_if(records, isMessage));
    }
};

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
        EventCpo event = actionOf(1, 2);
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
            host.take(kFirst, message, {StrategyKind::AsaAdaptive, encodeRelayed(message)}, false,
                      now);
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

    /// A thousand in a second went to each of the others at once.
    void rapidMessagesGoOnTogether()
    {
        HostActions host;
        host.setStrategy({.kind = StrategyKind::None}, kStart);
        host.share(kObject, {ParticipantId{1}, 1});
        for (const PeerAddress address : {kOwner, kFirst, kSecond})
            host.join(address, ParticipantId{static_cast<std::uint16_t>(address - 100)}, kStart);
        std::size_t passed = 0;
        std::uint32_t newest = 0;
        const auto hear = [&](LocalTime now) {
            host.advance(kSession, now);
            (void)host.takeDue(kSecond, now);
            for (const WireRecord& record : host.takeDue(kFirst, now))
                if (const auto* message = std::get_if<StrategyMessage>(&record)) {
                    ++passed;
                    newest = std::get<EventCpo>(decodeRelayed(message->bytes)->content).action;
                }
        };
        constexpr std::uint32_t kActions = 5000;
        for (std::uint32_t i = 1; i <= kActions; ++i) {
            const LocalTime now = kStart + i * 1ms;
            const RelayedMessage message{ParticipantId{1}, kAllOthers, actionOf(1, i)};
            host.take(kOwner, message, {StrategyKind::None, encodeRelayed(message)}, true, now);
            hear(now);
        }
        // The burst, those at once and those together, in 5 s.
        const double together = 5.0 / toSeconds(HostActions::kTogether);
        QVERIFY2(double(passed) <= 7.0 * HostActions::kAtOnce + together + 2.0,
                 qPrintable(QString::number(passed)));
        QVERIFY(double(passed) >= together);
        const LocalTime due = host.nextDue();
        QVERIFY(due <= kStart + kActions * 1ms + HostActions::kTogether);
        hear(due);
        QCOMPARE(newest, kActions); // the newest is not lost
    }

    /// As in virtual time: sixty times a second all objects of a participant, in one datagram.
    void snapshotsOfSeveralObjectsDoNotWait()
    {
        Relayed relayed;
        for (std::uint32_t tick = 1; tick <= 600; ++tick) {
            const LocalTime now = kStart + tick * 16'667us;
            for (std::uint16_t object = 1; object <= Relayed::kObjects; ++object)
                relayed.send(object, tick, now);
            QCOMPARE(relayed.heard(now), std::size_t{Relayed::kObjects});
        }
    }

    /// One object after the other, or one again and again at the same time, does not count as one.
    void onlyWhatComesTogetherCountsAsOne_data()
    {
        QTest::addColumn<int>("atATime");
        QTest::addColumn<bool>("isOneObject");
        QTest::newRow("one after the other") << 1 << false;
        QTest::newRow("one again and again") << 8 << true;
    }
    void onlyWhatComesTogetherCountsAsOne()
    {
        QFETCH(const int, atATime);
        QFETCH(const bool, isOneObject);
        Relayed relayed;
        double moments = 0.0;
        double messages = 0.0;
        std::uint32_t number = 0;
        for (LocalTime now = kStart + 1ms; now <= kStart + 5s; now += 1ms) {
            for (int i = 0; i < atATime; ++i, ++number)
                relayed.send(
                    isOneObject ? 1 : static_cast<std::uint16_t>(1 + number % Relayed::kObjects),
                    number, now);
            const std::size_t heard = relayed.heard(now);
            moments += heard > 0 ? 1.0 : 0.0;
            messages += static_cast<double>(heard);
        }
        // The burst and those at once, and those together, in 5 s.
        const double together = 5.0 / toSeconds(HostActions::kTogether) + 2.0;
        QVERIFY2(moments <= 7.0 * HostActions::kAtOnce + together,
                 qPrintable(QString::number(moments)));
        const double objects = isOneObject ? 1.0 : double{Relayed::kObjects};
        QVERIFY2(messages <= 7.0 * HostActions::kAtOnce + objects * together,
                 qPrintable(QString::number(messages)));
    }

    /// Nobody has it any more: the action is neither shown, nor sent, nor stored.
    void endsTheActionOnWhatIsPutBack()
    {
        HostActions host = hostOfThree();
        (void)host.takeChanged();
        const EventCpo event = actionOf(1, 2);
        host.take(kOwner, event, kSession, kStart);
        host.share(kObject, {kNobody, 2, std::uint16_t{2}});
        QVERIFY(!host.shared().shown(kObject, kSession, kStart, kStart));
        (void)host.takeDue(kOwner, kStart); // the acknowledgement
        for (const PeerAddress address : {kOwner, kFirst, kSecond})
            QVERIFY(host.takeDue(address, kStart + 1s).empty());
        QVERIFY(host.takeChanged().empty());
        // Not even by a heartbeat or a repeat of who had it.
        host.take(kOwner, event, kSession, kStart);
        host.take(kOwner, EventBeat{kObject, 1, 2}, kSession, kStart);
        QVERIFY(!host.shared().shown(kObject, kSession, kStart, kStart));
    }

    /// What was stored before it was put back is not what the next one lifts.
    void restoresNoActionFromBeforeItWasPutBack()
    {
        HostActions host;
        host.share(kObject, {ParticipantId{2}, 3, std::uint16_t{2}});
        host.restore(actionOf(1, 7));
        host.advance(kSession, kStart);
        QVERIFY(!host.shared().shown(kObject, kSession, kStart, kStart));
        // One from since then goes on for who has it now.
        host.share(kObject, {ParticipantId{1}, 4, std::uint16_t{2}});
        host.restore(actionOf(3, 7));
        host.advance(kSession, kStart);
        QVERIFY(host.shared().shown(kObject, kSession, kStart, kStart));
    }

    /// A client may know an action before it knows that the object was put back and lifted again.
    void aClientKeepsTheActionOfWhoLiftedItNext()
    {
        ClientActions client;
        client.setSelf(ParticipantId{5});
        client.share(kObject, {ParticipantId{1}, 1, std::uint16_t{0}});
        client.take(actionOf(1, 1), kSession, kStart);
        client.take(actionOf(3, 1), kSession, kStart);
        client.share(kObject, {kNobody, 2, std::uint16_t{2}});
        QCOMPARE(client.shared().table().newest(kObject)->epoch, std::uint16_t{3});
        client.share(kObject, {ParticipantId{2}, 3, std::uint16_t{2}});
        QCOMPARE(client.shared().table().newest(kObject)->epoch, std::uint16_t{3});
        // And takes none that comes late.
        client.share(kObject, {kNobody, 4, std::uint16_t{4}});
        client.take(actionOf(3, 2), kSession, kStart);
        QVERIFY(!client.shared().table().newest(kObject));
    }

    void whoLiftsItAgainBeginsInItsPlace()
    {
        ClientActions client;
        client.setSelf(ParticipantId{1});
        client.share(kObject, {ParticipantId{1}, 1, std::uint16_t{0}});
        const ActedPose away{RigidTransform::translation(Vec3::UnitX()), 2.0};
        QVERIFY(client.act(kObject, {.from = away, .anew = true}, kSession, kStart));
        client.share(kObject, {kNobody, 2, std::uint16_t{2}});
        QVERIFY(!client.act(kObject, {}, kSession, kStart)); // it is nobody's
        client.share(kObject, {ParticipantId{1}, 3, std::uint16_t{2}});
        QVERIFY(client.act(kObject, {}, kSession, kStart));
        const auto shown = client.shared().shown(kObject, kSession, kStart, kStart);
        QVERIFY(shown->acted.X_AO.translation().isZero());
        QCOMPARE(shown->acted.scale, 1.0);
    }
};

CARINA_TEST(TestHostActions)

} // namespace carina::host_actions_test

#include "tst_host_actions.moc"
