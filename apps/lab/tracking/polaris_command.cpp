#include "apps/lab/command/patient_options.h"
#include "apps/lab/commands.h"
#include "apps/lab/tracking/polaris_sight.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/files/whole_file.h"
#include "engine/net/devices/any_recording.h"
#include "evaluation/polaris/polaris_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <random>
#include <utility>

namespace carina::lab
{
namespace
{

enum class Fault : std::uint8_t {
    None,
    Corrupt,
    Cut,
    Silence,
    Reset,
    Interference,
    BadFit,
    FewMarkers,
    OutOfVolume,
    PartlyOutOfVolume,
    Unplug,
    WrongRate
};

struct NamedFault {
    std::string_view name;
    Fault fault;
};
constexpr std::array kFaults{NamedFault{"none", Fault::None},
                             NamedFault{"corrupt", Fault::Corrupt},
                             NamedFault{"cut", Fault::Cut},
                             NamedFault{"silence", Fault::Silence},
                             NamedFault{"reset", Fault::Reset},
                             NamedFault{"interference", Fault::Interference},
                             NamedFault{"bad-fit", Fault::BadFit},
                             NamedFault{"few-markers", Fault::FewMarkers},
                             NamedFault{"out-of-volume", Fault::OutOfVolume},
                             NamedFault{"partly-out-of-volume", Fault::PartlyOutOfVolume},
                             NamedFault{"unplug", Fault::Unplug},
                             NamedFault{"wrong-rate", Fault::WrongRate}};
constexpr Duration kFaultEvery = std::chrono::seconds{5};
constexpr Duration kFaultLasts = std::chrono::seconds{1}; // one that is not of one reply

namespace polaris_option
{
constexpr Option kTcp{"tcp", "PORT", "at this port of the loopback address instead of a terminal"};
constexpr Option kSeconds{"seconds", "N", "how long it serves, 1 to 86400 (60)"};
constexpr Option kNoise{"noise-mm", "MM",
                        "that is added to each position: its standard deviation along each axis, "
                        "0 to 10 (0)"};
constexpr Option kRecording{"recording", "FILE",
                            "of a tracker, in any form that --tracker recorded:FILE plays: its "
                            "tools, at most nine, are seen in place of scripted hands, again and "
                            "again"};
constexpr Option kTool{"tool", "TOOL=FILE",
                       "one of the tools has the markers of this .rom file, and what else the "
                       "file says of it; several, separated by commas. A tool of scripted hands "
                       "is seen while as many of its markers face the device as the file asks"};
constexpr Option kHide{"hide", "TOOL",
                       "head, jaw, tube or stylus, or one of the recording: is not seen"};
constexpr Option kWired{"wired", "TOOL",
                        "one of the same: is plugged into the device, in place of a wireless one"};
constexpr Option kOld{"old", "",
                      "it knows TX only, as the first generation: BX and BX2 are errors"};
constexpr Option kFault{"fault", "KIND",
                        "every 5 s: corrupt a bit of a reply, cut a reply, silence for 1 s, "
                        "reset as after the power was cycled, interference by other infrared "
                        "light for 1 s, bad-fit, few-markers, out-of-volume or "
                        "partly-out-of-volume of the tube, or of the first tool of a recording "
                        "without one, for 1 s, unplug of the wired tool for 1 s, "
                        "wrong-rate of its line, which is 9600 again; none unless given"};
} // namespace polaris_option

namespace polaris_key
{
constexpr Key kFolder{"folder", "DIR as given"};
constexpr Key kServed{"served_s", "how long it served"};
constexpr Key kReceived{"bytes_received", "of commands"};
constexpr Key kReplies{"replies", "that were sent"};
constexpr Key kSent{"bytes_sent", "of them"};
constexpr Key kFaultsMade{"faults", "that were made"};
constexpr Key kSchema{"schema", "carina.polaris/1"};
} // namespace polaris_key

/// What is wanted of the device.
struct SimulationOrder {
    PolarisTools tools;
    std::int64_t seconds = 0;
    std::optional<std::uint16_t> port{}; ///< of TCP; else a terminal
    double noise_mm = 0.0;
    Fault fault = Fault::None;
    std::string hidden{}; ///< name of a tool; empty: none
    std::string wired{};  ///< likewise
    bool isOld = false;

