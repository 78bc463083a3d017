#include "engine/sync/drift.h"
#include "tests/engine/sync/session_world.h"

#include <QTest>

#include <cmath>

namespace carina
{
namespace
{

using namespace std::chrono_literals;

constexpr ObjectId kModel{3};
const SimulatedLink::Path kCalm{5ms, 0ms, 0.0, 0.0};
/// Every fault at once: datagrams are lost, doubled and overtake each other.
const SimulatedLink::Path kStorm{20ms, 15ms, 0.2, 0.1};
constexpr double kRate = 100.0 * 3.14159265358979323846 / 180.0;

bool isSame(const EventCpo& a, const EventCpo& b)
{
    return a.epoch == b.epoch && a.action == b.action && a.kind == b.kind && a.start == b.start
           && a.q_AO.coeffs() == b.q_AO.coeffs() && a.p_AO == b.p_AO && a.axis_A == b.axis_A
           && a.rate == b.rate && a.scale == b.scale;
}

} // namespace

/// Sites that share one object, which the first owns to begin with, and follow the facts.
class ActedWorld : public SessionWorld
{
public:
    ActedWorld(std::uint32_t seed, std::size_t sites, const SimulatedLink::Path& path,
               std::vector<SimulatedClock> clocks = {})
        : SessionWorld{seed}
    {
        clocks.resize(sites);
        for (const SimulatedClock& clock : clocks) {
            startClient(addSite(path, clock), "site " + std::to_string(m_followed.size()));
            m_followed.push_back(0);
        }
        SessionWorld::run(2s);
        session.ownership = {self(0), 1};
        host().share(kModel, session.ownership);
        for (std::size_t i = 0; i < sites; ++i)
            site(i).client->share(kModel, session.ownership);
    }
    [[nodiscard]] ParticipantId self(std::size_t i) { return site(i).client->self(); }

    void addLateSite(const SimulatedLink::Path& path)
    {
        startClient(addSite(path), "late");
        m_followed.push_back(0);
        site(m_followed.size() - 1).client->share(kModel, {self(0), 1});
    }
    void restartClient(std::size_t i)
    {
        startClient(i, "site " + std::to_string(i));
        m_followed[i] = 0;
        site(i).client->share(kModel, session.ownership);
    }
    void restartHost()
    {
        crashHost();
        startHost();
        host().share(kModel, session.ownership);
    }
    void run(Duration length, const std::function<void()>& each = {})
    {
        SessionWorld::run(length, 1ms, [&] {
            follow();
            if (each)
                each();
        });
    }
    Result<void> act(std::size_t i, const ObjectAction& action)
    {
        return site(i).client->act(kModel, action, local(i));
    }
    /// Turns the object; as it was when it is refused.
    bool turn(std::size_t i, const Vec3& axis_A = Vec3::UnitZ())
    {
        return act(i, {ActionKind::Rotation, axis_A, kRate, {}}).has_value();
    }
    void takeOver(std::size_t i, std::uint16_t epoch)
    {
        std::string body{"T"};
        body += std::to_string(epoch) + " " + std::to_string(self(i).value);
        propose(i, std::move(body));
    }
    void cut(std::size_t i, bool isCut)
    {
        site(i).toHost.setCut(isCut);
        site(i).fromHost.setCut(isCut);
    }
    [[nodiscard]] const EventCpo* newest(std::size_t i)
    {
        return site(i).client->actions().table().newest(kModel);
    }
    /// Whether every node has this action in force.
    [[nodiscard]] bool allHave(const EventCpo& event)
    {
        bool all = host().actions().table().newest(kModel)
                   && isSame(*host().actions().table().newest(kModel), event);
        for (std::size_t i = 0; i < m_followed.size(); ++i)
            all = all && newest(i) && isSame(*newest(i), event);
        return all;
    }
    [[nodiscard]] std::optional<ShownObject> shown(std::size_t i)
    {
        const auto& mapping = site(i).client->clock().mapping();
        if (!mapping)
            return std::nullopt;
        return site(i).client->actions().shown(kModel, mapping->at(local(i)), local(i));
    }
    [[nodiscard]] LocalTime local(std::size_t i) { return site(i).clock.at(now()); }

private:
    /// What a node's driver does with facts about ownership.
    void follow()
    {
        host().share(kModel, session.ownership);
        for (std::size_t i = 0; i < m_followed.size(); ++i)
            for (; m_followed[i] < site(i).log.size(); ++m_followed[i])
                if (const auto next = TestSession::handedOver(site(i).log[m_followed[i]].body))
                    site(i).client->share(kModel, *next);
    }

