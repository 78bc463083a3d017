#pragma once

#include <string>
#include <vector>

namespace carina
{

/// A serial port of this computer.
struct SerialPortFound {
    std::string address;     ///< "/dev/ttyUSB0"
    std::string description; ///< as its adapter tells it: "FT232R USB UART"; may be empty
};

/// The serial ports that are there now, adapters first.
[[nodiscard]] std::vector<SerialPortFound> serialPorts();

} // namespace carina
