#include "apps/lab/command/patient_options.h"
#include "apps/lab/commands.h"
#include "apps/lab/intubation/intubate_page.h"
#include "apps/lab/intubation/trial_report.h"
#include "apps/lab/intubation/trial_statistics.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr double kSmallestTube_mm = 2.5;
constexpr double kLargestTube_mm = 9.0;
constexpr std::int64_t kUsualSeeds = 20;
constexpr std::int64_t kMostSeeds = 10000;
constexpr std::int64_t kGreatestSeed = 4294967295;

Result<IntubationSubject> subjectOf(const Words& words)
{
    const auto tube_mm =
        words.number(intubate_option::kTube, kSmallestTube_mm, kLargestTube_mm, 0.0);
    if (!tube_mm)
        return tl::unexpected(tube_mm.error());
    return subjectOption(words).and_then([&](const Subject& subject) {
        return intubationSubject(subject.anatomy, subject.build, millimetres(*tube_mm));
    });
}

Result<MotionKind> motionOf(const Words& words)
{
    const std::string word = words.files().front().toStdString();
    const auto* named = std::ranges::find(kNamedMotions, word, &NamedMotion::name);
    if (named != kNamedMotions.end())
        return named->kind;
    QStringList names;
    for (const NamedMotion& each : kNamedMotions)
        names += QString::fromLatin1(each.name.data(), qsizetype(each.name.size()));
    return words.refuse(QStringLiteral("has no motion %1; choose one of %2.")
                            .arg(words.files().front(), names.join(QStringLiteral(", "))));
}

Result<QJsonObject> oneMotion(const Words& words)
{
    const auto kind = motionOf(words);
    if (!kind)
        return tl::unexpected(kind.error());
    const auto seed = words.whole(intubate_option::kSeed, 0, kGreatestSeed, 1);
    if (!seed)
        return tl::unexpected(seed.error());
    return subjectOf(words).and_then([&](const IntubationSubject& subject) {
        return runTrial(subject, *kind, static_cast<std::uint32_t>(*seed))
            .map([&](const IntubationTrial& trial) { return trialReport(subject, trial); });
    });
}

Result<QJsonObject> allMotions(const Words& words)
{
    const auto seeds = words.whole(intubate_option::kSeeds, 1, kMostSeeds, kUsualSeeds);
    if (!seeds)
        return tl::unexpected(seeds.error());
    const auto subject = subjectOf(words);
    if (!subject)
        return tl::unexpected(subject.error());
    TrialStatistics statistics;
    for (const NamedMotion& motion : kNamedMotions)
        for (std::int64_t seed = 1; seed <= *seeds; ++seed) {
            const auto trial = runTrial(*subject, motion.kind, static_cast<std::uint32_t>(seed));
            if (!trial)
                return tl::unexpected(trial.error());
            statistics.add(*trial);
        }
    return statistics.report(*subject);
}

Result<QJsonObject> intubate(const Words& words)
{
    const bool isAll = words.has(intubate_option::kAll);
    if (isAll == !words.files().isEmpty())
        return words.refuse(QStringLiteral("needs one motion, or --all-scripts."));
    if (isAll ? words.has(intubate_option::kSeed) : words.has(intubate_option::kSeeds))
        return words.refuse(
            QStringLiteral("takes --seed with one motion, and --seeds with --all-scripts."));
    return isAll ? allMotions(words) : oneMotion(words);
}

Use intubateOnce()
{
    using namespace intubate_key;
    return {.lines = {"SCRIPT [--patient WHO] [--anatomy DIR] [--tube MM] [--seed N]"},
            .text = "Lets simulated hands intubate a patient, observes tube, laryngoscope and jaw "
                    "with the errors of a tracker and a registration, and prints what the monitor "
                    "of intubations makes of it beside what happened, what becomes of the patient, "
                    "and the score. The same words print the same.",
            .notes = {{"SCRIPT",
                       "good, slow, oesophageal, right_mainstem, left_mainstem, three_attempts, "
                       "dental_lever, too_shallow, neck_flexed, stuck_at_arytenoid, "
                       "cuff_above_cords or late_recognition"}},
            .options = {lab::kPatient, kAnatomy, intubate_option::kTube, intubate_option::kSeed},
            .schema = kSchema,
            .keys = {intubate_key::kPatient,
                     kTube,
                     kScript,
                     kSeed,
                     kOutside,
                     kOutcome,
                     kConfidence,
                     kIsRight,
                     kAttempts,
                     kDepth,
                     kAboveCarina,
                     kRegistration,
                     kTruth,
                     kTrueOutcome,
                     kTrueAttempts,
                     kTrueDepth,
                     kTrueAboveCarina,
                     kTrueTimeline,
                     kTrueStep,
                     kTrueAt,
                     kTimeline,
                     kStep,
                     kAt,
                     kNotedAt,
                     kSeat,
                     kStepConfidence,
                     kStepDepth,
                     kStepAboveCarina,
                     kVitals,
                     kVitalsAt,
                     kSaturation,
                     kShown,
                     kEndTidal,
                     kHeartRate,
                     kMean,
                     kMetrics,
                     kMeasuredMetric,
                     kMeasuredValue,
                     kNotMeasured,
                     kScore,
                     kRubric,
                     kSource,
                     kPoints,
                     kPossible,
                     kOfAll,
                     kJudgements,
                     kCriterion,
                     kMetric,
                     kVerdict,
                     kValue,
                     kGot,
                     kMoment}};
}

Use intubateOften()
{
    using namespace intubate_all_key;
    return {.lines = {"--all-scripts [--seeds N] [--patient WHO] [--anatomy DIR] [--tube MM]"},
            .text = "Runs each motion with the seeds 1 to N, without the patient's vital signs, "
                    "and prints how often and how far the monitor was wrong.",
            .options = {intubate_option::kAll, intubate_option::kSeeds, lab::kPatient, kAnatomy,
                        intubate_option::kTube},
            .schema = kSchema,
            .keys = {intubate_all_key::kPatient,
                     kTube,
                     kRuns,
                     kOutside,
                     kWrong,
                     kUnsure,
                     kSurelyRight,
                     kConfusion,
                     kTruth,
                     kNone,
                     kTrachea,
                     kRightMain,
                     kLeftMain,
                     kOesophagus,
                     kDepth,
                     kMedian,
                     k95,
                     kGreatest,
                     kWithin,
                     kCarina,
                     kTimes,
                     kMedianTime,
                     k95Time,
                     kGreatestTime,
                     kWithinTime,
                     kMissed,
                     kInvented,
                     kAttempts,
                     kWrongRuns,
                     kWrongScript,
                     kWrongSeed,
                     kWrongTruth,
                     kWrongOutcome,
                     kWrongConfidence,
                     kWrongOutside}};
}

} // namespace

Command intubateCommand()
{
    return {.name = "intubate",
            .theme = "the patient",
            .summary = "lets simulated hands intubate a patient, and judges what was understood",
            .uses = {intubateOnce(), intubateOften()},
            .mostFiles = 1,
            .reminder = "intubate needs one motion, or --all-scripts.",
            .experiment = intubate};
}

} // namespace carina::lab
