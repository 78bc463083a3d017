#include "evaluation/polaris/polaris_ports.h"

#include "evaluation/polaris/polaris_bytes.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

using polaris::error;
using polaris::hexadecimal;
using polaris::written;

const std::string kDone = "OKAY";

constexpr std::size_t kDefinition = 752;
constexpr std::size_t kLoaded = 1024; // by sixteen blocks
constexpr std::size_t kToldPartNumber = 20;

constexpr unsigned kOccupied = 0x001;
constexpr unsigned kInitialised = 0x010;
constexpr unsigned kEnabled = 0x020;

constexpr unsigned kBecameOccupied = 0x0040; // of the system
constexpr unsigned kBecameUnoccupied = 0x0080;

/// Of PHINF, in the order of the answer.
constexpr unsigned kTellsInformation = 0x0001;
constexpr unsigned kTellsElectricalTest = 0x0002;
constexpr unsigned kTellsPartNumber = 0x0004;
constexpr unsigned kTellsAccessories = 0x0008;
constexpr unsigned kTellsMarkers = 0x0010;
constexpr unsigned kTellsLocation = 0x0020;
constexpr unsigned kTellsKnown = 0x003F;
const std::string kAccessoriesOfWireless = "01";

std::string padded(std::string text, std::size_t width)
{
    text.resize(width, ' ');
    return text;
}

std::string nameOfWired(std::size_t wired) { return "wired " + std::to_string(wired); }

} // namespace

unsigned PolarisPorts::Port::status() const
{
    return (isOccupied ? kOccupied : 0) | (isInitialised ? kInitialised : 0)
           | (isEnabled ? kEnabled : 0);
}

PluggedTool pluggedTool(const PolarisTool& tool)
{
    return {.information = tool.information, .partNumber = tool.partNumber};
}

PolarisPorts::PolarisPorts(std::vector<PluggedTool> plugged, std::string serialNumber,
                           std::map<std::string, PolarisTool> tools)
    : m_plugged{std::move(plugged)},
      m_serialNumber{std::move(serialNumber)},
      m_tools{std::move(tools)}
{
    std::ranges::sort(m_plugged, {}, &PluggedTool::port);
}

std::optional<std::string> PolarisPorts::answer(const std::string& name,
                                                const std::string& arguments)
{
    if (name == "PHSR")
        return list(arguments.empty() ? 0 : arguments.back() - '0');
    if (name == "PHRQ")
        return request();
    if (name == "PVWR")
        return load(arguments);
    if (name != "PINIT" && name != "PHF" && name != "PENA" && name != "PDIS" && name != "PHINF")
        return std::nullopt;
    const auto found = m_ports.find(int(hexadecimal(arguments.substr(0, 2)).value_or(0)));
    if (found == m_ports.end())
        return error(0x2B);
    Port& port = found->second;
    if (name == "PINIT")
        return initialise(port);
    if (name == "PHINF")
        return information(port, hexadecimal(arguments.substr(2)).value_or(0));
    if (name == "PHF") {
        m_ports.erase(found);
        return kDone;
    }
    if (!port.isInitialised)
        return error(0x23);
    port.isEnabled = name == "PENA";
    return kDone;
}

void PolarisPorts::unplug(std::size_t wired)
{
    m_out.insert(wired);
    m_changes |= kBecameUnoccupied;
    for (auto& [handle, port] : m_ports)
        if (port.tool == nameOfWired(wired))
            port.isOccupied = false;
}

void PolarisPorts::plugIn(std::size_t wired)
{
    m_out.erase(wired);
    m_changes |= kBecameOccupied;
}

int PolarisPorts::freeHandle() const
{
    int handle = 1;
    while (m_ports.contains(handle))
        ++handle;
    return handle;
}

/// Each gets a handle the first time.
void PolarisPorts::findPlugged()
{
    for (std::size_t i = 0; i < m_plugged.size(); ++i) {
        const std::string name = nameOfWired(i + 1);
        const bool isFound = std::ranges::any_of(m_ports, [&](const auto& entry) {
            return entry.second.tool == name && entry.second.isOccupied;
        });
        if (!isFound && !m_out.contains(i + 1))
            m_ports[freeHandle()] = {.tool = name, .plugged = m_plugged[i]};
    }
}

