#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/tracking/prediction_score.h"
#include "engine/core/units.h"
#include "engine/io/files/file_limit.h"
#include "engine/tracking/tum_file.h"

namespace carina::lab
{
namespace
{

using namespace std::chrono_literals;

namespace predict_key
{
constexpr Key kSchema{"schema", "carina.predict/1"};
constexpr Key kRecording{"recording", "FILE as given"};
constexpr Key kSamples{"samples", "poses of the recording"};
constexpr Key kDuration{"duration_s", "from the first to the last"};
constexpr Key kAhead40{"ahead_40ms", "scored on the second half, for a pose predicted by 40 ms:"};
constexpr Key kPoses{"poses", "that were predicted", 1};
constexpr Key kHeldPosition{"hold_position_mm",
                            "root mean square error where the newest pose is held", 1};
constexpr Key kHeldRotation{"hold_rotation_deg", "the same for the rotation", 1};
constexpr Key kLinePosition{"line_position_ratio_to_hold",
                            "error of a straight line through the last six samples, in shares of "
                            "the error of holding",
                            1};
constexpr Key kLineRotation{"line_rotation_ratio_to_hold", "the same for the rotation", 1};
constexpr Key kSmoothedPosition{"smoothed_position_ratio_to_hold",
                                "error of the newest pose after a 1-Euro filter, which lags behind",
                                1};
constexpr Key kExpectedPosition{
    "expected_position_ratio_to_error",
    "the error that is expected of each pose, in shares of the one found", 1};
constexpr Key kExpectedRotation{"expected_rotation_ratio_to_error", "the same for the rotation", 1};
constexpr Key kAhead80{"ahead_80ms", "the same keys, for 80 ms"};
constexpr Key kPosition40{"position_ratio_to_hold_40ms",
                          "error of the poses that are drawn, predicted by 40 ms, in shares "
                          "of the error of holding"};
constexpr Key kRotation40{"rotation_ratio_to_hold_40ms", "the same for the rotation"};
constexpr Key kPosition80{"position_ratio_to_hold_80ms", "the same at 80 ms"};
constexpr Key kRotation80{"rotation_ratio_to_hold_80ms", "the same for the rotation"};
} // namespace predict_key

constexpr std::size_t kFewestSamples = 100;

/// The errors of all predictors for one time ahead, on the second half.
struct Scores {
    PredictionError hold;
    PredictionError line;
    PredictionError smoothed;
    PredictionScore shown;
};

Scores scoresOf(std::span<const PoseSample> samples, Duration ahead)
{
    const auto scoreOf = [&](Predictor predictor, const PoseTreatment& treatment = {}) {
        return predictionScore(samples, samples.size() / 2, ahead, predictor, treatment);
    };
    return {scoreOf(Predictor::History, {.predicts = false}).error, scoreOf(Predictor::Line).error,
            scoreOf(Predictor::History, {.predicts = false, .smooths = true}).error,
            scoreOf(Predictor::History)};
}

QJsonObject baselinesOf(const Scores& scores)
{
    return {{predict_key::kPoses, qint64(scores.hold.poses)},
            {predict_key::kHeldPosition, inMillimetres(metres(scores.hold.position))},
            {predict_key::kHeldRotation, inDegrees(radians(scores.hold.rotation))},
            {predict_key::kLinePosition, scores.line.position / scores.hold.position},
            {predict_key::kLineRotation, scores.line.rotation / scores.hold.rotation},
            {predict_key::kSmoothedPosition, scores.smoothed.position / scores.hold.position},
            {predict_key::kExpectedPosition,
             scores.shown.expectedPosition / scores.shown.error.position},
            {predict_key::kExpectedRotation,
             scores.shown.expectedRotation / scores.shown.error.rotation}};
}

Result<QJsonObject> predict(const Words& words)
{
    if (words.files().size() != 1)
        return words.refuse(QStringLiteral("needs one FILE."));
    const QString file = words.files().front();
    const Result<std::vector<PoseSample>> samples =
        readableSize(file.toStdString(), kMeasurementLimit).and_then([&](std::uint64_t) {
            return readTumFile(file.toStdString());
        });
    if (!samples)
        return tl::unexpected(samples.error());
    if (samples->size() < kFewestSamples)
        return words.refuse(
            QStringLiteral("needs a recording of at least %1 poses.").arg(kFewestSamples));
    const Scores at40 = scoresOf(*samples, 40ms);
    const Scores at80 = scoresOf(*samples, 80ms);
    if (!(at80.hold.position > 0.0 && at80.hold.rotation > 0.0))
        return words.refuse(QStringLiteral("needs a recording that moves and turns."));
    return QJsonObject{
        {predict_key::kSchema, QLatin1StringView{predict_key::kSchema.help}},
        {predict_key::kRecording, file},
        {predict_key::kSamples, qint64(samples->size())},
        {predict_key::kDuration, toSeconds(samples->back().time - samples->front().time)},
        {predict_key::kAhead40, baselinesOf(at40)},
        {predict_key::kAhead80, baselinesOf(at80)},
        {predict_key::kPosition40, at40.shown.error.position / at40.hold.position},
        {predict_key::kRotation40, at40.shown.error.rotation / at40.hold.rotation},
        {predict_key::kPosition80, at80.shown.error.position / at80.hold.position},
        {predict_key::kRotation80, at80.shown.error.rotation / at80.hold.rotation}};
}

} // namespace

Command predictCommand()
{
    return {
        .name = "predict",
        .theme = "tracking",
        .summary = "how well recorded poses are predicted",
        .uses = {{.lines = {"FILE"},
                  .text = "Predicts the poses of a recorded trajectory (TUM text: seconds x y z qx "
                          "qy qz qw) by 40 and 80 ms as the programs do that draw them. What the "
                          "predictor has to learn of the noise it learns on the way; scored is the "
                          "second half.",
                  .schema = predict_key::kSchema,
                  .keys = {predict_key::kRecording, predict_key::kSamples, predict_key::kDuration,
                           predict_key::kAhead40, predict_key::kPoses, predict_key::kHeldPosition,
                           predict_key::kHeldRotation, predict_key::kLinePosition,
                           predict_key::kLineRotation, predict_key::kSmoothedPosition,
                           predict_key::kExpectedPosition, predict_key::kExpectedRotation,
                           predict_key::kAhead80, predict_key::kPosition40,
                           predict_key::kRotation40, predict_key::kPosition80,
                           predict_key::kRotation80}}},
        .mostFiles = 1,
        .reminder = "It needs one FILE.",
        .experiment = predict};
}

} // namespace carina::lab
