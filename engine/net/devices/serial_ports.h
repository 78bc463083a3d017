#pragma once

#include <span>
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

/// The rates that an adapter at a serial port usually holds, in bits a second, best first.
[[nodiscard]] std::span<const int> usualSerialRates();

} // namespace carina
