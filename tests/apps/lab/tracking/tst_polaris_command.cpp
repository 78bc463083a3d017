#include "apps/lab/commands.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/site/devices/tracker_file.h"
#include "engine/net/devices/any_recording.h"
#include "engine/net/devices/device_tracker.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

#include <QJsonObject>
#include <QTemporaryDir>

#include <cmath>
#include <filesystem>
#include <thread>

namespace carina::lab::polaris_command_test
{
namespace
{

using namespace std::chrono_literals;

constexpr double kExact = 1e-5; ///< metres: BX has single precision

/// The program's device, which serves while this lives; its patient takes some seconds to make.
class Served
{
public:
    /// @param recording that it sees; without one scripted hands
    explicit Served(QStringList words, const TrackerSequence& recording = {})
    {
        words.prepend(m_folder.path());
        if (!recording.tools.empty()) {
            const QString file = m_folder.filePath(QStringLiteral("poses.csv"));
            QVERIFY(writeAnyRecording(file.toStdString(), recording));
            words << QStringLiteral("--recording") << file;
        }
        m_thread = std::jthread{[words] { static_cast<void>(polarisCommand().run(words)); }};
    }

    [[nodiscard]] std::filesystem::path description() const
    {
        return m_folder.filePath(QStringLiteral("tracker.json")).toStdString();
    }

private:
    QTemporaryDir m_folder;
    std::jthread m_thread;
};

/// The client of a device, by this computer's clock.
auto trackerOf(const TrackerDescription& description)
{
    return DeviceTracker::make(
        description, [] { return std::optional{SessionTime{monotonicNow().time_since_epoch()}}; });
}

std::size_t placeOf(const std::string& name, const std::vector<TrackedTool>& tools)
{
    return std::size_t(std::ranges::find(tools, name, &TrackedTool::name) - tools.begin());
}

} // namespace

class PolarisCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The fault comes after five seconds.
    void aWiredToolIsUnpluggedAndComesBack()
    {
        const Served served{{QStringLiteral("--seconds"), QStringLiteral("8"),
                             QStringLiteral("--wired"), QStringLiteral("tube"),
                             QStringLiteral("--fault"), QStringLiteral("unplug")}};
        QVERIFY(test::soon([&] { return std::filesystem::exists(served.description()); }, 60s));
        const auto description = readTrackerFile(served.description());
        QVERIFY2(description, description ? "" : description.error().detail.c_str());
        for (const DescribedTool& tool : description->tools)
            QCOMPARE(tool.definition.has_value(), tool.name != "tube");
        const auto tracker = trackerOf(*description);
        QVERIFY(tracker && (*tracker)->start());
        const auto tools = (*tracker)->tools();
        const auto tube = placeOf("tube", tools);
        const auto stylus = placeOf("stylus", tools);
        const auto isSeen = [&](std::size_t tool) {
            const auto newest = tools[tool].history->newest();
            return newest && newest->validity != Validity::Lost;
        };
        QVERIFY(test::soon([&] { return isSeen(tube); }, 20s));
        const auto isUnplugged = [&] {
            return (*tracker)->trouble().ends_with("tube: nothing is plugged in for it")
                   && !isSeen(tube) && isSeen(stylus);
        };
        QVERIFY(test::soon(isUnplugged, 20s));
        QVERIFY(test::soon([&] { return isSeen(tube); }, 20s));
        QCOMPARE((*tracker)->trouble(), std::string{});
    }

