#pragma once

#include "engine/tracking/device_clock.h"
#include "engine/tracking/igtl/igtl_pose.h"
#include "engine/tracking/igtl/igtl_reader.h"
#include "engine/tracking/pose_sample.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// How a server of OpenIGTLink is asked for poses.
enum class IgtlPoses : std::uint8_t {
    Transform, ///< not at all: it sends by itself, as PLUS does
    Tdata,     ///< by STT_TDATA
    Qtdata,    ///< by STT_QTDATA
};

struct IgtlClientSettings {
    /// The names by which the server knows the wanted tools: the device of a TRANSFORM or POSITION,
    /// the name within TDATA or QTDATA. Of a longer one the first 20 characters count.
    std::vector<std::string> devices;
    IgtlPoses poses = IgtlPoses::Transform;
    int rate_hz = 60; ///< that is asked for; not of a server that sends by itself
};

/// A pose of a tool, or that it is not seen.
struct IgtlSight {
    std::size_t tool = 0; ///< index of its device
    LocalTime exposed;
    std::optional<RigidTransform> X_TO{}; ///< nothing: not seen
};

/// A client of a server of OpenIGTLink, such as PLUS: takes the poses of the wanted tools from
/// TRANSFORM, POSITION, TDATA and QTDATA, whichever comes. Without socket, clock and thread.
///
/// A server of protocol 3 says how well it sees a tool (TransformStatus) only to a client that has
/// shown that it understands, and one of protocol 1 or 2 may lose its place behind a message that
/// it does not. The client therefore begins with a question of protocol 3 without a body, behind
/// which no server loses its place. A tool is not seen where its status says so, and where its pose
/// is the identity, which older servers send then.
///
/// Times are those that the server states, brought to this machine's clock by DeviceClock; where it
/// states none, or the same one for another pose, those of arrival. A pose that is sent again with
/// its time is passed on once. A tool of which nothing comes for half a second is not seen: older
/// servers leave out those that they do not see.
///
/// A server that falls silent is asked for its status every two seconds, so that a connection that
/// is no longer one is noticed.
class IgtlClient
{
public:
    /// Without a device it only tells what the server sends.
    explicit IgtlClient(IgtlClientSettings settings);

    /// A connection has been made.
    void start(LocalTime now);
    /// Bytes that have arrived.
    void take(std::span<const std::byte> bytes, LocalTime now);
    /// What is to be sent now. Call it after start(), after take() and at nextWake().
    [[nodiscard]] std::vector<std::byte> advance(LocalTime now);
    [[nodiscard]] LocalTime nextWake() const { return m_wake; }

    /// The poses since the last call.
    [[nodiscard]] std::vector<IgtlSight> takeSights();
    /// Whether what comes is no OpenIGTLink: the connection is to be closed.
    [[nodiscard]] bool isLost() const { return m_reader.isLost(); }
    /// What keeps a tool, or the server, from tracking; empty if nothing does.
    [[nodiscard]] std::string trouble() const;
    /// Whether nothing has come for two seconds.
    [[nodiscard]] bool isSilent() const;
    /// The names of the tools that came since start(), those that are not wanted among them, in
    /// the order in which they first came; at most 32.
    [[nodiscard]] const std::vector<std::string>& sentTools() const { return m_sent; }
    /// What is to be sent before the connection is closed.
    [[nodiscard]] std::vector<std::byte> farewell() const;

private:
    struct Tool {
        std::optional<LocalTime> came{}; ///< its last message that said something new
        bool isOverdue = false;          ///< and is held for not seen
        std::uint64_t stamp = 0;
        bool isSeen = false;                  ///< by the last message
        std::optional<RigidTransform> X_TO{}; ///< of the last message
        std::string refused{};                ///< why its last pose was
    };

    void take(const IgtlMessage& message, LocalTime now);
    void take(const IgtlMessage& message, const std::string& name, bool isSeen,
              const Result<RigidTransform>& pose, LocalTime now);
    void missOverdueTools();
    [[nodiscard]] std::string others() const;
    void send(const IgtlMessage& message);

    IgtlClientSettings m_settings;
    IgtlReader m_reader;
    DeviceClock m_clock;
    std::vector<Tool> m_tools;
    std::vector<std::string> m_sent; ///< names of tools that come
    std::vector<std::byte> m_toSend;
    LocalTime m_now{};
    LocalTime m_begun{};
    LocalTime m_heard{};
    LocalTime m_asked{};
    LocalTime m_wake{};
    std::size_t m_damaged = 0;
    std::vector<IgtlSight> m_sights;
};

} // namespace carina