    std::vector<std::size_t> m_followed;
};

class TestSessionActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyNodeEndsInTheSameState_data()
    {
        QTest::addColumn<std::uint32_t>("seed");
        for (std::uint32_t seed = 1; seed <= 6; ++seed)
            QTest::addRow("storm %u", seed) << seed;
    }

    void everyNodeEndsInTheSameState()
    {
        QFETCH(std::uint32_t, seed);
        ActedWorld world{seed, 4, kStorm, {{250ms, 50}, {-250ms, -50}, {1s, 0}, {}}};
        std::mt19937 random{seed};
        std::size_t call = 0;
        world.run(30s, [&] {
            if (++call % 600 != 0)
                return;
            const Vec3 axis_A = Vec3::Unit(random() % 3) * (random() % 2 == 0 ? 1.0 : -1.0);
            const auto kind = static_cast<ActionKind>(random() % 3);
            QVERIFY(world.act(0, {kind, axis_A, 0.1, {}}));
        });
        world.run(2s);
        QCOMPARE(world.newest(0)->action, 50U);
        QVERIFY(world.allHave(*world.newest(0)));
        QVERIFY(!world.shown(1)->isStale);
    }

    void actionsAreShownWhereTheyAreInSpiteOfTheClocks()
    {
        // The best there is: both draw for the same instant, off by their clocks alone.
        constexpr Duration kClockError = 300us;
        ActedWorld world{7, 2, {20ms, 1ms, 0.0, 0.0}, {{250ms, 50}, {-250ms, -50}}};
        world.run(30s);
        std::size_t call = 0;
        double worst = 0.0;
        world.run(20s, [&] {
            if (++call % 1200 == 0)
                QVERIFY(world.turn(0, Vec3::Unit(call / 1200 % 3)));
            if (call % 1200 > 200 && call > 2400)
                worst = std::max(
                    worst, driftBetween(world.shown(0)->acted.X_AO, world.shown(1)->acted.X_AO)
                               .rotation.si);
        });
        QVERIFY2(worst <= kRate * toSeconds(kClockError), qPrintable(QString::number(worst)));
        QVERIFY(worst > 0.0);
    }

    void actionsTravelAtOnce()
    {
        ActedWorld world{8, 2, kCalm};
        QVERIFY(world.turn(0));
        world.run(2 * kCalm.delay + 1ms);
        QVERIFY(world.newest(1));
        QVERIFY(isSame(*world.newest(0), *world.newest(1)));
    }

    void lateJoinerGetsWhatIsInForce()
    {
        ActedWorld world{9, 2, kCalm};
        QVERIFY(world.turn(0));
        world.run(100ms);
        world.addLateSite(kStorm);
        world.run(3s);
        QVERIFY(world.allHave(*world.newest(0)));
    }

    void oneOfTwoWhoTakeOverAtOnceHasIt_data()
    {
        QTest::addColumn<std::uint32_t>("seed");
        for (std::uint32_t seed = 1; seed <= 6; ++seed)
            QTest::addRow("storm %u", seed) << seed;
    }

    void oneOfTwoWhoTakeOverAtOnceHasIt()
    {
        QFETCH(std::uint32_t, seed);
        ActedWorld world{seed, 3, kStorm};
        QVERIFY(world.turn(0));
        world.run(500ms);
        world.takeOver(1, 1);
        world.takeOver(2, 1);
        world.run(1s, [&] { // whoever has it acts, as long as it has it
            for (const std::size_t i : {0U, 1U, 2U})
                static_cast<void>(world.turn(i));
        });
        world.run(2s);
        QCOMPARE(world.session.ownership.epoch, std::uint16_t{2});
        const std::size_t winner = world.session.ownership.owner == world.self(1) ? 1 : 2;
        const std::size_t loser = 3 - winner;
        QVERIFY(world.site(winner).refused.empty());
        QCOMPARE(world.site(loser).refused.size(), std::size_t{1});
        QCOMPARE(world.site(loser).refused[0].reason, Errc::OwnerChanged);
        QCOMPARE(world.newest(winner)->epoch, std::uint16_t{2});
        QVERIFY(world.newest(winner)->action > 0);
        QVERIFY(world.allHave(*world.newest(winner)));
        QVERIFY(!world.turn(0) && !world.turn(loser) && world.turn(winner));
    }

