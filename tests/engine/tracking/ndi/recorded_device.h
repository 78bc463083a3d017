#pragma once

#include "engine/tracking/ndi/ndi_recording.h"
#include "tests/engine/tracking/ndi/scripted_line.h"

#include <deque>
#include <map>
#include <set>

namespace carina::test
{

/// A text on the line without checksum and CR.
inline std::string contentOf(const std::string& bytes)
{
    constexpr std::size_t kEnd = 5;
    return bytes.substr(0, bytes.size() - std::min(kEnd, bytes.size()));
}

/// A device that answers to each command what a recorded one answered to the same bytes, each time
/// the next. A few commands of the client are in no recording, or came at another time; their
/// replies are made of recorded ones:
///
/// - a break, after which the recordings begin: RESET;
/// - RESET, to which the devices of then say nothing: none;
/// - VER:4: what VER:0 told, else the error of a command that is not known;
/// - PHINF with 0020, a tool's place: the end of what 0021 or 0025 told, of which it is the last;
/// - PHSR:02 before PHRQ: without the tools that have their handles from it later;
/// - TX with 0801: what 0001 told, as 0800 adds poses out of the volume only;
/// - TX with 0803: the same, with no marker of any tool seen.
class RecordedDevice
{
public:
    explicit RecordedDevice(const std::vector<NdiExchange>& recording)
    {
        for (const NdiExchange& each : recording) {
            if (each.command.empty() || each.reply.empty())
                continue;
            if (each.command.starts_with("TX:"))
                m_poses.push_back(each.reply);
            else
                m_replies[each.command].push_back(each.reply);
            if (each.command.starts_with("PHRQ:"))
                m_wireless.insert(contentOf(each.reply));
            if (each.command.starts_with("PHINF:") && isWithPlace(each.command))
                m_places[each.command.substr(6, 2)] = placeIn(each.reply);
        }
    }

    [[nodiscard]] std::string answer(const std::string& command)
    {
        const auto begins = [&](const char* name) { return command.starts_with(name); };
        if (command.empty())
            return "RESETBE6F\r";
        m_isAskedForHandle = m_isAskedForHandle || begins("PHRQ:");
        if (begins("TX:0801") || begins("TX:0803"))
            return nextPoses(begins("TX:0803"));
        if (begins("PHINF:") && command.substr(8, 4) == "0020")
            return textReply(m_places[command.substr(6, 2)]);
        if (begins("PHSR:02") && !m_isAskedForHandle)
            return withoutWireless(next(command));
        if (begins("VER:4") && !m_replies.contains(command)) {
            const std::string told = next("VER:065EE\r");
            return told.empty() ? textReply("ERROR01") : told;
        }
        return next(command);
    }

    /// Whether it has a recorded reply to TX that was not asked for yet.
    [[nodiscard]] bool hasPoses() const { return !m_poses.empty(); }
    /// The handles that were asked for.
    [[nodiscard]] const std::set<std::string>& wireless() const { return m_wireless; }

private:
    static constexpr std::size_t kPlace = 14;
    static constexpr std::size_t kEntry = 5; ///< of PHSR: handle and status

    static bool isWithPlace(const std::string& command)
    {
        return command.substr(8, 4) == "0021" || command.substr(8, 4) == "0025";
    }
    static std::string placeIn(const std::string& reply)
    {
        const std::string told = contentOf(reply);
        return told.substr(told.size() - std::min(kPlace, told.size()));
    }

    std::string next(const std::string& command)
    {
        std::deque<std::string>& replies = m_replies[command];
        if (replies.empty())
            return {};
        std::string reply = std::move(replies.front());
        replies.pop_front();
        return reply;
    }

    std::string nextPoses(bool tellsMarkers)
    {
        if (m_poses.empty())
            return {};
        std::string reply = std::move(m_poses.front());
        m_poses.pop_front();
        if (!tellsMarkers)
            return reply;
        std::string text;
        for (const char c : contentOf(reply))
            text += c == '\n' ? std::string(22, '0') + c : std::string(1, c);
        return textReply(text);
    }

    [[nodiscard]] std::string withoutWireless(const std::string& reply) const
    {
        if (m_wireless.empty())
            return reply;
        const std::string told = contentOf(reply);
        std::string entries;
        for (std::size_t at = 2; at + kEntry <= told.size(); at += kEntry)
            if (!m_wireless.contains(told.substr(at, 2)))
                entries += told.substr(at, kEntry);
        return textReply('0' + std::to_string(entries.size() / kEntry) + entries);
    }

    std::map<std::string, std::deque<std::string>> m_replies; ///< by command
    std::deque<std::string> m_poses;
    std::set<std::string> m_wireless;
    std::map<std::string, std::string> m_places; ///< by handle
    bool m_isAskedForHandle = false;
};

} // namespace carina::test