    /// The tool of which poses are faulty, as the device names it: the tube, or the first tool.
    [[nodiscard]] std::string faulty() const
    {
        const auto& all = tools.described;
        const auto tube = std::ranges::find(all, ToolRole::Tube, &DescribedTool::role);
        const std::string& name = (tube == all.end() ? all.front() : *tube).name;
        return name == wired ? kWiredTool : name;
    }
};

/// The tracker and its tools, as a technician would describe them.
TrackerDescription descriptionOf(const SimulationOrder& order, const std::string& address)
{
    TrackerDescription described{
        .address = address, .fastestRate = 115200, .tools = order.tools.described};
    for (DescribedTool& tool : described.tools)
        if (tool.name == order.wired)
            tool.definition.reset();
    return described;
}

/// On stderr, as soon as it is there: where it serves, and which file is the definition of which
/// tool (writeTrackerFile).
void announce(const std::filesystem::path& file, const TrackerDescription& described)
{
    std::string tools;
    int written = 0;
    for (const DescribedTool& tool : described.tools) {
        const std::string definition =
            tool.definition ? file.stem().string() + '-' + std::to_string(++written) + ".rom"
                            : "plugged in";
        tools += (tools.empty() ? "" : ", ") + tool.name + " (" + definition + ')';
    }
    const std::string text =
        "serves at " + described.address + "; " + file.string() + " describes it: " + tools + '\n';
    std::fwrite(text.data(), 1, text.size(), stderr);
}

/// What the device states of what it sees.
PolarisDevice::PoseOf statedPoses(const SimulationOrder& order, SeenPose poseOf)
{
    return [order, poseOf = std::move(poseOf), random = std::mt19937{7}](
               const std::string& handle, LocalTime t) mutable -> std::optional<PolarisPose> {
        const std::string& name = handle == kWiredTool ? order.wired : handle;
        const auto& tools = order.tools.described;
        const auto tool = std::ranges::find(tools, name, &DescribedTool::name);
        if (tool == tools.end() || name == order.hidden)
            return std::nullopt;
        auto pose = poseOf(std::size_t(tool - tools.begin()), t);
        if (!pose)
            return std::nullopt;
        std::normal_distribution<double> noise;
        for (double& coordinate : pose->p_mm)
            coordinate += order.noise_mm * noise(random);
        pose->error_mm = std::hypot(pose->error_mm, order.noise_mm);
        return pose;
    };
}

/// Makes a fault every kFaultEvery.
class FaultMaker
{
public:
    /// @param tool as the device names it: of which poses are faulty
    FaultMaker(PolarisDevice& device, Fault fault, std::string tool, LocalTime now)
        : m_device{device}, m_fault{fault}, m_faultyTool{std::move(tool)}, m_next{now + kFaultEvery}
    {
    }

    void look(LocalTime now)
    {
        if (m_until && now >= *m_until) {
            m_device.faults() = {};
            if (m_fault == Fault::Unplug)
                m_device.ports().plugIn(1);
            m_until.reset();
        }
        if (m_fault == Fault::None || now < m_next)
            return;
        m_next += kFaultEvery;
        ++m_made;
        if (m_fault == Fault::Reset)
            static_cast<void>(m_device.reset(now)); // its word is lost: nobody listened
        if (m_fault == Fault::WrongRate)
            m_device.loseRate();
        PolarisFaults& faults = m_device.faults();
        faults.corruptsNext = m_fault == Fault::Corrupt;
        faults.cutsNext = m_fault == Fault::Cut;
        faults.isSilent = m_fault == Fault::Silence;
        faults.hasInterference = m_fault == Fault::Interference;
        if (m_fault == Fault::BadFit)
            faults.losses[m_faultyTool] = PolarisLoss::BadFit;
        if (m_fault == Fault::FewMarkers)
            faults.losses[m_faultyTool] = PolarisLoss::FewMarkers;
        if (m_fault == Fault::OutOfVolume)
            faults.places[m_faultyTool] = PolarisPlace::Outside;
        if (m_fault == Fault::PartlyOutOfVolume)
            faults.places[m_faultyTool] = PolarisPlace::PartlyOut;
        if (m_fault == Fault::Unplug)
            m_device.ports().unplug(1);
        if (m_fault != Fault::Corrupt && m_fault != Fault::Cut)
            m_until = now + kFaultLasts;
    }

