#include "engine/net/devices/any_recording.h"

#include "engine/io/files/file_limit.h"
#include "engine/io/files/unused_name.h"
#include "engine/io/files/whole_file.h"
#include "engine/net/devices/device_replay.h"
#include "engine/tracking/record/pose_record.h"
#include "engine/tracking/sequence_fields.h"
#include "engine/tracking/tool_role.h"
#include "engine/tracking/tum_file.h"

#include <algorithm>
#include <fstream>
#include <istream>

namespace carina
{
namespace
{

bool beginsWith(const std::filesystem::path& file, std::string_view words)
{
    auto input = field::openFile(file);
    std::string text(words.size(), '\0');
    return input && input->read(text.data(), std::streamsize(text.size())) && text == words;
}

/// A file that is read, and asks meanwhile whether to go on.
class WatchedFile : public std::filebuf
{
public:
    WatchedFile(const std::filesystem::path& file, std::uint64_t size, const Progress& goesOn)
        : m_size{double(std::max<std::uint64_t>(1, size))}, m_goesOn{goesOn}
    {
        open(file, std::ios::in | std::ios::binary);
    }
    [[nodiscard]] bool isStopped() const { return m_isStopped; }

protected:
    int_type underflow() override
    {
        if (m_isStopped || (m_goesOn && !m_goesOn(std::min(1.0, m_read / m_size)))) {
            m_isStopped = true;
            return traits_type::eof();
        }
        const int_type next = std::filebuf::underflow();
        m_read += double(egptr() - gptr());
        return next;
    }

private:
    double m_size;
    double m_read = 0.0;
    const Progress& m_goesOn;
    bool m_isStopped = false;
};

Result<TrackerSequence> trajectory(std::istream& input, const std::filesystem::path& file)
{
    return readTum(input, file.string()).map([&](std::vector<PoseSample> samples) {
        const std::string name = file.stem().string();
        return TrackerSequence{
            {{.name = name, .role = toolRoleOfName(name), .samples = std::move(samples)}}};
    });
}

Result<TrackerSequence> readAs(std::istream& input, const std::filesystem::path& file)
{
    if (file.extension() == ".mha")
        return readSequence(input, file.string());
    if (beginsWith(file, pose_record::kFirstLine))
        return pose_record::read(input, file.string());
    if (isConversation(file))
        return replayedConversation(input, file.string());
    if (file.extension() == ".tum" || file.extension() == ".txt")
        return trajectory(input, file);
    return beginsWith(file, "ObjectType") ? readSequence(input, file.string())
                                          : fail(Errc::UnknownFormat, file.string());
}

std::string recordText(const TrackerSequence& sequence)
{
    std::vector<std::pair<const RecordedTool*, const PoseSample*>> samples;
    for (const RecordedTool& tool : sequence.tools)
        for (const PoseSample& sample : tool.samples)
            samples.push_back({&tool, &sample});
    std::ranges::stable_sort(samples, {}, [](const auto& each) { return each.second->time; });
    std::string text = pose_record::beginning();
    for (const auto& [tool, sample] : samples)
        text += pose_record::line(*tool, *sample);
    return text;
}

Result<void> writeTrajectories(const std::filesystem::path& file, const TrackerSequence& sequence,
                               const Progress& goesOn)
{
    const std::size_t tools = sequence.tools.size();
    for (std::size_t i = 0; i < tools; ++i) {
        if (goesOn && !goesOn(double(i) / double(tools)))
            return fail(Errc::Cancelled, file.string());
        const auto each = i == 0 ? file : unusedName(file);
        if (const auto wrote = writeWholeFile(each, tumText(sequence.tools[i])); !wrote)
            return wrote;
    }
    return {};
}

} // namespace

Result<TrackerSequence> readAnyRecording(const std::filesystem::path& file, const Progress& goesOn)
{
    const auto size = readableSize(file, kMeasurementLimit);
    if (!size)
        return tl::unexpected(size.error());
    WatchedFile watched{file, *size, goesOn};
    if (!watched.is_open())
        return fail(Errc::FileUnreadable, file.string());
    std::istream input{&watched};
    auto sequence = readAs(input, file);
    return watched.isStopped() ? fail(Errc::Cancelled, file.string()) : std::move(sequence);
}

Result<void> writeAnyRecording(const std::filesystem::path& file, const TrackerSequence& sequence,
                               const Progress& goesOn)
{
    if (file.extension() == ".csv")
        return writeWholeFile(file, recordText(sequence));
    if (file.extension() == ".mha")
        return sequenceText(sequence, goesOn).and_then([&](const std::string& text) {
            return writeWholeFile(file, text);
        });
    if (file.extension() == ".tum")
        return writeTrajectories(file, sequence, goesOn);
    return fail(Errc::UnknownFormat, file.string() + ": its name ends in none of .csv, .mha, .tum");
}

bool canWriteRecording(const std::filesystem::path& file)
{
    return file.extension() == ".csv" || file.extension() == ".mha" || file.extension() == ".tum";
}

} // namespace carina
