#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace carina
{

/// How well the owner saw the object when the sample was taken.
enum class StreamValidity : std::uint8_t { Tracked, PartlyOccluded, Lost };

/// Velocity of an object O in the anatomy frame A of its station, in axes of A.
struct StreamMotion {
    Vec3 v_AO = Vec3::Zero(); ///< of the origin of O, m/s
    Vec3 w_AO = Vec3::Zero(); ///< angular, rad/s
};

/// The form of an object that bends, as its owner draws it: of a tube what it is at rest
/// (TubeRest), by how much it bends from that in eight numbers (TubeShapeCode), and how far behind
/// its pose it begins, as what is held up lies behind the hand that pushes it (ElasticRod). The
/// tube that the patient has, which every program knows, has length, thickness and curvature 0.
///
/// On the wire it is quantised: its time to 1 ms, up to 255 ms before that of the sample, length
/// and way behind the pose to 10 um up to 655 mm, the thickness to 0.1 mm up to 25.5 mm, and each
/// number per metre to 0.002 within +-65.5. A form with a value outside its range is not sent, nor
/// one that has a length or a thickness alone.
struct StreamShape {
    SessionTime time{};             ///< of the sample or before
    double length = 0.0;            ///< metres
    double thickness = 0.0;         ///< metres
    std::array<double, 2> atRest{}; ///< curvature of its halves, per metre
    std::array<double, 8> perMetre{};
    double heldBack = 0.0; ///< metres

    [[nodiscard]] bool isOfPatientsTube() const
    {
        return length == 0.0 && thickness == 0.0 && atRest == std::array<double, 2>{};
    }
    [[nodiscard]] bool isOfSameObject(const StreamShape& other) const
    {
        return length == other.length && thickness == other.thickness && atRest == other.atRest;
    }

    friend bool operator==(const StreamShape&, const StreamShape&) = default;
};

/// A control packet object (CPO) of a stream: pose and velocity of a shared object O at one time.
///
/// On the wire it is quantised (docs/protocol.md): time to 1 us, each quaternion component to
/// 2.2e-5, position to 10 um within +-83.8 m, velocity to 0.1 mm/s within +-3.2 m/s, angular
/// velocity to 0.02 deg/s within +-655 deg/s, error to 0.05 mm up to 12.75 mm. A value outside its
/// range is sent as the nearest value inside; a position outside is sent as Lost.
struct StreamCpo {
    ObjectId object;
    std::uint16_t sequence = 0; ///< sequence number of this object's samples; wraps
    SessionTime time{};         ///< at which the pose was measured
    RigidTransform X_AO;
    std::optional<StreamMotion> motion; ///< nothing where the owner has no velocity
    StreamValidity validity = StreamValidity::Tracked;
    double error = 0.0;               ///< RMS error of the pose, metres
    std::optional<StreamShape> shape; ///< of what bends, while its owner knows it
};

/// Stream samples of one owner at one station that are sent together.
struct StreamGroup {
    ParticipantId owner;
    std::uint16_t epoch = 0; ///< increases with each joining of the owner; wraps
    StationId station;
    std::vector<StreamCpo> streams; ///< 1 to kStreamsPerGroup, within kGroupTimeSpan
};

/// The most that fit into one datagram: without forms.
inline constexpr std::size_t kStreamsPerGroup = 30;
/// Largest distance of a time in a group from the first: 32 bits of microseconds hold it.
inline constexpr Duration kGroupTimeSpan = std::chrono::minutes{30};

} // namespace carina
