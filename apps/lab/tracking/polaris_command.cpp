#include "apps/lab/command/patient_options.h"
#include "apps/lab/commands.h"
#include "apps/lab/tracking/simulated_tools.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/files/whole_file.h"
#include "engine/net/devices/any_recording.h"
#include "engine/session/simulated_station.h"
#include "engine/tracking/record/recorded_tracker.h"
#include "evaluation/polaris/polaris_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
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
    Unplug,
    WrongRate
};

struct NamedFault {
    std::string_view name;
    Fault fault;
};
constexpr std::array kFaults{
    NamedFault{"none", Fault::None},      NamedFault{"corrupt", Fault::Corrupt},
    NamedFault{"cut", Fault::Cut},        NamedFault{"silence", Fault::Silence},
    NamedFault{"reset", Fault::Reset},    NamedFault{"interference", Fault::Interference},
    NamedFault{"bad-fit", Fault::BadFit}, NamedFault{"few-markers", Fault::FewMarkers},
    NamedFault{"unplug", Fault::Unplug},  NamedFault{"wrong-rate", Fault::WrongRate}};
constexpr Duration kFaultEvery = std::chrono::seconds{5};
constexpr Duration kFaultLasts = std::chrono::seconds{1}; // one that is not of one reply
const std::string kWiredTool = "wired 1";                 // the device's name of the only one
constexpr std::size_t kMostTools = 9;
constexpr std::size_t kLongestName = 20;                    // of a part number
constexpr Duration kStale = std::chrono::milliseconds{200}; // a recorded pose; then none is stated

using NamedTool = std::pair<std::string, ToolRole>;
const std::vector<NamedTool> kScriptedTools{{"head", ToolRole::Head},
                                            {"jaw", ToolRole::Jaw},
                                            {"tube", ToolRole::Tube},
                                            {"stylus", ToolRole::Stylus}};

/// The pose of a tool of a list; nothing while it is not seen.
using SeenPose = std::function<std::optional<PolarisPose>(std::size_t tool, LocalTime t)>;

namespace polaris_option
{
constexpr Option kTcp{"tcp", "PORT", "at this port of the loopback address instead of a terminal"};
constexpr Option kSeconds{"seconds", "N", "how long it serves, 1 to 86400 (60)"};
constexpr Option kNoise{"noise-mm", "MM",
                        "standard deviation of a position along each axis, 0 to "
                        "10 (0)"};
constexpr Option kRecording{"recording", "FILE",
                            "of a tracker, in any form that --tracker recorded:FILE plays: its "
                            "tools, at most nine, are seen in place of scripted hands, again and "
                            "again"};
constexpr Option kHide{"hide", "TOOL",
                       "head, jaw, tube or stylus, or one of the recording: is not seen"};
constexpr Option kWired{"wired", "TOOL",
                        "one of the same: is plugged into the device, in place of a wireless one"};
constexpr Option kOld{"old", "",
                      "it knows TX only, as the first generation: BX and BX2 are errors"};
constexpr Option kFault{"fault", "KIND",
                        "every 5 s: corrupt a bit of a reply, cut a reply, silence for 1 s, "
                        "reset as after the power was cycled, interference by other infrared "
                        "light for 1 s, bad-fit or few-markers of the tube, or of the first tool "
                        "of a recording without one, for 1 s, unplug of the wired tool for 1 s, "
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
    std::vector<NamedTool> tools;
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
        const auto tube = std::ranges::find(tools, ToolRole::Tube, &NamedTool::second);
        const std::string& name = (tube == tools.end() ? tools.front() : *tube).first;
        return name == wired ? kWiredTool : name;
    }
};

/// The description of the tracker and the definitions of its tools, as a technician would write
/// them.
Result<void> writeDescription(const std::filesystem::path& folder, const std::string& address,
                              const SimulationOrder& order)
{
    auto tools = simulatedTools(order.tools);
    if (!tools)
        return tl::unexpected(tools.error());
    for (DescribedTool& tool : *tools)
        if (tool.name == order.wired)
            tool.definition.reset();
    return writeTrackerFile(
        folder / "tracker.json",
        {.address = address, .fastestRate = 115200, .tools = *std::move(tools)});
}

