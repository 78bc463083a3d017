#include "tests/engine/sync/actions/acted_world.h"
#include "tests/support/test_class.h"

namespace carina::session_ownership_test
{

/// Who may act on an object, and what becomes of it when somebody goes or comes back.
class TestSessionOwnership : public QObject
{
    Q_OBJECT

private Q_SLOTS:
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

    /// What is measured is of actions: an old one that goes on for a new owner is none.
    void handOverIsNoAction()
    {
        ActedWorld world{10, 2, kCalm};
        QVERIFY(world.turn(0));
        world.run(100ms);
        QVERIFY(world.turn(0, Vec3::UnitX()));
        world.run(5s);
        world.takeOver(1, 1);
        world.run(300ms);
        QCOMPARE(world.newest(1)->epoch, std::uint16_t{2});
        for (const std::size_t i : {0U, 1U})
            QVERIFY(world.site(i).client->actions().meters().at(kModel).figures().delay < 20ms);
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

    void partitionHealsToAnObjectWhoseNewOwnerIsAway()
    {
        ActedWorld world{21, 3, kCalm};
        QVERIFY(world.turn(0));
        world.run(1s);
        world.cut(0, true);
        QVERIFY(world.turn(0)); // never arrives
        world.takeOver(1, 1);
        world.run(1s);
        world.cut(1, true);
        world.cut(0, false);
        world.run(1s);
        QVERIFY(world.newest(0));
        QCOMPARE(world.newest(0)->epoch, std::uint16_t{2});
        QVERIFY(isSame(*world.newest(0), *world.newest(2)));
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

    void restartedHostGoesOnWithWhatItKept()
    {
        ActedWorld world{22, 2, kStorm};
        world.session.ownership = {ParticipantId{0}, 2};
        for (const std::size_t i : {0U, 1U})
            world.site(i).client->share(kModel, world.session.ownership);
        world.run(100ms);
        const auto act = [&](double rate) {
            return world.host().act(kModel, {ActionKind::Rotation, Vec3::UnitX(), rate, {}},
                                    world.hostTime());
        };
        QVERIFY(act(1.0));
        QVERIFY(act(2.0));
        const std::vector<EventCpo> kept = world.host().takeChanged();
        QCOMPARE(kept.size(), std::size_t{1});
        QCOMPARE(kept[0].action, 2U);
        QVERIFY(world.host().takeChanged().empty());
        world.run(1s);
        world.restartHost();
        world.host().restore(kept[0]);
        world.run(2s);
        QVERIFY(world.allHave(kept[0]));
        QVERIFY(!world.shown(0)->isStale);
        QVERIFY(act(3.0));
        QCOMPARE(world.host().actions().table().newest(kModel)->action, 3U);
        world.run(1s);
        QVERIFY(world.allHave(*world.host().actions().table().newest(kModel)));
    }

    void keptActionOfALastOwnerGoesOnInTheNewOnesName()
    {
        ActedWorld world{23, 2, kCalm};
        QVERIFY(world.turn(0));
        world.run(1s);
        const EventCpo kept = world.host().takeChanged().at(0);
        world.crashClient(0);
        world.session.ownership = {world.self(1), 2};
        world.restartHost();
        world.host().restore(kept);
        world.run(2s);
        EventCpo continued = kept;
        continued.epoch = 2;
        continued.action = 0;
        QVERIFY(isSame(*world.host().actions().table().newest(kModel), continued));
        QVERIFY(isSame(*world.newest(1), continued));
    }

    void keptActionOnNothingIsDropped()
    {
        ActedWorld world{24, 1, kCalm};
        EventCpo event;
        event.object = ObjectId{99};
        world.host().restore(event);
        world.run(100ms);
        QVERIFY(!world.host().actions().table().newest(ObjectId{99}));
    }
};

CARINA_TEST(TestSessionOwnership)

} // namespace carina::session_ownership_test

#include "tst_session_ownership.moc"
