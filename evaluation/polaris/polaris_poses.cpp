#include "evaluation/polaris/polaris_poses.h"

#include "evaluation/polaris/polaris_bytes.h"

#include <cmath>
#include <map>

namespace carina
{
namespace
{

using polaris::little;
using polaris::real;
using polaris::written;

constexpr unsigned kAsksPoses = 0x0001;
constexpr unsigned kAsksMarkers = 0x0002;
constexpr unsigned kAsksSingleStray = 0x0004;
constexpr unsigned kAsksOutOfVolume = 0x0800;
constexpr unsigned kAsksStrays = 0x1000;
constexpr unsigned kAsksKnown =
    kAsksPoses | kAsksMarkers | kAsksSingleStray | kAsksOutOfVolume | kAsksStrays;

// What is told of a tool and its markers: bits, and four more for each of twenty markers.
constexpr unsigned kBadFit = 0x01;
constexpr unsigned kNotEnoughMarkers = 0x02;
constexpr int kMarkers = 20;
constexpr unsigned kWrongPlace = 2; // of a marker
constexpr unsigned kUsed = 3;

// Of a port in TX and BX.
constexpr unsigned kIsOutside = 0x40;
constexpr unsigned kIsPartlyOut = 0x80;

// Of BX2.
constexpr unsigned kNoPose = 0x0100;
constexpr unsigned kPosedPartlyOut = 3;
constexpr unsigned kOutOfVolume = 9;
constexpr unsigned kUnplugged = 33;

unsigned portStatus(const PolarisExposure::Tool& tool)
{
    return tool.status | (tool.place == PolarisPlace::Outside ? kIsOutside : 0)
           | (tool.place == PolarisPlace::PartlyOut ? kIsPartlyOut : 0);
}

/// Of TX and BX with these options; nothing for one that is not stated.
std::optional<PolarisPose> statedPose(const PolarisExposure::Tool& tool, unsigned asked)
{
    const bool isStated = tool.place != PolarisPlace::Outside || (asked & kAsksOutOfVolume) != 0;
    return isStated ? tool.pose : std::nullopt;
}

unsigned toolBits(const PolarisExposure::Tool& tool)
{
    if (tool.pose)
        return 0;
    return tool.loss == PolarisLoss::BadFit ? kBadFit : kNotEnoughMarkers;
}

/// Of each of the last two markers in the list.
unsigned lastMarkers(const PolarisExposure::Tool& tool)
{
    if (tool.pose || tool.loss == PolarisLoss::Hidden || tool.loss == PolarisLoss::Interference)
        return 0;
    return tool.loss == PolarisLoss::BadFit ? 0x11 * kWrongPlace : kUsed;
}

unsigned generalStatus(const PolarisExposure::Tool& tool)
{
    static const std::map<PolarisLoss, unsigned> kCodes{{PolarisLoss::Hidden, 31},
                                                        {PolarisLoss::FewMarkers, 13},
                                                        {PolarisLoss::BadFit, 17},
                                                        {PolarisLoss::Interference, 14}};
    if (!tool.isPlugged)
        return kNoPose | kUnplugged;
    if (tool.place == PolarisPlace::Outside)
        return kOutOfVolume | (tool.pose ? 0 : kNoPose);
    if (tool.pose)
        return tool.place == PolarisPlace::PartlyOut ? kPosedPartlyOut : 0;
    return kNoPose | kCodes.at(tool.loss);
}

/// Of TX and BX; nothing where they are not known.
std::optional<unsigned> known(const std::string& options)
{
    const auto asked = polaris::hexadecimal(options);
    return asked && *asked != 0 && (*asked & ~kAsksKnown) == 0 ? asked : std::nullopt;
}

std::string realPose(const PolarisPose& pose)
{
    std::string out;
    for (const double number : {pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z(), pose.p_mm.x(),
                                pose.p_mm.y(), pose.p_mm.z(), pose.error_mm})
        out += real(number);
    return out;
}

std::string textPoint(const Vec3& p_mm)
{
    std::string out;
    for (const double number : p_mm)
        out += written("%+07ld", std::lround(number * 1e2));
    return out;
}

std::string textPose(const PolarisPose& pose)
{
    std::string out;
    for (const double number : {pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()})
        out += written("%+06ld", std::lround(number * 1e4));
    return out + textPoint(pose.p_mm) + written("%+06ld", std::lround(pose.error_mm * 1e4));
}

std::string textTool(const PolarisExposure::Tool& tool, unsigned asked, std::uint32_t frame)
{
    std::string out = written("%02X", unsigned(tool.handle));
    if (!tool.isPlugged)
        return out + "UNOCCUPIED\n";
    const auto pose = statedPose(tool, asked);
    if ((asked & kAsksPoses) != 0)
        out += (pose ? textPose(*pose) : "MISSING")
               + written("%08X%08X", portStatus(tool), unsigned(frame));
    if ((asked & kAsksMarkers) != 0)
        out += written("%02X", toolBits(tool)) + std::string(kMarkers - 2, '0')
               + written("%02X", lastMarkers(tool));
    if ((asked & kAsksSingleStray) != 0)
        out += "00"; // none
    return out + '\n';
}

/// The count, for each whether it is out of the volume, four to a digit, and where they are.
std::string textStrays(const std::vector<Vec3>& strays_mm)
{
    std::string out = written("%02X", unsigned(strays_mm.size()));
    out += std::string((strays_mm.size() + 3) / 4, '0');
    for (const Vec3& p_mm : strays_mm)
        out += textPoint(p_mm);
    return out;
}

std::string binaryTool(const PolarisExposure::Tool& tool, unsigned asked, std::uint32_t frame)
{
    const std::string handle = little(std::uint64_t(tool.handle), 1);
    if (!tool.isPlugged)
        return handle + little(4, 1); // disabled
    const auto pose = statedPose(tool, asked);
    std::string out = handle + little(pose ? 1 : 2, 1);
    if ((asked & kAsksPoses) != 0)
        out += (pose ? realPose(*pose) : std::string{}) + little(portStatus(tool), 4)
               + little(frame, 4);
    if ((asked & kAsksMarkers) != 0)
        out += little(toolBits(tool), 1) + std::string(kMarkers / 2 - 1, '\0')
               + little(lastMarkers(tool), 1);
    if ((asked & kAsksSingleStray) != 0)
        out += little(0, 1);
    return out;
}

std::string binaryStrays(const std::vector<Vec3>& strays_mm)
{
    std::string out = little(strays_mm.size(), 1);
    out += std::string((strays_mm.size() + 7) / 8, '\0');
    for (const Vec3& p_mm : strays_mm)
        for (const double number : p_mm)
            out += real(number);
    return out;
}

} // namespace

std::string textReply(const PolarisExposure& seen, const std::string& options)
{
    const auto asked = known(options);
    if (!asked)
        return polaris::asText(polaris::error(0x23));
    std::string out = written("%02X", unsigned(seen.tools.size()));
    for (const PolarisExposure::Tool& tool : seen.tools)
        out += textTool(tool, *asked, seen.frame);
    if ((*asked & kAsksStrays) != 0)
        out += textStrays(seen.strays_mm);
    return polaris::asText(out + written("%04X", seen.system));
}

std::string binaryReply(const PolarisExposure& seen, const std::string& options)
{
    const auto asked = known(options);
    if (!asked)
        return polaris::asText(polaris::error(0x23));
    std::string out = little(seen.tools.size(), 1);
    for (const PolarisExposure::Tool& tool : seen.tools)
        out += binaryTool(tool, *asked, seen.frame);
    if ((*asked & kAsksStrays) != 0)
        out += binaryStrays(seen.strays_mm);
    return polaris::asBinary(out + little(seen.system, 2));
}

std::string generalReply(const PolarisExposure& seen)
{
    std::string tools;
    for (const PolarisExposure::Tool& tool : seen.tools)
        tools += little(std::uint64_t(tool.handle), 2) + little(generalStatus(tool), 2)
                 + (tool.pose ? realPose(*tool.pose) : std::string{});
    const auto component = [](std::uint64_t type, std::uint64_t items, const std::string& bytes) {
        return little(type, 2) + little(12 + bytes.size(), 4) + little(0, 2) + little(items, 4)
               + bytes;
    };
    const auto time = std::uint64_t(seen.time.time_since_epoch().count());
    const std::string frame = little(1, 1) + little(0, 1) + little(0, 2) + little(seen.frame, 4)
                              + little(time / 1'000'000'000, 4) + little(time % 1'000'000'000, 4)
                              + little(1, 2) + little(1, 2)
                              + component(2, seen.tools.size(), tools);
    return polaris::asBinary(little(1, 2) + little(1, 2) + component(1, 1, frame));
}

} // namespace carina
