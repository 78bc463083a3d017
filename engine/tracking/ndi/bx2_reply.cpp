#include "engine/core/byte_buffer.h"
#include "engine/tracking/ndi/ndi_fields.h"
#include "engine/tracking/ndi/ndi_frame.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::uint16_t kFrame = 1;
constexpr std::uint16_t kPose6d = 2;
constexpr std::uint16_t kPosition3d = 3;
constexpr std::size_t kComponentHeader = 12;
constexpr std::uint16_t kStrayHandle = 0xFFFF;

// The status of a tool: a code in its low byte, and bits.
constexpr std::uint16_t kMissingBit = 0x0100;
constexpr std::uint16_t kLeastReason = 9; // below it a code is of a pose

NdiSight sightOf(std::uint16_t status)
{
    const std::uint16_t code = status & 0xFFU;
    if ((status & kMissingBit) != 0 && code < kLeastReason)
        return NdiSight::Missing;
    switch (code) {
    case 0:
        return NdiSight::Tracked;
    case 3:
        return NdiSight::PartlyOutOfVolume;
    case 5:
        return NdiSight::PartlyAveraged;
    case 9:
        return NdiSight::OutOfVolume;
    case 13:
        return NdiSight::TooFewMarkers;
    case 14:
        return NdiSight::Interference;
    case 17:
        return NdiSight::BadFit;
    case 31:
        return NdiSight::Missing;
    case 32:
        return NdiSight::Disabled;
    case 33:
        return NdiSight::Unoccupied;
    default:
        return NdiSight::Failed;
    }
}

/// Reads components into a frame.
class GbfReader
{
public:
    explicit GbfReader(NdiFrame& frame) : m_frame{frame} {}

    void read(ByteReader& gbf)
    {
        static_cast<void>(gbf.number<std::uint16_t>()); // its version
        const auto components = gbf.number<std::uint16_t>();
        for (int i = 0; i < components && gbf.ok(); ++i)
            readComponent(gbf);
    }

private:
    void readComponent(ByteReader& gbf)
    {
        const auto type = gbf.number<std::uint16_t>();
        const std::size_t size = gbf.number<std::uint32_t>();
        static_cast<void>(gbf.number<std::uint16_t>()); // options of its items
        const auto count = gbf.number<std::uint32_t>();
        gbf.require(size >= kComponentHeader, "the size of a component");
        ByteReader items{gbf.bytes(gbf.ok() ? size - kComponentHeader : 0)};
        for (std::uint32_t i = 0; i < count && gbf.ok() && items.ok(); ++i) {
            if (type == kFrame)
                readFrame(items);
            else if (type == kPose6d)
                readTool(items);
            else if (type == kPosition3d)
                readMarkers(items);
            else
                return; // buttons, pictures, alerts
        }
        items.require(items.remaining() == 0, "the end of a component");
        if (!items.ok())
            gbf.require(false, items.brokenRule());
    }

    /// Its own components follow, with no size around them.
    void readFrame(ByteReader& items)
    {
        items.require(!m_isInFrame, "a frame in a frame");
        static_cast<void>(items.number<std::uint8_t>());  // its type
        static_cast<void>(items.number<std::uint8_t>());  // its number in a sequence
        static_cast<void>(items.number<std::uint16_t>()); // its status
        m_frameNumber = items.number<std::uint32_t>();
        const auto seconds = items.number<std::uint32_t>();
        const auto nanoseconds = items.number<std::uint32_t>();
        if (!items.ok())
            return;
        m_frame = {};
        m_frame.deviceTime = std::chrono::seconds{seconds} + std::chrono::nanoseconds{nanoseconds};
        m_isInFrame = true;
        read(items);
        m_isInFrame = false;
    }

    void readTool(ByteReader& items)
    {
        NdiTool tool{.handle = items.number<std::uint16_t>()};
        const auto status = items.number<std::uint16_t>();
        tool.status = status;
        tool.sight = sightOf(status);
        tool.frameNumber = m_frameNumber;
        if ((status & kMissingBit) == 0) {
            const ndi::StatedPose pose = ndi::poseFrom(items);
            if (items.ok())
                ndi::placeTool(tool, pose, m_frame);
        }
        if (items.ok())
            m_frame.tools.push_back(std::move(tool));
    }

    void readMarkers(ByteReader& items)
    {
        const auto handle = items.number<std::uint16_t>();
        const auto count = items.number<std::uint16_t>();
        std::vector<Vec3> markers;
        for (int i = 0; i < count && items.ok(); ++i) {
            static_cast<void>(items.number<std::uint8_t>());  // its status
            static_cast<void>(items.number<std::uint8_t>());  // reserved
            static_cast<void>(items.number<std::uint16_t>()); // its place in the tool
            const Vec3 p_TQ = ndi::positionFrom(items);
            if (p_TQ.allFinite()) // one that is not seen
                markers.push_back(p_TQ);
        }
        if (handle == kStrayHandle) {
            m_frame.p_TStrays = std::move(markers);
            return;
        }
        const auto tool = std::ranges::find(m_frame.tools, handle, &NdiTool::handle);
        if (tool != m_frame.tools.end())
            tool->p_TMarkers = std::move(markers);
    }

    NdiFrame& m_frame;
    std::uint32_t m_frameNumber = 0;
    bool m_isInFrame = false;
};

} // namespace

Result<NdiFrame> decodeBx2(std::span<const std::byte> body)
{
    ByteReader gbf{body};
    NdiFrame frame;
    GbfReader{frame}.read(gbf);
    gbf.require(gbf.remaining() == 0, "its end");
    if (!gbf.ok())
        return fail(Errc::DeviceReplyDamaged, std::string{"BX2: "} + gbf.brokenRule());
    return frame;
}

} // namespace carina
