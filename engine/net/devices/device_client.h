#pragma once

#include "engine/core/session_time.h"
#include "engine/io/site/devices/tracker_file.h"
#include "engine/tracking/tool_sight.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// What a device says of a tool at one exposure.
struct DeviceSight {
    std::size_t tool = 0; ///< index in the description
    LocalTime exposed{};
    std::optional<RigidTransform> X_TO{};  ///< nothing: there is no pose of it
    Validity validity = Validity::Tracked; ///< of the pose
    double error = 0.0; ///< RMS of the fit, metres; 0 where the device does not tell it
    ToolSight sight = ToolSight::Unsaid;
};

/// What answers at an address.
struct DeviceFound {
    std::string name{};                     ///< that the device gives itself; may be empty
    std::optional<std::size_t> pluggedIn{}; ///< tools in the ports of a device that has ports
    std::vector<std::string> sent{};        ///< names of the tools that a server sends

    friend bool operator==(const DeviceFound&, const DeviceFound&) = default;
};

/// The conversation with a device of some protocol. Without port, clock and thread: the caller
/// tells the time, does what advance() says, and passes on what arrives.
class DeviceClient
{
public:
    virtual ~DeviceClient() = default;

    /// The port is open, and the device in any state.
    /// @param holdsRate whether a serial port can be set to a rate; the port outlives its use
    virtual void start(LocalTime now, HoldsRate holdsRate) = 0;
    /// Bytes that have arrived.
    virtual void take(std::span<const std::byte> bytes, LocalTime now) = 0;
    /// What is to be done now. Call it after start(), after take() and at nextWake().
    [[nodiscard]] virtual NdiPortAction advance(LocalTime now) = 0;
    [[nodiscard]] virtual LocalTime nextWake() const = 0;

    /// What was seen since the last call.
    [[nodiscard]] virtual std::vector<DeviceSight> takeSights() = 0;
    /// Whether the port is to be closed and opened again.
    [[nodiscard]] virtual bool isLost() const = 0;
    /// What keeps a tool, or the device, from tracking; empty if nothing does.
    [[nodiscard]] virtual std::string trouble() const = 0;
    /// Whether the device does not answer; not before that lasts.
    [[nodiscard]] virtual bool isSilent() const = 0;
    /// The device, while it answers.
    [[nodiscard]] virtual std::optional<DeviceFound> found() const = 0;
    /// Leaves the device idle before the port is closed: what that takes is for advance() and
    /// take(), until hasLeft().
    virtual void leave() = 0;
    [[nodiscard]] virtual bool hasLeft() const = 0;
};

/// The client that a description needs, not started.
/// @pre its kind is that of a device at a port.
[[nodiscard]] std::unique_ptr<DeviceClient> deviceClient(const TrackerDescription& description);

} // namespace carina
