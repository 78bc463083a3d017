#include "engine/net/devices/device_replay.h"

#include "engine/net/devices/device_client.h"
#include "engine/net/devices/device_log_header.h"
#include "engine/tracking/ndi/ndi_conversation.h"
#include "engine/tracking/ndi/recorded_line.h"
#include "engine/tracking/sequence_fields.h"

#include <algorithm>
#include <map>

namespace carina
{
namespace
{

constexpr std::size_t kLookedAt = 4096;                ///< characters, for what a file is
constexpr std::int64_t kLatestSeconds = 6'000'000'000; ///< since 1970
constexpr double kExposuresPerSecond = 60.0;           ///< where a recording has no times

/// One line of a log behind its first.
struct LoggedLine {
    LocalTime time{};
    bool opens = false;
    bool isReply = false; ///< else a command, or nothing
    std::string bytes{};
};

/// Seconds since 1970 with up to nine decimals. All of them count: what a client does at the time
/// that it waited for, it would not do a tenth of a microsecond before.
std::optional<LocalTime> timeOf(std::string_view text)
{
    const std::size_t point = std::min(text.find('.'), text.size());
    const auto seconds = field::numberOf<std::int64_t>(text.substr(0, point));
    std::string decimals{text.substr(std::min(point + 1, text.size()))};
    decimals.resize(9, '0');
    const auto nanoseconds = field::numberOf<std::int64_t>(decimals);
    if (!seconds || !nanoseconds || *seconds < 0 || *seconds > kLatestSeconds || *nanoseconds < 0)
        return std::nullopt;
    return LocalTime{std::chrono::seconds{*seconds} + std::chrono::nanoseconds{*nanoseconds}};
}

std::optional<LoggedLine> loggedLine(std::string_view text)
{
    text = field::trimmed(text);
    const auto time = timeOf(text.substr(0, text.find(' ')));
    const std::size_t level = text.find(") ");
    if (!time || level == std::string_view::npos)
        return std::nullopt;
    text.remove_prefix(level + 2);
    LoggedLine line{.time = *time, .opens = text == kDeviceLogOpened};
    if (line.opens || text == kDeviceLogWaited)
        return line;
    const auto head = ndi::takeHead(text);
    auto bytes = head ? ndi::unescaped(text) : std::nullopt;
    if (!bytes || bytes->size() != head->bytes)
        return std::nullopt;
    line.isReply = head->isReply;
    line.bytes = *std::move(bytes);
    return line;
}

/// Holds a conversation again.
class Replay
{
public:
    explicit Replay(const TrackerDescription& description) : m_client{deviceClient(description)}
    {
        for (const DescribedTool& tool : description.tools)
            m_sequence.tools.push_back({.name = tool.name, .role = tool.role});
        m_last.resize(m_sequence.tools.size());
    }

    void take(const LoggedLine& line)
    {
        if (line.opens) {
            m_isOpen = true;
            m_client->start(line.time, [](int) { return true; }); // no port of this computer
        }
        if (!m_isOpen)
            return;
        if (line.isReply)
            m_client->take(std::as_bytes(std::span{line.bytes}), line.time);
        advance(line.time);
    }

    [[nodiscard]] TrackerSequence finish() { return std::move(m_sequence); }

private:
    void advance(LocalTime now)
    {
        static_cast<void>(m_client->advance(now));
        for (const DeviceSight& sight : m_client->takeSights())
            add(sight);
    }

    void add(const DeviceSight& sight)
    {
        RecordedTool& tool = m_sequence.tools[sight.tool];
        std::optional<RigidTransform>& last = m_last[sight.tool];
        if (sight.X_TO)
            last = sight.X_TO;
        if (!last) {
            ++tool.neverSeenYet;
            return;
        }
        const SessionTime time{sight.exposed.time_since_epoch()};
        if (!tool.samples.empty() && time < tool.samples.back().time)
            return; // a clock that was converted anew
        tool.samples.push_back({.time = time,
                                .X_FO = *last,
                                .validity = sight.X_TO ? sight.validity : Validity::Lost,
                                .error = sight.error});
    }

    std::unique_ptr<DeviceClient> m_client;
    TrackerSequence m_sequence;
    std::vector<std::optional<RigidTransform>> m_last;
    bool m_isOpen = false;
};

bool hasPose(const TrackerSequence& sequence)
{
    return std::ranges::any_of(sequence.tools,
                               [](const auto& tool) { return !tool.samples.empty(); });
}

Result<TrackerSequence> replayed(std::istream& input, const std::string& name)
{
    std::string text;
    std::getline(input, text);
    auto description = readDeviceLogHeader(std::string_view{text}.substr(kDeviceLogBegins.size()));
    if (!description)
        return fail(Errc::FileMalformed, name + ": line 1: " + description.error().detail);
    Replay replay{*description};
    for (std::size_t number = 2; std::getline(input, text); ++number) {
        if (input.eof())
            break; // the program was killed within this line
        const auto line = loggedLine(text);
        if (!line)
            return fail(Errc::FileMalformed, name + ": line " + std::to_string(number)
                                                 + ": no opening, command or reply with its time");
        replay.take(*line);
    }
    return replay.finish();
}

/// The tools of a conversation that others recorded.
TrackerSequence handlesIn(const NdiConversation& conversation)
{
    std::map<std::uint16_t, RecordedTool> tools;
    for (const RecordedNdiFrame& recorded : conversation.frames)
        for (const NdiTool& seen : recorded.frame.tools) {
            RecordedTool& tool = tools[seen.handle];
            const double seconds =
                recorded.seconds.value_or(seen.frameNumber / kExposuresPerSecond);
            const SessionTime time{fromSeconds(seconds)};
            if (!seen.X_TO && tool.samples.empty()) {
                ++tool.neverSeenYet;
                continue;
            }
            if (!tool.samples.empty() && time < tool.samples.back().time)
                continue;
            tool.samples.push_back(
                {.time = time,
                 .X_FO = seen.X_TO.value_or(tool.samples.empty() ? RigidTransform{}
                                                                 : tool.samples.back().X_FO),
                 .validity = validityOf(seen),
                 .error = seen.error});
        }
    TrackerSequence sequence;
    for (auto& [handle, tool] : tools) {
        constexpr std::string_view kDigits = "0123456789ABCDEF";
        tool.name = {'P', 'o', 'r', 't', ' ', kDigits[handle >> 4U & 0xFU], kDigits[handle & 0xFU]};
        sequence.tools.push_back(std::move(tool));
    }
    return sequence;
}

std::string beginningOf(std::istream& input, std::size_t most)
{
    std::string text(most, '\0');
    input.read(text.data(), std::streamsize(most));
    text.resize(std::size_t(input.gcount()));
    return text;
}

} // namespace

Result<TrackerSequence> replayedConversation(std::istream& input, const std::string& name)
{
    const bool isOurs = beginningOf(input, kDeviceLogBegins.size()) == kDeviceLogBegins;
    input.clear();
    input.seekg(0);
    auto sequence = isOurs ? replayed(input, name)
                           : readNdiRecording(input, name).map([](const auto& exchanges) {
                                 return handlesIn(decode(exchanges));
                             });
    if (sequence && !hasPose(*sequence))
        return fail(Errc::FileMalformed, name + ": it has no pose");
    return sequence;
}

bool isConversation(const std::filesystem::path& file)
{
    auto input = field::openFile(file);
    if (!input)
        return false;
    const std::string text = beginningOf(*input, kLookedAt);
    return text.starts_with(kDeviceLogBegins) || text.find("command[") != std::string::npos
           || text.find("sent:") != std::string::npos;
}

} // namespace carina
