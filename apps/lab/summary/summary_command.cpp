#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/summary/breath_estimate.h"
#include "apps/lab/summary/drift_between.h"
#include "apps/lab/summary/volume_between.h"
#include "engine/io/files/file_limit.h"
#include "models/station/frame_log.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <vector>

namespace carina::lab
{
namespace
{

namespace summary_key
{
constexpr Key kSchema{"schema", "carina.demo/1"};
constexpr Key kConsole{"console", "the values in force in the console during the measurement:"};
constexpr Key kRate{"breathing_rate_per_min", "of breathing", 1};
constexpr Key kTidalVolume{"tidal_volume_ml", "of breathing", 1};
constexpr Key kSteadyFrom{"steady_from_ns", "session time from which on these held", 1};
constexpr Key kAction{"action", "how the script turned the virtual patient:", 1};
constexpr Key kTurningSpeed{"speed_deg_per_s", "of the turn", 2};
constexpr Key kFrom{"from_ns", "session time at which the turn began", 2};
constexpr Key kTo{"to_ns", "session time at which it ended", 2};
constexpr Key kUntil{"until_ns", "session time until which the patient lay still after it", 2};
constexpr Key kInstructor{"instructor", "what the console drew:"};
constexpr Key kViewSchema{"schema", "\"carina.view/1\"", 1};
constexpr Key kScreenshot{"screenshot", "its file", 1};
constexpr Key kAnatomy{"anatomy", "name of the anatomy drawn", 1};
constexpr Key kAnatomyHash{"anatomy_hash", "hash of its content", 1};
constexpr Key kTriangles{"triangles", "that were drawn", 1};
constexpr Key kLevel{"level", "of detail that was drawn", 1};
constexpr Key kFrames{"frames", "that were drawn", 1};
constexpr Key kFramesPerSecond{"frames_per_second", "mean of all frames", 1};
constexpr Key kSampleAge{
    "tracker_sample_age",
    "age of the newest sample of the tube when a frame was lit (latency), null where none came:",
    1};
constexpr Key kMedianAge{"median_ms", "median", 2};
constexpr Key kPercentileAge{"p95_ms", "95th percentile", 2};
constexpr Key kVisiblePixels{"visible_pixels",
                             "for each part, as a drawing of part numbers shows "
                             "them",
                             1};
constexpr Key kDrawn{"drawn", "breathing, estimated from the volumes of the vertices drawn:", 1};
constexpr Key kDrawnRate{"breathing_rate_per_min", "of breathing", 2};
constexpr Key kDrawnTidalVolume{"tidal_volume_ml", "of breathing", 2};
constexpr Key kBreaths{"breaths", "that the estimate is from", 2};
constexpr Key kTrainee{"trainee", "the same of the trainee's view, and:"};
constexpr Key kActionDelay{"action_delay_ms", "latency of an action", 1};
constexpr Key kOverlay{
    "overlay",
    "with a headset's output: over a number of frames, how far \"carina\", \"vocal_cords\" and "
    "\"incisors\" were drawn from where the manikin of the simulator was before the head when the "
    "frame was lit (mean_mm, p95_mm, largest_mm)",
    1};
constexpr Key kRegistration{
    "registration",
    "of a demo with --register: what carina-registration measured (docs/registration.md); "
    "overlay_error_mm is how far the stored registration lies from the truth of the simulator"};
constexpr Key kDrift{"drift", "the tube in the console against the tube at the trainee, for the "
                              "same session time:"};
constexpr Key kInstants{"instants", "that were compared; without any the figures are null", 1};
constexpr Key kMeanAngle{"mean_deg", "mean of the angle between them", 1};
constexpr Key kPercentileAngle{"p95_deg", "95th percentile", 1};
constexpr Key kLargestAngle{"largest_deg", "the largest", 1};
constexpr Key kMeanDistance{"mean_mm", "mean of the distance between them", 1};
constexpr Key kPercentileDistance{"p95_mm", "95th percentile", 1};
constexpr Key kLargestDistance{"largest_mm", "the largest", 1};
constexpr Key kMeanClock{"clock_mean_ms",
                         "difference of the two session clocks against CLOCK_MONOTONIC", 1};
constexpr Key kLargestClock{"clock_largest_ms", "the largest of it", 1};
constexpr Key kVolumeDifference{"lung_volume_difference",
                                "the gas in both lungs as drawn by the console against that drawn "
                                "by the trainee:"};
constexpr Key kSameSessionTime{"same_session_time",
                               "at the same time by the session clock of each, an object:", 1};
constexpr Key kVolumeInstants{"instants", "that were compared; likewise", 2};
constexpr Key kMeanVolume{"mean_ml", "mean of the difference", 2};
constexpr Key kPercentileVolume{"p95_ml", "95th percentile", 2};
constexpr Key kLargestVolume{
    "largest_ml",
    "an upper bound: between frames the volume is interpolated, also across the corner where an "
    "inspiration ends",
    2};
constexpr Key kSameInstant{"same_instant",
                           "the same at the same instant of CLOCK_MONOTONIC, where the difference "
                           "of the clocks is included",
                           1};
constexpr Key kActionDrift{
    "action_drift",
    "the virtual patient at the trainee against the one in the console, for the instants at which "
    "both were lit, while the script turned it by the controls of \"Move\": instants, mean_, "
    "p95_ and largest_ as of drift, and:"};
constexpr Key kDelay{"delay_ms", "latency of an action", 1};
constexpr Key kLimit{"limit_mean_deg",
                     "lower bound of mean_deg for that delay and a viewer who goes on with the old "
                     "motion until it hears",
                     1};
} // namespace summary_key

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
    const std::string name = path.toStdString();
    if (const auto good = checkSize(name, std::uint64_t(file.size()), kDescriptionLimit); !good)
        return tl::unexpected(good.error());
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
QJsonValue sampleAges(const std::vector<LoggedFrame>& frames)
{
    std::vector<double> ages_ms;
    for (const LoggedFrame& frame : frames)
        if (frame.sampleAge)
            ages_ms.push_back(1e3 * toSeconds(*frame.sampleAge));
    if (ages_ms.empty())
        return QJsonValue::Null;
    std::sort(ages_ms.begin(), ages_ms.end());
    return QJsonObject{
        {summary_key::kMedianAge, ages_ms[ages_ms.size() / 2]},
        {summary_key::kPercentileAge, ages_ms[(ages_ms.size() * 95 + 99) / 100 - 1]}};
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
    return {{summary_key::kDrawnRate, inPerMinute(estimate->rate)},
            {summary_key::kDrawnTidalVolume, inMillilitres(estimate->tidalVolume)},
            {summary_key::kBreaths, estimate->breaths}};
}

QJsonObject describe(const Viewer& viewer, SessionTime steadyFrom)
{
    QJsonObject object = viewer.report;
    object.remove(summary_key::kConsole);
    object[summary_key::kFrames] = static_cast<int>(viewer.frames.size());
    if (viewer.frames.size() > 1)
        object[summary_key::kFramesPerSecond] =
            double(viewer.frames.size() - 1)
            / toSeconds(viewer.frames.back().local - viewer.frames.front().local);
    object[summary_key::kSampleAge] = sampleAges(viewer.frames);
    object[summary_key::kDrawn] = drawnBreathing(viewer, steadyFrom);
    return object;
}

/// Of so many instants: without any there is no figure.
QJsonValue figureOf(int instants, double value)
{
    return instants > 0 ? QJsonValue{value} : QJsonValue{QJsonValue::Null};
}

QJsonObject describe(const DriftSummary& drift)
{
    return {{summary_key::kInstants, drift.instants},
            {summary_key::kMeanAngle, figureOf(drift.instants, drift.mean_deg)},
            {summary_key::kPercentileAngle, figureOf(drift.instants, drift.p95_deg)},
            {summary_key::kLargestAngle, figureOf(drift.instants, drift.largest_deg)},
            {summary_key::kMeanDistance, figureOf(drift.instants, drift.mean_mm)},
            {summary_key::kPercentileDistance, figureOf(drift.instants, drift.p95_mm)},
            {summary_key::kLargestDistance, figureOf(drift.instants, drift.largest_mm)},
            {summary_key::kMeanClock, figureOf(drift.clockInstants, drift.clockMean_ms)},
            {summary_key::kLargestClock, figureOf(drift.clockInstants, drift.clockLargest_ms)}};
}

QJsonObject describe(const VolumeDifference& difference)
{
    return {{summary_key::kVolumeInstants, difference.instants},
            {summary_key::kMeanVolume, figureOf(difference.instants, difference.mean_ml)},
            {summary_key::kPercentileVolume, figureOf(difference.instants, difference.p95_ml)},
            {summary_key::kLargestVolume, figureOf(difference.instants, difference.largest_ml)}};
}

/// What the console and the viewer drew of the lungs, against each other.
QJsonObject lungVolumes(const Viewer& console, const Viewer& viewer)
{
    const auto apart = [&](Sameness same) {
        return describe(volumesBetween(console.frames, viewer.frames, same));
    };
    return {{summary_key::kSameSessionTime, apart(Sameness::SessionTime)},
            {summary_key::kSameInstant, apart(Sameness::Instant)}};
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
    const QJsonObject action =
        instructor.report[summary_key::kConsole].toObject()[summary_key::kAction].toObject();
    const auto timeOf = [&action](const Key& key) {
        return SessionTime{Duration{action[key].toString().toLongLong()}};
    };
    const SessionTime from = timeOf(summary_key::kFrom);
    const SessionTime until = timeOf(summary_key::kUntil);
    if (from == SessionTime{} || until <= from)
        return {};
    QJsonObject drift =
        describe(driftBetween(onSharedClock(instructor, from, until),
                              onSharedClock(trainee, from, until), &LoggedFrame::X_AV));
    drift.remove(summary_key::kMeanClock);
    drift.remove(summary_key::kLargestClock);
    const QJsonValue delay_ms = trainee.report[summary_key::kActionDelay];
    if (delay_ms.isUndefined())
        return drift;
    const double delay_s = 1e-3 * delay_ms.toDouble();
    drift[summary_key::kDelay] = delay_ms;
    drift[summary_key::kLimit] =
        action[summary_key::kTurningSpeed].toDouble() * delay_s * delay_s / toSeconds(until - from);
    return drift;
}

/// What was not measured, and why.
QJsonArray leftOut(const QJsonObject& summary)
{
    QJsonArray told;
    const auto hasAge = [&summary](const Key& who) {
        return !summary[who].toObject()[summary_key::kSampleAge].isNull();
    };
    if (!hasAge(summary_key::kTrainee))
        told += QStringLiteral("No sample of the tube came to the trainee, so its age is null.");
    if (!hasAge(summary_key::kInstructor))
        told += QStringLiteral("No sample of the tube came to the console, so its age is null.");
    if (summary[summary_key::kDrift].toObject()[summary_key::kInstants].toInt() == 0)
        told += QStringLiteral("No frame of the console could be compared, as the trainee drew the "
                               "tube too seldom or not at all, so its drift is null.");
    return told;
}

Result<QJsonObject> summarise(const Words& words)
{
    if (words.files().size() != 1)
        return words.refuse(QStringLiteral("takes one folder: carina-lab summary DIR"));
    const QDir folder{words.files().first()};
    const auto instructor = readViewer(folder, QStringLiteral("instructor"));
    if (!instructor)
        return tl::unexpected(instructor.error());
    const auto trainee = readViewer(folder, QStringLiteral("trainee"));
    if (!trainee)
        return tl::unexpected(trainee.error());

    const QJsonObject console = instructor->report[summary_key::kConsole].toObject();
    const SessionTime steadyFrom{
        Duration{console[summary_key::kSteadyFrom].toString().toLongLong()}};
    QJsonObject summary{
        {summary_key::kSchema, QLatin1StringView{summary_key::kSchema.help}},
        {summary_key::kConsole, console},
        {summary_key::kInstructor, describe(*instructor, steadyFrom)},
        {summary_key::kTrainee, describe(*trainee, steadyFrom)},
        {summary_key::kDrift, describe(driftBetween(trainee->frames, instructor->frames))},
        {summary_key::kVolumeDifference, lungVolumes(*instructor, *trainee)},
        {summary_key::kActionDrift, actionDrift(*instructor, *trainee)}};
    const QString registration = folder.filePath(QStringLiteral("registration.json"));
    if (QFile::exists(registration)) {
        const auto report = readObject(registration);
        if (!report)
            return tl::unexpected(report.error());
        summary[summary_key::kRegistration] = *report;
    }
    summary[kWarnings] = leftOut(summary);
    return summary;
}

Use summaryOfDemo()
{
    return {.lines = {"DIR"},
            .text = "Reads the logs that the two processes of a headless demo wrote into DIR, and "
                    "prints what was measured.",
            .notes = {{"DIR", "folder of ./carina demo --headless DIR"}},
            .schema = summary_key::kSchema,
            .keys = {summary_key::kConsole,
                     summary_key::kRate,
                     summary_key::kTidalVolume,
                     summary_key::kSteadyFrom,
                     summary_key::kAction,
                     summary_key::kTurningSpeed,
                     summary_key::kFrom,
                     summary_key::kTo,
                     summary_key::kUntil,
                     summary_key::kInstructor,
                     summary_key::kViewSchema,
                     summary_key::kScreenshot,
                     summary_key::kAnatomy,
                     summary_key::kAnatomyHash,
                     summary_key::kTriangles,
                     summary_key::kLevel,
                     summary_key::kFrames,
                     summary_key::kFramesPerSecond,
                     summary_key::kSampleAge,
                     summary_key::kMedianAge,
                     summary_key::kPercentileAge,
                     summary_key::kVisiblePixels,
                     summary_key::kDrawn,
                     summary_key::kDrawnRate,
                     summary_key::kDrawnTidalVolume,
                     summary_key::kBreaths,
                     summary_key::kTrainee,
                     summary_key::kActionDelay,
                     summary_key::kOverlay,
                     summary_key::kRegistration,
                     summary_key::kDrift,
                     summary_key::kInstants,
                     summary_key::kMeanAngle,
                     summary_key::kPercentileAngle,
                     summary_key::kLargestAngle,
                     summary_key::kMeanDistance,
                     summary_key::kPercentileDistance,
                     summary_key::kLargestDistance,
                     summary_key::kMeanClock,
                     summary_key::kLargestClock,
                     summary_key::kVolumeDifference,
                     summary_key::kSameSessionTime,
                     summary_key::kVolumeInstants,
                     summary_key::kMeanVolume,
                     summary_key::kPercentileVolume,
                     summary_key::kLargestVolume,
                     summary_key::kSameInstant,
                     summary_key::kActionDrift,
                     summary_key::kDelay,
                     summary_key::kLimit,
                     kWarnings}};
}

} // namespace

Command summaryCommand()
{
    return {.name = "summary",
            .theme = "the patient",
            .summary = "describes what a headless demo measured",
            .uses = {summaryOfDemo()},
            .mostFiles = 1,
            .reminder = "It takes one folder: carina-lab summary DIR",
            .experiment = summarise};
}

} // namespace carina::lab
