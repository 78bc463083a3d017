#pragma once

#include "engine/core/result.h"
#include "engine/tracking/ndi/ndi_client.h"

#include <QIODevice>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace carina
{

/// Whether an address is that of a serial port, "/dev/ttyUSB0", and not host and port.
[[nodiscard]] bool isSerialPort(const std::string& address);

/// Whether it is one of the two.
[[nodiscard]] bool isDeviceAddress(const std::string& address);

/// The bytes to and from a device: a serial port, or a connection over TCP. Needs a thread with an
/// event loop; all its functions and callbacks are of that thread.
class DevicePort
{
public:
    struct Callbacks {
        std::function<void()> opened;
        std::function<void()> arrived;                      ///< bytes
        std::function<void(const std::string& why)> closed; ///< also where it does not open
    };

    /// @returns WrongAddress where the address is neither a path nor host:port.
    [[nodiscard]] static Result<std::unique_ptr<DevicePort>> make(const std::string& address,
                                                                  Callbacks callbacks);
    virtual ~DevicePort() = default;

    /// Begins to open; one of the callbacks follows, perhaps at once, on the network after two
    /// seconds at most.
    virtual void open() = 0;
    virtual void close() = 0;
    [[nodiscard]] virtual bool isOpen() const = 0;
    /// Whether it can be set to a rate of transmission, bits a second, which it does not keep.
    /// @pre isOpen()
    [[nodiscard]] virtual bool holdsRate(int rate) = 0;
    /// @pre isOpen()
    virtual void act(const NdiPortAction& action) = 0;
    [[nodiscard]] virtual QByteArray readAll() = 0;

    /// Waits, without the event loop, until all of act() has left, but not longer than this.
    void flush(std::chrono::milliseconds patience);
    /// Waits, without the event loop, until bytes have arrived, but not longer than this.
    void await(std::chrono::milliseconds patience);

protected:
    [[nodiscard]] virtual QIODevice& line() = 0;
};

} // namespace carina
