#pragma once

#include "engine/tracking/device_clock.h"
#include "engine/tracking/ndi/ndi_connection.h"
#include "engine/tracking/ndi/ndi_frame.h"
#include "engine/tracking/ndi/ndi_tools.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// How poses are asked for.
enum class NdiPoseReply : std::uint8_t { Tx, Bx, Bx2 };

struct NdiClientSettings {
    std::vector<NdiWantedTool> tools; ///< none: only looks what is there
    NdiPoseReply poses = NdiPoseReply::Bx;
    /// Whether the device is at a serial port, which has a rate and is reset by a break.
    bool isSerial = true;
    /// Rates of transmission that are to be tried, in bits a second, best first; of those that COMM
    /// can set.
    std::vector<int> rates{921600, 115200, 57600, 38400, 19200, 9600};
};

/// Poses of the wanted tools at one exposure.
struct NdiMeasurement {
    LocalTime exposed;
    /// One for each wanted tool, in their order; nothing for one that the device refuses.
    std::vector<std::optional<NdiTool>> tools;
};

/// What answered.
struct NdiFound {
    std::string name{}; ///< of its firmware, and its serial number; empty if it tells neither
    std::size_t pluggedIn = 0; ///< tools in its ports

    friend bool operator==(const NdiFound&, const NdiFound&) = default;
};

/// A client of a tracker of NDI: brings it from whatever state it is in to tracking, asks for
/// poses, and begins anew when it is reset, unplugged or silent. Without port, clock and thread:
/// the caller tells the time, does what advance() says, and passes on what arrives.
///
/// A device at a serial port is reset and set to the best rate (NdiConnection); it is initialised
/// and asked what it is; it is given its tools (NdiTools); then it tracks. A tool that the device
/// refuses is left out and named (trouble()); the others are tracked. A wired tool that is
/// unplugged is lost until it is plugged in again. An older device that does not know BX2 is asked
/// by BX, and one that does not know BX by TX. Why a tool has no pose is asked for while one has
/// none.
///
/// A device on the network is not reset: it is told to stop, and its ports are freed. It answers at
/// once, and often with the exposure of the reply before: after a reply without a newer one, or
/// that cannot be read, it is asked again 4 ms later. At a serial port the line itself takes such a
/// time.
///
/// A device that tracked and is silent is asked for poses on, three times before it is reset and
/// then between the resets: one that still is in its state tracks again with its first answer.
///
/// The time of a sample is that of the arrival of its reply less the time that the reply took on
/// the wire (10 bits a byte); for BX2, which has the device's own time, that time by the least
/// delay of the last 256 replies (DeviceClock). An exposure is passed on once, although a
/// device may be asked more often than it exposes.
class NdiClient
{
public:
    enum class Phase : std::uint8_t {
        Connecting, ///< reset and rate
        SettingUp,  ///< tools
        Tracking,
        Silent, ///< it did not answer; tried again by itself
    };

    /// @pre at least one rate.
    explicit NdiClient(NdiClientSettings settings);
    NdiClient(const NdiClient&) = delete; // its parts know where it is
    NdiClient& operator=(const NdiClient&) = delete;

    /// The port is open, and the device in any state.
    /// @param holdsRate asked before the device is set to a rate; without it all rates are held
    void start(LocalTime now, HoldsRate holdsRate = {});
    /// Bytes that have arrived.
    void take(std::span<const std::byte> bytes, LocalTime now);
    /// What is to be done now. Call it after start(), after take() and at nextWake().
    [[nodiscard]] NdiPortAction advance(LocalTime now);
    [[nodiscard]] LocalTime nextWake() const { return m_dialogue.nextWake(); }

    /// The measurements since the last call.
    [[nodiscard]] std::vector<NdiMeasurement> takeMeasurements();

    [[nodiscard]] Phase phase() const { return m_phase; }
    /// What keeps a tool, or the device, from tracking; empty if nothing does.
    [[nodiscard]] std::string trouble() const;
    /// Whether the device does not answer, or refuses to track; not before that lasts.
    [[nodiscard]] bool isSilent() const { return !m_silence.empty(); }
    /// The device, while it tracks.
    [[nodiscard]] std::optional<NdiFound> found() const;
    /// Replies that were damaged, since the construction.
    [[nodiscard]] std::size_t damagedReplies() const
    {
        return m_dialogue.damagedReplies() + m_undecoded;
    }

    /// Leaves the device idle: what it was asked is awaited, then it is told to stop tracking, and
    /// its ports are freed.
    void leave();
    /// Whether nothing more is to be sent or awaited since leave().
    [[nodiscard]] bool hasLeft() const { return m_hasLeft; }

private:
    void begin();
    void setUp();
    void initialise();
    void startTracking();
    void askForPoses();
    void askAgain(bool wasNewer);
    void missPoses();
    [[nodiscard]] NdiStep askingWhetherItTracks();
    [[nodiscard]] Duration posePatience() const;
    [[nodiscard]] LocalTime exposureOf(const NdiFrame& frame);
    void takePoses(const NdiReply& reply, std::uint16_t options);
    [[nodiscard]] Result<NdiFrame> decoded(const NdiReply& reply, std::uint16_t options) const;
    [[nodiscard]] bool measure(const NdiFrame& frame);
    void lookAtPorts(const NdiFrame& frame);
    void fallSilent(std::string why);
    void giveUp(std::string why);
    void listen();
    [[nodiscard]] std::string noAnswer() const;

    NdiPoseReply m_wantedPoses;
    NdiPoseReply m_poses; ///< as they are asked for: the device may not know what is wanted
    bool m_isSerial;
    NdiDialogue m_dialogue;
    NdiConnection m_connection;
    NdiTools m_tools;
    DeviceClock m_deviceClock;
    LocalTime m_now{};
    Phase m_phase = Phase::Connecting;
    std::string m_name;      ///< of the device
    std::string m_silence;   ///< why it is silent; empty where it is not
    bool m_mayTrack = false; ///< as it did when it was heard last
    LocalTime m_heard{};     ///< poses, or that it tracks
    LocalTime m_read{};      ///< the same, and they were decoded
    LocalTime m_nextLook{};  ///< at the ports, at the earliest
    bool m_hasLeft = false;
    bool m_asksReasons = false;      ///< why a tool has no pose
    std::string m_unreadable;        ///< why the newest reply was not decoded; empty if it was
    std::size_t m_undecoded = 0;     ///< replies whose checksum was right
    std::size_t m_damagedBefore = 0; ///< replies, when it was heard, or tried
    std::optional<std::uint32_t> m_lastFrame;
    std::vector<NdiMeasurement> m_measured;
};

} // namespace carina
