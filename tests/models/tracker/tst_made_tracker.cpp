#include "models/tracker/made_tracker.h"

#include "tests/support/test_class.h"

namespace carina::made_tracker_test
{
namespace
{

/// A server that nobody asks: the trackers of this test are not started.
TrackerDescription server(const std::string& tool, const std::string& address = "192.0.2.7:18944")
{
    TrackerDescription description;
    description.kind = TrackerKind::OpenIgtLink;
    description.address = address;
    description.tools.push_back({tool, ToolRole::Other, {}, tool});
    return description;
}

const DevicePlace kPlace{RigidTransform::translation({1.0, 0.0, 0.0}), {}};
const DevicePlace kOtherPlace{RigidTransform::translation({2.0, 0.0, 0.0}), {}};

TrackerChoice two(const TrackerDescription& first, const TrackerDescription& second,
                  const DevicePlace& place = kPlace)
{
    return {DeviceSet{{{first, {}}, {second, place}}}};
}

std::optional<SessionTime> noClock() { return std::nullopt; }

MadeTracker made(const TrackerChoice& choice) { return MadeTracker::make(choice, noClock).value(); }

PoseHistory* historyOf(const MadeTracker& tracker, std::size_t tool)
{
    return tracker.tracker()->tools().at(tool).history;
}

} // namespace

class TestMadeTracker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesOverWhatStaysAsItIs()
    {
        const MadeTracker before = made(two(server("a"), server("b")));
        const auto after = before.next(two(server("a"), server("c")), noClock);
        QVERIFY(after.has_value());
        QCOMPARE(historyOf(*after, 0), historyOf(before, 0));
        QVERIFY(historyOf(*after, 1) != historyOf(before, 1));
        QVERIFY(after->hasFrameOf(before));
    }

    void putsItInItsNewPlace()
    {
        const MadeTracker before = made(two(server("a"), server("b")));
        const auto after = before.next(two(server("a"), server("b"), kOtherPlace), noClock);
        QCOMPARE(historyOf(*after, 1), historyOf(before, 1));
        QCOMPARE(historyOf(*after, 1)->deviceFrame()->translation().x(), 2.0);
        QVERIFY(!historyOf(*after, 0)->deviceFrame());
    }

    void goesOnWithOneOfTwoAndWithOneMore()
    {
        const MadeTracker both = made(two(server("a"), server("b")));
        const auto one = both.next({server("a")}, noClock);
        QCOMPARE(one->tracker()->tools().size(), std::size_t{1});
        QCOMPARE(historyOf(*one, 0), historyOf(both, 0));
        const auto again = one->next(two(server("a"), server("b")), noClock);
        QCOMPARE(historyOf(*again, 0), historyOf(both, 0));
        QCOMPARE(historyOf(*again, 1)->deviceFrame()->translation().x(), 1.0);
    }

    /// It was placed in the frame of another, and is to have its own.
    void makesTheFirstAnewWhereItWasNotTheFirst()
    {
        const MadeTracker before = made(two(server("a"), server("b")));
        const auto after = before.next({server("b")}, noClock);
        QVERIFY(historyOf(*after, 0) != historyOf(before, 1));
        QVERIFY(!historyOf(*after, 0)->deviceFrame());
        QVERIFY(!after->hasFrameOf(before));
    }

    void playsARecordingAnew()
    {
        const TrackerChoice recording{PlayedRecording{
            "tube.csv", {{{.name = "tube", .role = ToolRole::Tube}}}, Playing::Once}};
        const MadeTracker before = made(recording);
        const auto after = before.next(recording, noClock);
        QVERIFY(after->tracker() != before.tracker());
        QVERIFY(!after->hasFrameOf(before));
    }

    void changesNothingWhereADeviceCannotBeMade()
    {
        const MadeTracker before = made(two(server("a"), server("b")));
        const auto after = before.next(
            {DeviceSet{
                {{server("a"), {}}, {server("b"), kOtherPlace}, {server("c", "nowhere"), kPlace}}}},
            noClock);
        QVERIFY(!after);
        QCOMPARE(after.error().code, Errc::WrongAddress);
        QCOMPARE(historyOf(before, 1)->deviceFrame()->translation().x(), 1.0);
    }

    void tellsDevicesApartByAllThatIsSaidOfThem()
    {
        const TrackerDescription plain = server("a");
        QCOMPARE(contentOf(plain), contentOf(server("a")));
        std::vector<TrackerDescription> others{server("b"), server("a", "192.0.2.8:18944")};
        const auto add = [&](const auto& change) {
            others.push_back(plain);
            change(others.back());
        };
        add([](TrackerDescription& of) { of.kind = TrackerKind::Ndi; });
        add([](TrackerDescription& of) { of.poses = NdiPoseReply::Tx; });
        add([](TrackerDescription& of) { of.fastestRate = 9600; });
        add([](TrackerDescription& of) { of.igtlPoses = IgtlPoses::Tdata; });
        add([](TrackerDescription& of) { of.rate_hz = 30; });
        add([](TrackerDescription& of) { of.isLooped = true; });
        add([](TrackerDescription& of) { of.camera.focal.x() = 800.0; });
        add([](TrackerDescription& of) { of.tools.front().role = ToolRole::Head; });
        add([](TrackerDescription& of) { of.tools.front().device = "other"; });
        add([](TrackerDescription& of) { of.tools.front().body = MarkedBody{}; });
        add([](TrackerDescription& of) { of.tools.push_back({"b"}); });
        for (const TrackerDescription& other : others)
            QVERIFY(contentOf(other) != contentOf(plain));
    }

    void comparesDevicesAndPlaces()
    {
        const TrackerChoice choice = two(server("a"), server("b"));
        QVERIFY(areSameDevices(std::nullopt, std::nullopt));
        QVERIFY(areSameDevices(choice, two(server("a"), server("b"))));
        QVERIFY(!areSameDevices(choice, std::nullopt));
        QVERIFY(!areSameDevices(choice, two(server("a"), server("b"), kOtherPlace)));
        QVERIFY(!areSameDevices(choice, two(server("b"), server("a"))));
        QVERIFY(!areSameDevices(choice, TrackerChoice{server("a")}));
        QVERIFY(
            !areSameDevices(TrackerChoice{SimulatedDevice{}}, TrackerChoice{SimulatedDevice{}}));
    }
};

CARINA_TEST(TestMadeTracker)

} // namespace carina::made_tracker_test

#include "tst_made_tracker.moc"
