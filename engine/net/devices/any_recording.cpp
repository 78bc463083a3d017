#include "engine/net/devices/any_recording.h"

#include "engine/io/files/file_limit.h"
#include "engine/io/files/whole_file.h"
#include "engine/net/devices/device_replay.h"
#include "engine/tracking/record/pose_record.h"
#include "engine/tracking/sequence_fields.h"
#include "engine/tracking/tool_role.h"
#include "engine/tracking/tum_file.h"

#include <algorithm>

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

Result<TrackerSequence> ownRecord(const std::filesystem::path& file)
{
    return field::openFile(file).and_then(
        [&](std::ifstream input) { return pose_record::read(input, file.string()); });
}

Result<TrackerSequence> trajectory(const std::filesystem::path& file)
{
    return readTumFile(file).map([&](std::vector<PoseSample> samples) {
        const std::string name = file.stem().string();
        return TrackerSequence{
            {{.name = name, .role = toolRoleOfName(name), .samples = std::move(samples)}}};
    });
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

Result<void> writeTrajectories(const std::filesystem::path& file, const TrackerSequence& sequence)
{
    for (std::size_t i = 0; i < sequence.tools.size(); ++i) {
        std::filesystem::path each = file;
        if (i > 0)
            each.replace_filename(file.stem().string() + "-" + std::to_string(i + 1) + ".tum");
        if (const auto wrote = writeWholeFile(each, tumText(sequence.tools[i])); !wrote)
            return wrote;
    }
    return {};
}

} // namespace

Result<TrackerSequence> readAnyRecording(const std::filesystem::path& file)
{
    if (const auto size = readableSize(file, kMeasurementLimit); !size)
        return tl::unexpected(size.error());
    if (file.extension() == ".mha")
        return readSequenceFile(file);
    if (beginsWith(file, pose_record::kFirstLine))
        return ownRecord(file);
    if (isConversation(file))
        return replayedConversation(file);
    if (file.extension() == ".tum" || file.extension() == ".txt")
        return trajectory(file);
    return beginsWith(file, "ObjectType") ? readSequenceFile(file)
                                          : fail(Errc::UnknownFormat, file.string());
}

Result<void> writeAnyRecording(const std::filesystem::path& file, const TrackerSequence& sequence)
{
    if (file.extension() == ".csv")
        return writeWholeFile(file, recordText(sequence));
    if (file.extension() == ".mha")
        return writeWholeFile(file, sequenceText(sequence));
    if (file.extension() == ".tum")
        return writeTrajectories(file, sequence);
    return fail(Errc::UnknownFormat, file.string());
}

bool canWriteRecording(const std::filesystem::path& file)
{
    return file.extension() == ".csv" || file.extension() == ".mha" || file.extension() == ".tum";
}

} // namespace carina
