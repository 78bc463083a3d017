#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/tracking/simulated_tools.h"
#include "engine/core/monotonic_clock.h"
#include "engine/net/devices/device_tracker.h"
#include "evaluation/polaris/polaris_line.h"

#include <QTcpServer>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <atomic>
#include <ctime>
#include <pthread.h>
#include <thread>

namespace carina::lab
{
namespace
{

using namespace std::chrono_literals;

struct NamedReply {
    std::string_view name;
    NdiPoseReply reply;
};
constexpr std::array kReplies{NamedReply{"bx", NdiPoseReply::Bx},
                              NamedReply{"tx", NdiPoseReply::Tx},
                              NamedReply{"bx2", NdiPoseReply::Bx2}};
constexpr int kRate = 115200;
constexpr Duration kPatience = 20s;    // until it tracks
constexpr Duration kRateSettling = 1s; // after it does, and after a tool was hidden
constexpr int kRestarts = 3;
constexpr Duration kGone = 1s;        // before the first of these
constexpr Duration kMoreGone = 170ms; // before each other one: at another phase of the attempts
constexpr Duration kCountEvery = 1s;  // of eight that a history holds
const std::string kHiddenTool = "stylus";
// What is demanded of three tools with BX.
constexpr double kLeastRate_Hz = 59.0;
constexpr double kClientBound_percent = 3.0; ///< of one core; not reached
/// The same on the network, where the device is asked five times for each exposure.
constexpr double kNetworkClientBound_percent = 10.0;
constexpr Duration kLatestBack = 2s;

namespace rate_option
{
constexpr Option kSeconds{"seconds", "N", "of each of the three measurements, 1 to 600 (10)"};
constexpr Option kPoses{"poses", "COMMAND", "that asks for poses: bx unless said, tx or bx2"};
} // namespace rate_option

namespace rate_key
{
constexpr Key kBitsPerSecond{"bits_per_second", "of the line"};
constexpr Key kCommand{"poses", "the command that asked for them: bx, tx or bx2"};
constexpr Key kAllSeen{"all_seen", "while three tools are seen"};
constexpr Key kOneHidden{"one_hidden", "while one of them is not; as all_seen"};
constexpr Key kNetwork{"network", "while three tools are seen, over TCP; as all_seen"};
constexpr Key kSeconds{"measured_s", "how long", 1};
constexpr Key kSamples{"samples_per_s", "of the tool with the fewest, those that are lost included",
                       1};
constexpr Key kClient{"client_core_percent",
                      "processor time of this program without its simulated device, of one core",
                      1};
constexpr Key kDevice{"device_core_percent", "the same of the simulated device", 1};
constexpr Key kBack{"back_s",
                    "from when the device is there again, after it and its port were gone, until "
                    "all tools are tracked: the longest of three times"};
constexpr Key kSchema{"schema", "carina.polaris-rate/1"};
} // namespace rate_key

QString nameOf(NdiPoseReply reply)
{
    const auto* named = std::ranges::find(kReplies, reply, &NamedReply::reply);
    return QString::fromLatin1(named->name.data(), qsizetype(named->name.size()));
}

Duration timeOn(clockid_t clock)
{
    timespec time{};
    ::clock_gettime(clock, &time);
    return std::chrono::seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec};
}

Duration processorTimeOf(std::jthread& thread)
{
    clockid_t clock{};
    return ::pthread_getcpuclockid(thread.native_handle(), &clock) == 0 ? timeOn(clock)
                                                                        : Duration{0};
}

/// Keeps the computer from saving power, in which each waking costs several times as much, by
/// threads that work while nothing else does; one processor is left free.
class WakefulProcessors
{
public:
    WakefulProcessors()
    {
        for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
            m_threads.emplace_back([](const std::stop_token& stopping) {
                const sched_param lowest{};
                if (::pthread_setschedparam(::pthread_self(), SCHED_IDLE, &lowest) == 0)
                    while (!stopping.stop_requested()) {}
            });
    }

    [[nodiscard]] Duration processorTime()
    {
        Duration sum{0};
        for (std::jthread& thread : m_threads)
            sum += processorTimeOf(thread);
        return sum;
    }

private:
    std::vector<std::jthread> m_threads;
};

/// The simulated device on a thread of its own, whose processor time can be told.
class MeasuredDevice
{
public:
    MeasuredDevice(PolarisLine line, bool isSerial)
        : m_device{{.hasRate = isSerial},
                   [this](const std::string& tool, LocalTime t) { return poseOf(tool, t); }},
          m_thread{[this, line = std::move(line)](const std::stop_token& stopping) mutable {
              static_cast<void>(
                  line.serve(m_device, [&](LocalTime) { return !stopping.stop_requested(); }));
          }}
    {
    }