    /// The fault comes after five seconds.
    void aToolIsOutOfTheVolumeForAWhile()
    {
        const Served served{{QStringLiteral("--seconds"), QStringLiteral("8"),
                             QStringLiteral("--fault"), QStringLiteral("out-of-volume")}};
        QVERIFY(test::soon([&] { return std::filesystem::exists(served.description()); }, 60s));
        const auto description = readTrackerFile(served.description());
        QVERIFY2(description, description ? "" : description.error().detail.c_str());
        const auto tracker = trackerOf(*description);
        QVERIFY(tracker && (*tracker)->start());
        const auto tools = (*tracker)->tools();
        const auto tube = placeOf("tube", tools);
        const auto isSeen = [&](Validity validity) {
            const auto newest = tools[tube].history->newest();
            return newest && newest->validity == validity;
        };
        QVERIFY(test::soon([&] { return isSeen(Validity::Tracked); }, 20s));
        QVERIFY(test::soon(
            [&] {
                return (*tracker)->sightOf(tube) == ToolSight::OutOfVolume
                       && isSeen(Validity::PartlyOccluded);
            },
            20s));
        QVERIFY(test::soon([&] { return isSeen(Validity::Tracked); }, 20s));
    }

    void showsTheToolsOfARecording()
    {
        const Vec3 p_TE{0.1, -0.2, -1.5};
        TrackerSequence recording{{{.name = "Tube", .role = ToolRole::Tube},
                                   {.name = "Pointer", .role = ToolRole::Tube}}};
        for (int i = 0; i < 60; ++i) {
            const SessionTime time{i * 16ms};
            recording.tools[0].samples.push_back(
                {.time = time, .X_FO = RigidTransform::translation(p_TE), .error = 0.0002});
            recording.tools[1].samples.push_back({.time = time, .validity = Validity::Lost});
        }
        const Served served{{QStringLiteral("--seconds"), QStringLiteral("8")}, recording};
        QVERIFY(test::soon([&] { return std::filesystem::exists(served.description()); }, 60s));
        const auto description = readTrackerFile(served.description());
        QVERIFY2(description, description ? "" : description.error().detail.c_str());
        QCOMPARE(description->tools[1].role, ToolRole::Other); // no role twice
        const auto tracker = trackerOf(*description);
        QVERIFY(tracker && (*tracker)->start());
        const auto tools = (*tracker)->tools();
        std::optional<PoseSample> tube;
        QVERIFY(test::soon(
            [&] {
                tube = tools[0].history->newest();
                return tube && tube->validity == Validity::Tracked;
            },
            20s));
        QVERIFY((tube->X_FO.translation() - p_TE).norm() < kExact);
        QVERIFY(std::abs(tube->error - 0.0002) < kExact);
        const auto pointer = tools[1].history->newest();
        QVERIFY(!pointer || pointer->validity == Validity::Lost);
    }

    void refusesOtherWords()
    {
        const QTemporaryDir folder;
        TrackerSequence wired{{{.name = "wired 1", .role = ToolRole::Tube}}}; // the device's name
        for (int i = 0; i < 3; ++i)
            wired.tools[0].samples.push_back(
                {.time = SessionTime{i * 16ms},
                 .X_FO = RigidTransform::translation(Vec3{0.0, 0.0, -1.0})});
        const QString file = folder.filePath(QStringLiteral("wired.csv"));
        QVERIFY(writeAnyRecording(file.toStdString(), wired));
        for (const QStringList& words :
             {QStringList{},
              {folder.path(), QStringLiteral("--wired"), QStringLiteral("bougie")},
              {folder.path(), QStringLiteral("--hide"), QStringLiteral("bougie")},
              {folder.path(), QStringLiteral("--tool"), QStringLiteral("bougie=bougie.rom")},
              {folder.path(), QStringLiteral("--fault"), QStringLiteral("unplug")},
              {folder.path(), QStringLiteral("--fault"), QStringLiteral("wrong-rate"),
               QStringLiteral("--tcp"), QStringLiteral("1")},
              {folder.path(), QStringLiteral("--patient"), QStringLiteral("child"),
               QStringLiteral("--recording"), QStringLiteral("poses.csv")},
              {folder.path(), QStringLiteral("--recording"), file}}) {
            const auto object = polarisCommand().run(words);
            QVERIFY(!object);
            QCOMPARE(object.error().code, Errc::WrongOption);
        }
    }
};

CARINA_TEST(PolarisCommandTest)

} // namespace carina::lab::polaris_command_test

#include "tst_polaris_command.moc"
