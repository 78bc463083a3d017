#include "engine/net/devices/serial_ports.h"

#include <QSerialPortInfo>

#include <algorithm>
#include <array>

namespace carina
{

std::vector<SerialPortFound> serialPorts()
{
    std::vector<SerialPortFound> found;
    for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts())
        found.push_back({port.systemLocation().toStdString(), port.description().toStdString()});
    std::stable_partition(found.begin(), found.end(),
                          [](const SerialPortFound& port) { return !port.description.empty(); });
    return found;
}

std::span<const int> usualSerialRates()
{
    static constexpr std::array kUsual{921600, 230400, 115200, 57600, 38400, 19200, 9600};
    return kUsual;
}

} // namespace carina
