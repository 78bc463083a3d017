#include "engine/core/byte_buffer.h"
#include "engine/tracking/ndi/ndi_fields.h"
#include "engine/tracking/ndi/ndi_frame.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::uint16_t kBxOptions = kNdiPoses | kNdiMarkerStates | kNdiSingleStray
                                     | kNdiMarkerPositions | kNdiOutOfVolumeToo | kNdiStrays;
constexpr std::size_t kMarkerStateBytes = 10; // four bits of each of twenty
// The status byte of a handle.
constexpr std::uint8_t kValid = 0x01;
constexpr std::uint8_t kMissing = 0x02;
constexpr std::uint8_t kDisabled = 0x04;

/// A count, a bit for each marker that is out of the volume, and the positions.
std::vector<Vec3> markersFrom(ByteReader& body)
{
    const auto count = body.number<std::uint8_t>();
    static_cast<void>(body.bytes((std::size_t{count} + 7) / 8));
    std::vector<Vec3> markers;
    for (int i = 0; i < count && body.ok(); ++i)
        markers.push_back(ndi::positionFrom(body));
    body.require(std::ranges::all_of(markers, [](const Vec3& p_TQ) { return p_TQ.allFinite(); }),
                 "the position of a marker");
    return markers;
}

/// Of the tool, and of its markers.
void readStates(ByteReader& body, NdiTool& tool)
{
    const auto bits = body.number<std::uint8_t>();
    const auto isSeen = [](std::byte two) { return two != std::byte{0}; };
    ndi::judgeMissing(tool, bits, std::ranges::any_of(body.bytes(kMarkerStateBytes), isSeen));
}

NdiTool toolFrom(ByteReader& body, std::uint16_t options, NdiFrame& frame)
{
    NdiTool tool{.handle = body.number<std::uint8_t>()};
    const auto status = body.number<std::uint8_t>();
    if (status == kDisabled) {
        tool.sight = NdiSight::Disabled;
        return tool;
    }
    body.require(status == kValid || status == kMissing, "the status of a tool");
    if ((options & kNdiPoses) == 0)
        return tool;
    if (status == kValid) {
        const ndi::StatedPose pose = ndi::poseFrom(body);
        if (body.ok())
            ndi::placeTool(tool, pose, frame);
    }
    tool.status = body.number<std::uint32_t>();
    tool.frameNumber = body.number<std::uint32_t>();
    ndi::judge(tool);
    if ((options & kNdiMarkerStates) != 0)
        readStates(body, tool);
    if ((options & kNdiSingleStray) != 0 && (body.number<std::uint8_t>() & kValid) != 0)
        tool.p_TMarkers.push_back(ndi::positionFrom(body));
    if ((options & kNdiMarkerPositions) != 0)
        tool.p_TMarkers = markersFrom(body);
    return tool;
}

} // namespace

Result<NdiFrame> decodeBx(std::span<const std::byte> bytes, std::uint16_t options)
{
    if ((options & ~kBxOptions) != 0)
        return fail(Errc::WrongOption, "BX with options that are not understood");
    ByteReader body{bytes};
    NdiFrame frame;
    const auto tools = body.number<std::uint8_t>();
    for (int i = 0; i < tools && body.ok(); ++i) {
        NdiTool tool = toolFrom(body, options, frame);
        if ((options & kNdiPoses) != 0)
            frame.tools.push_back(std::move(tool));
    }
    if ((options & kNdiStrays) != 0)
        frame.p_TStrays = markersFrom(body);
    frame.status = body.number<std::uint16_t>();
    ndi::judgeMissing(frame);
    body.require(body.remaining() == 0, "its end");
    if (!body.ok())
        return fail(Errc::DeviceReplyDamaged, std::string{"BX: "} + body.brokenRule());
    return frame;
}

} // namespace carina
