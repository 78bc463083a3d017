#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/core/units.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/net/devices/any_recording.h"

#include <QJsonArray>

#include <algorithm>

namespace carina::lab
{
namespace
{

namespace track_option
{
constexpr Option kRecording{"recording", "FILE",
                            "the recording: .igs.mha of Plus or 3D Slicer, Carina's own (.csv), "
                            "the conversation with a device, or a trajectory (.tum)"};
constexpr Option kSave{"save", "FILE",
                       "write it, in the form of the extension: .csv, .igs.mha or .tum (of the "
                       "second tool in NAME-2.tum, and so on)"};
} // namespace track_option

namespace track_key
{
constexpr Key kRecording{"recording", "FILE as given"};
constexpr Key kTools{"tools", "one object per tool, in the order of the file:"};
constexpr Key kName{"name", "of the tool in the file", 1};
constexpr Key kSamples{"samples", "frames with an entry for the tool", 1};
constexpr Key kTracked{"tracked", "of these, with a pose", 1};
constexpr Key kLost{"lost", "of these, without a pose", 1};
constexpr Key kDuration{"duration_s", "from the first pose to the last frame", 1};
constexpr Key kRate{"rate_hz", "frames per second in that time; null below two frames", 1};
constexpr Key kMeanStep{
    "mean_step_mm",
    "mean distance between the poses of two successive frames; null where there are none", 1};
constexpr Key kMaxGap{"max_gap_ms", "longest time from one pose to the next; null below two poses",
                      1};
constexpr Key kBounds{"bounds_mm",
                      "\"min\" and \"max\", each [x, y, z] in the tracker's frame; null without "
                      "a pose",
                      1};
constexpr Key kMin{"min", "", 2};
constexpr Key kMax{"max", "", 2};
constexpr Key kSchema{"schema", "carina.track/1"};
} // namespace track_key

/// What the poses of a tool amount to.
struct ToolFigures {
    std::size_t tracked = 0;
    std::size_t steps = 0; ///< between poses of successive frames
    Length way;            ///< sum of the steps
    Duration longestGap{};
    Box bounds_T;
};

ToolFigures figuresOf(const RecordedTool& tool)
{
    ToolFigures figures;
    const PoseSample* lastTracked = nullptr;
    const PoseSample* last = nullptr;
    for (const PoseSample& sample : tool.samples) {
        if (sample.validity != Validity::Lost) {
            const Vec3& p_T = sample.X_FO.translation();
            ++figures.tracked;
            figures.bounds_T.include(p_T);
            if (lastTracked != nullptr)
                figures.longestGap = std::max(figures.longestGap, sample.time - lastTracked->time);
            if (lastTracked != nullptr && lastTracked == last) {
                ++figures.steps;
                figures.way = figures.way + metres((p_T - lastTracked->X_FO.translation()).norm());
            }
            lastTracked = &sample;
        }
        last = &sample;
    }
    return figures;
}

QJsonArray inMillimetresOf(const Vec3& p)
{
    return {inMillimetres(metres(p.x())), inMillimetres(metres(p.y())),
            inMillimetres(metres(p.z()))};
}

QJsonObject objectOf(const RecordedTool& tool)
{
    const ToolFigures figures = figuresOf(tool);
    const std::size_t frames = tool.samples.size();
    const double seconds =
        frames > 0 ? toSeconds(tool.samples.back().time - tool.samples.front().time) : 0.0;
    QJsonObject object{{track_key::kName, QString::fromStdString(tool.name)},
                       {track_key::kSamples, qint64(frames + tool.neverSeenYet)},
                       {track_key::kTracked, qint64(figures.tracked)},
                       {track_key::kLost, qint64(frames + tool.neverSeenYet - figures.tracked)},
                       {track_key::kDuration, seconds},
                       {track_key::kRate, QJsonValue::Null},
                       {track_key::kMeanStep, QJsonValue::Null},
                       {track_key::kMaxGap, QJsonValue::Null},
                       {track_key::kBounds, QJsonValue::Null}};
    if (seconds > 0.0)
        object[track_key::kRate] = double(frames - 1) / seconds;
    if (figures.steps > 0)
        object[track_key::kMeanStep] = inMillimetres(figures.way) / double(figures.steps);
    if (figures.tracked > 1)
        object[track_key::kMaxGap] = toSeconds(figures.longestGap) * 1e3;
    if (figures.tracked > 0)
        object[track_key::kBounds] =
            QJsonObject{{track_key::kMin, inMillimetresOf(figures.bounds_T.min)},
                        {track_key::kMax, inMillimetresOf(figures.bounds_T.max)}};
    return object;
}

Result<QJsonObject> track(const Words& words)
{
    if (!words.has(track_option::kRecording))
        return words.refuse(QStringLiteral("needs --recording FILE and nothing else."));
    const QString file = words.text(track_option::kRecording);
    const Result<TrackerSequence> sequence = readAnyRecording(file.toStdString());
    if (!sequence)
        return tl::unexpected(sequence.error());
    if (words.has(track_option::kSave))
        if (const auto wrote =
                writeAnyRecording(words.text(track_option::kSave).toStdString(), *sequence);
            !wrote)
            return tl::unexpected(wrote.error());
    QJsonArray tools;
    for (const RecordedTool& tool : sequence->tools)
        tools.append(objectOf(tool));
    return QJsonObject{{track_key::kSchema, QLatin1StringView{track_key::kSchema.help}},
                       {track_key::kRecording, file},
                       {track_key::kTools, tools}};
}

} // namespace

Command trackCommand()
{
    return {
        .name = "track",
        .theme = "tracking",
        .summary = "describes the tools of a tracker's recording",
        .uses = {{.lines = {"--recording FILE [--save FILE]"},
                  .text = "Reads a recording of a tracker and describes each of its tools; with "
                          "--save it is also written in another form.",
                  .options = {track_option::kRecording, track_option::kSave},
                  .schema = track_key::kSchema,
                  .keys = {track_key::kRecording, track_key::kTools, track_key::kName,
                           track_key::kSamples, track_key::kTracked, track_key::kLost,
                           track_key::kDuration, track_key::kRate, track_key::kMeanStep,
                           track_key::kMaxGap, track_key::kBounds}}},
        .experiment = track};
}

} // namespace carina::lab
