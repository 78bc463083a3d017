#include "engine/sync/wire/cpo_codec.h"

#include "engine/core/expects.h"
#include "engine/core/units.h"
#include "engine/sync/wire/wire_quantities.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace carina
{
namespace
{

// Bits of a stream's flag byte, beside the index of the quaternion's largest component.
constexpr unsigned kValidityShift = 2;
constexpr std::uint8_t kTwoBits = 0x3;
constexpr std::uint8_t kHasMotion = 0x10;
constexpr std::uint8_t kHasShape = 0x20;
constexpr std::uint8_t kKnownStreamFlags = 0x3F;

constexpr float kAxisTolerance = 1e-5F;

bool isSent(const std::optional<StreamShape>& shape, SessionTime ofSample)
{
    return shape && isInRange(*shape, ofSample);
}

template <std::size_t Bytes>
void writeShape(BlockWriter<Bytes>& out, const StreamShape& shape, SessionTime ofSample)
{
    out.number(static_cast<std::uint8_t>((ofSample - shape.time) / kShapeAgeStep));
    out.number(static_cast<std::uint8_t>(quantise(shape.thickness, kThicknessStep, kLargestUint8)));
    out.number(
        static_cast<std::uint16_t>(quantise(shape.length, kShapeLengthStep, kLargestUint16)));
    const auto write = [&out](std::span<const double> numbers) {
        for (const double perMetre : numbers)
            out.number(
                static_cast<std::int16_t>(quantise(perMetre, kCurvatureStep, kLargestInt16)));
    };
    write(shape.atRest);
    write(shape.perMetre);
    out.number(
        static_cast<std::uint16_t>(quantise(shape.heldBack, kShapeLengthStep, kLargestUint16)));
}

void writeStream(ByteWriter& buffer, const StreamCpo& stream)
{
    BlockWriter<kStreamCpoBytes + kStreamShapeBytes> out;
    const PackedRotation rotation = packRotation(stream.X_AO.rotation());
    const bool inReach = isInReach(stream.X_AO.translation());
    const StreamValidity validity = inReach ? stream.validity : StreamValidity::Lost;
    const StreamMotion motion = stream.motion.value_or(StreamMotion{});
    const bool hasShape = isSent(stream.shape, stream.time);

    out.number(stream.object.value);
    out.number(stream.sequence);
    out.number(static_cast<std::uint8_t>(
        rotation.largest | static_cast<unsigned>(validity) << kValidityShift
        | (stream.motion ? kHasMotion : 0U) | (hasShape ? kHasShape : 0U)));
    out.number(packError(stream.error));
    out.number(static_cast<std::uint32_t>(wireMicroseconds(stream.time)));
    for (const std::int16_t component : rotation.others)
        out.number(component);
    for (const double metres : stream.X_AO.translation())
        out.int24(quantise(metres, kPositionStep, kLargestInt24));
    for (const double metresPerSecond : motion.v_AO)
        out.number(
            static_cast<std::int16_t>(quantise(metresPerSecond, kVelocityStep, kLargestInt16)));
    for (const double radiansPerSecond : motion.w_AO)
        out.number(static_cast<std::int16_t>(
            quantise(radiansPerSecond, kAngularVelocityStep, kLargestInt16)));
    if (hasShape)
        writeShape(out, *stream.shape, stream.time);
    buffer.bytes(out.bytes());
}

Vec3 readVelocity(ByteReader& in, double step)
{
    Vec3 v;
    for (double& component : v) {
        const auto code = in.number<std::int16_t>();
        in.require(code >= -kLargestInt16, "velocity");
        component = code * step;
    }
    return v;
}

Vec3 readPosition(ByteReader& in)
{
    Vec3 p;
    for (double& component : p) {
        const std::int32_t code = in.int24();
        in.require(code >= -kLargestInt24, "position");
        component = code * kPositionStep;
    }
    return p;
}

Quat readRotation(ByteReader& in, std::uint8_t largest)
{
    PackedRotation packed{largest, {}};
    for (std::int16_t& component : packed.others)
        component = in.number<std::int16_t>();
    const std::optional<Quat> q = unpackRotation(packed);
    in.require(q.has_value(), "rotation");
    return q.value_or(Quat::Identity());
}

std::optional<StreamMotion> readMotion(ByteReader& in, bool known)
{
    StreamMotion motion;
    motion.v_AO = readVelocity(in, kVelocityStep);
    motion.w_AO = readVelocity(in, kAngularVelocityStep);
    if (known)
        return motion;
    in.require(motion.v_AO.isZero(0.0) && motion.w_AO.isZero(0.0), "motion");
    return std::nullopt;
}

StreamShape readShape(ByteReader& in, SessionTime ofSample)
{
    StreamShape shape;
    shape.time = ofSample - in.number<std::uint8_t>() * kShapeAgeStep;
    const auto thickness = in.number<std::uint8_t>();
    const auto length = in.number<std::uint16_t>();
    in.require((thickness > 0) == (length > 0), "size of a form");
    shape.thickness = thickness * kThicknessStep;
    shape.length = length * kShapeLengthStep;
    const auto read = [&in](std::span<double> numbers) {
        for (double& perMetre : numbers) {
            const auto code = in.number<std::int16_t>();
            in.require(code >= -kLargestInt16, "form");
            perMetre = code * kCurvatureStep;
        }
    };
    read(shape.atRest);
    in.require(length > 0 || shape.isOfPatientsTube(), "form at rest");
    read(shape.perMetre);
    shape.heldBack = in.number<std::uint16_t>() * kShapeLengthStep;
    return shape;
}

/// @param timeBase microseconds to which the sample's time is the nearest with its lower 32 bits
StreamCpo readStream(ByteReader& in, std::int64_t timeBase)
{
    StreamCpo stream;
    stream.object.value = in.number<std::uint16_t>();
    stream.sequence = in.number<std::uint16_t>();
    const auto flags = in.number<std::uint8_t>();
    const auto validity = static_cast<std::uint8_t>(flags >> kValidityShift & kTwoBits);
    in.require(flags <= kKnownStreamFlags, "stream flags");
    in.require(validity <= static_cast<std::uint8_t>(StreamValidity::Lost), "validity");
    stream.validity = static_cast<StreamValidity>(validity);
    stream.error = in.number<std::uint8_t>() * kErrorStep;
    stream.time = fromWireMicroseconds(nearestTime(timeBase, in.number<std::uint32_t>()));
    const Quat q_AO = readRotation(in, flags & kTwoBits);
    const Vec3 p_AO = readPosition(in);
    stream.X_AO = RigidTransform{q_AO, p_AO};
    stream.motion = readMotion(in, (flags & kHasMotion) != 0);
    if ((flags & kHasShape) != 0)
        stream.shape = readShape(in, stream.time);
    return stream;
}

} // namespace

bool isInRange(const StreamShape& shape, SessionTime ofSample)
{
    const Duration age = ofSample - shape.time;
    // Written so that a NaN fails too.
    const auto canBeSent = [](double perMetre) {
        return std::abs(perMetre) <= kLargestInt16 * kCurvatureStep;
    };
    constexpr double kLongest = kLargestUint16 * kShapeLengthStep;
    const bool hasSize = shape.thickness >= kThicknessStep
                         && shape.thickness <= kLargestUint8 * kThicknessStep
                         && shape.length >= kShapeLengthStep && shape.length <= kLongest;
    return age >= Duration{} && age <= kLargestUint8 * kShapeAgeStep
           && (hasSize || shape.isOfPatientsTube()) && std::ranges::all_of(shape.atRest, canBeSent)
           && std::ranges::all_of(shape.perMetre, canBeSent) && shape.heldBack >= 0.0
           && shape.heldBack <= kLongest;
}

std::size_t bytesOf(const StreamCpo& stream)
{
    return kStreamCpoBytes + (isSent(stream.shape, stream.time) ? kStreamShapeBytes : 0);
}

void writeStreamGroup(ByteWriter& out, const StreamGroup& group)
{
    CARINA_EXPECTS(!group.streams.empty() && group.streams.size() <= kStreamsPerGroup);
    const SessionTime first = group.streams.front().time;
    out.number(group.owner.value);
    out.number(group.epoch);
    out.number(group.station.value);
    out.number(static_cast<std::int32_t>(wireMicroseconds(first) >> 32));
    out.number(static_cast<std::uint8_t>(group.streams.size()));
    for (const StreamCpo& stream : group.streams) {
        CARINA_EXPECTS(std::chrono::abs(stream.time - first) <= kGroupTimeSpan);
        writeStream(out, stream);
    }
}

StreamGroup readStreamGroup(ByteReader& in)
{
    StreamGroup group;
    group.owner.value = in.number<std::uint16_t>();
    group.epoch = in.number<std::uint16_t>();
    group.station.value = in.number<std::uint16_t>();
    const auto timeHigh = in.number<std::int32_t>();
    in.require(timeHigh >= -kLargestTimeHigh && timeHigh <= kLargestTimeHigh, "time");
    const auto count = in.number<std::uint8_t>();
    in.require(count >= 1 && count <= kStreamsPerGroup, "stream count");
    in.require(in.remaining() >= count * kStreamCpoBytes, "length");
    // The middle of the high part's range, from which every low part is at most half a range away.
    std::int64_t timeBase = (std::int64_t{timeHigh} << 32) + (std::int64_t{1} << 31);
    group.streams.reserve(in.ok() ? count : 0);
    for (int i = 0; i < count && in.ok(); ++i) {
        group.streams.push_back(readStream(in, timeBase));
        const SessionTime first = group.streams.front().time;
        in.require(std::chrono::abs(group.streams.back().time - first) <= kGroupTimeSpan, "time");
        timeBase = wireMicroseconds(first);
    }
    return group;
}

void writeEventCpo(ByteWriter& buffer, const EventCpo& event)
{
    BlockWriter<kEventCpoBytes> out;
    out.number(event.object.value);
    out.number(event.epoch);
    out.number(event.action);
    out.number(static_cast<std::uint8_t>(event.kind));
    writeWireTime(out, event.start.time_since_epoch());
    for (const double component : event.q_AO.coeffs())
        out.real(component);
    for (const double metres : event.p_AO)
        out.real(metres);
    for (const float component : event.axis_A)
        out.real(component);
    out.real(event.rate);
    out.real(event.scale);
    buffer.bytes(out.bytes());
}

EventCpo readEventCpo(ByteReader& in)
{
    EventCpo event;
    event.object.value = in.number<std::uint16_t>();
    event.epoch = in.number<std::uint16_t>();
    event.action = in.number<std::uint32_t>();
    const auto kind = in.number<std::uint8_t>();
    in.require(kind <= static_cast<std::uint8_t>(ActionKind::Scaling), "action kind");
    event.kind = static_cast<ActionKind>(kind);
    event.start = SessionTime{readWireTime(in)};
    for (double& component : event.q_AO.coeffs())
        component = in.realDouble();
    for (double& metres : event.p_AO)
        metres = in.realDouble();
    for (float& component : event.axis_A)
        component = in.realFloat();
    event.rate = in.realFloat();
    event.scale = in.realFloat();
    // Written so that a NaN fails too.
    in.require(std::abs(event.q_AO.norm() - 1.0) <= kUnitTolerance, "rotation");
    in.require((event.p_AO.array().abs() <= kFarthestAction).all(), "position");
    in.require(std::abs(event.axis_A.norm() - 1.0F) <= kAxisTolerance, "axis");
    in.require(std::abs(event.rate) <= kFastestAction, "rate");
    in.require(std::isfinite(event.scale) && event.scale > 0.0F, "scale");
    return event;
}

} // namespace carina
