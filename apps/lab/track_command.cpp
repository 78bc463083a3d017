#include "apps/lab/track_command.h"

#include "engine/core/units.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/tracking/sequence_file.h"

#include <QJsonArray>

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr std::string_view kTrackHelp =
    R"(track --recording FILE
    Reads a recording of a tracker (.igs.mha) and describes each of its tools.
    --recording FILE  the recording
    schema            "carina.track/1"
    recording         FILE as given
    tools             one object per tool, in the order of the file:
      name            of the tool in the file
      samples         frames that speak of the tool
      tracked         of these, with a pose
      lost            of these, without
      duration_s      from the first pose to the last frame
      rate_hz         frames per second in that time; null below two frames
      mean_step_mm    mean way between two poses of successive frames; null where there are none
      max_gap_ms      longest time from one pose to the next; null below two poses
      bounds_mm       "min" and "max", each [x, y, z] in the tracker's frame; null without a pose
)";

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
    QJsonObject object{
        {QStringLiteral("name"), QString::fromStdString(tool.name)},
        {QStringLiteral("samples"), qint64(frames + tool.neverSeenYet)},
        {QStringLiteral("tracked"), qint64(figures.tracked)},
        {QStringLiteral("lost"), qint64(frames + tool.neverSeenYet - figures.tracked)},
        {QStringLiteral("duration_s"), seconds},
        {QStringLiteral("rate_hz"), QJsonValue::Null},
        {QStringLiteral("mean_step_mm"), QJsonValue::Null},
        {QStringLiteral("max_gap_ms"), QJsonValue::Null},
        {QStringLiteral("bounds_mm"), QJsonValue::Null}};
    if (seconds > 0.0)
        object[QStringLiteral("rate_hz")] = double(frames - 1) / seconds;
    if (figures.steps > 0)
        object[QStringLiteral("mean_step_mm")] = inMillimetres(figures.way) / double(figures.steps);
    if (figures.tracked > 1)
        object[QStringLiteral("max_gap_ms")] = toSeconds(figures.longestGap) * 1e3;
    if (figures.tracked > 0)
        object[QStringLiteral("bounds_mm")] =
            QJsonObject{{QStringLiteral("min"), inMillimetresOf(figures.bounds_T.min)},
                        {QStringLiteral("max"), inMillimetresOf(figures.bounds_T.max)}};
    return object;
}

Result<QJsonObject> track(const QStringList& arguments)
{
    if (arguments.size() != 2 || arguments.front() != QStringLiteral("--recording"))
        return fail(Errc::OutOfRange, "track needs --recording FILE and nothing else.");
    const Result<TrackerSequence> sequence = readSequenceFile(arguments.back().toStdString());
    if (!sequence)
        return tl::unexpected(sequence.error());
    QJsonArray tools;
    for (const RecordedTool& tool : sequence->tools)
        tools.append(objectOf(tool));
    return QJsonObject{{QStringLiteral("schema"), QStringLiteral("carina.track/1")},
                       {QStringLiteral("recording"), arguments.back()},
                       {QStringLiteral("tools"), tools}};
}

} // namespace

Command trackCommand() { return {"track", kTrackHelp, track}; }

} // namespace carina::lab
