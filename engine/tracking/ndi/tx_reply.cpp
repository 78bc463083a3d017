#include "engine/core/units.h"
#include "engine/tracking/ndi/ndi_fields.h"
#include "engine/tracking/ndi/ndi_frame.h"

#include <charconv>

namespace carina
{
namespace
{

constexpr std::uint16_t kTxOptions =
    kNdiPoses | kNdiMarkerStates | kNdiSingleStray | kNdiOutOfVolumeToo | kNdiStrays;
constexpr std::size_t kMarkerStateDigits = 20; // one of each marker
constexpr std::size_t kPosition = 7;           // characters of a coordinate
constexpr double kPositionUnit_mm = 1e-2;
constexpr std::uint32_t kSeenStray = 0x01; // of the status of a single stray

/// Reads the fields of the text one after another. After the first that is not as it has to be
/// ok() is false for good, and fields are zero.
class TxReader
{
public:
    explicit TxReader(std::string_view text) : m_rest{text} {}

    [[nodiscard]] bool ok() const { return m_broken == nullptr; }
    [[nodiscard]] const char* broken() const { return m_broken; }
    [[nodiscard]] bool isAtEnd() const { return m_rest.empty(); }

    void require(bool holds, const char* rule)
    {
        if (!holds && ok())
            m_broken = rule;
    }

    std::uint32_t hexadecimal(std::size_t digits)
    {
        return whole<std::uint32_t>(taken(digits), 16, "a hexadecimal number");
    }

    /// A sign and digits, the last `decimals` of which are behind the point.
    double decimal(std::size_t characters, double unit)
    {
        const std::string_view text = taken(characters);
        require(text.starts_with('+') || text.starts_with('-'), "the sign of a number");
        if (!ok())
            return 0.0;
        const double amount = whole<std::uint32_t>(text.substr(1), 10, "a number") * unit;
        return text[0] == '-' ? -amount : amount;
    }

    void skipDigits(std::size_t count) { static_cast<void>(taken(count)); }
    /// Whether one of so many digits is not 0.
    bool hasDigit(std::size_t count)
    {
        return taken(count).find_first_not_of('0') != std::string_view::npos;
    }
    bool skip(std::string_view word)
    {
        if (!ok() || !m_rest.starts_with(word))
            return false;
        m_rest.remove_prefix(word.size());
        return true;
    }

private:
    template <class Number> Number whole(std::string_view digits, int base, const char* what)
    {
        Number value = 0;
        const char* const end = digits.data() + digits.size();
        const auto [stop, fault] = std::from_chars(digits.data(), end, value, base);
        require(fault == std::errc{} && stop == end && !digits.empty(), what);
        return ok() ? value : Number{0};
    }

    std::string_view taken(std::size_t count)
    {
        require(m_rest.size() >= count, "its length");
        if (!ok())
            return {};
        const std::string_view first = m_rest.substr(0, count);
        m_rest.remove_prefix(count);
        return first;
    }

    std::string_view m_rest;
    const char* m_broken = nullptr;
};

ndi::StatedPose poseFrom(TxReader& text)
{
    constexpr std::size_t kQuaternion = 6;
    constexpr std::size_t kError = 6;
    ndi::StatedPose pose;
    for (double* each : {&pose.q0, &pose.qx, &pose.qy, &pose.qz})
        *each = text.decimal(kQuaternion, 1e-4);
    for (double* each : {&pose.x_mm, &pose.y_mm, &pose.z_mm})
        *each = text.decimal(kPosition, kPositionUnit_mm);
    pose.error_mm = text.decimal(kError, 1e-4);
    return pose;
}

Vec3 positionFrom(TxReader& text)
{
    Vec3 p_TQ;
    for (double& each : p_TQ)
        each = millimetres(text.decimal(kPosition, kPositionUnit_mm)).si;
    return p_TQ;
}

/// A count, a bit for each that is out of the volume, in whole digits, and the positions.
std::vector<Vec3> straysFrom(TxReader& text)
{
    const std::uint32_t count = text.hexadecimal(2);
    text.skipDigits((count + 3) / 4);
    std::vector<Vec3> strays;
    for (std::uint32_t i = 0; i < count && text.ok(); ++i)
        strays.push_back(positionFrom(text));
    return strays;
}

/// Status, frame number and options of a tool that is in a port.
void readState(TxReader& text, NdiTool& tool, std::uint16_t options)
{
    tool.status = text.hexadecimal(8);
    tool.frameNumber = text.hexadecimal(8);
    ndi::judge(tool);
    if ((options & kNdiMarkerStates) != 0) {
        const std::uint32_t bits = text.hexadecimal(2);
        ndi::judgeMissing(tool, bits, text.hasDigit(kMarkerStateDigits));
    }
    if ((options & kNdiSingleStray) != 0 && (text.hexadecimal(2) & kSeenStray) != 0)
        tool.p_TMarkers.push_back(positionFrom(text));
}

NdiTool toolFrom(TxReader& text, std::uint16_t options, NdiFrame& frame)
{
    NdiTool tool{.handle = static_cast<std::uint16_t>(text.hexadecimal(2))};
    if (text.skip("UNOCCUPIED")) {
        tool.sight = NdiSight::Unoccupied;
    } else if (text.skip("DISABLED")) {
        tool.sight = NdiSight::Disabled;
    } else if ((options & kNdiPoses) != 0) {
        if (!text.skip("MISSING")) {
            const ndi::StatedPose pose = poseFrom(text);
            if (text.ok())
                ndi::placeTool(tool, pose, frame);
        }
        readState(text, tool, options);
    }
    text.require(text.skip("\n"), "the end of a tool's line");
    return tool;
}

} // namespace

Result<NdiFrame> decodeTx(std::string_view text, std::uint16_t options)
{
    if ((options & ~kTxOptions) != 0)
        return fail(Errc::WrongOption, "TX with options that are not understood");
    TxReader reader{text};
    NdiFrame frame;
    const std::uint32_t tools = reader.hexadecimal(2);
    for (std::uint32_t i = 0; i < tools && reader.ok(); ++i) {
        NdiTool tool = toolFrom(reader, options, frame);
        if ((options & kNdiPoses) != 0)
            frame.tools.push_back(std::move(tool));
    }
    if ((options & kNdiStrays) != 0)
        frame.p_TStrays = straysFrom(reader);
    frame.status = static_cast<std::uint16_t>(reader.hexadecimal(4));
    ndi::judgeMissing(frame);
    reader.require(reader.isAtEnd(), "its end");
    if (!reader.ok())
        return fail(Errc::DeviceReplyDamaged, std::string{"TX: "} + reader.broken());
    return frame;
}

} // namespace carina
