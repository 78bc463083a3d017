#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/vec.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// A pose as a Polaris states it.
struct PolarisPose {
    Quat q = Quat::Identity();
    Vec3 p_mm = Vec3::Zero();
    double error_mm = 0.0;
};

/// What goes wrong, on demand.
struct PolarisFaults {
    bool isSilent = false;     ///< answers nothing
    bool corruptsNext = false; ///< one bit of the next reply is wrong
    bool cutsNext = false;     ///< the second half of the next reply is missing
};

/// A Polaris without hardware: answers commands as the table of NDI's commands says, and paces the
/// bytes of its replies at the rate of its serial line. Without port and clock. Written from that
/// table alone: it shares no code with the client that it is there to test.
class PolarisDevice
{
public:
    /// The pose of a tool at a time; nothing while it is not seen. A tool is named by its part
    /// number, or by its number among the wired ones: "wired 1".
    using PoseOf = std::function<std::optional<PolarisPose>(const std::string& tool, LocalTime t)>;

    struct Settings {
        int wiredTools = 0;
        double exposuresPerSecond = 60.0;
        /// Rates that it can be set to, in bits a second.
        std::vector<int> rates{9600, 14400, 19200, 38400, 57600, 115200, 921600};
        bool hasRate = true;   ///< a serial line; else its bytes take no time
        bool hasBinary = true; ///< understands BX; else an error
    };

    /// A reply, and when its last byte is there.
    struct Reply {
        std::string bytes;
        LocalTime at;
    };

    PolarisDevice(Settings settings, PoseOf poseOf);

    /// Bytes that were sent at a rate. @returns the replies to whole commands.
    [[nodiscard]] std::vector<Reply> take(std::span<const std::byte> bytes, int rate,
                                          LocalTime now);
    /// The line's break, which resets it.
    [[nodiscard]] Reply takeBreak(LocalTime now) { return reset(now); }
    /// As after it was switched off and on.
    [[nodiscard]] Reply reset(LocalTime now);

    PolarisFaults& faults() { return m_faults; }
    [[nodiscard]] int rate() const { return m_rate; }
    [[nodiscard]] bool isTracking() const { return m_isTracking; }

private:
    struct Port {
        std::string tool{};
        std::string definition{}; ///< of a wireless tool, as loaded
        bool isWireless = false;
        bool isInitialised = false;
        bool isEnabled = false;
    };

    [[nodiscard]] std::string answer(const std::string& command, LocalTime now);
    [[nodiscard]] std::string answerPort(const std::string& name, const std::string& arguments);
    [[nodiscard]] std::string loadDefinition(const std::string& arguments);
    [[nodiscard]] std::string initialise(Port& port) const;
    [[nodiscard]] std::string listPorts(int which) const;
    [[nodiscard]] std::string textPoses(const std::string& options, LocalTime now) const;
    [[nodiscard]] std::string binaryPoses(LocalTime now) const;
    [[nodiscard]] std::string generalPoses(LocalTime now) const;
    [[nodiscard]] std::uint32_t frameAt(LocalTime now) const;
    [[nodiscard]] LocalTime exposureAt(LocalTime now) const;
    [[nodiscard]] Reply sent(std::string bytes, LocalTime now);

    Settings m_settings;
    PoseOf m_poseOf;
    PolarisFaults m_faults;
    std::map<int, Port> m_ports; ///< by handle
    std::string m_received;
    int m_rate = 9600;
    std::optional<int> m_nextRate; ///< from the end of the present reply on
    bool m_isInitialised = false;
    bool m_isTracking = false;
    LocalTime m_trackingSince{};
    LocalTime m_lineFree{}; ///< when the last byte of the last reply was sent
};

} // namespace carina
