#include "engine/sync/strategies/drift.h"
#include "tests/engine/sync/actions/acted_world.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::session_actions_test
{

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

    void saysWhatGoesOn()
    {
        ActedWorld world{13, 2, kCalm};
        QVERIFY(world.act(0, {ActionKind::Translation, -Vec3::UnitY(), 0.25, {}}));
        world.run(1s);
        for (const std::size_t site : {0U, 1U}) {
            QCOMPARE(world.shown(site)->kind, ActionKind::Translation);
            QCOMPARE(world.shown(site)->axis_A, Vec3(-Vec3::UnitY()));
            QCOMPARE(world.shown(site)->rate, 0.25);
        }
    }

    void putsAnObjectWhereItIsToldWhereverItIs()
    {
        ActedWorld world{14, 2, kCalm};
        const ActedPose place{RigidTransform::translation({0.1, 0.2, 0.3}), 2.0};
        const ActedPose elsewhere{RigidTransform::translation({1.0, 0.0, 0.0}), 0.5};
        QVERIFY(world.act(0, {ActionKind::Rotation, Vec3::UnitZ(), 0.0, place}));
        QVERIFY(world.act(0, {ActionKind::Rotation, Vec3::UnitZ(), 0.0, elsewhere}));
        world.run(1s);
        QCOMPARE(world.shown(1)->acted.X_AO.translation(), Vec3(0.1, 0.2, 0.3)); // goes on
        QVERIFY(world.act(0, {ActionKind::Rotation, Vec3::UnitZ(), 0.0, elsewhere, true}));
        world.run(1s);
        for (const std::size_t site : {0U, 1U}) {
            QCOMPARE(world.shown(site)->acted.X_AO.translation(), Vec3(1.0, 0.0, 0.0));
            QCOMPARE(world.shown(site)->acted.scale, 0.5);
        }
    }

    void showsNoSizeBeyondItsBounds()
    {
        ActedWorld world{15, 2, kCalm};
        QVERIFY(world.act(0, {ActionKind::Scaling, Vec3::UnitX(), 20.0, {}}));
        world.run(1s); // exp(20) times as large
        QCOMPARE(world.shown(1)->acted.scale, SharedActions::kLargestScale);
        QVERIFY(world.act(0, {ActionKind::Scaling, Vec3::UnitX(), -20.0, {}}));
        world.run(1s);
        QCOMPARE(world.shown(1)->acted.scale, SharedActions::kSmallestScale);
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

    void observersCannotAct()
    {
        ActedWorld world{14, 2, kCalm};
        world.session.observers.insert(world.self(0));
        QVERIFY(world.turn(0)); // the engine at the host is the one that counts
        world.run(1s);
        QVERIFY(!world.newest(1));
        QVERIFY(!world.host().actions().table().newest(kModel));
    }

    void everybodyCountsTheSameActionsAndNoChangeOfOwner()
    {
        ActedWorld world{18, 2, kCalm};
        QVERIFY(world.turn(0));
        const SessionTime first = world.newest(0)->start;
        for (int i = 0; i < 3; ++i) {
            world.run(250ms);
            QVERIFY(world.turn(0));
        }
        world.takeOver(1, 1);
        world.run(5s);
        QCOMPARE(world.newest(1)->epoch, std::uint16_t{2});
        const SessionTime now = world.trueSessionTime();
        const auto seconds = std::chrono::floor<std::chrono::seconds>(now)
                             - std::chrono::floor<std::chrono::seconds>(first);
        const std::optional expected{4.0 / toSeconds(seconds)};
        const ParticipantId actor = world.site(0).client->self();
        const auto check = [&](const ApplicationAnalysis& analysis) {
            QCOMPARE(analysis.actionFrequency(actor, 1, now), expected);
            QCOMPARE(analysis.participants().size(), std::size_t{1}); // not who took it over
        };
        check(world.host().actions().analysis());
        for (std::size_t i = 0; i < 2; ++i)
            check(world.site(i).client->actions().analysis());
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
};

CARINA_TEST(TestSessionActions)

} // namespace carina::session_actions_test

#include "tst_session_actions.moc"
