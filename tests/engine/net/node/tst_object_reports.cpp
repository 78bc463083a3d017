#include "tests/engine/net/node/driver_world.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <utility>

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

constexpr ObjectId kTurned{1};
constexpr ParticipantId kTurner{1};
constexpr SessionTime kBegin{1000s};
constexpr double kRate = 100.0 * 3.14159265358979323846 / 180.0; // rad/s

EventCpo turnAt(SessionTime start, std::uint32_t number, double rate)
{
    EventCpo event;
    event.object = kTurned;
    event.epoch = 1;
    event.action = number;
    event.start = start;
    event.axis_A = Vec3f::UnitZ();
    event.rate = static_cast<float>(rate);
    return event;
}

/// An object at rest that begins to turn at 100 deg/s, which is heard of here 40 ms later, and a
/// view of it that is 4 degrees off at the time `compared`.
NodeBoard::View turnedAndCompared(SessionTime compared)
{
    SharedActions actions;
    actions.share(kTurned, {kTurner, 1});
    actions.take(turnAt(kBegin - 1s, 1, 0.0), kBegin - 960ms, LocalTime{1s});
    actions.take(turnAt(kBegin, 2, kRate), kBegin + 40ms, LocalTime{2s});
    NodeBoard::View view;
    view.actions = std::make_shared<SharedActions>(actions);
    view.drifts = std::make_shared<ShownViews::Drifts>(
        ShownViews::Drifts{{kTurned, {Drift{degrees(4.0), millimetres(0.0), 0.02}, compared}}});
    return view;
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

    /// v_k of the paper's equation 3, of a host and of a guest who stream one object each.
    void ownStreamsCountAsThoseOfOthers()
    {
        constexpr double kTicks = 60.0; // in a second
        HeldStore::Disk disk;
        DriverWorld world{disk};
        auto& guest = world.add("Anna");
        const LocalTime never = LocalTime::max() - 1h;
        world.run(500ms);
        guest.driver->publish(ObjectKind::Tube, "Tube",
                              tubeMoving(world, guest.board, never, never));
        world.host->publish(ObjectKind::Tube, "Tube", tubeMoving(world, world.board, never, never));
        world.run(12s); // more than what is counted over
        const ParticipantId self = guest.board.part(&NodeBoard::View::self);
        for (const NodeBoard* board : {&std::as_const(world.board), &std::as_const(guest.board)}) {
            const auto frequencies = board->actionFrequencies(board->clock()->at(world.now));
            const double objects = double(board->state()->sharedObjects());
            for (const ParticipantId k : {ParticipantId{0}, self}) {
                QVERIFY(frequencies.contains(k));
                QVERIFY(std::abs(frequencies.at(k) * objects - kTicks) < 3.0);
            }
        }
    }

    /// What a viewer is off by for good stands beside 0, not beside what the delay once explained.
    void limitOfAnActionIsThatOfTheTimeThatWasCompared_data()
    {
        QTest::addColumn<SessionTime>("compared");
        QTest::addColumn<double>("limit_deg");
        QTest::newRow("before it began") << kBegin - 1ms << 0.0;
        QTest::newRow("while it was under way") << kBegin + 20ms << 4.0;
        QTest::newRow("once it had arrived") << kBegin + 40ms << 0.0;
    }
    void limitOfAnActionIsThatOfTheTimeThatWasCompared()
    {
        QFETCH(const SessionTime, compared);
        QFETCH(const double, limit_deg);
        NodeBoard board;
        static_cast<void>(board.show(turnedAndCompared(compared)));
        const auto reports = board.objectReports(kBegin + 1s);
        QCOMPARE(reports.size(), std::size_t{1});
        QVERIFY(std::abs(reports[0].driftDeg.value() - 4.0) < 1e-9);
        QVERIFY(std::abs(reports[0].limitDeg.value() - limit_deg) < 1e-5);
        QCOMPARE(reports[0].limitMm, std::optional{0.0});
        QCOMPARE(reports[0].driftScale, std::optional{0.02});
        QCOMPARE(reports[0].limitScale, std::optional{0.0});
        QCOMPARE(reports[0].delay, std::optional{Duration{40ms}});
    }
};

CARINA_TEST(TestObjectReports)

} // namespace carina::object_reports_test

#include "tst_object_reports.moc"
