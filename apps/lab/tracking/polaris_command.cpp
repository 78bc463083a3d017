#include "apps/lab/command/patient_options.h"
#include "apps/lab/commands.h"
#include "apps/lab/tracking/simulated_tools.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/files/whole_file.h"
#include "engine/session/simulated_station.h"
#include "evaluation/polaris/polaris_line.h"

#include <array>
#include <filesystem>
#include <random>

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
    Unplug
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
    NamedFault{"unplug", Fault::Unplug}};
constexpr Duration kFaultEvery = std::chrono::seconds{5};
constexpr Duration kFaultLasts = std::chrono::seconds{1}; // one that is not of one reply
const std::string kFaultyTool = "tube";
const std::string kWiredTool = "wired 1"; // the device's name of the only one

struct SimulatedTool {
    const char* name;
    ToolRole role;
};
constexpr std::array kTools{
    SimulatedTool{"head", ToolRole::Head}, SimulatedTool{"jaw", ToolRole::Jaw},
    SimulatedTool{"tube", ToolRole::Tube}, SimulatedTool{"stylus", ToolRole::Stylus}};

namespace polaris_option
{
constexpr Option kTcp{"tcp", "PORT", "at this port of the loopback address instead of a terminal"};
constexpr Option kSeconds{"seconds", "N", "how long it serves, 1 to 86400 (60)"};
constexpr Option kNoise{"noise-mm", "MM",
                        "standard deviation of a position along each axis, 0 to "
                        "10 (0)"};
constexpr Option kHide{"hide", "TOOL", "head, jaw, tube or stylus: is not seen"};
constexpr Option kWired{"wired", "TOOL",
                        "head, jaw, tube or stylus: is plugged into the device, in place of a "
                        "wireless one"};
constexpr Option kOld{"old", "",
                      "it knows TX only, as the first generation: BX and BX2 are errors"};
constexpr Option kFault{"fault", "KIND",
                        "every 5 s: corrupt a bit of a reply, cut a reply, silence for 1 s, "
                        "reset as after the power was cycled, interference by other infrared "
                        "light for 1 s, bad-fit or few-markers of the tube for 1 s, unplug of the "
                        "wired tool for 1 s; none unless given"};
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

/// The description of the tracker and the definitions of its tools, as a technician would write
/// them.
Result<void> writeDescription(const std::filesystem::path& folder, const std::string& address,
                              const std::string& wired)
{
    std::vector<std::pair<std::string, ToolRole>> named;
    for (const SimulatedTool& tool : kTools)
        named.emplace_back(tool.name, tool.role);
    auto tools = simulatedTools(named);
    if (!tools)
        return tl::unexpected(tools.error());
    for (DescribedTool& tool : *tools)
        if (tool.name == wired)
            tool.definition.reset();
    return writeTrackerFile(
        folder / "tracker.json",
        {.address = address, .fastestRate = 115200, .tools = *std::move(tools)});
}

/// What the device states of the scripted hands.
PolarisDevice::PoseOf statedPoses(TrueToolPose truth, double noise_mm, const std::string& hidden,
                                  const std::string& wired)
{
    return [truth = std::move(truth), noise_mm, hidden, wired, random = std::mt19937{7}](
               const std::string& handle, LocalTime t) mutable -> std::optional<PolarisPose> {
        const std::string& name = handle == kWiredTool ? wired : handle;
        const auto* tool = std::ranges::find(kTools, name, &SimulatedTool::name);
        if (tool == kTools.end() || name == hidden)
            return std::nullopt;
        const auto X_TO = truth(tool->role, SessionTime{t.time_since_epoch()});
        if (!X_TO)
            return std::nullopt;
        PolarisPose pose{X_TO->rotation(), 1e3 * X_TO->translation(), noise_mm};
        std::normal_distribution<double> noise;
        for (double& coordinate : pose.p_mm)
            coordinate += noise_mm * noise(random);
        return pose;
    };
}

/// Makes a fault every kFaultEvery.
class FaultMaker
{
public:
    FaultMaker(PolarisDevice& device, Fault fault, const std::string& wired, LocalTime now)
        : m_device{device},
          m_fault{fault},
          m_faultyTool{wired == kFaultyTool ? kWiredTool : kFaultyTool},
          m_next{now + kFaultEvery}
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
Result<std::string> toolOption(const Words& words, const Option& option)
{
    const std::string name = words.text(option).toStdString();
    if (name.empty() || std::ranges::count(kTools, name, &SimulatedTool::name) != 0)
        return name;
    QStringList names;
    for (const SimulatedTool& tool : kTools)
        names << QString::fromLatin1(tool.name);
    return words.unknownWord(option, names);
}

Result<QJsonObject> serve(const Words& words, const std::filesystem::path& folder,
                          const std::string& wired, PolarisDevice::PoseOf poses)
{
    const auto seconds = words.whole(polaris_option::kSeconds, 1, 86400, 60);
    const auto fault = words.word(polaris_option::kFault, kFaults, &NamedFault::fault);
    const auto port = words.whole(polaris_option::kTcp, 1, 65535, 0);
    if (!seconds || !fault || !port)
        return tl::unexpected(!seconds ? seconds.error() : !fault ? fault.error() : port.error());
    if (*fault == Fault::Unplug && wired.empty())
        return words.refuse(QStringLiteral("--fault unplug needs --wired TOOL."));
    const bool isTcp = words.has(polaris_option::kTcp);
    const std::filesystem::path link = std::filesystem::absolute(folder) / "port";
    auto line = isTcp ? PolarisLine::tcp(std::uint16_t(*port)) : PolarisLine::terminal(link);
    if (!line)
        return tl::unexpected(line.error());
    const std::string address = isTcp ? "127.0.0.1:" + std::to_string(*port) : link.string();
    if (const auto wrote = writeDescription(folder, address, wired); !wrote)
        return tl::unexpected(wrote.error());
    PolarisDevice device{{.wired = std::vector<PluggedTool>(wired.empty() ? 0 : 1),
                          .hasRate = !isTcp,
                          .hasBinary = !words.has(polaris_option::kOld)},
                         std::move(poses)};
    const LocalTime begin = monotonicNow();
    FaultMaker faults{device, *fault, wired, begin};
    const LocalTime end = begin + std::chrono::seconds{*seconds};
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
    const auto noise = words.number(polaris_option::kNoise, 0.0, 10.0, 0.0);
    if (!noise)
        return tl::unexpected(noise.error());
    const auto hidden = toolOption(words, polaris_option::kHide);
    const auto wired = toolOption(words, polaris_option::kWired);
    if (!hidden || !wired)
        return tl::unexpected(!hidden ? hidden.error() : wired.error());
    if (const auto opened = openFolder(folder); !opened)
        return tl::unexpected(opened.error());
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
    return serve(words, folder, *wired,
                 statedPoses(std::move(station->truth), *noise, *hidden, *wired));
}

} // namespace

Command polarisCommand()
{
    return {
        .name = "polaris-sim",
        .theme = "tracking",
        .summary = "serves a Polaris without hardware",
        .uses = {{.lines = {"DIR [--patient WHO] [--tcp PORT] [--seconds N]",
                            "DIR [--noise-mm MM] [--hide TOOL] [--wired TOOL] [--old]",
                            "DIR [--fault KIND]"},
                  .text = "Serves a simulated Polaris that sees scripted hands at the "
                          "patient's manikin, at a pseudo-terminal whose rate paces its "
                          "replies, or at a TCP port. DIR/tracker.json, which is written with "
                          "the definitions of its tools, is for --tracker of carina-trainee "
                          "and carina-registration.",
                  .options = {kPatient, polaris_option::kTcp, polaris_option::kSeconds,
                              polaris_option::kNoise, polaris_option::kHide, polaris_option::kWired,
                              polaris_option::kOld, polaris_option::kFault},
                  .schema = polaris_key::kSchema,
                  .keys = {polaris_key::kFolder, polaris_key::kServed, polaris_key::kReceived,
                           polaris_key::kReplies, polaris_key::kSent, polaris_key::kFaultsMade}}},
        .mostFiles = 1,
        .reminder = "polaris-sim needs DIR.",
        .experiment = simulate};
}

} // namespace carina::lab