    void handedOverObjectGoesOn()
    {
        ActedWorld world{10, 2, kCalm};
        QVERIFY(world.turn(0));
        world.run(100ms);
        const EventCpo before = *world.newest(0);
        world.takeOver(1, 1);
        world.run(100ms);
        EventCpo expected = before;
        expected.epoch = 2;
        expected.action = 0;
        QVERIFY(world.allHave(expected));
        // The new owner keeps it alive, and the old is not heard any more.
        world.run(1s);
        QVERIFY(!world.shown(0)->isStale && !world.shown(1)->isStale);
        QVERIFY(world.turn(1));
        QCOMPARE(world.newest(1)->action, 1U);
    }

    void partitionHealsToTheOwnersLast()
    {
        ActedWorld world{11, 3, kStorm};
        QVERIFY(world.turn(0));
        world.run(1s);
        world.cut(0, true);
        world.run(1s, [&] { QVERIFY(world.turn(0)); });
        QVERIFY(!world.allHave(*world.newest(0)));
        QVERIFY(world.shown(1)->isStale);
        world.run(1s);
        world.cut(0, false);
        world.run(2s);
        QVERIFY(world.allHave(*world.newest(0)));
        QVERIFY(!world.shown(1)->isStale);
    }

    void partitionHealsToTheNewOwner_data()
    {
        QTest::addColumn<bool>("actedBefore");
        QTest::addColumn<bool>("newOwnerActs");
        QTest::newRow("who acts") << true << true;
        QTest::newRow("who does nothing yet") << true << false;
        QTest::newRow("who acts first of all") << false << true;
    }

    void partitionHealsToTheNewOwner()
    {
        QFETCH(bool, actedBefore);
        QFETCH(bool, newOwnerActs);
        ActedWorld world{12, 3, kStorm};
        if (actedBefore)
            QVERIFY(world.turn(0));
        world.run(1s);
        world.cut(0, true);
        world.run(1s, [&] { QVERIFY(world.turn(0)); });
        world.takeOver(1, 1);
        world.run(1s);
        if (newOwnerActs)
            QVERIFY(world.turn(1));
        world.cut(0, false);
        world.run(3s);
        QCOMPARE(world.newest(1)->epoch, std::uint16_t{2});
        QVERIFY(world.allHave(*world.newest(1)));
        QVERIFY(!world.turn(0));
    }

    void whatNeverArrivedIsVoidUnderANewOwner()
    {
        ActedWorld world{13, 2, kCalm};
        world.cut(0, true);
        QVERIFY(world.turn(0));
        world.takeOver(1, 1);
        world.run(2s);
        world.cut(0, false);
        world.run(2s);
        QVERIFY(!world.newest(0) && !world.newest(1));
        QVERIFY(!world.shown(0));
    }

    void observersCannotAct()
    {
        ActedWorld world{14, 2, kCalm};
        world.session.observers.insert(world.self(0));
        QVERIFY(world.turn(0)); // the engine at the host is the one that counts
        world.run(1s);
        QVERIFY(!world.newest(1));
        QVERIFY(!world.host().actions().table().newest(kModel));
    }

    void othersObjectsCannotBeActedOn()
    {
        ActedWorld world{15, 2, kCalm};
        QCOMPARE(world.act(1, {}).error().code, Errc::NotPermitted);
        // Not even by a program that believes it owns the object.
        world.site(1).client->share(kModel, {world.self(1), 1});
        QVERIFY(world.turn(1));
        world.run(1s);
        QVERIFY(!world.newest(0));
        // Nor under an ownership that is over or is not yet.
        for (const int epoch : {0, 2}) {
            world.site(0).client->share(kModel, {world.self(0), std::uint16_t(epoch)});
            QVERIFY(world.turn(0));
            world.run(1s);
            QVERIFY(!world.host().actions().table().newest(kModel));
        }
    }

