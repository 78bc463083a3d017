#pragma once

#include "engine/core/byte_buffer.h"
#include "engine/core/expects.h"
#include "engine/core/session_time.h"
#include "engine/geometry/vec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace carina
{

inline constexpr std::int32_t kLargestInt16 = 32767;
inline constexpr std::int32_t kLargestUint8 = 255;
inline constexpr std::int32_t kLargestUint16 = 65535;
inline constexpr std::int32_t kLargestInt24 = 8388607;

inline constexpr double kPositionStep = 1e-5;                                   ///< m
inline constexpr double kVelocityStep = 1e-4;                                   ///< m/s
inline constexpr double kAngularVelocityStep = 0.02 * std::numbers::pi / 180.0; ///< rad/s
inline constexpr double kErrorStep = 5e-5;                                      ///< m
inline constexpr Duration kShapeAgeStep = std::chrono::milliseconds{1};
inline constexpr double kShapeLengthStep = 1e-5; ///< m
inline constexpr double kThicknessStep = 1e-4;   ///< m
inline constexpr double kCurvatureStep = 2e-3;   ///< 1/m: a tip of 0.3 m moves by less than 0.1 mm
/// Of a quaternion component that is not the largest; its magnitude is at most sqrt(1/2).
inline constexpr double kRotationStep = 1.0 / (std::numbers::sqrt2 * kLargestInt16);

/// The integer nearest to value / step, limited to +-largest.
/// @pre value is finite.
[[nodiscard]] inline std::int32_t quantise(double value, double step, std::int32_t largest)
{
    CARINA_EXPECTS(std::isfinite(value));
    const double code = std::clamp<double>(value / step, -largest, largest);
    return static_cast<std::int32_t>(code + std::copysign(0.5, code)); // cut off towards 0
}

/// An RMS error in steps of kErrorStep; 255 stands for 12.75 mm or more.
[[nodiscard]] std::uint8_t packError(double metres);

/// Whether a position can be encoded: each coordinate within +-83.8 m.
[[nodiscard]] bool isInReach(const Vec3& p);

/// "Smallest three" encoding of a unit quaternion: q and -q are the same rotation, so the largest
/// component is made positive and left out; it follows from the others.
struct PackedRotation {
    std::uint8_t largest = 0;             ///< 0 x, 1 y, 2 z, 3 w
    std::array<std::int16_t, 3> others{}; ///< in the order x y z w, in steps of kRotationStep
};

/// @pre q is of unit length.
[[nodiscard]] PackedRotation packRotation(const Quat& q);
/// Nothing where the codes do not belong to a unit quaternion whose largest component was left out.
/// @pre packed.largest <= 3
[[nodiscard]] std::optional<Quat> unpackRotation(const PackedRotation& packed);

/// Times on the wire lie within 2^61 ns (73 years) of zero, so that differences do not overflow.
inline constexpr Duration kLargestWireTime{std::int64_t{1} << 61};
/// Largest magnitude of the upper 32 bits of a time in microseconds; within kLargestWireTime.
inline constexpr std::int32_t kLargestTimeHigh = 500'000;

/// Session time in microseconds, rounded to the nearest.
[[nodiscard]] std::int64_t wireMicroseconds(SessionTime t);
[[nodiscard]] SessionTime fromWireMicroseconds(std::int64_t microseconds);
/// The number nearest to `base` that has these lower 32 bits.
[[nodiscard]] std::int64_t nearestTime(std::int64_t base, std::uint32_t low);

/// A time as 64 bits of nanoseconds. @pre within kLargestWireTime.
template <class Sink> void writeWireTime(NumberWriter<Sink>& out, Duration sinceEpoch)
{
    CARINA_EXPECTS(std::chrono::abs(sinceEpoch) <= kLargestWireTime);
    out.number(std::int64_t{sinceEpoch.count()});
}
[[nodiscard]] Duration readWireTime(ByteReader& in);

} // namespace carina
