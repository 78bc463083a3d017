#include "tests/engine/net/node/nodes.h"
#include "tests/support/test_class.h"

namespace carina::node_poses_test
{
namespace
{

constexpr double kCurvatureOff = 2e-3; ///< 1/m: as it is sent

} // namespace

class TestNodePoses : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void posesReachTheOthers()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        const auto ben = join(*instructor, "Ben");
        anna->publish(ObjectKind::Tube, "Tube", stillTube(*anna));
        for (const auto* node : {instructor.get(), ben.get()}) {
            QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*node) && onlyObject(*node)->newest(),
                                     kPatience_ms);
            const auto pose = onlyObject(*node)->at(*node->now());
            QVERIFY(pose);
            QCOMPARE(pose->validity, Validity::Tracked);
            QVERIFY((pose->X_FO.translation() - Vec3{0.1, 0.2, 0.3}).norm() < 1e-5);
            const auto reports = node->objectReports();
            QCOMPARE(reports.size(), std::size_t{1});
            QVERIFY(reports[0].age < 200ms);
            QTRY_VERIFY_WITH_TIMEOUT(node->objectReports()[0].driftMm, kPatience_ms);
            QVERIFY(*node->objectReports()[0].driftMm < 0.02);
        }
        QVERIFY(!onlyObject(*anna)); // one's own is not fetched from the session
        QVERIFY(anna->objectReports().empty());
        const SharedObject object = instructor->state()->objects().begin()->second;
        QCOMPARE(object.owner, anna->self());
        QCOMPARE(object.kind, ObjectKind::Tube);
        QCOMPARE(object.name, std::string{"Tube"});
    }

    /// From a participant by way of the host, and from the host.
    void whatBendsDoesSoAtTheOthers()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        const auto ben = join(*instructor, "Ben");
        const auto bends = [](const SessionNode& node) -> ShapeSource {
            return [&node]() -> std::optional<StreamShape> {
                const auto now = node.now();
                return now ? std::optional{StreamShape{*now, 0.3, 0.01, {7.0, 7.0}, {1.0, -2.0}}}
                           : std::nullopt;
            };
        };
        anna->publish(ObjectKind::Tube, "Tube", stillTube(*anna));
        anna->publishShape(ObjectKind::Tube, bends(*anna));
        for (const auto* node : {instructor.get(), ben.get()}) {
            QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*node) && onlyObject(*node)->shapeAt(*node->now()),
                                     kPatience_ms);
            const auto shape = onlyObject(*node)->shapeAt(*node->now());
            QVERIFY(shape && std::abs(shape->to.length - 0.3) < 1e-5);
            QVERIFY(std::abs(shape->to.perMetre[0] - 1.0) < kCurvatureOff);
            QVERIFY(std::abs(shape->to.perMetre[1] + 2.0) < kCurvatureOff);
        }
        anna->publishShape(ObjectKind::Tube, [] { return std::nullopt; });
        QTRY_VERIFY_WITH_TIMEOUT(!onlyObject(*ben)->shapeAt(*ben->now()), kPatience_ms);
        QVERIFY(onlyObject(*ben)->newest());
    }

    void hostsPosesReachTheOthers()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        instructor->publish(ObjectKind::Head, "Head", stillTube(*instructor));
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*anna) && onlyObject(*anna)->newest(), kPatience_ms);
    }

    void posesGoStaleWhenTheirOwnerFallsSilent()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        auto anna = join(*instructor, "Anna");
        anna->publish(ObjectKind::Tube, "Tube", stillTube(*anna));
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*instructor) && onlyObject(*instructor)->newest(),
                                 kPatience_ms);
        const auto tube = onlyObject(*instructor);
        anna.reset();
        const SessionTime last = tube->newest()->time;
        QCOMPARE(tube->at(last + 300ms)->validity, Validity::Tracked);
        QCOMPARE(tube->at(last + 301ms)->validity, Validity::Lost);
    }

    /// Otherwise each name that came and went would leave a history of its poses.
    void posesAreGivenUpWhenTheirOwnerHasGone()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto olga = join(*instructor, "Olga", Role::Observer);
        auto anna = join(*instructor, "Anna");
        anna->publish(ObjectKind::Tube, "Tube", stillTube(*anna));
        for (const SessionNode* node : {instructor.get(), olga.get()})
            QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*node) && onlyObject(*node)->newest(),
                                     kPatience_ms);
        anna.reset();
        for (const SessionNode* node : {instructor.get(), olga.get()})
            QTRY_VERIFY_WITH_TIMEOUT(!onlyObject(*node), kPatience_ms);
        QCOMPARE(instructor->state()->objects().size(), std::size_t{1});
    }
};

CARINA_TEST(TestNodePoses)

} // namespace carina::node_poses_test

#include "tst_node_poses.moc"
