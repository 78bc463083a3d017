#include "engine/tracking/ndi/tool_definition.h"

#include "engine/core/byte_buffer.h"

#include <algorithm>
#include <bit>
#include <cmath>
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
constexpr double kMostError_mm = 100.0;
constexpr double kLargestAngle_deg = 180.0;
constexpr double kWhole_deg = 1e-6; // an angle is written in whole degrees

struct NamedKind {
    NdiToolDefinition::Kind kind;
    const char* name;
};
constexpr NamedKind kKinds[] = {{NdiToolDefinition::Kind::Reference, "reference"},
                                {NdiToolDefinition::Kind::Pointer, "pointer"},
                                {NdiToolDefinition::Kind::ButtonBox, "button box"},
                                {NdiToolDefinition::Kind::Software, "software-defined"},
                                {NdiToolDefinition::Kind::Microscope, "microscope"},
                                {NdiToolDefinition::Kind::CalibrationDock, "calibration dock"},
                                {NdiToolDefinition::Kind::CArm, "C-arm"},
                                {NdiToolDefinition::Kind::Catheter, "catheter"}};

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

bool isText(const std::string& text, std::size_t most)
{
    return text.size() <= most
           && std::ranges::all_of(text, [](char each) { return each >= ' ' && each <= '~'; });
}

bool isAngle(Angle angle)
{
    const double angle_deg = inDegrees(angle);
    return angle_deg >= 1.0 - kWhole_deg && angle_deg <= kLargestAngle_deg + kWhole_deg
           && std::abs(angle_deg - std::round(angle_deg)) <= kWhole_deg;
}

/// A fact that a file cannot state, of those that differ from what it states.
std::optional<Error> faultOf(const NdiToolDefinition::Facts& wanted,
                             const NdiToolDefinition::Facts& stated, std::size_t markers)
{
    const double error_mm = inMillimetres(wanted.largestMarkerError);
    const double spread = wanted.smallestSpread.si;
    const struct {
        bool isStated;
        bool holds;
        const char* fault;
    } rules[] = {
        {wanted.kind == stated.kind,
         std::ranges::count(kKinds, NdiToolDefinition::Kind(wanted.kind), &NamedKind::kind) != 0,
         "a kind of tool that has no name"},
        {wanted.maker == stated.maker, isText(wanted.maker, kMakerBytes),
         "a maker that is not at most 12 plain characters"},
        {wanted.partNumber == stated.partNumber, isText(wanted.partNumber, kPartBytes),
         "a part number that is not at most 20 plain characters"},
        {wanted.fewestMarkers == stated.fewestMarkers,
         wanted.fewestMarkers >= kLeastForAPose && wanted.fewestMarkers <= markers,
         "a pose from fewer than three markers, or from more than the tool has"},
        {wanted.largestMarkerError.si == stated.largestMarkerError.si,
         error_mm > 0.0 && error_mm <= kMostError_mm,
         "a largest error that is not above 0 and at most 100 mm"},
        {wanted.smallestSpread.si == stated.smallestSpread.si,
         spread >= 0.0 && spread <= 2.0 * kFarthest, "a smallest spread that is not 0 to 4000 mm"},
        {wanted.largestMarkerAngle.si == stated.largestMarkerAngle.si,
         isAngle(wanted.largestMarkerAngle), "a largest angle that is not 1 to 180 whole degrees"}};
    for (const auto& rule : rules)
        if (!rule.isStated && !rule.holds)
            return Error{Errc::OutOfRange, rule.fault};
    return std::nullopt;
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
    return make(kind, Probe{.markers = {markers.begin(), markers.end()}}, maker, partNumber);
}

Result<NdiToolDefinition> NdiToolDefinition::make(Kind kind, const Probe& probe,
                                                  const std::string& maker,
                                                  const std::string& partNumber)
{
    const std::vector<ToolMarker>& markers = probe.markers;
    if (markers.size() < kLeastForAPose)
        return fail(Errc::TooFewLandmarks, "a tool needs three markers");
    if (markers.size() > kMostMarkers)
        return fail(Errc::OutOfRange, "a tool has at most 20 markers");
    if (!std::ranges::all_of(markers, isNear, &ToolMarker::p_OQ))
        return fail(Errc::OutOfRange, "a marker more than 2 m from the tool's origin");
    if (areCollinear(markers))
        return fail(Errc::DegenerateLandmarks, "the markers of a tool");
    const Facts facts{.kind = static_cast<std::uint8_t>(kind),
                      .fewestMarkers = std::uint32_t(probe.fewest),
                      .largestMarkerError = probe.largestMisfit,
                      .largestMarkerAngle = probe.largestAngle};
    if (const auto fault = faultOf(facts, {}, markers.size()))
        return tl::unexpected(*fault);
    NdiToolDefinition tool;
    std::ranges::copy(std::as_bytes(std::span{kBegin}), tool.m_bytes.begin());
    tool.putByte(kAlwaysOneAt, 1);
    tool.putWhole(kCountAt, std::uint32_t(markers.size()));
    tool.putAsked(facts);
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

Result<NdiToolDefinition> NdiToolDefinition::with(const Facts& wanted) const
{
    const Facts stated = facts();
    if (const auto fault = faultOf(wanted, stated, wholeAt(kCountAt)))
        return tl::unexpected(*fault);
    NdiToolDefinition changed = *this;
    changed.putAsked(wanted);
    if (wanted.maker != stated.maker)
        changed.putText(kMakerAt, kMakerBytes, wanted.maker);
    if (wanted.partNumber != stated.partNumber)
        changed.putText(kPartAt, kPartBytes, wanted.partNumber);
    changed.putChecksum();
    return changed;
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

NdiToolDefinition::Facts NdiToolDefinition::facts() const
{
    return {.kind = kind(),
            .maker = maker(),
            .partNumber = partNumber(),
            .fewestMarkers = fewestMarkers(),
            .largestMarkerError = largestMarkerError(),
            .smallestSpread = smallestSpread(),
            .largestMarkerAngle = largestMarkerAngle()};
}

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

/// What is behind it in the field is zero.
void NdiToolDefinition::putText(std::size_t at, std::size_t most, const std::string& text)
{
    for (std::size_t i = 0; i < most; ++i)
        putByte(at + i, i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{0});
}

/// Its kind, and what is asked of its markers.
void NdiToolDefinition::putAsked(const Facts& facts)
{
    putByte(kKindAt, facts.kind);
    putWhole(kFewestAt, facts.fewestMarkers);
    putReal(kErrorAt, inMillimetres(facts.largestMarkerError));
    putReal(kSpreadAt, inMillimetres(facts.smallestSpread));
    putWhole(kAngleAt, std::uint32_t(std::llround(inDegrees(facts.largestMarkerAngle))));
}

std::string kindName(std::uint8_t kind)
{
    const auto* named = std::ranges::find(kKinds, NdiToolDefinition::Kind(kind), &NamedKind::kind);
    return named != std::end(kKinds) ? named->name : "kind " + std::to_string(kind);
}

std::optional<std::uint8_t> kindOfName(std::string_view name)
{
    const auto* named = std::ranges::find(kKinds, name, &NamedKind::name);
    return named != std::end(kKinds) ? std::optional{static_cast<std::uint8_t>(named->kind)}
                                     : std::nullopt;
}

std::string kindNames()
{
    std::string names;
    for (const NamedKind& each : kKinds)
        names += (names.empty() ? "" : ", ") + std::string{each.name};
    return names;
}

} // namespace carina
