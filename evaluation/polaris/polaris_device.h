#pragma once

#include "evaluation/polaris/polaris_ports.h"
#include "evaluation/polaris/polaris_poses.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// What goes wrong, on demand.
struct PolarisFaults {
    bool isSilent = false;        ///< answers nothing
    bool corruptsNext = false;    ///< one bit of the next reply is wrong
    bool cutsNext = false;        ///< the second half of the next reply is missing
    Duration clockSetBy{};        ///< its clock, which BX2 tells, was set by so much
    bool hasInterference = false; ///< too much other infrared light: no tool has a pose
    std::map<std::string, PolarisLoss> losses{};  ///< tools without a pose, and why
    std::map<std::string, PolarisPlace> places{}; ///< tools that are not inside the volume
};

/// A Polaris without hardware: answers commands as the table of NDI's commands says, and paces the
/// bytes of its replies at the rate of its serial line. Without port and clock. Written from that
/// table alone: it shares no code with the client that it is there to test.
class PolarisDevice
{
public:
    /// The pose of a tool at a time; nothing while it is not seen. A wireless tool is named as in
    /// Settings::tools, or where there is none by its part number; a wired one by its number among
    /// the wired ones: "wired 1".
    using PoseOf = std::function<std::optional<PolarisPose>(const std::string& tool, LocalTime t)>;
    /// The markers of no tool that are seen at a time, millimetres.
    using StraysAt = std::function<std::vector<Vec3>(LocalTime t)>;

    struct Settings {
        std::vector<PluggedTool> wired{};
        double exposuresPerSecond = 60.0;
        /// Rates that it can be set to, in bits a second.
        std::vector<int> rates{9600, 14400, 19200, 38400, 57600, 115200, 921600};
        bool hasRate = true;    ///< a serial line; else its bytes take no time
        bool hasBinary = true;  ///< understands BX; else an error, as of the first generation
        bool hasGeneral = true; ///< understands BX2, likewise
        bool isStrict = false;  ///< INIT neither ends tracking nor frees a port
        std::string serialNumber = "P4-00000";
        /// What it answers to commands that ask for what does not change.
        std::map<std::string, std::string> constants{
            {"VER:4", "Simulated Polaris\nNDI S/N: P4-00000\n"}};
        StraysAt strays = [](LocalTime) { return std::vector<Vec3>{}; };
        /// The wireless tools before it, by name. One that is loaded is told by its markers, as a
        /// real device does; one whose markers no tool has is not seen.
        std::map<std::string, PolarisTool> tools{};
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
    /// As after the line's break, or after it was switched off and on.
    [[nodiscard]] Reply reset(LocalTime now);
    /// Its line has the first rate again, and the host is not told: what is sent to it is noise.
    void loseRate();

    PolarisFaults& faults() { return m_faults; }
    PolarisPorts& ports() { return m_ports; }
    [[nodiscard]] int rate() const { return m_rate; }
    [[nodiscard]] bool isTracking() const { return m_mode == Mode::Tracking; }

private:
    enum class Mode : std::uint8_t { Begun, Initialised, Diagnosing, Tracking };

    [[nodiscard]] std::string answer(const std::string& command, LocalTime now);
    [[nodiscard]] std::string setRate(const std::string& arguments);
    [[nodiscard]] std::optional<std::string> changeMode(const std::string& name, LocalTime now);
    [[nodiscard]] std::optional<std::string> poses(const std::string& name,
                                                   const std::string& options, LocalTime now) const;
    [[nodiscard]] PolarisExposure exposureAt(LocalTime now) const;
    [[nodiscard]] PolarisExposure::Tool toolAt(int handle, const PolarisPorts::Port& port,
                                               LocalTime exposed) const;
    [[nodiscard]] Reply sent(std::string bytes, LocalTime now);

    Settings m_settings;
    PoseOf m_poseOf;
    PolarisPorts m_ports;
    PolarisFaults m_faults;
    std::string m_received;
    int m_rate = 9600;
    std::optional<int> m_nextRate; ///< from the end of the present reply on
    Mode m_mode = Mode::Begun;
    LocalTime m_trackingSince{};
    LocalTime m_lineFree{}; ///< when the last byte of the last reply was sent
};

} // namespace carina
