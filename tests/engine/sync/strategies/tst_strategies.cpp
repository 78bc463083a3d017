#include "engine/sync/strategies/probe_trigger.h"
#include "engine/sync/strategies/relayed_message.h"
#include "tests/engine/sync/strategies/strategy_star.h"
#include "tests/support/test_class.h"

namespace carina::strategies_test
{
namespace
{

using namespace std::chrono_literals;
using test::quarterTurns;
using test::StrategyStar;
using test::turnedAboutZ_deg;

constexpr ObjectId kObject{1};
/// The rate and the turn pass through single precision.
constexpr double kTolerance_deg = 1e-4;
constexpr double kDegreesPerSecond = 90.0;

} // namespace

/// What each strategy draws over links of constant delay, where mathematics says what it must be.
class TestStrategies : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areFoundByName()
    {
        QCOMPARE(syncStrategies().size(), 8U);
        QCOMPARE(QByteArray(syncStrategies().front().name.data()), QByteArray("session-clock"));
        for (const SyncStrategy& strategy : syncStrategies()) {
            QVERIFY(findSyncStrategy(strategy.name) != nullptr);
            QCOMPARE(findSyncStrategy(strategy.name)->meaning, strategy.meaning);
            QVERIFY(!strategy.meaning.empty());
        }
        QVERIFY(findSyncStrategy("event ") == nullptr);
        QVERIFY(findSyncStrategy("") == nullptr);
    }

    void lagAsTheirMeaningSays_data()
    {
        QTest::addColumn<QByteArray>("strategy");
        QTest::addColumn<double>("lag_s");
        QTest::addColumn<double>("tolerance_deg");
        // 10 ms to the host and 10 ms from it.
        QTest::newRow("none") << QByteArray{"none"} << 0.020 << kTolerance_deg;
        QTest::newRow("event") << QByteArray{"event"} << 0.020 << kTolerance_deg;
        QTest::newRow("interpolation")
            << QByteArray{"interpolation"} << 0.020 + 1.0 / 60.0 << kTolerance_deg;
        QTest::newRow("dead reckoning") << QByteArray{"dead-reckoning"} << 0.020 << kTolerance_deg;
        QTest::newRow("ASA, fixed") << QByteArray{"asa-fixed"} << 0.0 << kTolerance_deg;
        QTest::newRow("ASA, adaptive") << QByteArray{"asa-adaptive"} << 0.0 << kTolerance_deg;
        QTest::newRow("session clock") << QByteArray{"session-clock"} << 0.0 << kTolerance_deg;
    }
    void lagAsTheirMeaningSays()
    {
        QFETCH(QByteArray, strategy);
        QFETCH(double, lag_s);
        QFETCH(double, tolerance_deg);
        StrategyStar star{strategy.constData(), 3, {}};
        star.runTo(5s);
        star.act(1, quarterTurns());
        star.runTo(6s);
        QVERIFY(std::abs(turnedAboutZ_deg(star.shown(1, kObject)) - 90.0) < kTolerance_deg);
        for (std::uint16_t viewer = 2; viewer <= 3; ++viewer) {
            const double drawn = turnedAboutZ_deg(star.shown(viewer, kObject));
            QVERIFY2(std::abs(drawn - (90.0 - kDegreesPerSecond * lag_s)) < tolerance_deg,
                     qPrintable(QString::number(drawn)));
        }
        QVERIFY(!star.shown(2, ObjectId{2}));
    }

    void clockOffsetsDoNotMatter_data()
    {
        QTest::addColumn<QByteArray>("strategy");
        for (const SyncStrategy& strategy : syncStrategies())
            QTest::newRow(strategy.name.data()) << QByteArray{strategy.name.data()};
    }
    void clockOffsetsDoNotMatter()
    {
        QFETCH(QByteArray, strategy);
        const auto drawn = [&](Duration actor, Duration viewer) {
            StrategyStar star{strategy.constData(), 2, {}};
            star.setOffset(1, actor);
            star.setOffset(2, viewer);
            star.runTo(5s);
            star.act(1, quarterTurns());
            star.runTo(6s);
            return turnedAboutZ_deg(star.shown(2, kObject));
        };
        QVERIFY(std::abs(drawn(100s, 350h) - drawn(0s, 0s)) < kTolerance_deg);
    }

