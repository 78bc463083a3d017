#include "evaluation/polaris/polaris_device.h"

#include "evaluation/polaris/polaris_bytes.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

using polaris::asText;
using polaris::error;

constexpr int kFirstRate = 9600;
constexpr int kBitsOfAByte = 10;
constexpr Duration kThinking = std::chrono::microseconds{500}; // before it answers
const std::string kOkay = "OKAY";
constexpr unsigned kInterference = 0x0002; // of the system

} // namespace

PolarisDevice::PolarisDevice(Settings settings, PoseOf poseOf)
    : m_settings{std::move(settings)},
      m_poseOf{std::move(poseOf)},
      m_ports{m_settings.wired, m_settings.serialNumber, m_settings.tools}
{
    static_cast<void>(reset(LocalTime{}));
}

PolarisDevice::Reply PolarisDevice::reset(LocalTime now)
{
    m_ports.clear();
    m_received.clear();
    m_rate = kFirstRate;
    m_nextRate.reset();
    m_mode = Mode::Begun;
    m_lineFree = now;
    return sent(asText("RESET"), now);
}

void PolarisDevice::loseRate()
{
    m_rate = kFirstRate;
    m_nextRate.reset();
}

std::vector<PolarisDevice::Reply> PolarisDevice::take(std::span<const std::byte> bytes, int rate,
                                                      LocalTime now)
{
    if (m_settings.hasRate && rate != m_rate)
        return {}; // noise
    std::vector<Reply> replies;
    for (const std::byte each : bytes) {
        const char c = char(std::to_integer<unsigned char>(each));
        if (c != '\r') {
            m_received += c;
            continue;
        }
        const std::string command = std::exchange(m_received, {});
        if (m_faults.isSilent)
            continue;
        if (command.starts_with("RESET:")) {
            replies.push_back(reset(now));
            continue;
        }
        const std::string answered = answer(command, now);
        replies.push_back(sent(answered, now));
        m_rate = std::exchange(m_nextRate, std::nullopt).value_or(m_rate);
    }
    return replies;
}

PolarisDevice::Reply PolarisDevice::sent(std::string bytes, LocalTime now)
{
    if (std::exchange(m_faults.corruptsNext, false))
        bytes[bytes.size() / 2] ^= 0x04;
    if (std::exchange(m_faults.cutsNext, false))
        bytes.resize(bytes.size() / 2);
    LocalTime at = std::max(now + kThinking, m_lineFree);
    if (m_settings.hasRate)
        at += Duration{std::int64_t(1e9 * kBitsOfAByte * double(bytes.size()) / m_rate)};
    m_lineFree = at;
    return {std::move(bytes), at};
}

std::string PolarisDevice::answer(const std::string& command, LocalTime now)
{
    const std::size_t colon = command.find(':');
    if (colon == std::string::npos || command.size() < colon + 5)
        return asText(error(0x01));
    const std::string content = command.substr(0, command.size() - 4);
    if (asText(content) != command + "\r")
        return asText(error(0x04));
    const std::string name = content.substr(0, colon);
    const std::string arguments = content.substr(colon + 1);
    if (const auto constant = m_settings.constants.find(content);
        constant != m_settings.constants.end())
        return asText(constant->second);
    if (name == "COMM")
        return asText(setRate(arguments));
    if (const auto changed = changeMode(name, now))
        return asText(*changed);
    const bool changesPorts = name == "PINIT" || name == "PENA" || name == "PHF" || name == "PVWR";
    if (m_mode == Mode::Begun || (m_mode == Mode::Tracking && changesPorts))
        return asText(error(0x0C));
    if (const auto told = poses(name, arguments, now))
        return *told;
    return asText(m_ports.answer(name, arguments).value_or(error(0x01)));
}

std::string PolarisDevice::setRate(const std::string& arguments)
{
    static const std::map<char, int> kRates{{'0', 9600},   {'1', 14400},   {'2', 19200},
                                            {'3', 38400},  {'4', 57600},   {'5', 115200},
                                            {'6', 921600}, {'7', 1228739}, {'A', 230400}};
    const auto rate = kRates.find(arguments.empty() ? '?' : arguments[0]);
    if (rate == kRates.end() || std::ranges::count(m_settings.rates, rate->second) == 0)
        return error(0x23);
    m_nextRate = rate->second;
    return kOkay;
}

/// Nothing for a command that changes none.
std::optional<std::string> PolarisDevice::changeMode(const std::string& name, LocalTime now)
{
    const auto from = [this](Mode needed, Mode next) {
        if (m_mode != needed)
            return error(0x0C);
        m_mode = next;
        return kOkay;
    };
    if (name == "INIT") {
        if (m_settings.isStrict && m_mode == Mode::Tracking)
            return error(0x0C);
        if (!m_settings.isStrict)
            m_ports.clear();
        m_mode = Mode::Initialised;
        return kOkay;
    }
    if (name == "TSTART") {
        m_trackingSince = now;
        return m_mode == Mode::Tracking ? kOkay : from(Mode::Initialised, Mode::Tracking);
    }
    if (name == "TSTOP")
        return m_mode == Mode::Initialised ? kOkay : from(Mode::Tracking, Mode::Initialised);
    if (name == "DSTART")
        return from(Mode::Initialised, Mode::Diagnosing);
    if (name == "DSTOP")
        return from(Mode::Diagnosing, Mode::Initialised);
    if (name == "IRINIT")
        return from(Mode::Diagnosing, Mode::Diagnosing);
    return std::nullopt;
}

/// Nothing for a command that asks for none.
std::optional<std::string> PolarisDevice::poses(const std::string& name, const std::string& options,
                                                LocalTime now) const
{
    if (name != "TX" && name != "BX" && name != "BX2")
        return std::nullopt;
    if (m_mode != Mode::Tracking)
        return asText(error(0x0C));
    const PolarisExposure seen = exposureAt(now);
    if (name == "TX")
        return textReply(seen, options);
    if (!m_settings.hasBinary || (name == "BX2" && !m_settings.hasGeneral))
        return asText(error(0x01));
    return name == "BX" ? binaryReply(seen, options) : generalReply(seen);
}

PolarisExposure PolarisDevice::exposureAt(LocalTime now) const
{
    PolarisExposure seen;
    seen.frame = std::uint32_t(toSeconds(now - m_trackingSince) * m_settings.exposuresPerSecond);
    seen.time = m_trackingSince + fromSeconds(seen.frame / m_settings.exposuresPerSecond);
    for (const auto& [handle, port] : m_ports.all())
        if (port.isEnabled)
            seen.tools.push_back(toolAt(handle, port, seen.time));
    seen.system = m_ports.changes() | (m_faults.hasInterference ? kInterference : 0);
    seen.strays_mm = m_settings.strays(seen.time);
    seen.time += m_faults.clockSetBy;
    return seen;
}

PolarisExposure::Tool PolarisDevice::toolAt(int handle, const PolarisPorts::Port& port,
                                            LocalTime exposed) const
{
    PolarisExposure::Tool tool{.handle = handle, .status = port.status()};
    tool.isPlugged = port.isOccupied;
    const auto lost = m_faults.losses.find(port.tool);
    const auto place = m_faults.places.find(port.tool);
    if (!port.isOccupied)
        return tool;
    if (place != m_faults.places.end())
        tool.place = place->second;
    if (lost != m_faults.losses.end())
        tool.loss = lost->second;
    else if (m_faults.hasInterference)
        tool.loss = PolarisLoss::Interference;
    else
        tool.pose = m_poseOf(port.tool, exposed);
    return tool;
}

} // namespace carina
