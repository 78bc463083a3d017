#pragma once

#include "engine/tracking/ndi/ndi_recording.h"
#include "evaluation/polaris/polaris_device.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace carina::test
{

/// Without line end.
inline std::string bare(std::string text)
{
    while (text.ends_with('\r') || text.ends_with('\n'))
        text.pop_back();
    return text;
}

/// Without line end and checksum.
inline std::string content(const std::string& text)
{
    const std::string line = bare(text);
    return line.substr(0, line.size() - std::min<std::size_t>(4, line.size()));
}

inline unsigned digitsOf(const std::string& text)
{
    return unsigned(std::stoul("0" + text, nullptr, 16));
}

/// What a recorded reply to TX or BX has apart from its poses.
struct PoseShape {
    std::vector<bool> isSeen;         ///< of each tool
    std::vector<PolarisPlace> places; ///< likewise
    std::size_t strays = 0;
    std::string text; ///< all but poses, frame numbers, states of markers and checksums
};

/// By the status of its port: 40 outside, 80 partly.
inline PolarisPlace placeOf(unsigned status)
{
    if ((status & 0x40U) != 0)
        return PolarisPlace::Outside;
    return (status & 0x80U) != 0 ? PolarisPlace::PartlyOut : PolarisPlace::Inside;
}

/// The reply to TX with options.
inline PoseShape shapeOfText(unsigned options, const std::string& reply)
{
    PoseShape shape;
    std::size_t at = 0;
    const auto take = [&](std::size_t count) {
        const std::string taken = reply.substr(std::min(at, reply.size()), count);
        at += count;
        return taken;
    };
    const auto keep = [&](std::size_t count) {
        const std::string taken = take(count);
        shape.text += taken + ' ';
        return taken;
    };
    for (unsigned tools = digitsOf(keep(2)); tools > 0; --tools) {
        keep(2); // handle
        if ((options & 0x0001U) != 0) {
            const bool isSeen = reply.compare(at, 7, "MISSING") != 0;
            take(isSeen ? 51 : 7);
            shape.isSeen.push_back(isSeen);
            shape.text += isSeen ? "pose " : "missing ";
            shape.places.push_back(placeOf(digitsOf(keep(8))));
            take(8); // frame
        }
        take((options & 0x0002U) != 0 ? 22 : 0);
        keep((options & 0x0004U) != 0 ? 2 : 0);
        keep(1);
    }
    if ((options & 0x1000U) != 0) {
        shape.strays = digitsOf(keep(2));
        keep((shape.strays + 3) / 4);
        take(shape.strays * 21);
    }
    keep(4); // status of the system
    take(4); // checksum
    shape.text += std::to_string(reply.size() - std::min(at, reply.size())) + " left";
    return shape;
}

/// The same of the reply to BX.
inline PoseShape shapeOfBinary(unsigned options, const std::string& reply)
{
    PoseShape shape;
    std::size_t at = 0;
    const auto take = [&](std::size_t count) {
        const std::string taken = reply.substr(std::min(at, reply.size()), count);
        at += count;
        return taken;
    };
    const auto keep = [&](std::size_t count) {
        unsigned number = 0;
        const std::string taken = take(count);
        for (std::size_t i = taken.size(); i-- > 0;)
            number = 256 * number + static_cast<unsigned char>(taken[i]);
        shape.text += std::to_string(number) + ' ';
        return number;
    };
    keep(2); // the mark, the length, its checksum
    keep(2);
    keep(2);
    for (unsigned tools = keep(1); tools > 0; --tools) {
        keep(1); // handle
        const unsigned state = keep(1);
        shape.isSeen.push_back(state == 1);
        if ((options & 0x0001U) != 0) {
            take(state == 1 ? 32 : 0);
            shape.places.push_back(placeOf(keep(4)));
            take(4); // frame
        }
        take((options & 0x0002U) != 0 ? 11 : 0);
        keep((options & 0x0004U) != 0 ? 1 : 0);
    }
    if ((options & 0x1000U) != 0) {
        shape.strays = keep(1);
        keep((shape.strays + 7) / 8);
        take(shape.strays * 12);
    }
    keep(2); // status of the system
    take(2); // checksum
    shape.text += std::to_string(reply.size() - std::min(at, reply.size())) + " left";
    return shape;
}

inline bool asksForPoses(const std::string& command)
{
    return command.starts_with("TX:") || command.starts_with("BX:");
}

/// @pre asksForPoses(command)
inline PoseShape shapeOf(const std::string& command, const std::string& reply)
{
    const unsigned options = digitsOf(command.substr(3, 4));
    return command.starts_with("TX:") ? shapeOfText(options, reply) : shapeOfBinary(options, reply);
}

/// Puts what an answer to PHINF tells of a plugged tool into it; the location also tells the
/// device's serial number.
inline void learn(PluggedTool& tool, std::string& serialNumber, unsigned options,
                  const std::string& told)
{
    std::size_t at = 0;
    const auto field = [&](unsigned option, std::size_t length) {
        const bool isTold = (options & option) != 0;
        const std::string text = isTold ? told.substr(at, length) : std::string{};
        at += isTold ? length : 0;
        return text;
    };
    const std::string information = field(0x0001, 33);
    const bool isKnown = !information.starts_with("00000000 ");
    if (!information.empty() && isKnown)
        tool.information = information.substr(0, 31);
    if (const std::string test = field(0x0002, 8); !test.empty())
        tool.electricalTest = test;
    if (const std::string part = field(0x0004, 20); !part.empty() && isKnown)
        tool.partNumber = part;
    if (const std::string more = field(0x0008, 2); !more.empty() && isKnown)
        tool.accessories = more;
    if (const std::string markers = field(0x0010, 2); !markers.empty())
        tool.markers = markers;
    if (const std::string location = field(0x0020, 14); !location.empty()) {
        serialNumber = location.substr(0, 8);
        tool.port = std::stoi(location.substr(10, 2));
    }
}

/// The device that a conversation was recorded with, as far as it tells: its firmware, and what is
/// plugged into it.
inline PolarisDevice::Settings recordedDevice(const std::vector<NdiExchange>& conversation)
{
    PolarisDevice::Settings settings;
    std::set<unsigned> wireless;
    std::map<unsigned, PluggedTool> plugged;
    for (const NdiExchange& each : conversation) {
        const std::string command = content(each.command);
        const std::string told = content(each.reply);
        if (command.starts_with("PHRQ:"))
            wireless.insert(digitsOf(told));
        if (command == "PHSR:02")
            for (std::size_t at = 2; at + 5 <= told.size(); at += 5)
                if (const unsigned handle = digitsOf(told.substr(at, 2));
                    !wireless.contains(handle))
                    plugged[handle].port = int(handle);
        for (const char* constant : {"VER:", "SFLIST:", "SSTAT:", "BEEP:", "IRCHK:"})
            if (command.starts_with(constant))
                settings.constants[command] = told;
    }
    for (const NdiExchange& each : conversation) {
        const std::string command = content(each.command);
        if (!command.starts_with("PHINF:") && !command.starts_with("PINIT:"))
            continue;
        const auto tool = plugged.find(digitsOf(command.substr(6, 2)));
        if (tool == plugged.end())
            continue;
        if (command.starts_with("PINIT:"))
            tool->second.warns = content(each.reply) == "WARNING";
        else
            learn(tool->second, settings.serialNumber, digitsOf(command.substr(8)),
                  content(each.reply));
    }
    for (const auto& [handle, tool] : plugged)
        settings.wired.push_back(tool);
    return settings;
}

} // namespace carina::test