    void hide(bool hides) { m_hides = hides; }
    [[nodiscard]] Duration processorTime() { return processorTimeOf(m_thread); }

private:
    /// A metre and a half before it, turning.
    [[nodiscard]] std::optional<PolarisPose> poseOf(const std::string& tool, LocalTime t) const
    {
        if (m_hides && tool == kHiddenTool)
            return std::nullopt;
        const double angle = 0.5 * toSeconds(t.time_since_epoch() % Duration{1h});
        return PolarisPose{Quat{Eigen::AngleAxisd{angle, Vec3::UnitZ()}}, {0.0, 0.0, -1500.0}, 0.1};
    }

    PolarisDevice m_device;
    std::atomic<bool> m_hides = false;
    std::jthread m_thread; // last: it uses the others
};

/// Samples of each tool since the construction.
class SampleCount
{
public:
    explicit SampleCount(const Tracker& tracker) : m_tools{tracker.tools()}
    {
        for (const TrackedTool& tool : m_tools)
            m_counts.push_back({0, newestOf(tool)});
    }

    void look()
    {
        for (std::size_t i = 0; i < m_tools.size(); ++i) {
            Count& count = m_counts[i];
            for (const PoseSample& sample : m_tools[i].history->samples())
                count.samples += sample.time > count.upTo ? 1 : 0;
            count.upTo = newestOf(m_tools[i]);
        }
    }
    [[nodiscard]] int fewest() const
    {
        return std::ranges::min(m_counts, {}, &Count::samples).samples;
    }

private:
    struct Count {
        int samples = 0;
        SessionTime upTo{};
    };

    static SessionTime newestOf(const TrackedTool& tool)
    {
        const auto newest = tool.history->newest();
        return newest ? newest->time : SessionTime{};
    }