    void lopsidedPathCostsHalfItsDifference_data()
    {
        QTest::addColumn<QByteArray>("strategy");
        QTest::newRow("ASA") << QByteArray{"asa-fixed"};
        QTest::newRow("session clock") << QByteArray{"session-clock"};
    }
    void lopsidedPathCostsHalfItsDifference()
    {
        // 30 ms from actor to viewer, 70 ms back: the delay is taken for 50 ms.
        QFETCH(QByteArray, strategy);
        StrategyStar star{strategy.constData(), 2, {}};
        star.setLegs(1, {.toHost = 15ms, .fromHost = 35ms});
        star.setLegs(2, {.toHost = 35ms, .fromHost = 15ms});
        star.runTo(5s);
        star.act(1, quarterTurns());
        star.runTo(6s);
        const double drawn = turnedAboutZ_deg(star.shown(2, kObject));
        QVERIFY2(std::abs(drawn - (90.0 + kDegreesPerSecond * 0.020)) < 1e-3,
                 qPrintable(QString::number(drawn)));
    }

    /// Half the trip of each, a thousand years, would be the mean of a history.
    void answersThatNobodyAskedForChangeNothing()
    {
        StrategyStar star{"asa-adaptive", 2, {}};
        star.runTo(5s);
        for (int i = 0; i < 100; ++i) {
            for (const Duration sentAt :
                 {Duration{-(std::int64_t{1} << 60)}, Duration{}, Duration{4999ms}})
                star.participant(2).receive(
                    ParticipantId{},
                    encodeRelayed({ParticipantId{1}, ParticipantId{2}, DelayAnswer{sentAt}}),
                    LocalTime{5s});
        }
        star.act(1, quarterTurns());
        star.runTo(6s);
        QVERIFY(std::abs(turnedAboutZ_deg(star.shown(2, kObject)) - 90.0) < kTolerance_deg);
        QCOMPARE(star.participant(2).nextWake() - LocalTime{6s} <= 1s, true);
    }

    void withoutSynchronisationALossStays()
    {
        StrategyStar star{"none", 2, {}};
        star.act(1, quarterTurns(1));
        star.runTo(1s);
        star.loseIf([](const auto& departure) { return departure.at == 1s; });
        EventCpo turnBack = quarterTurns(2);
        turnBack.rate = -turnBack.rate;
        star.act(1, turnBack);
        star.runTo(2s);
        EventCpo rest = quarterTurns(3);
        rest.rate = 0.0F;
        rest.q_AO = Quat::Identity();
        star.act(1, rest);
        star.runTo(3s);
        // 2 s forth instead of 1 s forth and 1 s back.
        QVERIFY(std::abs(std::abs(turnedAboutZ_deg(star.shown(2, kObject))) - 180.0)
                < kTolerance_deg);
    }

    void eventRepairsALossWithTheNext()
    {
        StrategyStar star{"event", 2, {}};
        star.act(1, quarterTurns(1));
        star.runTo(1s);
        star.loseIf([](const auto& departure) { return departure.at == 1s; });
        EventCpo lost = quarterTurns(2);
        lost.q_AO = Quat{0.0, 1.0, 0.0, 0.0};
        star.act(1, lost);
        star.runTo(2s);
        EventCpo rest = quarterTurns(3);
        rest.rate = 0.0F;
        star.act(1, rest);
        star.runTo(3s);
        QCOMPARE(turnedAboutZ_deg(star.shown(2, kObject)), 0.0);
    }

    void deadReckoningSendsNothingWhileItsModelHolds()
    {
        StrategyStar star{"dead-reckoning", 2, {}};
        star.act(1, quarterTurns());
        star.runTo(4900ms);
        QCOMPARE(star.sent(1, 0), 1U);
        star.runTo(5100ms);
        QCOMPARE(star.sent(1, 0), 2U); // the heartbeat of 5 s
    }

