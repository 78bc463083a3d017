#include "apps/lab/summary/summary_command.h"

#include "apps/lab/summary/breath_estimate.h"
#include "apps/lab/summary/drift_between.h"
#include "apps/lab/summary/volume_between.h"
#include "models/station/frame_log.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>

#include <algorithm>
#include <vector>

namespace carina::lab
{
namespace
{

/// One process of the demo: what it wrote of itself, and its frames.
struct Viewer {
    QJsonObject report;
    std::vector<LoggedFrame> frames;
};

Result<QJsonObject> readObject(const QString& path)
{
    QFile file{path};
    if (!file.open(QIODevice::ReadOnly))
        return fail(Errc::FileNotFound,
                    "No " + path.toStdString() + ". Run ./carina demo --headless DIR first.");
    const QJsonDocument document = QJsonDocument::fromJson(file.readAll());
    if (!document.isObject())
        return fail(Errc::FileMalformed, path.toStdString() + " is not a JSON object.");
    return document.object();
}

Result<Viewer> readViewer(const QDir& folder, const QString& name)
{
    auto report = readObject(folder.filePath(name + QStringLiteral(".json")));
    if (!report)
        return tl::unexpected(report.error());
    auto frames = readFrames(folder.filePath(name + QStringLiteral("_frames.csv")));
    if (!frames)
        return tl::unexpected(frames.error());
    return Viewer{std::move(*report), std::move(*frames)};
}

/// Median and 95th percentile of the newest sample's age when each frame was drawn.
QJsonObject sampleAges(const std::vector<LoggedFrame>& frames)
{
    std::vector<double> ages_ms;
    for (const LoggedFrame& frame : frames)
        if (frame.sampleAge)
            ages_ms.push_back(1e3 * toSeconds(*frame.sampleAge));
    if (ages_ms.empty())
        return {};
    std::sort(ages_ms.begin(), ages_ms.end());
    return {{QStringLiteral("median_ms"), ages_ms[ages_ms.size() / 2]},
            {QStringLiteral("p95_ms"), ages_ms[(ages_ms.size() * 95 + 99) / 100 - 1]}};
}

/// Breathing estimated from the volumes drawn since the controls came to rest.
QJsonObject drawnBreathing(const Viewer& viewer, SessionTime from)
{
    std::vector<VolumeSample> samples;
    for (const LoggedFrame& frame : viewer.frames)
        if (frame.session >= from)
            samples.push_back({frame.local, frame.volume_ml[0] + frame.volume_ml[1]});
    const auto estimate = estimateBreathing(samples);
    if (!estimate)
        return {};
    return {{QStringLiteral("breathing_rate_per_min"), inPerMinute(estimate->rate)},
            {QStringLiteral("tidal_volume_ml"), inMillilitres(estimate->tidalVolume)},
            {QStringLiteral("breaths"), estimate->breaths}};
}

QJsonObject describe(const Viewer& viewer, SessionTime steadyFrom)
{
    QJsonObject object = viewer.report;
    object.remove(QStringLiteral("console"));
    object[QStringLiteral("frames")] = static_cast<int>(viewer.frames.size());
    if (viewer.frames.size() > 1)
        object[QStringLiteral("frames_per_second")] =
            double(viewer.frames.size() - 1)
            / toSeconds(viewer.frames.back().local - viewer.frames.front().local);
    object[QStringLiteral("tracker_sample_age")] = sampleAges(viewer.frames);
    object[QStringLiteral("drawn")] = drawnBreathing(viewer, steadyFrom);
    return object;
}

QJsonObject describe(const DriftSummary& drift)
{
    return {{QStringLiteral("instants"), drift.instants},
            {QStringLiteral("mean_deg"), drift.mean_deg},
            {QStringLiteral("p95_deg"), drift.p95_deg},
            {QStringLiteral("largest_deg"), drift.largest_deg},
            {QStringLiteral("mean_mm"), drift.mean_mm},
            {QStringLiteral("p95_mm"), drift.p95_mm},
            {QStringLiteral("largest_mm"), drift.largest_mm},
            {QStringLiteral("clock_mean_ms"), drift.clockMean_ms},
            {QStringLiteral("clock_largest_ms"), drift.clockLargest_ms}};
}

QJsonObject describe(const VolumeDifference& difference)
{
    return {{QStringLiteral("instants"), difference.instants},
            {QStringLiteral("mean_ml"), difference.mean_ml},
            {QStringLiteral("p95_ml"), difference.p95_ml},
            {QStringLiteral("largest_ml"), difference.largest_ml}};
}

/// What the console and the viewer drew of the lungs, against each other.
QJsonObject lungVolumes(const Viewer& console, const Viewer& viewer)
{
    const auto apart = [&](Sameness same) {
        return describe(volumesBetween(console.frames, viewer.frames, same));
    };
    return {{QStringLiteral("same_session_time"), apart(Sameness::SessionTime)},
            {QStringLiteral("same_instant"), apart(Sameness::Instant)}};
}

/// Frames drawn within a span of session time, told on CLOCK_MONOTONIC alone: what the session
/// clocks are off then is drift like any other.
std::vector<LoggedFrame> onSharedClock(const Viewer& viewer, SessionTime from, SessionTime until)
{
    std::vector<LoggedFrame> frames;
    for (LoggedFrame frame : viewer.frames) {
        if (frame.session < from || frame.session >= until)
            continue;
        frame.session = SessionTime{frame.local.time_since_epoch()};
        frames.push_back(frame);
    }
    return frames;
}

/// The virtual patient while the script in the console turned it, and what nothing can be below:
/// of each of both changes of its angular velocity by w nobody else can know before the delay d, so
/// that over the time T the average is at least w d^2 / T.
QJsonObject actionDrift(const Viewer& instructor, const Viewer& trainee)
{
    const QJsonObject action = instructor.report[QStringLiteral("console")]
                                   .toObject()[QStringLiteral("action")]
                                   .toObject();
    const auto timeOf = [&action](const char* key) {
        return SessionTime{Duration{action[QLatin1String{key}].toString().toLongLong()}};
    };
    const SessionTime from = timeOf("from_ns");
    const SessionTime until = timeOf("until_ns");
    if (from == SessionTime{} || until <= from)
        return {};
    QJsonObject drift =
        describe(driftBetween(onSharedClock(instructor, from, until),
                              onSharedClock(trainee, from, until), &LoggedFrame::X_AV));
    drift.remove(QStringLiteral("clock_mean_ms"));
    drift.remove(QStringLiteral("clock_largest_ms"));
    const QJsonValue delay_ms = trainee.report[QStringLiteral("action_delay_ms")];
    if (delay_ms.isUndefined())
        return drift;
    const double delay_s = 1e-3 * delay_ms.toDouble();
    drift[QStringLiteral("delay_ms")] = delay_ms;
    drift[QStringLiteral("limit_mean_deg")] = action[QStringLiteral("speed_deg_per_s")].toDouble()
                                              * delay_s * delay_s / toSeconds(until - from);
    return drift;
}

Result<QJsonObject> summarise(const QStringList& arguments)
{
    if (arguments.size() != 1)
        return fail(Errc::OutOfRange, "summary takes one folder: carina-lab summary DIR");
    const QDir folder{arguments.first()};
    const auto instructor = readViewer(folder, QStringLiteral("instructor"));
    if (!instructor)
        return tl::unexpected(instructor.error());
    const auto trainee = readViewer(folder, QStringLiteral("trainee"));
    if (!trainee)
        return tl::unexpected(trainee.error());

    const QJsonObject console = instructor->report[QStringLiteral("console")].toObject();
    const SessionTime steadyFrom{
        Duration{console[QStringLiteral("steady_from_ns")].toString().toLongLong()}};
    QJsonObject summary{
        {QStringLiteral("schema"), QStringLiteral("carina.demo/1")},
        {QStringLiteral("console"), console},
        {QStringLiteral("instructor"), describe(*instructor, steadyFrom)},
        {QStringLiteral("trainee"), describe(*trainee, steadyFrom)},
        {QStringLiteral("drift"), describe(driftBetween(trainee->frames, instructor->frames))},
        {QStringLiteral("lung_volume_difference"), lungVolumes(*instructor, *trainee)},
        {QStringLiteral("action_drift"), actionDrift(*instructor, *trainee)}};
    const QString registration = folder.filePath(QStringLiteral("registration.json"));
    if (QFile::exists(registration)) {
        const auto report = readObject(registration);
        if (!report)
            return tl::unexpected(report.error());
        summary[QStringLiteral("registration")] = *report;
    }
    return summary;
}

constexpr std::string_view kSummaryHelp = R"(summary DIR
    What a headless demo measured, from the logs of its two processes in DIR. schema carina.demo/1
      console                the values in force in the console while it was measured:
                             breathing_rate_per_min, tidal_volume_ml, and steady_from_ns, the session
                             time from which on they held; action: the virtual patient was turned at
                             speed_deg_per_s from from_ns to to_ns, and lay still until until_ns
      instructor, trainee    per program: screenshot, anatomy, triangles and level (of detail) drawn,
                             frames, frames_per_second, tracker_sample_age (median_ms and p95_ms of
                             the newest tube sample's age when a frame is lit), visible_pixels
                             (per part, from an id pass), drawn (breathing_rate_per_min,
                             tidal_volume_ml and breaths, estimated from the volumes of the vertices
                             drawn). The trainee of a headset's output has "overlay" besides: how
                             far carina, vocal_cords and incisors were drawn from where the
                             simulator's manikin was before the head when the frame was lit (mean_mm,
                             p95_mm, largest_mm), over a number of frames
      registration           of a demo with --register: what carina-registration measured, described
                             in docs/registration.md; overlay_error_mm is how far the stored
                             registration lies from the simulator's truth
      drift                  the tube in the console against the tube at the trainee for the same
                             session time, over a number of instants: mean_, p95_, largest_ in _deg
                             and _mm; clock_mean_ms and clock_largest_ms are the difference of the two
                             session clocks against CLOCK_MONOTONIC
      lung_volume_difference the gas in both lungs as drawn by the console against that drawn by the
                             trainee, over a number of instants: mean_, p95_, largest_ml, once for
                             the same_session_time by each one's own clock, and once for the
                             same_instant of CLOCK_MONOTONIC, where the clocks' difference counts too.
                             largest_ml is an upper bound: between frames the volume is interpolated,
                             also across the corner where an inspiration ends
      action_drift           the virtual patient at the trainee against the one in the console, for
                             the instants at which both were lit, while the script turned it by the
                             controls of "Actions": instants, mean_, p95_, largest_ as for drift;
                             delay_ms is how long an action took to arrive, and limit_mean_deg what
                             mean_deg cannot be below with that delay
)";

} // namespace

Command summaryCommand() { return {"summary", kSummaryHelp, summarise}; }

} // namespace carina::lab