/// What the device states of what it sees.
PolarisDevice::PoseOf statedPoses(const SimulationOrder& order, SeenPose poseOf)
{
    return [order, poseOf = std::move(poseOf), random = std::mt19937{7}](
               const std::string& handle, LocalTime t) mutable -> std::optional<PolarisPose> {
        const std::string& name = handle == kWiredTool ? order.wired : handle;
        const auto tool = std::ranges::find(order.tools, name, &NamedTool::first);
        if (tool == order.tools.end() || name == order.hidden)
            return std::nullopt;
        auto pose = poseOf(std::size_t(tool - order.tools.begin()), t);
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
                               const std::vector<NamedTool>& tools)
{
    const std::string name = words.text(option).toStdString();
    if (name.empty() || std::ranges::count(tools, name, &NamedTool::first) != 0)
        return name;
    QStringList names;
    for (const NamedTool& tool : tools)
        names << QString::fromStdString(tool.first);
    return words.unknownWord(option, names);
}

Result<SimulationOrder> orderOf(const Words& words, std::vector<NamedTool> tools)
{
    const auto seconds = words.whole(polaris_option::kSeconds, 1, 86400, 60);
    const auto port = words.whole(polaris_option::kTcp, 1, 65535, 0);
    const auto noise = words.number(polaris_option::kNoise, 0.0, 10.0, 0.0);
    const auto fault = words.word(polaris_option::kFault, kFaults, &NamedFault::fault);
    const auto hidden = toolOption(words, polaris_option::kHide, tools);
    const auto wired = toolOption(words, polaris_option::kWired, tools);
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

/// Scripted hands at a patient's manikin see kScriptedTools.
Result<SeenPose> scriptedHands(const Words& words)
{
    const auto parameters = patientOption(words, BuiltinPatient::TwelveYears);
    if (!parameters)
        return tl::unexpected(parameters.error());
    const auto dimensions = dimensionsFor(*parameters);
    if (!dimensions)
        return tl::unexpected(dimensions.error());
    const auto patient = patientFor(*parameters);
    if (!patient)
        return tl::unexpected(patient.error());
    const AirwayLandmarks& airway = patient->landmarks;
    const auto tube = makeTube(dimensions->tubeInnerDiameter, airway.path_A, airway.p_A_incisors);
    if (!tube)
        return tl::unexpected(tube.error());
    auto station = simulatedStation(airway, *tube, [] { return std::optional<SessionTime>{}; });
    if (!station)
        return tl::unexpected(station.error());
    return [truth = std::move(station->truth)](std::size_t tool,
                                               LocalTime t) -> std::optional<PolarisPose> {
        const auto X_TO = truth(kScriptedTools[tool].second, SessionTime{t.time_since_epoch()});
        if (!X_TO)
            return std::nullopt;
        return PolarisPose{X_TO->rotation(), 1e3 * X_TO->translation()};
    };
}

/// kWiredTool would be taken for the wired one.
bool canBePartNumber(const std::string& name)
{
    return !name.empty() && name != kWiredTool && name.size() <= kLongestName
           && std::ranges::all_of(name, [](char each) { return each >= ' ' && each <= '~'; });
}

/// The tools of a recording as a device can have them: no role twice.
Result<std::vector<NamedTool>> toolsOf(const Words& words, const TrackerSequence& sequence)
{
    if (sequence.tools.empty() || sequence.tools.size() > kMostTools)
        return words.refuse(QStringLiteral("sees one to nine tools, and the recording has %1.")
                                .arg(sequence.tools.size()));
    std::vector<NamedTool> tools;
    for (const RecordedTool& tool : sequence.tools) {
        if (!canBePartNumber(tool.name)
            || std::ranges::count(tools, tool.name, &NamedTool::first) != 0)
            return words.refuse(QStringLiteral("needs a name of its own for each tool, of at most "
                                               "20 plain characters, not '%1'.")
                                    .arg(QString::fromStdString(tool.name)));
        const bool isTaken = std::ranges::count(tools, tool.role, &NamedTool::second) != 0;
        tools.emplace_back(tool.name, isTaken ? ToolRole::Other : tool.role);
    }
    return tools;
}

/// A recording that is played again and again.
SeenPose recordedPoses(const TrackerSequence& sequence)
{
    // Shared by the copies of the function, however many are made.
    const auto played = std::make_shared<RecordedTracker>(
        sequence, [] { return std::optional<SessionTime>{}; }, Playing::Looped);
    return [played, tools = played->tools()](std::size_t tool,
                                             LocalTime t) -> std::optional<PolarisPose> {
        const SessionTime now{t.time_since_epoch()};
        static_cast<void>(played->advance(now));
        const auto newest = tools[tool].history->newest();
        if (!newest || newest->validity == Validity::Lost || now - newest->time > kStale)
            return std::nullopt;
        return PolarisPose{newest->X_FO.rotation(), 1e3 * newest->X_FO.translation(),
                           1e3 * newest->error};
    };
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
    if (const auto wrote = writeDescription(folder, address, order); !wrote)
        return tl::unexpected(wrote.error());
    PolarisDevice device{{.wired = std::vector<PluggedTool>(order.wired.empty() ? 0 : 1),
                          .hasRate = !order.port,
                          .hasBinary = !order.isOld},
                         statedPoses(order, std::move(poseOf))};
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
    const auto tools =
        isRecorded ? toolsOf(words, *recording) : Result<std::vector<NamedTool>>{kScriptedTools};
    if (!tools)
        return tl::unexpected(tools.error());
    const auto order = orderOf(words, *tools);
    if (!order)
        return tl::unexpected(order.error());
    if (const auto opened = openFolder(folder); !opened)
        return tl::unexpected(opened.error());
    auto poseOf = isRecorded ? Result<SeenPose>{recordedPoses(*recording)} : scriptedHands(words);
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
                            "DIR [--hide TOOL] [--wired TOOL] [--old]", "DIR [--fault KIND]"},
                  .text = "Serves a simulated Polaris that sees scripted hands at the "
                          "patient's manikin, or the tools of a recording, at a pseudo-terminal "
                          "whose rate paces its replies, or at a TCP port. DIR/tracker.json, "
                          "which is written with the definitions of its tools, is for --tracker "
                          "of carina-trainee and carina-registration.",
                  .options = {kPatient, polaris_option::kRecording, polaris_option::kTcp,
                              polaris_option::kSeconds, polaris_option::kNoise,
                              polaris_option::kHide, polaris_option::kWired, polaris_option::kOld,
                              polaris_option::kFault},
                  .schema = polaris_key::kSchema,
                  .keys = {polaris_key::kFolder, polaris_key::kServed, polaris_key::kReceived,
                           polaris_key::kReplies, polaris_key::kSent, polaris_key::kFaultsMade}}},
        .mostFiles = 1,
        .reminder = "polaris-sim needs DIR.",
        .experiment = simulate};
}

} // namespace carina::lab