    void deadReckoningSendsBeyondItsThreshold_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("rate");
        QTest::addColumn<int>("sent");
        constexpr double kDegree = std::numbers::pi / 180.0;
        // From rest for a second: the model at rest is off by all that has happened.
        QTest::newRow("2.9 degrees") << 0 << 2.9 * kDegree << 0;
        QTest::newRow("3.2 degrees") << 0 << 3.2 * kDegree << 1;
        QTest::newRow("0.97 m") << 1 << 0.97 << 0;
        QTest::newRow("1.05 m") << 1 << 1.05 << 1;
        QTest::newRow("grown by 9 %") << 2 << std::log(1.09) << 0;
        QTest::newRow("grown by 11 %") << 2 << std::log(1.115) << 1;
    }
    void deadReckoningSendsBeyondItsThreshold()
    {
        QFETCH(int, kind);
        QFETCH(double, rate);
        QFETCH(int, sent);
        StrategyStar star{"dead-reckoning", 2, {}};
        EventCpo action = quarterTurns(1);
        action.kind = static_cast<ActionKind>(kind);
        action.rate = 0.0F;
        star.act(1, action);
        star.runTo(1s);
        star.forgetDepartures();
        action.action = 2;
        action.rate = static_cast<float>(rate);
        star.act(1, action);
        star.runTo(2s);
        QCOMPARE(star.sent(1, 0), static_cast<std::size_t>(sent));
    }

    void interpolationSends60SnapshotsASecond()
    {
        StrategyStar star{"interpolation", 3, {}};
        star.act(1, quarterTurns());
        star.runTo(10s);
        QCOMPARE(star.sent(1, 0), 599U);
        QCOMPARE(star.sent(2, 0), 0U);
    }

    void asaProbesEveryOtherParticipantOnceASecond()
    {
        StrategyStar star{"asa-fixed", 4, {}};
        star.runTo(10s);
        for (std::uint16_t id = 1; id <= 4; ++id)
            QCOMPARE(star.participant(id).probesSent(), 30U);
        // A probe and its answer take four legs.
        star.forgetDepartures();
        star.runTo(20s);
        QCOMPARE(star.departures().size(), 4U * 30U * 4U);
    }

    /// One delay of two legs of 10 ms for each probe; the others have none to show.
    void asaShowsTheDelaysThatItGoesBy()
    {
        StrategyStar star{"asa-fixed", 2, {}};
        star.runTo(4500ms);
        const ProbeTrigger* trigger = star.participant(1).triggerTo(ParticipantId{2});
        QVERIFY(trigger);
        QCOMPARE(trigger->history().size(), std::size_t{4});
        QCOMPARE(trigger->history().mean(), Duration{20ms});
        QCOMPARE(trigger->rate(), 1.0);
        QVERIFY(!star.participant(1).triggerTo(ParticipantId{3}));
        StrategyStar events{"event", 2, {}};
        QVERIFY(!events.participant(1).triggerTo(ParticipantId{2}));
    }

    void asaUsesTheNewestRoundTrip()
    {
        // The path gets 10 ms longer each way; the next probe knows.
        StrategyStar star{"asa-fixed", 2, {}};
        star.runTo(5s);
        star.setLegs(1, {.toHost = 20ms, .fromHost = 20ms});
        star.runTo(5100ms);
        star.act(1, quarterTurns(1));
        star.runTo(5200ms);
        QVERIFY(
            std::abs(turnedAboutZ_deg(star.shown(2, kObject)) - kDegreesPerSecond * (0.100 - 0.010))
            < kTolerance_deg);
        star.runTo(7s);
        star.act(1, quarterTurns(2));
        star.runTo(7100ms);
        QVERIFY(std::abs(turnedAboutZ_deg(star.shown(2, kObject)) - kDegreesPerSecond * 0.100)
                < kTolerance_deg);
    }
};

CARINA_TEST(TestStrategies)

} // namespace carina::strategies_test

#include "tst_strategies.moc"