    [[nodiscard]] int made() const { return m_made; }

private:
    PolarisDevice& m_device;
    Fault m_fault;
    std::string m_faultyTool;
    LocalTime m_next;
    std::optional<LocalTime> m_until; ///< that a fault lasts
    int m_made = 0;
};

/// A tool's name, as an option has it; empty where it is not given.
Result<std::string> toolOption(const Words& words, const Option& option,
                               const std::vector<DescribedTool>& tools)
{
    const std::string name = words.text(option).toStdString();
    if (name.empty() || std::ranges::count(tools, name, &DescribedTool::name) != 0)
        return name;
    QStringList names;
    for (const DescribedTool& tool : tools)
        names << QString::fromStdString(tool.name);
    return words.unknownWord(option, names);
}

Result<SimulationOrder> orderOf(const Words& words, PolarisTools tools)
{
    const auto seconds = words.whole(polaris_option::kSeconds, 1, 86400, 60);
    const auto port = words.whole(polaris_option::kTcp, 1, 65535, 0);
    const auto noise = words.number(polaris_option::kNoise, 0.0, 10.0, 0.0);
    const auto fault = words.word(polaris_option::kFault, kFaults, &NamedFault::fault);
    const auto hidden = toolOption(words, polaris_option::kHide, tools.described);
    const auto wired = toolOption(words, polaris_option::kWired, tools.described);
    if (!seconds || !port || !noise)
        return tl::unexpected(!seconds ? seconds.error() : !port ? port.error() : noise.error());
    if (!fault || !hidden || !wired)
        return tl::unexpected(!fault ? fault.error() : !hidden ? hidden.error() : wired.error());
    const bool isTcp = words.has(polaris_option::kTcp);
    if (*fault == Fault::Unplug && wired->empty())
        return words.refuse(QStringLiteral("--fault unplug needs --wired TOOL."));
    if (*fault == Fault::WrongRate && isTcp)
        return words.refuse(QStringLiteral("--fault wrong-rate needs a line with a rate: with "
                                           "--tcp there is none."));
    SimulationOrder order{.tools = std::move(tools),
                          .seconds = *seconds,
                          .noise_mm = *noise,
                          .fault = *fault,
                          .hidden = *hidden,
                          .wired = *wired,
                          .isOld = words.has(polaris_option::kOld)};
    if (isTcp)
        order.port = std::uint16_t(*port);
    return order;
}

/// What the device has, and what is before it.
PolarisDevice::Settings settingsOf(const SimulationOrder& order)
{
    PolarisDevice::Settings settings{
        .hasRate = !order.port, .hasBinary = !order.isOld, .tools = order.tools.known};
    if (const auto wired = settings.tools.find(order.wired); wired != settings.tools.end()) {
        settings.wired = {pluggedTool(wired->second)};
        settings.tools.erase(wired);
    }
    return settings;
}

Result<QJsonObject> serve(const std::filesystem::path& folder, const SimulationOrder& order,
                          SeenPose poseOf)
{
    const std::filesystem::path link = std::filesystem::absolute(folder) / "port";
    auto line = order.port ? PolarisLine::tcp(*order.port) : PolarisLine::terminal(link);
    if (!line)
        return tl::unexpected(line.error());
    const std::string address =
        order.port ? "127.0.0.1:" + std::to_string(*order.port) : link.string();
    const TrackerDescription described = descriptionOf(order, address);
    const std::filesystem::path file = folder / "tracker.json";
    if (const auto wrote = writeTrackerFile(file, described); !wrote)
        return tl::unexpected(wrote.error());
    announce(file, described);
    PolarisDevice device{settingsOf(order), statedPoses(order, std::move(poseOf))};
    const LocalTime begin = monotonicNow();
    FaultMaker faults{device, order.fault, order.faulty(), begin};
    const LocalTime end = begin + std::chrono::seconds{order.seconds};
    const PolarisTraffic traffic = line->serve(device, [&](LocalTime now) {
        faults.look(now);
        return now < end;
    });
    return QJsonObject{{polaris_key::kSchema, QLatin1StringView{polaris_key::kSchema.help}},
                       {polaris_key::kFolder, QString::fromStdString(folder.string())},
                       {polaris_key::kServed, toSeconds(monotonicNow() - begin)},
                       {polaris_key::kReceived, qint64(traffic.bytesReceived)},
                       {polaris_key::kReplies, qint64(traffic.replies)},
                       {polaris_key::kSent, qint64(traffic.bytesSent)},
                       {polaris_key::kFaultsMade, faults.made()}};
}

Result<QJsonObject> simulate(const Words& words)
{
    if (words.files().size() != 1)
        return words.refuse(QStringLiteral("needs DIR."));
    const std::filesystem::path folder{words.files()[0].toStdString()};
    const bool isRecorded = words.has(polaris_option::kRecording);
    if (isRecorded && words.has(kPatient))
        return words.refuse(QStringLiteral("takes --patient or --recording, not both."));
    const auto recording =
        isRecorded ? readAnyRecording(words.text(polaris_option::kRecording).toStdString())
                   : Result<TrackerSequence>{};
    if (!recording)
        return tl::unexpected(recording.error());
    const auto named =
        isRecorded ? toolsOf(words, *recording) : Result<std::vector<NamedTool>>{scriptedTools()};
    if (!named)
        return tl::unexpected(named.error());
    auto tools = polarisTools(words, *named, words.text(polaris_option::kTool));
    if (!tools)
        return tl::unexpected(tools.error());
    const auto order = orderOf(words, *std::move(tools));
    if (!order)
        return tl::unexpected(order.error());
    if (const auto opened = openFolder(folder); !opened)
        return tl::unexpected(opened.error());
    auto poseOf = isRecorded ? Result<SeenPose>{recordedSight(*recording)}
                             : scriptedSight(words, order->tools);
    if (!poseOf)
        return tl::unexpected(poseOf.error());
    return serve(folder, *order, *std::move(poseOf));
}

} // namespace

Command polarisCommand()
{
    return {
        .name = "polaris-sim",
        .theme = "tracking",
        .summary = "serves a Polaris without hardware",
        .uses = {{.lines = {"DIR [--patient WHO | --recording FILE]",
                            "DIR [--tcp PORT] [--seconds N] [--noise-mm MM]",
                            "DIR [--tool TOOL=FILE] [--hide TOOL] [--wired TOOL] [--old]",
                            "DIR [--fault KIND]"},
                  .text = "Serves a simulated Polaris that states what the simulated tracker "
                          "measures of scripted hands at the patient's manikin, or the tools of a "
                          "recording, at a pseudo-terminal whose rate paces its replies, or at a "
                          "TCP port. DIR/tracker.json, "
                          "which is written with the definitions of its tools, is for --tracker "
                          "of carina-trainee and carina-registration. That it serves, where, and "
                          "which file defines which tool is told on stderr.",
                  .options = {kPatient, polaris_option::kRecording, polaris_option::kTcp,
                              polaris_option::kSeconds, polaris_option::kNoise,
                              polaris_option::kTool, polaris_option::kHide, polaris_option::kWired,
                              polaris_option::kOld, polaris_option::kFault},
                  .schema = polaris_key::kSchema,
                  .keys = {polaris_key::kFolder, polaris_key::kServed, polaris_key::kReceived,
                           polaris_key::kReplies, polaris_key::kSent, polaris_key::kFaultsMade}}},
        .mostFiles = 1,
        .reminder = "polaris-sim needs DIR.",
        .experiment = simulate};
}

} // namespace carina::lab
