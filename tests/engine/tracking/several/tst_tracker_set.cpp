#include "engine/tracking/several/tracker_set.h"

#include "engine/geometry/rotation.h"
#include "engine/tracking/markers/tool_error.h"
#include "engine/tracking/simulated/simulated_tracker.h"
#include "tests/support/test_class.h"

#include <deque>

namespace carina::tracker_set_test
{
namespace
{

using namespace std::chrono_literals;

const DevicePlace kPlace{{rotationFromVector({0.0, 0.0, 1.5707963267948966}), Vec3{1.0, 0.0, 0.0}},
                         20ms};

/// A device that is fed by the test.
class FedTracker : public Tracker
{
public:
    explicit FedTracker(std::vector<std::string> tools)
    {
        for (std::string& name : tools)
            m_tools.push_back({std::move(name), ToolRole::Other, &m_histories.emplace_back()});
    }
    Result<void> start() override
    {
        if (startsNot)
            return fail(Errc::TrackerFailed, "no thread");
        isStarted = true;
        return {};
    }
    void stop() override { isStarted = false; }
    std::vector<TrackedTool> tools() const override { return m_tools; }
    std::string trouble() const override { return m_trouble; }
    ToolSight sightOf(std::size_t tool) const override
    {
        return tool == blocked ? ToolSight::OutOfVolume : ToolSight::Unsaid;
    }

    bool isStarted = false;
    bool startsNot = false;
    std::string m_trouble;
    std::size_t blocked = 99;

private:
    std::deque<PoseHistory> m_histories;
    std::vector<TrackedTool> m_tools;
};

struct Two {
    FedTracker* first = nullptr;
    FedTracker* second = nullptr;
    std::unique_ptr<TrackerSet> both;
};

Two twoDevices()
{
    auto first = std::make_unique<FedTracker>(std::vector<std::string>{"chin"});
    auto second = std::make_unique<FedTracker>(std::vector<std::string>{"head", "hand"});
    Two two{first.get(), second.get(), nullptr};
    std::vector<PlacedTracker> placed;
    placed.push_back({std::move(first), {}});
    placed.push_back({std::move(second), kPlace});
    two.both = std::make_unique<TrackerSet>(std::move(placed));
    return two;
}

} // namespace

class TestTrackerSet : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasTheToolsOfAll()
    {
        const Two two = twoDevices();
        const auto tools = two.both->tools();
        QCOMPARE(tools.size(), 3U);
        QCOMPARE(tools[0].name, std::string{"chin"});
        QCOMPARE(tools[2].name, std::string{"hand"});
    }

    /// A quarter turn about z takes x to y; the second device stands a metre along x.
    void bringsPosesIntoTheFrameOfTheFirst()
    {
        const Two two = twoDevices();
        two.second->tools()[0].history->push(
            {.time = SessionTime{1s},
             .X_FO = RigidTransform::translation({0.5, 0.0, 0.2}),
             .motion = Motion{.v_FO = {0.3, 0.0, 0.0}, .w_FO = {0.0, 2.0, 0.0}}});
        const auto sample = two.both->tools()[1].history->newest();
        QVERIFY(sample.has_value());
        constexpr double kExact = 1e-12;
        QVERIFY((sample->X_FO.translation() - Vec3{1.0, 0.5, 0.2}).norm() < kExact);
        QVERIFY((sample->X_FO.rotation() * Vec3::UnitX() - Vec3::UnitY()).norm() < kExact);
        QVERIFY((sample->motion->v_FO - Vec3{0.0, 0.3, 0.0}).norm() < kExact);
        QVERIFY((sample->motion->w_FO - Vec3{-2.0, 0.0, 0.0}).norm() < kExact);
        QCOMPARE(sample->time, SessionTime{980ms});
    }

    void leavesThoseOfTheFirstAsTheyAre()
    {
        const Two two = twoDevices();
        two.first->tools()[0].history->push(
            {.time = SessionTime{1s}, .X_FO = RigidTransform::translation({0.5, 0.1, 0.2})});
        const auto sample = two.both->tools()[0].history->newest();
        QVERIFY(sample.has_value());
        QCOMPARE(sample->time, SessionTime{1s});
        QVERIFY((sample->X_FO.translation() - Vec3{0.5, 0.1, 0.2}).norm() == 0.0);
    }

    void asksEachDeviceForItsOwnTools()
    {
        const Two two = twoDevices();
        two.second->blocked = 1;
        QCOMPARE(two.both->sightOf(1), ToolSight::Unsaid);
        QCOMPARE(two.both->sightOf(2), ToolSight::OutOfVolume);
    }

    void tellsTheTroubleOfEach()
    {
        const Two two = twoDevices();
        two.second->m_trouble = "b";
        QCOMPARE(two.both->trouble(), std::string{"b"});
        two.first->m_trouble = "a";
        QCOMPARE(two.both->trouble(), std::string{"a; b"});
    }

    void startsAllOrNone()
    {
        const Two two = twoDevices();
        QVERIFY(two.both->start());
        QVERIFY(two.first->isStarted && two.second->isStarted);
        two.both->stop();
        QVERIFY(!two.first->isStarted && !two.second->isStarted);
        two.second->startsNot = true;
        QVERIFY(!two.both->start());
        QVERIFY(!two.first->isStarted);
    }

    /// Of which the next set goes on with one, in another place.
    void endsWithoutStoppingWhatAnotherSetHas()
    {
        const auto first = std::make_shared<FedTracker>(std::vector<std::string>{"chin"});
        const auto second = std::make_shared<FedTracker>(std::vector<std::string>{"head"});
        std::optional<TrackerSet> before{std::in_place,
                                         std::vector<PlacedTracker>{{first, {}}, {second, kPlace}}};
        QVERIFY(before->start());
        const auto seen = [&second](Duration t) {
            second->tools()[0].history->push({.time = SessionTime{t}});
            return second->tools()[0].history->newest()->X_FO.translation().x();
        };
        QCOMPARE(seen(1s), 1.0);
        const TrackerSet after{std::vector<PlacedTracker>{
            {first, {}}, {second, {RigidTransform::translation({3.0, 0.0, 0.0}), {}}}}};
        before.reset();
        QVERIFY(first->isStarted && second->isStarted);
        QVERIFY(!second->tools()[0].history->newest()); // in its former place
        QCOMPARE(seen(2s), 3.0);
    }

    /// Markers face a device, wherever the frame is in which the pose is told.
    void predictsTheErrorFromWhereTheDeviceStands()
    {
        PoseHistory own;
        TrackedTool tool{
            "head", ToolRole::Head, &own, simulatedProbe(ToolRole::Head), {millimetres(0.1), 3.0}};
        const RigidTransform X_DO{rotationFromVector({0.3, -0.4, 0.9}), Vec3{0.2, -0.1, -1.5}};
        const auto alone = predictedError(tool, {.X_FO = X_DO});
        PoseHistory placed;
        placed.placeDevice(kPlace);
        tool.history = &placed;
        const auto among = predictedError(tool, {.X_FO = kPlace.X_FD * X_DO});
        QVERIFY(alone && among);
        const Vec3 p_OQ{0.0, 0.0, 0.2};
        QVERIFY(std::abs(alone->at(p_OQ).si - among->at(p_OQ).si) < 1e-12);
    }
};

CARINA_TEST(TestTrackerSet)

} // namespace carina::tracker_set_test

#include "tst_tracker_set.moc"
