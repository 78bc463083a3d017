#pragma once

#include "engine/core/session_time.h"
#include "engine/tracking/ndi/ndi_command.h"
#include "engine/tracking/ndi/ndi_frame.h"
#include "engine/tracking/ndi/ndi_reply.h"
#include "engine/tracking/ndi/tool_definition.h"

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// A tool that a tracker of NDI is to track.
struct NdiWantedTool {
    std::string name;
    /// Of a wireless tool, which is told to the device; nothing for one that is plugged in. The
    /// wired tools of the list are those of the device's ports, in ascending order.
    std::optional<NdiToolDefinition> definition{};
};

/// How poses are asked for.
enum class NdiPoseReply : std::uint8_t { Tx, Bx, Bx2 };

struct NdiClientSettings {
    std::vector<NdiWantedTool> tools;
    NdiPoseReply poses = NdiPoseReply::Bx;
    /// Whether the device is at a serial port, which has a rate and is reset by a break.
    bool isSerial = true;
    /// Rates of transmission that the host's port can hold, in bits a second, best first; of those
    /// that COMM can set.
    std::vector<int> rates{921600, 115200, 57600, 38400, 19200, 9600};
};

/// What is to be done at the port now, in this order.
struct NdiPortAction {
    std::optional<int> rate{}; ///< set the host's rate
    bool sendBreak = false;
    std::string bytes{}; ///< to send
};

/// Poses of the wanted tools at one exposure.
struct NdiMeasurement {
    LocalTime exposed;
    /// One for each wanted tool, in their order; nothing for one that the device does not have.
    std::vector<std::optional<NdiTool>> tools;
};

/// A client of a tracker of NDI: brings it from whatever state it is in to tracking, asks for
/// poses, and begins anew when it is reset, unplugged or silent. Without port, clock and thread:
/// the caller tells the time, does what advance() says, and passes on what arrives.
///
/// A device at a serial port is reset by a break, or where that does not pass, as at many adapters,
/// by a command at each rate; then it is set to the best rate that it accepts and at which it then
/// answers, and initialised; ports that others left are freed; each wireless tool is
/// defined and enabled, wired tools are initialised and enabled; then it tracks. A tool that the
/// device refuses is left out and named (trouble()); the others are tracked.
///
/// The time of a sample is that of the arrival of its reply less the time that the reply took on
/// the wire (10 bits a byte); for BX2, which has the device's own time, that time by the least
/// delay of the last 256 replies. An exposure is passed on once, although a device may be asked
/// more often than it exposes.
class NdiClient
{
public:
    enum class Phase : std::uint8_t {
        Connecting, ///< reset and rate
        SettingUp,  ///< tools
        Tracking,
        Silent, ///< it did not answer; tried again by itself
    };

    /// @pre at least one tool and one rate.
    explicit NdiClient(NdiClientSettings settings);

    /// The port is open, and the device in any state.
    void start(LocalTime now);
    /// Bytes that have arrived.
    void take(std::span<const std::byte> bytes, LocalTime now);
    /// What is to be done now. Call it after start(), after take() and at nextWake().
    [[nodiscard]] NdiPortAction advance(LocalTime now);
    [[nodiscard]] LocalTime nextWake() const { return m_wake; }

    /// The measurements since the last call.
    [[nodiscard]] std::vector<NdiMeasurement> takeMeasurements();

    [[nodiscard]] Phase phase() const { return m_phase; }
    /// What keeps a tool, or the device, from tracking; empty if nothing does.
    [[nodiscard]] std::string trouble() const;
    /// Replies that were damaged, since the construction.
    [[nodiscard]] std::size_t damagedReplies() const { return m_damaged; }

    /// To leave the device idle: what is to be sent before the port is closed.
    [[nodiscard]] static std::string farewell() { return encoded({"TSTOP"}); }

private:
    /// One command and what follows from its reply.
    struct Step {
        NdiCommand command{}; ///< without a name: only waits
        Duration patience{};
        std::function<void(const NdiReply&)> then{};
        std::function<void()> inVain{}; ///< without it the client begins anew
        bool isReset = false;           ///< answered by RESET
        bool sendsBreak = false;
        std::optional<int> rate{};
    };

    void begin();
    [[nodiscard]] std::vector<Step> resetSteps();
    void takeReset();
    [[nodiscard]] std::vector<Step> rateSteps();
    void queueSetUp();
    void queueDefinition(std::size_t tool);
    void queueWiredTools();
    void queueEnabling(std::size_t tool, std::uint16_t handle);
    void queuePoses();
    void queue(NdiCommand command, std::function<void(const NdiReply&)> then);
    /// In front of what is queued, in the order of the list.
    void queueFirst(std::vector<Step> steps);
    void refuseTool(std::size_t tool, const NdiReply& reply);
    void takeReply(const NdiReply& reply, LocalTime now);
    void takePoses(const NdiReply& reply, LocalTime now);
    [[nodiscard]] LocalTime exposureOf(const NdiFrame& frame, LocalTime arrived);
    void fallSilent(LocalTime now, std::string why);

    NdiClientSettings m_settings;
    NdiReplyReader m_reader;
    std::deque<Step> m_steps;
    std::optional<LocalTime> m_deadline; ///< of the step that is under way; nothing: not begun
    LocalTime m_wake{};
    LocalTime m_now{};
    Phase m_phase = Phase::Connecting;
    std::size_t m_rate = 0; ///< index of the rate that is tried
    int m_bitsPerSecond = 9600;
    std::map<std::uint16_t, std::size_t> m_toolOf; ///< by handle
    std::map<std::size_t, std::string> m_refused;  ///< tools, and why
    std::string m_silence;                         ///< why it is silent
    std::size_t m_missedPoses = 0;
    std::size_t m_damaged = 0;
    std::size_t m_replyBytes = 0; ///< of the reply that is arriving
    std::optional<std::uint32_t> m_lastFrame;
    std::deque<Duration> m_delays; ///< arrival less device time, of the last replies
    std::vector<NdiMeasurement> m_measured;
};

} // namespace carina
