#include "apps/lab/registration/recorded_stylus.h"

#include "engine/io/files/file_limit.h"
#include "engine/tracking/sequence_file.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr const char* kReferenceTool = "Reference";

const RecordedTool* referenceIn(const TrackerSequence& sequence)
{
    const auto found = std::ranges::find(sequence.tools, kReferenceTool, &RecordedTool::name);
    return found == sequence.tools.end() ? nullptr : &*found;
}

/// The tool that is a stylus, or the only one beside the reference.
const RecordedTool* stylusIn(const TrackerSequence& sequence)
{
    const RecordedTool* only = nullptr;
    std::size_t others = 0;
    for (const RecordedTool& tool : sequence.tools) {
        if (tool.role == ToolRole::Stylus)
            return &tool;
        if (tool.name == kReferenceTool)
            continue;
        only = &tool;
        ++others;
    }
    return others == 1 ? only : nullptr;
}

/// X_RS of the frames that speak of both tools, which have the same time.
std::vector<PoseSample> inReferenceFrame(const RecordedTool& stylus, const RecordedTool& reference)
{
    std::vector<PoseSample> samples;
    auto other = reference.samples.begin();
    for (const PoseSample& sample : stylus.samples) {
        while (other != reference.samples.end() && other->time < sample.time)
            ++other;
        if (other == reference.samples.end() || other->time != sample.time)
            continue;
        PoseSample relative = sample;
        relative.X_FO = other->X_FO.inverse() * sample.X_FO;
        if (other->validity == Validity::Lost)
            relative.validity = Validity::Lost;
        samples.push_back(relative);
        ++other;
    }
    return samples;
}

} // namespace

Result<RecordedStylus> readRecordedStylus(const QString& file)
{
    const Result<TrackerSequence> sequence =
        readableSize(file.toStdString(), kMeasurementLimit).and_then([&](std::uint64_t) {
            return readSequenceFile(file.toStdString());
        });
    if (!sequence)
        return tl::unexpected(sequence.error());
    const RecordedTool* stylus = stylusIn(*sequence);
    if (stylus == nullptr)
        return fail(Errc::NothingRecognised,
                    file.toStdString() + " has neither a tool Stylus nor one tool only.");
    const RecordedTool* reference = referenceIn(*sequence);
    if (reference == nullptr)
        return RecordedStylus{false, stylus->samples};
    return RecordedStylus{true, inReferenceFrame(*stylus, *reference)};
}

} // namespace carina::lab
