#include "evaluation/polaris/polaris_device.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <utility>

namespace carina
{
namespace
{

constexpr int kFirstRate = 9600;
constexpr int kBitsOfAByte = 10;
constexpr Duration kThinking = std::chrono::microseconds{500}; // before it answers
constexpr std::size_t kDefinition = 752;
constexpr std::size_t kPartNumberAt = 592;
constexpr std::size_t kPartNumberBytes = 20;
const std::string kOkay = "OKAY";

// The check table of the CRC: a byte at a time.
const std::array<std::uint16_t, 256>& crcTable()
{
    static const auto table = [] {
        std::array<std::uint16_t, 256> made{};
        for (unsigned i = 0; i < made.size(); ++i) {
            unsigned value = i;
            for (int bit = 0; bit < 8; ++bit)
                value = (value % 2 == 1) ? value / 2 ^ 0xA001U : value / 2;
            made[i] = static_cast<std::uint16_t>(value);
        }
        return made;
    }();
    return table;
}

unsigned crcOf(const std::string& bytes)
{
    unsigned crc = 0;
    for (const char c : bytes)
        crc = crcTable()[(crc ^ static_cast<unsigned char>(c)) & 0xFFU] ^ (crc >> 8U);
    return crc;
}

template <class... Values> std::string written(const char* format, Values... values)
{
    std::array<char, 96> text{};
    // NOLINTNEXTLINE(*-vararg): digits, as the table has them
    const int length = std::snprintf(text.data(), text.size(), format, values...);
    return {text.data(), std::size_t(std::max(0, length))};
}

std::string asText(const std::string& content)
{
    return content + written("%04X", crcOf(content)) + "\r";
}

std::string error(unsigned code) { return "ERROR" + written("%02X", code); }

std::string little(std::uint64_t value, int bytes)
{
    std::string out;
    for (int i = 0; i < bytes; ++i)
        out += char(value >> (8 * i) & 0xFFU);
    return out;
}

std::string real(double value) { return little(std::bit_cast<std::uint32_t>(float(value)), 4); }

/// A body with a header and both checksums around it.
std::string asBinary(const std::string& body)
{
    const std::string begin = little(0xA5C4, 2) + little(body.size(), 2);
    return begin + little(crcOf(begin), 2) + body + little(crcOf(body), 2);
}

std::string realPose(const PolarisPose& pose)
{
    std::string out;
    for (const double number : {pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z(), pose.p_mm.x(),
                                pose.p_mm.y(), pose.p_mm.z(), pose.error_mm})
        out += real(number);
    return out;
}

std::string textPose(const PolarisPose& pose)
{
    std::string out;
    for (const double number : {pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()})
        out += written("%+06ld", std::lround(number * 1e4));
    for (const double number : pose.p_mm)
        out += written("%+07ld", std::lround(number * 1e2));
    return out + written("%+06ld", std::lround(pose.error_mm * 1e4));
}

std::optional<unsigned> hexadecimal(const std::string& digits)
{
    unsigned value = 0;
    if (digits.empty() || digits.find_first_not_of("0123456789ABCDEF") != std::string::npos)
        return std::nullopt;
    for (const char c : digits)
        value = 16 * value + unsigned(c <= '9' ? c - '0' : c - 'A' + 10);
    return value;
}

constexpr unsigned kOccupied = 0x001;
constexpr unsigned kInitialisedBit = 0x010;
constexpr unsigned kEnabledBit = 0x020;

} // namespace

PolarisDevice::PolarisDevice(Settings settings, PoseOf poseOf)
    : m_settings{std::move(settings)}, m_poseOf{std::move(poseOf)}
{
    static_cast<void>(reset(LocalTime{}));
}

PolarisDevice::Reply PolarisDevice::reset(LocalTime now)
{
    m_ports.clear();
    for (int i = 1; i <= m_settings.wiredTools; ++i)
        m_ports[i] = {.tool = "wired " + std::to_string(i)};
    m_received.clear();
    m_rate = kFirstRate;
    m_nextRate.reset();
    m_isInitialised = false;
    m_isTracking = false;
    m_lineFree = now;
    return sent(asText("RESET"), now);
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
    if (name == "COMM") {
        static const std::map<char, int> kRates{{'0', 9600},   {'1', 14400},   {'2', 19200},
                                                {'3', 38400},  {'4', 57600},   {'5', 115200},
                                                {'6', 921600}, {'7', 1228739}, {'A', 230400}};
        const auto rate = kRates.find(arguments.empty() ? '?' : arguments[0]);
        if (rate == kRates.end() || std::ranges::count(m_settings.rates, rate->second) == 0)
            return asText(error(0x23));
        m_nextRate = rate->second;
        return asText(kOkay);
    }
    if (name == "INIT") {
        std::erase_if(m_ports, [](const auto& entry) { return entry.second.isWireless; });
        m_isInitialised = true;
        return asText(kOkay);
    }
    if (!m_isInitialised)
        return asText(error(0x0C));
    if (name == "TSTART") {
        m_isTracking = true;
        m_trackingSince = now;
        return asText(kOkay);
    }
    if (name == "TSTOP") {
        m_isTracking = false;
        return asText(kOkay);
    }
    const bool asks = name == "TX" || name == "BX" || name == "BX2";
    if (asks && !m_isTracking)
        return asText(error(0x0C));
    if (name == "TX")
        return asText(textPoses(arguments, now));
    if (name == "BX" && m_settings.hasBinary)
        return asBinary(binaryPoses(now));
    if (name == "BX2" && m_settings.hasBinary)
        return asBinary(generalPoses(now));
    return asText(answerPort(name, arguments));
}

std::string PolarisDevice::answerPort(const std::string& name, const std::string& arguments)
{
    if (name == "PHSR")
        return listPorts(arguments.empty() ? 0 : arguments.back() - '0');
    if (name == "PHRQ") {
        int handle = 1;
        while (m_ports.contains(handle))
            ++handle;
        m_ports[handle] = {.definition = std::string(1024, '\0'), .isWireless = true};
        return written("%02X", unsigned(handle));
    }
    if (name == "PVWR")
        return loadDefinition(arguments);
    const auto handle = hexadecimal(arguments.substr(0, 2));
    const auto port = m_ports.find(int(handle.value_or(0)));
    if (port == m_ports.end())
        return error(0x2B);
    if (name == "PINIT")
        return initialise(port->second);
    if (name == "PHF") {
        m_ports.erase(port);
        return kOkay;
    }
    if (name == "PENA" || name == "PDIS") {
        if (!port->second.isInitialised)
            return error(0x23);
        port->second.isEnabled = name == "PENA";
        return kOkay;
    }
    return error(0x01);
}

std::string PolarisDevice::loadDefinition(const std::string& arguments)
{
    const auto handle = hexadecimal(arguments.substr(0, 2));
    const auto at = hexadecimal(arguments.size() > 6 ? arguments.substr(2, 4) : std::string{});
    const auto port = m_ports.find(int(handle.value_or(0)));
    if (port == m_ports.end() || !port->second.isWireless)
        return error(0x2B);
    if (!at || arguments.size() != 6 + 128 || *at + 64 > port->second.definition.size())
        return error(0x23);
    for (std::size_t i = 0; i < 64; ++i) {
        const auto byte = hexadecimal(arguments.substr(6 + 2 * i, 2));
        if (!byte)
            return error(0x23);
        port->second.definition[*at + i] = char(*byte);
    }
    return kOkay;
}

/// A wireless tool has to have a whole definition; its part number is its name here.
std::string PolarisDevice::initialise(Port& port) const
{
    if (port.isWireless) {
        unsigned sum = 0;
        for (std::size_t i = 6; i < kDefinition; ++i)
            sum += static_cast<unsigned char>(port.definition[i]);
        if (port.definition.substr(0, 3) != "NDI"
            || little(sum & 0xFFFFU, 2) != port.definition.substr(4, 2))
            return error(0x13);
        port.tool = port.definition.substr(kPartNumberAt, kPartNumberBytes).c_str();
    }
    port.isInitialised = true;
    return kOkay;
}

/// 00 all, 01 to be freed, 02 to be initialised, 03 to be enabled, 04 enabled.
std::string PolarisDevice::listPorts(int which) const
{
    std::string entries;
    unsigned count = 0;
    for (const auto& [handle, port] : m_ports) {
        const bool listed = which == 0 || (which == 2 && !port.isInitialised)
                            || (which == 3 && port.isInitialised && !port.isEnabled)
                            || (which == 4 && port.isEnabled);
        if (!listed)
            continue;
        const unsigned status = kOccupied | (port.isInitialised ? kInitialisedBit : 0)
                                | (port.isEnabled ? kEnabledBit : 0);
        entries += written("%02X%03X", unsigned(handle), status);
        ++count;
    }
    return written("%02X", count) + entries;
}

std::uint32_t PolarisDevice::frameAt(LocalTime now) const
{
    return std::uint32_t(toSeconds(now - m_trackingSince) * m_settings.exposuresPerSecond);
}

LocalTime PolarisDevice::exposureAt(LocalTime now) const
{
    return m_trackingSince + fromSeconds(frameAt(now) / m_settings.exposuresPerSecond);
}

std::string PolarisDevice::textPoses(const std::string& options, LocalTime now) const
{
    if (options != "0001" && options != "0801")
        return error(0x23);
    std::string tools;
    unsigned count = 0;
    for (const auto& [handle, port] : m_ports) {
        if (!port.isEnabled)
            continue;
        ++count;
        const auto pose = m_poseOf(port.tool, exposureAt(now));
        tools += written("%02X", unsigned(handle)) + (pose ? textPose(*pose) : "MISSING")
                 + written("%08X%08X\n", 0x31U, unsigned(frameAt(now)));
    }
    return written("%02X", count) + tools + "0000";
}

std::string PolarisDevice::binaryPoses(LocalTime now) const
{
    std::string tools;
    int count = 0;
    for (const auto& [handle, port] : m_ports) {
        if (!port.isEnabled)
            continue;
        ++count;
        const auto pose = m_poseOf(port.tool, exposureAt(now));
        tools += little(std::uint64_t(handle), 1) + (pose ? "\x01" + realPose(*pose) : "\x02")
                 + little(0x31, 4) + little(frameAt(now), 4);
    }
    return little(std::uint64_t(count), 1) + tools + little(0, 2);
}

std::string PolarisDevice::generalPoses(LocalTime now) const
{
    std::string tools;
    std::uint64_t count = 0;
    for (const auto& [handle, port] : m_ports) {
        if (!port.isEnabled)
            continue;
        ++count;
        const auto pose = m_poseOf(port.tool, exposureAt(now));
        tools += little(std::uint64_t(handle), 2)
                 + (pose ? little(0, 2) + realPose(*pose) : little(0x011F, 2));
    }
    const auto component = [](std::uint64_t type, std::uint64_t items, const std::string& bytes) {
        return little(type, 2) + little(12 + bytes.size(), 4) + little(0, 2) + little(items, 4)
               + bytes;
    };
    const auto time = std::uint64_t(exposureAt(now).time_since_epoch().count());
    const std::string frame = little(1, 1) + little(0, 1) + little(0, 2) + little(frameAt(now), 4)
                              + little(time / 1'000'000'000, 4) + little(time % 1'000'000'000, 4)
                              + little(1, 2) + little(1, 2) + component(2, count, tools);
    return little(1, 2) + little(1, 2) + component(1, 1, frame);
}

} // namespace carina
