#include "engine/net/devices/serial_ports.h"

#include <QSerialPortInfo>

#include <algorithm>

namespace carina
{

std::vector<SerialPortFound> serialPorts()
{
    std::vector<SerialPortFound> found;
    for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts())
        found.push_back({port.systemLocation().toStdString(), port.description().toStdString()});
    std::ranges::stable_partition(
        found, [](const SerialPortFound& port) { return !port.description.empty(); });
    return found;
}

} // namespace carina
