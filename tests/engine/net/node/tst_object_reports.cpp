#include "tests/engine/net/node/driver_world.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::object_reports_test
{
namespace
{

constexpr double kSpeed = 0.1; // m/s

/// A tube that moves along x from `begin` on until `end`.
PoseSource tubeMoving(const DriverWorld& world, const NodeBoard& board, const LocalTime& begin,
                      const LocalTime& end)
{
    return [&]() -> std::optional<PoseSample> {
        const auto clock = board.clock();
        if (!clock)
            return std::nullopt;
        PoseSample sample;
        sample.time = clock->at(world.now);
        const double moved = kSpeed * toSeconds(std::clamp(world.now, begin, end) - begin);
        sample.X_FO = RigidTransform{Quat::Identity(), Vec3{moved, 0.0, 0.0}};
        const bool moves = begin <= world.now && world.now < end;
        sample.motion = Motion{.v_FO = Vec3{moves ? kSpeed : 0.0, 0.0, 0.0}};
        return sample;
    };
}

} // namespace

class TestObjectReports : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    // The tube stands still again when the comparison arrives, and the delay must still explain it.
    void speedIsThatOfTheTimeThatWasCompared()
    {
        HeldStore::Disk disk;
        DriverWorld world{disk};
        auto& guest = world.add("Anna");
        LocalTime begin = LocalTime::max() - 1h;
        LocalTime end = begin;
        world.run(500ms);
        guest.driver->publish(ObjectKind::Tube, "Tube", tubeMoving(world, guest.board, begin, end));
        world.run(1s);
        const auto reportOf = [&] {
            const auto reports = world.board.objectReports(world.board.clock()->at(world.now));
            return reports.empty() ? ObjectReport{} : reports[0];
        };
        QVERIFY(reportOf().driftMm);
        QVERIFY(reportOf().moveMmPerS.value_or(0.0) < 1.0);
        begin = world.now;
        end = begin + 300ms; // there is a comparison within it
        double fastest = 0.0;
        world.run(1s, [&] {
            if (world.now > end + 50ms) // the newest sample is one at rest
                fastest = std::max(fastest, reportOf().moveMmPerS.value_or(0.0));
        });
        QVERIFY2(std::abs(fastest - 1e3 * kSpeed) < 1.0, qPrintable(QString::number(fastest)));
        world.run(500ms);
        QVERIFY(reportOf().moveMmPerS.value_or(1e3) < 1.0);
    }
};

CARINA_TEST(TestObjectReports)

} // namespace carina::object_reports_test

#include "tst_object_reports.moc"