    void senselessActionsAreRefused_data()
    {
        QTest::addColumn<double>("length");
        QTest::addColumn<double>("rate");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, double length, double rate, Errc code) {
            QTest::newRow(name) << length << rate << int(code);
        };
        row("no direction", 0.0, 1.0, Errc::OutOfRange);
        row("no unit vector", 1.00001, 1.0, Errc::OutOfRange);
        row("too fast", 1.0, 100.001, Errc::OutOfRange);
        row("too fast backwards", 1.0, -100.001, Errc::OutOfRange);
        row("no number", 1.0, std::nan(""), Errc::NotFinite);
        row("no finite axis", std::numeric_limits<double>::infinity(), 1.0, Errc::NotFinite);
    }

    void senselessActionsAreRefused()
    {
        QFETCH(double, length);
        QFETCH(double, rate);
        QFETCH(int, code);
        ActedWorld world{16, 1, kCalm};
        const auto done = world.act(0, {ActionKind::Scaling, Vec3{0.0, length, 0.0}, rate, {}});
        QCOMPARE(int(done.error().code), code);
        QVERIFY(world.act(0, {ActionKind::Scaling, Vec3::UnitY(), -100.0, {}}));
        // However small it has become, the next action finds something.
        world.run(10s);
        QVERIFY(world.act(0, {ActionKind::Scaling, Vec3::UnitY(), 100.0, {}}));
        QCOMPARE(world.newest(0)->scale, 1e-3F);
        world.run(10s);
        QVERIFY(world.act(0, {ActionKind::Scaling, Vec3::UnitY(), 0.0, {}}));
        QCOMPARE(world.newest(0)->scale, 1e3F);
    }

    void actionBeginsWhereTheObjectIs()
    {
        ActedWorld world{17, 1, kCalm};
        const ActedPose from{RigidTransform::translation(Vec3{1.0, 2.0, 3.0}), 2.0};
        QVERIFY(world.act(0, {ActionKind::Translation, Vec3::UnitX(), 0.5, from}));
        const EventCpo first = *world.newest(0);
        QVERIFY(first.p_AO == (Vec3{1.0, 2.0, 3.0}));
        QCOMPARE(first.scale, 2.0F);
        QCOMPARE(first.action, 1U);
        world.run(2s);
        QVERIFY(world.turn(0));
        const EventCpo second = *world.newest(0);
        QCOMPARE(second.action, 2U);
        QVERIFY(second.p_AO == evaluate(first, second.start).X_AO.translation());
        QVERIFY(std::abs(second.p_AO.x() - 2.0) < 1e-3);
    }

    void restartedOwnerCountsOn()
    {
        ActedWorld world{18, 2, kStorm};
        for (int i = 0; i < 5; ++i)
            QVERIFY(world.turn(0));
        world.run(1s);
        world.restartClient(0);
        world.run(3s);
        QCOMPARE(world.newest(0)->action, 5U);
        QVERIFY(world.turn(0));
        QCOMPARE(world.newest(0)->action, 6U);
        world.run(1s);
        QVERIFY(world.allHave(*world.newest(0)));
        QVERIFY(!world.shown(1)->isStale);
    }

    void restartedHostLearnsFromTheOwner()
    {
        ActedWorld world{19, 2, kStorm};
        QVERIFY(world.turn(0));
        world.run(1s);
        world.restartHost();
        world.run(2s);
        QVERIFY(world.allHave(*world.newest(0)));
        world.addLateSite(kCalm);
        world.run(2s);
        QVERIFY(world.allHave(*world.newest(0)));
    }

    void hostActsOnItsOwn()
    {
        ActedWorld world{20, 2, kStorm};
        world.session.ownership = {ParticipantId{0}, 2};
        for (const std::size_t i : {0U, 1U})
            world.site(i).client->share(kModel, world.session.ownership);
        world.run(100ms);
        QVERIFY(world.host().act(kModel, {ActionKind::Rotation, Vec3::UnitX(), 1.0, {}},
                                 world.hostTime()));
        world.run(2s);
        QVERIFY(world.newest(0));
        QVERIFY(world.allHave(*world.newest(0)));
        QVERIFY(!world.shown(0)->isStale && !world.shown(1)->isStale);
        world.cut(1, true);
        world.run(400ms);
        QVERIFY(world.shown(1)->isStale);
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestSessionActions)
#include "tst_session_actions.moc"