/// 00 all, 01 to be freed, 02 to be initialised, 03 to be enabled, 04 enabled.
std::string PolarisPorts::list(int which)
{
    m_changes = 0;
    if (which == 0 || which == 2)
        findPlugged();
    std::string entries;
    unsigned count = 0;
    for (const auto& [handle, port] : m_ports) {
        const bool isIn = port.isOccupied;
        const bool listed = which == 0 || (which == 1 && !isIn)
                            || (which == 2 && isIn && !port.isInitialised)
                            || (which == 3 && isIn && port.isInitialised && !port.isEnabled)
                            || (which == 4 && isIn && port.isEnabled);
        if (!listed)
            continue;
        entries += written("%02X%03X", unsigned(handle), port.status());
        ++count;
    }
    return written("%02X", count) + entries;
}

std::string PolarisPorts::request()
{
    const int handle = freeHandle();
    m_ports[handle] = {.definition = std::string(kLoaded, '\0')};
    return written("%02X", unsigned(handle));
}

std::string PolarisPorts::load(const std::string& arguments)
{
    const auto handle = hexadecimal(arguments.substr(0, 2));
    const auto at = hexadecimal(arguments.size() > 6 ? arguments.substr(2, 4) : std::string{});
    const auto port = m_ports.find(int(handle.value_or(0)));
    if (port == m_ports.end() || port->second.plugged)
        return error(0x2B);
    if (!at || arguments.size() != 6 + 128 || *at + 64 > kLoaded)
        return error(0x23);
    for (std::size_t i = 0; i < 64; ++i) {
        const auto byte = hexadecimal(arguments.substr(6 + 2 * i, 2));
        if (!byte)
            return error(0x23);
        port->second.definition[*at + i] = char(*byte);
    }
    return kDone;
}

/// A wireless tool has to have a whole definition.
std::string PolarisPorts::initialise(Port& port) const
{
    if (!port.plugged) {
        const auto loaded = polarisTool(port.definition.substr(0, kDefinition));
        if (!loaded)
            return error(0x13);
        port.loaded = *loaded;
        port.tool = nameOf(*loaded);
    }
    port.isInitialised = true;
    return port.plugged && port.plugged->warns ? "WARNING" : kDone;
}

/// That of the tool which has these markers; none fits where no tool does.
std::string PolarisPorts::nameOf(const PolarisTool& loaded) const
{
    if (m_tools.empty())
        return loaded.partNumber;
    const auto same = std::ranges::find_if(
        m_tools, [&](const auto& named) { return haveSameMarkers(named.second, loaded); });
    return same == m_tools.end() ? std::string{} : same->first;
}

/// What is not known before a tool is initialised is blank or zero.
std::string PolarisPorts::information(const Port& port, unsigned options) const
{
    if (options == 0 || (options & ~kTellsKnown) != 0)
        return error(0x23);
    const PluggedTool unknown{.information = "00000000" + std::string(12, ' ') + "00000000000"};
    PluggedTool told = unknown;
    if (port.isInitialised && port.plugged)
        told = *port.plugged;
    else if (port.isInitialised && port.loaded) {
        told = pluggedTool(*port.loaded);
        told.accessories = kAccessoriesOfWireless;
    }
    std::string text;
    if ((options & kTellsInformation) != 0)
        text += told.information + written("%02X", port.status() & 0xFFU);
    if ((options & kTellsElectricalTest) != 0)
        text += told.electricalTest;
    if ((options & kTellsPartNumber) != 0)
        text += padded(told.partNumber, kToldPartNumber);
    if ((options & kTellsAccessories) != 0)
        text += told.accessories;
    if ((options & kTellsMarkers) != 0)
        text += told.markers;
    if ((options & kTellsLocation) != 0)
        text += location(port);
    return text;
}

/// The device, the system, whether it is wireless, the port and the channel.
std::string PolarisPorts::location(const Port& port) const
{
    return padded(m_serialNumber, 8)
           + (port.plugged ? written("00%02d00", port.plugged->port) : "010A00");
}

} // namespace carina
