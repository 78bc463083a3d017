#include "engine/tracking/ndi/tool_definition.h"

#include "engine/core/byte_buffer.h"

#include <algorithm>
#include <bit>
#include <string_view>

namespace carina
{
namespace
{

// Where a field begins.
constexpr std::size_t kChecksumAt = 4;
constexpr std::size_t kSummedFrom = 6; // what the checksum is of
constexpr std::size_t kAlwaysOneAt = 8;
constexpr std::size_t kKindAt = 15;
constexpr std::size_t kAngleAt = 24;
constexpr std::size_t kCountAt = 28;
constexpr std::size_t kFewestAt = 32;
constexpr std::size_t kErrorAt = 36;
constexpr std::size_t kSpreadAt = 64;
constexpr std::size_t kMarkersAt = 72;
constexpr std::size_t kNormalsAt = 312;
constexpr std::size_t kFiringAt = 552;
constexpr std::size_t kFiringEndAt = 572; // four bytes 0x1F, then 9
constexpr std::size_t kMakerAt = 580;
constexpr std::size_t kMakerBytes = 12;
constexpr std::size_t kPartAt = 592;
constexpr std::size_t kPartBytes = 20;
constexpr std::size_t kFacesAt = 612; // 9, then the face of each marker, twice 20
constexpr std::size_t kTailAt = 653;  // 80 00 29 in every file
constexpr std::size_t kVectorBytes = 12;
constexpr std::string_view kBegin{"NDI\0", 4};

constexpr double kFarthest = 2.0; // m, from the tool's origin
constexpr std::uint32_t kLeastForAPose = 3;
constexpr double kOnALine = 1e-3; // m, of the third marker from the line through two others

tl::unexpected<Error> malformed(const char* what) { return fail(Errc::FileMalformed, what); }

bool isNear(const Vec3& p_OQ)
{
    return p_OQ.allFinite() && p_OQ.cwiseAbs().maxCoeff() <= kFarthest;
}

/// Millimetres.
Vec3 inFile(const Vec3& p_OQ)
{
    return p_OQ.unaryExpr([](double length) { return inMillimetres(metres(length)); });
}

/// Whether all are on one line.
bool areCollinear(std::span<const ToolMarker> markers)
{
    const Vec3 first = markers[0].p_OQ;
    const auto farther = [&first](const ToolMarker& a, const ToolMarker& b) {
        return (a.p_OQ - first).norm() < (b.p_OQ - first).norm();
    };
    const Vec3 along = std::ranges::max_element(markers, farther)->p_OQ - first;
    if (along.norm() < kOnALine)
        return true;
    return std::ranges::all_of(markers, [&](const ToolMarker& marker) {
        return along.normalized().cross(marker.p_OQ - first).norm() < kOnALine;
    });
}

} // namespace

Result<NdiToolDefinition> NdiToolDefinition::read(std::span<const std::byte> bytes)
{
    if (bytes.size() != kBytes)
        return malformed("it does not have 752 bytes");
    NdiToolDefinition tool;
    std::ranges::copy(bytes, tool.m_bytes.begin());
    if (!std::ranges::equal(bytes.first(kBegin.size()), std::as_bytes(std::span{kBegin})))
        return malformed("it does not begin with NDI");
    if (ByteReader{bytes.subspan(kChecksumAt)}.number<std::uint16_t>() != tool.checksum())
        return malformed("wrong checksum");
    const std::uint32_t count = tool.wholeAt(kCountAt);
    if (count == 0 || count > kMostMarkers)
        return malformed("it does not have 1 to 20 markers");
    if (!std::isfinite(tool.largestMarkerError().si) || !std::isfinite(tool.smallestSpread().si))
        return fail(Errc::NotFinite, "the largest error or the smallest spread of its markers");
    for (const ToolMarker& marker : tool.markers()) {
        if (!marker.p_OQ.allFinite() || !marker.normal_O.allFinite())
            return fail(Errc::NotFinite, "a marker");
        if (!isNear(marker.p_OQ))
            return fail(Errc::OutOfRange, "a marker more than 2 m from the tool's origin");
    }
    return tool;
}

Result<NdiToolDefinition> NdiToolDefinition::make(Kind kind, std::span<const ToolMarker> markers,
                                                  const std::string& maker,
                                                  const std::string& partNumber)
{
    if (markers.size() < kLeastForAPose)
        return fail(Errc::TooFewLandmarks, "a tool needs three markers");
    if (markers.size() > kMostMarkers)
        return fail(Errc::OutOfRange, "a tool has at most 20 markers");
    if (!std::ranges::all_of(markers, isNear, &ToolMarker::p_OQ))
        return fail(Errc::OutOfRange, "a marker more than 2 m from the tool's origin");
    if (areCollinear(markers))
        return fail(Errc::DegenerateLandmarks, "the markers of a tool");
    constexpr double kAngle_deg = 90.0;
    constexpr double kError_mm = 2.0;
    constexpr double kSpread_mm = 10.0;
    NdiToolDefinition tool;
    std::ranges::copy(std::as_bytes(std::span{kBegin}), tool.m_bytes.begin());
    tool.putByte(kAlwaysOneAt, 1);
    tool.putByte(kKindAt, static_cast<std::uint8_t>(kind));
    tool.putWhole(kAngleAt, std::uint32_t(kAngle_deg));
    tool.putWhole(kCountAt, std::uint32_t(markers.size()));
    tool.putWhole(kFewestAt, kLeastForAPose);
    tool.putReal(kErrorAt, kError_mm);
    tool.putReal(kSpreadAt, kSpread_mm);
    tool.putByte(kFacesAt, 9);
    for (std::size_t i = 0; i < markers.size(); ++i) {
        tool.putVector(kMarkersAt + i * kVectorBytes, inFile(markers[i].p_OQ));
        tool.putVector(kNormalsAt + i * kVectorBytes, markers[i].normal_O);
        tool.putByte(kFiringAt + i, static_cast<std::uint8_t>(i));
        tool.putByte(kFacesAt + 1 + i, 1);
        tool.putByte(kFacesAt + 1 + kMostMarkers + i, 1);
    }
    for (std::size_t i = 0; i < 4; ++i)
        tool.putByte(kFiringEndAt + i, 0x1F);
    tool.putByte(kFiringEndAt + 4, 9);
    tool.putText(kMakerAt, kMakerBytes, maker);
    tool.putText(kPartAt, kPartBytes, partNumber);
    tool.putByte(kTailAt, 0x80);
    tool.putByte(kTailAt + 2, 0x29);
    tool.putChecksum();
    return tool;
}

Result<NdiToolDefinition> NdiToolDefinition::withMarker(std::size_t marker, const Vec3& p_OQ) const
{
    std::vector<ToolMarker> all = markers();
    if (!isNear(p_OQ))
        return fail(Errc::OutOfRange, "a marker more than 2 m from the tool's origin");
    all.at(marker).p_OQ = p_OQ;
    if (all.size() >= kLeastForAPose && areCollinear(all))
        return fail(Errc::DegenerateLandmarks, "the markers of a tool");
    NdiToolDefinition moved = *this;
    moved.putVector(kMarkersAt + marker * kVectorBytes, inFile(p_OQ));
    moved.putChecksum();
    return moved;
}

std::vector<ToolMarker> NdiToolDefinition::markers() const
{
    std::vector<ToolMarker> markers(wholeAt(kCountAt));
    for (std::size_t i = 0; i < markers.size(); ++i)
        markers[i] = {vectorAt(kMarkersAt + i * kVectorBytes).unaryExpr([](double mm) {
                          return millimetres(mm).si;
                      }),
                      vectorAt(kNormalsAt + i * kVectorBytes)};
    return markers;
}

std::uint32_t NdiToolDefinition::fewestMarkers() const { return wholeAt(kFewestAt); }

Length NdiToolDefinition::largestMarkerError() const
{
    return millimetres(std::bit_cast<float>(wholeAt(kErrorAt)));
}

Length NdiToolDefinition::smallestSpread() const
{
    return millimetres(std::bit_cast<float>(wholeAt(kSpreadAt)));
}

Angle NdiToolDefinition::largestMarkerAngle() const { return degrees(wholeAt(kAngleAt)); }

Probe NdiToolDefinition::probe() const
{
    return {.markers = markers(),
            .largestAngle = largestMarkerAngle(),
            .fewest = std::max<std::size_t>(kLeastForAPose, fewestMarkers()),
            .largestMisfit = largestMarkerError()};
}

std::string NdiToolDefinition::maker() const { return textAt(kMakerAt, kMakerBytes); }

std::string NdiToolDefinition::partNumber() const { return textAt(kPartAt, kPartBytes); }

std::uint8_t NdiToolDefinition::byteAt(std::size_t at) const
{
    return std::to_integer<std::uint8_t>(m_bytes[at]);
}

std::uint32_t NdiToolDefinition::wholeAt(std::size_t at) const
{
    return ByteReader{std::span{m_bytes}.subspan(at)}.number<std::uint32_t>();
}

Vec3 NdiToolDefinition::vectorAt(std::size_t at) const
{
    ByteReader bytes{std::span{m_bytes}.subspan(at)};
    Vec3 vector;
    for (double& each : vector)
        each = bytes.realFloat();
    return vector;
}

/// Up to the first byte that does not print.
std::string NdiToolDefinition::textAt(std::size_t at, std::size_t most) const
{
    std::string text;
    for (std::size_t i = 0; i < most; ++i) {
        const auto character = static_cast<char>(byteAt(at + i));
        if (character < ' ' || character > '~')
            break;
        text += character;
    }
    return text;
}

std::uint16_t NdiToolDefinition::checksum() const
{
    std::uint32_t sum = 0;
    for (const std::byte each : std::span{m_bytes}.subspan(kSummedFrom))
        sum += std::to_integer<std::uint32_t>(each);
    return static_cast<std::uint16_t>(sum);
}

void NdiToolDefinition::putWhole(std::size_t at, std::uint32_t value)
{
    for (std::size_t i = 0; i < sizeof value; ++i)
        putByte(at + i, static_cast<std::uint8_t>((value >> (8 * i)) & 0xFFU));
}

void NdiToolDefinition::putReal(std::size_t at, double value)
{
    putWhole(at, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

void NdiToolDefinition::putVector(std::size_t at, const Vec3& vector)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        putReal(at + axis * sizeof(float), vector[Eigen::Index(axis)]);
}

void NdiToolDefinition::putChecksum()
{
    const std::uint16_t sum = checksum();
    putByte(kChecksumAt, static_cast<std::uint8_t>(sum & 0xFFU));
    putByte(kChecksumAt + 1, static_cast<std::uint8_t>(sum >> 8U));
}

void NdiToolDefinition::putText(std::size_t at, std::size_t most, const std::string& text)
{
    for (std::size_t i = 0; i < std::min(most, text.size()); ++i)
        putByte(at + i, static_cast<std::uint8_t>(text[i]));
}

std::string kindName(std::uint8_t kind)
{
    using Kind = NdiToolDefinition::Kind;
    switch (static_cast<Kind>(kind)) {
    case Kind::Reference:
        return "reference";
    case Kind::Pointer:
        return "pointer";
    case Kind::ButtonBox:
        return "button box";
    case Kind::Software:
        return "software-defined";
    case Kind::Microscope:
        return "microscope";
    case Kind::CalibrationDock:
        return "calibration dock";
    case Kind::CArm:
        return "C-arm";
    case Kind::Catheter:
        return "catheter";
    }
    return "kind " + std::to_string(kind);
}

} // namespace carina
