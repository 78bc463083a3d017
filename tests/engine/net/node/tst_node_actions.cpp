#include "tests/engine/net/node/nodes.h"
#include "tests/support/test_class.h"

namespace carina::node_actions_test
{

class TestNodeActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void actionsAreTheSameEverywhere()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        const auto ben = join(*instructor, "Ben");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna) && isIn(*ben), kPatience_ms);
        anna->propose(kStation, fact::ObjectShared{{}, anna->self(), ObjectKind::Jaw, "jaw"});
        QTRY_VERIFY_WITH_TIMEOUT(!anna->state()->objects().empty(), kPatience_ms);
        const ObjectId jaw = anna->state()->objects().begin()->first;
        QVERIFY(!anna->shown(jaw, *anna->now()));

        const ActedPose from{RigidTransform::translation(Vec3{1.0, 2.0, 3.0}), 1.5};
        anna->act(jaw, {ActionKind::Rotation, Vec3::UnitZ(), 0.5, from});
        for (const auto* node : {anna.get(), instructor.get(), ben.get()})
            QTRY_VERIFY_WITH_TIMEOUT(node->shown(jaw, *node->now()), kPatience_ms);
        const SessionTime t = *instructor->now() + 1s;
        QVERIFY(anna->clock() && anna->clock()->bound > 0ns);
        QVERIFY(std::chrono::abs(
                    *anna->now()
                    - (SessionTime{monotonicNow().time_since_epoch()} + anna->clock()->offset))
                < kClockTolerance);
        QCOMPARE(instructor->clock()->standardError, Duration{});
        const ShownObject expected = *anna->shown(jaw, t);
        QVERIFY(expected.acted.X_AO.translation() == from.X_AO.translation());
        QCOMPARE(expected.acted.scale, 1.5);
        const EventCpo taken = *anna->action(jaw);
        QVERIFY(taken.p_AO == from.X_AO.translation() && taken.start <= t - 1s);
        QVERIFY(ben->action(jaw)->start == taken.start);
        QVERIFY(!ben->action(ObjectId{99}));
        for (const auto* node : {instructor.get(), ben.get()}) {
            const ShownObject shown = *node->shown(jaw, t);
            QVERIFY(shown.acted.X_AO.matrix() == expected.acted.X_AO.matrix()); // to the bit
            QVERIFY(!shown.isStale);
        }
    }

    void instructorTakesOver()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        anna->propose(kStation, fact::ObjectShared{{}, anna->self(), ObjectKind::Jaw, "jaw"});
        QTRY_VERIFY_WITH_TIMEOUT(!anna->state()->objects().empty(), kPatience_ms);
        const SharedObject jaw = anna->state()->objects().begin()->second;

        instructor->act(jaw.id, {});
        QTRY_VERIFY_WITH_TIMEOUT(instructor->refusal(), kPatience_ms);
        QCOMPARE(instructor->refusal()->code, Errc::NotPermitted);
        instructor->propose(kStation,
                            fact::ObjectHandedOver{jaw.id, instructor->self(), jaw.epoch});
        QTRY_COMPARE_WITH_TIMEOUT(anna->state()->objects().at(jaw.id).owner, instructor->self(),
                                  kPatience_ms);
        instructor->act(jaw.id, {ActionKind::Translation, Vec3::UnitX(), 0.0, {}});
        QTRY_VERIFY_WITH_TIMEOUT(anna->shown(jaw.id, *anna->now()), kPatience_ms);
        anna->act(jaw.id, {});
        QTRY_VERIFY_WITH_TIMEOUT(anna->refusal(), kPatience_ms);
        // What has passed on meanwhile is not taken, and whoever tries hears why.
        instructor->propose(kStation, fact::ObjectHandedOver{jaw.id, anna->self(), jaw.epoch});
        QTRY_VERIFY_WITH_TIMEOUT(instructor->refusal(), kPatience_ms);
        QCOMPARE(instructor->refusal()->code, Errc::OwnerChanged);
    }

    void observersNeitherOwnNorAct()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto olga = join(*instructor, "Olga", Role::Observer);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*olga), kPatience_ms);
        olga->propose(kStation, fact::ObjectShared{{}, olga->self(), ObjectKind::Jaw, "jaw"});
        QTRY_VERIFY_WITH_TIMEOUT(olga->refusal(), kPatience_ms);
        QCOMPARE(olga->refusal()->code, Errc::NotPermitted);
        QVERIFY(instructor->state()->objects().empty());
        olga->act(ObjectId{1}, {});
        QTRY_VERIFY_WITH_TIMEOUT(olga->refusal(), kPatience_ms);
        QCOMPARE(olga->refusal()->code, Errc::NotPermitted);
    }
};

CARINA_TEST(TestNodeActions)

} // namespace carina::node_actions_test

#include "tst_node_actions.moc"
