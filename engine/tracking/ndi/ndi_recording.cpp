#include "engine/tracking/ndi/ndi_recording.h"

#include "engine/tracking/ndi/recorded_line.h"
#include "engine/tracking/sequence_fields.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace carina
{
namespace
{

using ndi::EntryHead;
using ndi::skip;
using ndi::takeHead;
using ndi::takeNumber;
using ndi::unescaped;

constexpr std::string_view kSent = "sent:";
constexpr std::string_view kReceived = "recv:";

class RecordingReader
{
public:
    RecordingReader(std::string_view text, const std::string& name) : m_rest{text}, m_name{name} {}

    Result<std::vector<NdiExchange>> read()
    {
        while (!m_rest.empty())
            if (const Result<void> taken = takeEntry(); !taken)
                return tl::unexpected(taken.error());
        if (m_exchanges.empty())
            return fail(Errc::FileEmpty, m_name + ": it has no command and no reply");
        return std::move(m_exchanges);
    }

private:
    [[nodiscard]] tl::unexpected<Error> refused(const char* what) const
    {
        return fail(Errc::FileMalformed, m_name + ": line " + std::to_string(m_line) + ": " + what);
    }

    std::string_view takeBytes(std::size_t count)
    {
        const std::string_view bytes = m_rest.substr(0, count);
        m_rest.remove_prefix(bytes.size());
        m_line += std::size_t(std::ranges::count(bytes, '\n'));
        return bytes;
    }

    /// Without its line end, which is taken, too.
    std::string_view takeLine()
    {
        const std::size_t end = m_rest.find('\n');
        std::string_view line = takeBytes(end == std::string_view::npos ? end : end + 1);
        if (line.ends_with('\n'))
            line.remove_suffix(1);
        return field::trimmed(line);
    }

    Result<void> takeEntry()
    {
        m_entryLine = m_line;
        std::string_view rest = m_rest;
        if (const auto head = takeHead(rest))
            return takeRaw(*head, m_rest.size() - rest.size());
        if (m_rest.starts_with(kSent) || m_rest.starts_with(kReceived))
            return takeNumbered();
        std::string_view line = takeLine();
        const std::size_t blank = line.find_first_of(" \t");
        const auto seconds = field::numberOf<double>(line.substr(0, blank));
        const std::size_t level = line.find(") ");
        if (!seconds || level == std::string_view::npos)
            return {}; // a remark
        line.remove_prefix(level + 2);
        if (const auto head = takeHead(line))
            return takeEscaped(*head, line, *seconds);
        return {};
    }

    /// The bytes as they were. Where an editor has made line ends of CR it is put back.
    Result<void> takeRaw(const EntryHead& head, std::size_t headBytes)
    {
        static_cast<void>(takeBytes(headBytes));
        if (head.bytes > m_rest.size())
            return refused("it ends within a reply");
        std::string bytes{takeBytes(head.bytes)};
        if (m_rest.starts_with('\n'))
            static_cast<void>(takeBytes(1));
        else if (bytes.ends_with('\n'))
            bytes.back() = '\r';
        add(head, std::move(bytes), {});
        return {};
    }

    Result<void> takeEscaped(const EntryHead& head, std::string_view text, double seconds)
    {
        auto bytes = unescaped(text);
        if (!bytes)
            return refused("a byte that is not \\xHH");
        if (bytes->size() != head.bytes)
            return refused("not as many bytes as it says");
        add(head, *std::move(bytes), seconds);
        return {};
    }

    /// "sent:0012 = TX:0001031A", up to the next line that begins so.
    Result<void> takeNumbered()
    {
        EntryHead head{.isReply = m_rest.starts_with(kReceived)};
        std::string_view rest = m_rest.substr(kSent.size());
        const auto number = takeNumber(rest);
        if (!number || !skip(rest, " = "))
            return refused("no number and no '='");
        head.number = *number;
        static_cast<void>(takeBytes(m_rest.size() - rest.size()));
        const std::size_t end = std::min(m_rest.find("\nsent:"), m_rest.find("\nrecv:"));
        std::string bytes{takeBytes(end == std::string_view::npos ? end : end + 1)};
        while (bytes.ends_with('\n') || bytes.ends_with('\r'))
            bytes.pop_back();
        if (!bytes.empty()) // a command that was not recorded
            add(head, bytes + '\r', {});
        return {};
    }

    void add(const EntryHead& head, std::string bytes, std::optional<double> seconds)
    {
        // A reply that comes in pieces is one; a command begins an exchange.
        const bool goesOn = head.isReply && !m_exchanges.empty() && head.number == m_number;
        m_number = head.number;
        if (!goesOn)
            m_exchanges.push_back({.line = m_entryLine});
        NdiExchange& exchange = m_exchanges.back();
        (head.isReply ? exchange.reply : exchange.command) += bytes;
        if (head.isReply)
            exchange.seconds = seconds;
    }

    std::string_view m_rest;
    std::string m_name;
    std::size_t m_line = 1;
    std::size_t m_entryLine = 1;
    std::size_t m_number = 0;
    std::vector<NdiExchange> m_exchanges;
};

} // namespace

Result<std::vector<NdiExchange>> readNdiRecording(std::istream& input, const std::string& name)
{
    const std::string text{std::istreambuf_iterator<char>{input}, {}};
    if (input.bad())
        return fail(Errc::FileUnreadable, name + ": reading it failed");
    return RecordingReader{text, name}.read();
}

Result<std::vector<NdiExchange>> readNdiRecordingFile(const std::filesystem::path& path)
{
    return field::openFile(path).and_then(
        [&](std::ifstream input) { return readNdiRecording(input, path.string()); });
}

} // namespace carina