    std::vector<TrackedTool> m_tools;
    std::vector<Count> m_counts;
};

QJsonObject measured(const Tracker& tracker, MeasuredDevice& device, Duration duration)
{
    WakefulProcessors wakeful;
    const auto clientTime = [&] {
        return timeOn(CLOCK_PROCESS_CPUTIME_ID) - device.processorTime() - wakeful.processorTime();
    };
    std::this_thread::sleep_for(kRateSettling);
    SampleCount count{tracker};
    const LocalTime begin = monotonicNow();
    const Duration clientBefore = clientTime();
    const Duration deviceBefore = device.processorTime();
    for (LocalTime now = begin; now < begin + duration; now = monotonicNow()) {
        std::this_thread::sleep_for(std::min(kCountEvery, begin + duration - now));
        count.look();
    }
    const double seconds = toSeconds(monotonicNow() - begin);
    const auto percent = [&](Duration used) { return 100.0 * toSeconds(used) / seconds; };
    return {{rate_key::kSeconds, seconds},
            {rate_key::kSamples, count.fewest() / seconds},
            {rate_key::kClient, percent(clientTime() - clientBefore)},
            {rate_key::kDevice, percent(device.processorTime() - deviceBefore)}};
}

SessionTime rateClock() { return SessionTime{monotonicNow().time_since_epoch()}; }

/// Once all tools have been seen after a time.
Result<void> waitUntilItTracks(const DeviceTracker& tracker, SessionTime since)
{
    const auto isSeen = [since](const TrackedTool& tool) {
        const auto newest = tool.history->newest();
        return newest && newest->validity != Validity::Lost && newest->time > since;
    };
    const LocalTime end = monotonicNow() + kPatience;
    while (!std::ranges::all_of(tracker.tools(), isSeen)) {
        if (monotonicNow() > end)
            return fail(Errc::TrackerFailed, tracker.trouble());
        std::this_thread::sleep_for(5ms);
    }
    return {};
}

/// Takes the device and its port away some times. @returns the longest until it tracks again
Result<Duration> longestUntilBack(const DeviceTracker& tracker,
                                  std::unique_ptr<MeasuredDevice>& device, const std::string& link)
{
    Duration longest{};
    for (int i = 0; i < kRestarts; ++i) {
        device.reset();
        std::this_thread::sleep_for(kGone + i * kMoreGone);
        auto line = PolarisLine::terminal(link);
        if (!line)
            return tl::unexpected(line.error());
        device = std::make_unique<MeasuredDevice>(*std::move(line), true);
        const SessionTime there = rateClock();
        if (const auto tracks = waitUntilItTracks(tracker, there); !tracks)
            return tl::unexpected(tracks.error());
        longest = std::max<Duration>(longest, rateClock() - there);
    }
    return longest;
}

bool isFastEnough(const QJsonObject& figures, double clientBound_percent)
{
    return figures[rate_key::kSamples].toDouble() >= kLeastRate_Hz
           && figures[rate_key::kClient].toDouble() < clientBound_percent;
}

/// The client of three tools, not started.
Result<std::unique_ptr<DeviceTracker>> threeToolsAt(const std::string& address, NdiPoseReply reply)
{
    auto tools = simulatedTools(
        {{"head", ToolRole::Head}, {"tube", ToolRole::Tube}, {kHiddenTool, ToolRole::Stylus}});
    if (!tools)
        return tl::unexpected(tools.error());
    return DeviceTracker::make(
        {.address = address, .poses = reply, .fastestRate = kRate, .tools = *std::move(tools)},
        [] { return std::optional{rateClock()}; });
}

std::uint16_t freeTcpPort()
{
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

/// Over TCP at the loopback address, while all tools are seen.
Result<QJsonObject> measuredOnNetwork(NdiPoseReply reply, Duration duration)
{
    const std::uint16_t port = freeTcpPort();
    auto line = PolarisLine::tcp(port);
    auto tracker = threeToolsAt("127.0.0.1:" + std::to_string(port), reply);
    if (!line || !tracker)
        return tl::unexpected(!line ? line.error() : tracker.error());
    MeasuredDevice device{*std::move(line), false};
    const auto tracks = (*tracker)->start().and_then(
        [&] { return waitUntilItTracks(**tracker, SessionTime::min()); });
    if (!tracks)
        return tl::unexpected(tracks.error());
    QJsonObject figures = measured(**tracker, device, duration);
    (*tracker)->stop();
    return figures;
}

Result<QJsonObject> measureRate(const Words& words)
{
    const auto seconds = words.whole(rate_option::kSeconds, 1, 600, 10);
    const auto poses = words.word(rate_option::kPoses, kReplies, &NamedReply::reply);
    if (!seconds || !poses)
        return tl::unexpected(!seconds ? seconds.error() : poses.error());
    const NdiPoseReply reply = words.has(rate_option::kPoses) ? *poses : NdiPoseReply::Bx;
    const QTemporaryDir folder;
    const std::string link = folder.filePath(QStringLiteral("port")).toStdString();
    auto line = PolarisLine::terminal(link);
    auto tracker = threeToolsAt(link, reply);
    if (!line || !tracker)
        return tl::unexpected(!line ? line.error() : tracker.error());
    auto device = std::make_unique<MeasuredDevice>(*std::move(line), true);
    const auto tracks = (*tracker)->start().and_then(
        [&] { return waitUntilItTracks(**tracker, SessionTime::min()); });
    if (!tracks)
        return tl::unexpected(tracks.error());
    const Duration duration = std::chrono::seconds{*seconds};
    const QJsonObject allSeen = measured(**tracker, *device, duration);
    device->hide(true);
    const QJsonObject oneHidden = measured(**tracker, *device, duration);
    const auto back = longestUntilBack(**tracker, device, link);
    (*tracker)->stop();
    device.reset(); // its time would be taken for that of a client
    if (!back)
        return tl::unexpected(back.error());
    const auto network = measuredOnNetwork(reply, duration);
    if (!network)
        return tl::unexpected(network.error());
    QJsonObject object{{rate_key::kSchema, QLatin1StringView{rate_key::kSchema.help}},
                       {rate_key::kBitsPerSecond, kRate},
                       {rate_key::kCommand, nameOf(reply)},
                       {rate_key::kAllSeen, allSeen},
                       {rate_key::kOneHidden, oneHidden},
                       {rate_key::kBack, toSeconds(*back)},
                       {rate_key::kNetwork, *network}};
    if (reply == NdiPoseReply::Bx)
        object.insert(kAcceptable, isFastEnough(allSeen, kClientBound_percent)
                                       && isFastEnough(oneHidden, kClientBound_percent)
                                       && *back <= kLatestBack
                                       && isFastEnough(*network, kNetworkClientBound_percent));
    return object;
}

} // namespace

Command polarisRateCommand()
{
    return {
        .name = "polaris-rate",
        .theme = "tracking",
        .summary = "measures the rate at which a Polaris is read, and what that costs",
        .uses = {{.lines = {"[--seconds N] [--poses COMMAND]"},
                  .text =
                      "Tracks three tools of a simulated Polaris, which exposes 60 times a "
                      "second, at a pseudo-terminal that is paced at 115200 bits a second: "
                      "first with all seen, then with one of them hidden. Then it takes "
                      "the device away, and tells how soon it tracks when it is back. At "
                      "last it measures another one over TCP, with all tools seen. With bx "
                      "that is acceptable where it reads 59 samples a second or more, needs "
                      "less than 3 % of one core, over TCP 10 %, and tracks within 2 s. Threads "
                      "of the lowest priority keep all processors but one busy meanwhile, since "
                      "those of a computer that saves power need several times as long.",
                  .options = {rate_option::kSeconds, rate_option::kPoses},
                  .schema = rate_key::kSchema,
                  .keys = {rate_key::kBitsPerSecond, rate_key::kCommand, rate_key::kAllSeen,
                           rate_key::kSeconds, rate_key::kSamples, rate_key::kClient,
                           rate_key::kDevice, rate_key::kOneHidden, rate_key::kBack,
                           rate_key::kNetwork, kAcceptable}}},
        .reminder = "carina-lab help polaris-rate lists its options.",
        .experiment = measureRate};
}

} // namespace carina::lab
