#include "engine/sync/strategies/relayed_message.h"
#include "engine/sync/wire/datagram_codec.h"
#include "tests/engine/sync/actions/acted_world.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::session_strategies_test
{
namespace
{

/// 20 ms from one site to another, through the host.
const SimulatedLink::Path kPath{10ms, 0ms, 0.0, 0.0};
constexpr double kDelay_s = 0.020;
constexpr double kTolerance_deg = 0.2; // of virtual time in steps of a millisecond

double turned_deg(const std::optional<ShownObject>& shown)
{
    const Quat q = shown->acted.X_AO.rotation();
    return 2.0 * std::atan2(q.z(), q.w()) * 180.0 / 3.14159265358979323846;
}

/// Three sites whose session has this strategy, the object at rest.
struct StrategyWorld : ActedWorld {
    explicit StrategyWorld(StrategyKind kind) : ActedWorld{3, 3, kPath}
    {
        choose({.kind = kind});
        for (std::size_t i = 0; i < 3; ++i)
            setOthers(i);
        static_cast<void>(act(0, {ActionKind::Rotation, Vec3::UnitZ(), 0.0, {}}));
        run(3s);
    }
    StrategyKind strategy = StrategyKind::SessionClock;

    void choose(const StrategyChoice& choice)
    {
        strategy = choice.kind;
        host().setStrategy(choice, hostTime());
        for (std::size_t i = 0; i < 3; ++i)
            site(i).client->setStrategy(choice, local(i));
    }
    void setOthers(std::size_t i)
    {
        std::vector<ParticipantId> others{ParticipantId{0}};
        for (std::size_t other = 0; other < 3; ++other)
            if (other != i)
                others.push_back(self(other));
        site(i).client->setOthers(std::move(others), local(i));
    }
    /// A message that the program at a site would not send.
    void sendFrom(std::size_t i, const RelayedMessage& message)
    {
        BundleHeader header;
        header.connection = site(i).client->link().connection();
        header.sequence = 1U << 20;
        header.sender = self(i);
        const WireRecord record{StrategyMessage{strategy, encodeRelayed(message)}};
        for (const auto& bytes : packDatagrams(std::span{&record, 1}, [&] { return header; }))
            host().receive(site(i).address, bytes, hostTime());
    }
    /// How far a viewer's picture is behind the owner's.
    double behind_deg(std::size_t viewer)
    {
        return turned_deg(shown(0)) - turned_deg(shown(viewer));
    }
    std::optional<ShownObject> shownByHost()
    {
        return host().actions().shown(kModel, trueSessionTime(), hostTime(), hostTime());
    }
};

} // namespace

/// The strategies within a whole session, of which the host is a participant.
class TestSessionStrategies : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void decideWhatIsShown_data()
    {
        QTest::addColumn<StrategyKind>("kind");
        QTest::addColumn<double>("lag_s");
        QTest::newRow("session clock") << StrategyKind::SessionClock << 0.0;
        QTest::newRow("local lag") << StrategyKind::LocalLag << 0.0;
        QTest::newRow("ASA, adaptive") << StrategyKind::AsaAdaptive << 0.0;
        QTest::newRow("ASA, fixed") << StrategyKind::AsaFixed << 0.0;
        QTest::newRow("event") << StrategyKind::Event << kDelay_s;
        QTest::newRow("dead reckoning") << StrategyKind::DeadReckoning << kDelay_s;
        QTest::newRow("interpolation") << StrategyKind::Interpolation << kDelay_s + 1.0 / 60.0;
        QTest::newRow("none") << StrategyKind::None << kDelay_s;
    }
    void decideWhatIsShown()
    {
        QFETCH(const StrategyKind, kind);
        QFETCH(const double, lag_s);
        StrategyWorld world{kind};
        QVERIFY(world.turn(0));
        world.run(500ms);
        for (const std::size_t viewer : {1U, 2U}) {
            const double behind = world.behind_deg(viewer);
            QVERIFY2(std::abs(behind - 100.0 * lag_s) < kTolerance_deg,
                     qPrintable(QString::number(behind)));
            QCOMPARE(world.shown(viewer)->rate, double(float(kRate)));
        }
        // The host hears of it half the way earlier.
        const double behind = turned_deg(world.shown(0)) - turned_deg(world.shownByHost());
        const double less = lag_s > 0.0 ? kDelay_s / 2.0 : 0.0;
        QVERIFY2(std::abs(behind - 100.0 * (lag_s - less)) < kTolerance_deg,
                 qPrintable(QString::number(behind)));
    }

    void ofTheHostToo()
    {
        StrategyWorld world{StrategyKind::Event};
        world.session.ownership = {ParticipantId{0}, 2};
        world.host().share(kModel, world.session.ownership);
        for (std::size_t i = 0; i < 3; ++i)
            world.site(i).client->share(kModel, world.session.ownership);
        world.run(100ms);
        QVERIFY(world.host().act(kModel, {ActionKind::Rotation, Vec3::UnitZ(), kRate, {}},
                                 world.hostTime()));
        world.run(500ms);
        const double behind = turned_deg(world.shownByHost()) - turned_deg(world.shown(1));
        QVERIFY2(std::abs(behind - 100.0 * kDelay_s / 2.0) < kTolerance_deg,
                 qPrintable(QString::number(behind)));
    }

    void anotherOneTakesOverAtOnce()
    {
        StrategyWorld world{StrategyKind::Event};
        QVERIFY(world.turn(0));
        world.run(300ms);
        QVERIFY(world.behind_deg(1) > 1.5);
        world.choose({.kind = StrategyKind::SessionClock});
        QVERIFY(std::abs(world.behind_deg(1)) < kTolerance_deg);
    }

    /// The owner hears last that there is another, and sends by the old one until then.
    void ownerWhoHearsLateHoldsNobodyUp_data()
    {
        QTest::addColumn<StrategyKind>("before");
        QTest::addColumn<StrategyKind>("after");
        QTest::addColumn<double>("lag_s"); // of the ASA before its first probe
        QTest::newRow("snapshots behind")
            << StrategyKind::Interpolation << StrategyKind::Event << kDelay_s;
        QTest::newRow("and the ASA")
            << StrategyKind::Interpolation << StrategyKind::AsaFixed << kDelay_s;
        QTest::newRow("an action behind")
            << StrategyKind::Event << StrategyKind::Interpolation << kDelay_s + 1.0 / 60.0;
    }
    void ownerWhoHearsLateHoldsNobodyUp()
    {
        QFETCH(const StrategyKind, before);
        QFETCH(const StrategyKind, after);
        QFETCH(const double, lag_s);
        StrategyWorld world{before};
        QVERIFY(world.turn(0));
        world.run(300ms);
        world.host().setStrategy({.kind = after}, world.hostTime());
        for (const std::size_t viewer : {1U, 2U})
            world.site(viewer).client->setStrategy({.kind = after}, world.local(viewer));
        QVERIFY(world.turn(0)); // by the old one still
        world.run(100ms);
        world.site(0).client->setStrategy({.kind = after}, world.local(0));
        world.run(2s);
        for (const std::size_t viewer : {1U, 2U})
            QVERIFY2(std::abs(world.behind_deg(viewer) - 100.0 * lag_s) < kTolerance_deg,
                     qPrintable(QString::number(world.behind_deg(viewer))));
        const double behind = turned_deg(world.shown(0)) - turned_deg(world.shownByHost());
        QVERIFY(std::abs(behind - 100.0 * (lag_s - kDelay_s / 2.0)) < kTolerance_deg);
    }

    /// Without another action.
    void goesOnWithWhatMoves_data()
    {
        QTest::addColumn<StrategyKind>("kind");
        QTest::addColumn<double>("lag_s");
        QTest::newRow("event") << StrategyKind::Event << kDelay_s;
        QTest::newRow("none") << StrategyKind::None << kDelay_s;
        QTest::newRow("dead reckoning") << StrategyKind::DeadReckoning << kDelay_s;
        QTest::newRow("interpolation") << StrategyKind::Interpolation << kDelay_s + 1.0 / 60.0;
        QTest::newRow("ASA, before its first probe") << StrategyKind::AsaAdaptive << kDelay_s;
    }
    void goesOnWithWhatMoves()
    {
        QFETCH(const StrategyKind, kind);
        QFETCH(const double, lag_s);
        StrategyWorld world{StrategyKind::SessionClock};
        QVERIFY(world.turn(0));
        world.run(300ms);
        const double before = turned_deg(world.shown(0));
        world.choose({.kind = kind});
        QVERIFY(std::abs(turned_deg(world.shown(0)) - before) < kTolerance_deg);
        world.run(500ms);
        for (const std::size_t viewer : {1U, 2U})
            QVERIFY2(std::abs(world.behind_deg(viewer) - 100.0 * lag_s) < kTolerance_deg,
                     qPrintable(QString::number(world.behind_deg(viewer))));
    }

    void goesOnWithWhatTheHostMoves()
    {
        StrategyWorld world{StrategyKind::SessionClock};
        world.session.ownership = {ParticipantId{0}, 2};
        world.host().share(kModel, world.session.ownership);
        for (std::size_t i = 0; i < 3; ++i)
            world.site(i).client->share(kModel, world.session.ownership);
        world.run(100ms);
        QVERIFY(world.host().act(kModel, {ActionKind::Rotation, Vec3::UnitZ(), kRate, {}},
                                 world.hostTime()));
        world.run(300ms);
        world.choose({.kind = StrategyKind::Event});
        world.run(500ms);
        const double behind = turned_deg(world.shownByHost()) - turned_deg(world.shown(1));
        QVERIFY2(std::abs(behind - 100.0 * kDelay_s / 2.0) < kTolerance_deg,
                 qPrintable(QString::number(behind)));
    }

    /// Whoever shows the last snapshot of an owner that was away gets new ones when it is back.
    void ownerWhoWasAwayGoesOn()
    {
        StrategyWorld world{StrategyKind::Interpolation};
        QVERIFY(world.turn(0));
        world.run(300ms);
        world.cut(0, true);
        world.run(4s);
        QVERIFY(std::abs(world.behind_deg(1)) > 10.0);
        world.cut(0, false);
        world.run(3s);
        for (const std::size_t viewer : {1U, 2U})
            QVERIFY2(std::abs(world.behind_deg(viewer) - 100.0 * (kDelay_s + 1.0 / 60.0))
                         < kTolerance_deg,
                     qPrintable(QString::number(world.behind_deg(viewer))));
    }

    /// The ASA goes by the newest round trip that it measured, the session clock by no delay: a
    /// path that has become longer since tells them apart.
    void asaGoesByWhatItMeasured_data()
    {
        QTest::addColumn<StrategyKind>("kind");
        QTest::addColumn<double>("lag_s");
        QTest::newRow("session clock") << StrategyKind::SessionClock << 0.0;
        QTest::newRow("ASA, adaptive") << StrategyKind::AsaAdaptive << 0.060;
        QTest::newRow("ASA, fixed") << StrategyKind::AsaFixed << 0.060;
    }
    void asaGoesByWhatItMeasured()
    {
        QFETCH(const StrategyKind, kind);
        QFETCH(const double, lag_s);
        StrategyWorld world{kind};
        // Probes go about each second, and come back before the path is longer.
        const SimulatedLink::Path longer{70ms, 0ms, 0.0, 0.0};
        world.site(0).toHost.setPath(longer);
        QVERIFY(world.turn(0));
        world.run(100ms);
        const double behind = world.behind_deg(1);
        QVERIFY2(std::abs(behind - 100.0 * lag_s) < kTolerance_deg,
                 qPrintable(QString::number(behind)));
    }

    void whoComesLateSeesWhatIsThere()
    {
        StrategyWorld world{StrategyKind::Event};
        QVERIFY(world.turn(0));
        world.run(300ms);
        world.addLateSite(kPath);
        world.site(3).client->setStrategy({.kind = StrategyKind::Event}, world.local(3));
        world.run(1s);
        QVERIFY(std::abs(world.behind_deg(3)) < kTolerance_deg);
        QVERIFY(world.turn(0)); // from here on by the strategy
        world.run(300ms);
        QVERIFY(std::abs(world.behind_deg(3) - 100.0 * kDelay_s) < kTolerance_deg);
    }

    /// The message that stopped the object was missed, and is not repeated.
    void whoWasAwayShowsWhatIsTrue()
    {
        StrategyWorld world{StrategyKind::Event};
        QVERIFY(world.turn(0));
        world.run(300ms);
        world.cut(1, true);
        QVERIFY(world.act(0, {ActionKind::Rotation, Vec3::UnitZ(), 0.0, {}}));
        world.run(4s);
        QVERIFY(std::abs(world.behind_deg(1)) > 10.0);
        world.cut(1, false);
        world.run(2s);
        QVERIFY(std::abs(world.behind_deg(1)) < kTolerance_deg);
        QVERIFY(world.turn(0));
        world.run(300ms);
        QVERIFY(std::abs(world.behind_deg(1) - 100.0 * kDelay_s) < kTolerance_deg);
    }

    /// A message of the last owner that arrives late.
    void lastOwnerMovesNothing()
    {
        StrategyWorld world{StrategyKind::Event};
        QVERIFY(world.turn(0));
        world.run(300ms);
        const EventCpo old = *world.newest(0);
        world.takeOver(1, 1);
        world.run(300ms);
        QVERIFY(world.act(1, {ActionKind::Rotation, Vec3::UnitZ(), 0.0, {}}));
        world.run(300ms);
        const double before = turned_deg(world.shown(2));
        const WireRecord record{
            StrategyMessage{StrategyKind::Event, encodeRelayed({world.self(0), kAllOthers, old})}};
        BundleHeader header;
        header.fromHost = true;
        header.connection = world.site(2).client->link().connection();
        header.sequence = 1U << 20;
        for (const auto& bytes : packDatagrams(std::span{&record, 1}, [&] { return header; }))
            world.site(2).client->receive(bytes, world.local(2));
        world.run(300ms);
        QCOMPARE(turned_deg(world.shown(2)), before);
    }

    void newOwnerGoesOnFromWhatItShows()
    {
        StrategyWorld world{StrategyKind::None};
        QVERIFY(world.turn(0));
        world.run(300ms);
        world.takeOver(1, 1);
        world.run(300ms);
        const double before = turned_deg(world.shown(1));
        QVERIFY(world.act(1, {ActionKind::Rotation, Vec3::UnitZ(), 0.0, {}}));
        QVERIFY(std::abs(turned_deg(world.shown(1)) - before) < kTolerance_deg);
        world.run(300ms);
        QVERIFY(std::abs(world.behind_deg(1)) < kTolerance_deg);
    }

    /// Only the owner moves an object, and nobody speaks for another.
    void othersMoveNothing()
    {
        StrategyWorld world{StrategyKind::Event};
        const double before = turned_deg(world.shown(2));
        EventCpo action;
        action.object = kModel;
        action.epoch = 1;
        action.action = 99;
        action.axis_A = Vec3f::UnitZ();
        action.rate = 1.0F;
        world.sendFrom(1, {world.self(1), kAllOthers, action});
        world.sendFrom(1, {world.self(0), kAllOthers, action});
        world.run(300ms);
        QCOMPARE(turned_deg(world.shown(2)), before);
        QCOMPARE(turned_deg(world.shownByHost()), before);
        world.sendFrom(0, {world.self(0), kAllOthers, action}); // its owner may
        world.run(300ms);
        QVERIFY(turned_deg(world.shown(2)) != before);
    }

    void observersMoveNothing()
    {
        StrategyWorld world{StrategyKind::Event};
        world.session.observers.insert(world.self(0));
        QVERIFY(world.turn(0));
        world.run(300ms);
        QVERIFY(std::abs(turned_deg(world.shown(1))) < kTolerance_deg);
    }
};

CARINA_TEST(TestSessionStrategies)

} // namespace carina::session_strategies_test

#include "tst_session_strategies.moc"
