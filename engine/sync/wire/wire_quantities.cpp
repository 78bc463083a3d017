#include "engine/sync/wire/wire_quantities.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

// What rounding of the three others can take from the square of the largest component, which is
// at least 1/4: 2 * sqrt(3/4) * sqrt(3) * kRotationStep / 2, rounded up.
constexpr double kLargestComponentSlack = 4e-5;

} // namespace

std::uint8_t packError(double metres)
{
    return static_cast<std::uint8_t>(std::max(quantise(metres, kErrorStep, 255), 0));
}

bool isInReach(const Vec3& p) { return p.cwiseAbs().maxCoeff() <= kLargestInt24 * kPositionStep; }

PackedRotation packRotation(const Quat& q)
{
    PackedRotation packed;
    int largest = 0;
    q.coeffs().cwiseAbs().maxCoeff(&largest);
    packed.largest = static_cast<std::uint8_t>(largest);
    const double sign = q.coeffs()[largest] < 0.0 ? -1.0 : 1.0;
    auto* code = packed.others.begin();
    for (int i = 0; i < 4; ++i)
        if (i != largest)
            *code++ = static_cast<std::int16_t>(
                quantise(sign * q.coeffs()[i], kRotationStep, kLargestInt16));
    return packed;
}

std::optional<Quat> unpackRotation(const PackedRotation& packed)
{
    Quat q;
    double largestSquared = 1.0;
    const auto* code = packed.others.begin();
    for (int i = 0; i < 4; ++i) {
        if (i == packed.largest)
            continue;
        q.coeffs()[i] = *code++ * kRotationStep;
        largestSquared -= q.coeffs()[i] * q.coeffs()[i];
    }
    if (largestSquared < 0.25 - kLargestComponentSlack)
        return std::nullopt;
    q.coeffs()[packed.largest] = std::sqrt(largestSquared);
    return q;
}

std::int64_t wireMicroseconds(SessionTime t)
{
    return std::chrono::round<std::chrono::microseconds>(t.time_since_epoch()).count();
}

SessionTime fromWireMicroseconds(std::int64_t microseconds)
{
    return SessionTime{std::chrono::microseconds{microseconds}};
}

std::int64_t nearestTime(std::int64_t base, std::uint32_t low)
{
    return base + static_cast<std::int32_t>(low - static_cast<std::uint32_t>(base));
}

Duration readWireTime(ByteReader& in)
{
    const Duration time{in.number<std::int64_t>()};
    in.require(time >= -kLargestWireTime && time <= kLargestWireTime, "time");
    return time;
}

} // namespace carina
