#include "apps/lab/command/patient_options.h"
#include "apps/lab/commands.h"
#include "apps/lab/intubation/intubate_page.h"
#include "apps/lab/intubation/intubate_recording.h"
#include "apps/lab/intubation/intubation_words.h"
#include "apps/lab/intubation/recorded_intubation.h"
#include "apps/lab/intubation/trial_report.h"
#include "apps/lab/intubation/trial_statistics.h"
#include "engine/net/devices/any_recording.h"

#include <QFileInfo>

#include <array>
#include <vector>

namespace carina::lab
{
namespace
{

constexpr std::int64_t kUsualMotionSeeds = 20;
constexpr std::int64_t kMostMotionSeeds = 10000;
constexpr std::int64_t kGreatestSeed = 4294967295;

Result<void> save(const Words& words, const IntubationTrial& trial)
{
    if (!words.has(intubate_option::kSave))
        return {};
    return writeAnyRecording(words.text(intubate_option::kSave).toStdString(),
                             recordingOf(trial.seen));
}

/// That options were given which only another use of the command takes.
Result<void> refuseAny(const Words& words, std::initializer_list<Option> options, const char* use)
{
    for (const Option& option : options)
        if (words.has(option))
            return words.refuse(QStringLiteral("takes --%1 with %2.")
                                    .arg(QLatin1StringView{option.name}, QLatin1StringView{use}));
    return {};
}

/// A registration that is worse is turned as much more, too.
Result<ObservationSettings> observationOption(const Words& words)
{
    constexpr double kWorst_mm = 20.0;
    const ObservationSettings usual;
    return words
        .number(intubate_option::kRegistration, 0.0, kWorst_mm, inMillimetres(usual.registration))
        .map([&usual](double error_mm) {
            ObservationSettings settings = usual;
            settings.registration = millimetres(error_mm);
            const double share = settings.registration / usual.registration;
            settings.registrationTurn = share * usual.registrationTurn;
            return settings;
        });
}

Result<QJsonObject> oneMotion(const Words& words, MotionKind kind)
{
    const auto seed = words.whole(intubate_option::kSeed, 0, kGreatestSeed, 1);
    if (!seed)
        return tl::unexpected(seed.error());
    const auto observation = observationOption(words);
    if (!observation)
        return tl::unexpected(observation.error());
    return intubationSubjectOption(words).and_then([&](const IntubationSubject& subject) {
        return runTrial(subject, kind, static_cast<std::uint32_t>(*seed), *observation)
            .and_then([&](const IntubationTrial& trial) {
                return save(words, trial).map([&] { return trialReport(subject, trial); });
            });
    });
}

Result<QJsonObject> oneRecording(const Words& words)
{
    if (!QFileInfo::exists(words.files().front()))
        return words.refuse(
            QStringLiteral("has no motion %1, and there is no such file; choose one of %2.")
                .arg(words.files().front(), QString::fromStdString(namesOfMotions())));
    return watchFile(words);
}

Result<QJsonObject> allMotions(const Words& words)
{
    const auto seeds = words.whole(intubate_option::kSeeds, 1, kMostMotionSeeds, kUsualMotionSeeds);
    if (!seeds)
        return tl::unexpected(seeds.error());
    const auto subject = intubationSubjectOption(words);
    if (!subject)
        return tl::unexpected(subject.error());
    const auto observation = observationOption(words);
    if (!observation)
        return tl::unexpected(observation.error());
    TrialStatistics statistics;
    for (const NamedMotion& motion : kNamedMotions)
        for (std::int64_t seed = 1; seed <= *seeds; ++seed) {
            const auto trial =
                runTrial(*subject, motion.kind, static_cast<std::uint32_t>(seed), *observation);
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
        return words.refuse(QStringLiteral("needs one motion or recording, or --all-scripts."));
    const auto kind = isAll ? std::nullopt : motionFromName(words.files().front().toStdString());
    using namespace intubate_option;
    auto fits = isAll ? Result<void>{} : refuseAny(words, {kSeeds}, "--all-scripts");
    if (fits && !kind)
        fits = refuseAny(words, {kSeed, kSave}, "one motion");
    if (fits && !isAll && !kind)
        fits = refuseAny(words, {kElastic, kRegistration}, "motions");
    if (fits && (isAll || kind))
        fits = refuseAny(words, {kSite, kBlade, kTold}, "a recording");
    if (!fits)
        return tl::unexpected(fits.error());
    if (isAll)
        return allMotions(words);
    return kind ? oneMotion(words, *kind) : oneRecording(words);
}

/// What is printed of a motion and of a recording alike, from the timeline to the score.
std::vector<Key> andTheCourse(std::vector<Key> keys)
{
    const std::array course{intubate_key::kTimeline,
                            intubate_key::kStep,
                            intubate_key::kAt,
                            intubate_key::kNotedAt,
                            intubate_key::kSeat,
                            intubate_key::kStepConfidence,
                            intubate_key::kStepDepth,
                            intubate_key::kStepAboveCarina,
                            intubate_key::kVitals,
                            intubate_key::kVitalsAt,
                            intubate_key::kSaturation,
                            intubate_key::kShown,
                            intubate_key::kEndTidal,
                            intubate_key::kHeartRate,
                            intubate_key::kMean,
                            intubate_key::kMetrics,
                            intubate_key::kMeasuredMetric,
                            intubate_key::kMeasuredValue,
                            intubate_key::kNotMeasured,
                            intubate_key::kScore,
                            intubate_key::kRubric,
                            intubate_key::kSource,
                            intubate_key::kPoints,
                            intubate_key::kPossible,
                            intubate_key::kOfAll,
                            intubate_key::kJudgements,
                            intubate_key::kCriterion,
                            intubate_key::kMetric,
                            intubate_key::kVerdict,
                            intubate_key::kValue,
                            intubate_key::kGot,
                            intubate_key::kMoment};
    keys.insert(keys.end(), course.begin(), course.end());
    return keys;
}

Use intubateOnce()
{
    static const std::string motions = namesOfMotions();
    return {.lines = {"SCRIPT [--patient WHO] [--anatomy DIR] [--tube MM] [--elastic]",
                      "SCRIPT [--seed N] [--registration MM] [--save FILE]"},
            .text = "Lets simulated hands intubate a patient, observes tube, laryngoscope and jaw "
                    "with the errors of a tracker and a registration, and prints what the monitor "
                    "of intubations makes of it beside what happened, what becomes of the patient, "
                    "and the score. The same words print the same.",
            .notes = {{"SCRIPT", motions.c_str()}},
            .options = {kPatient, kAnatomy, intubate_option::kTube, intubate_option::kElastic,
                        intubate_option::kSeed, intubate_option::kRegistration,
                        intubate_option::kSave},
            .schema = intubate_key::kSchema,
            .keys = andTheCourse({intubate_key::kPatient,
                                  intubate_key::kTube,
                                  intubate_key::kShape,
                                  intubate_key::kScript,
                                  intubate_key::kSeed,
                                  intubate_key::kOutside,
                                  intubate_key::kOutcome,
                                  intubate_key::kConfidence,
                                  intubate_key::kIsRight,
                                  intubate_key::kAttempts,
                                  intubate_key::kDepth,
                                  intubate_key::kAboveCarina,
                                  intubate_key::kRegistration,
                                  intubate_key::kRegistrationAtTeeth,
                                  intubate_key::kTruth,
                                  intubate_key::kTrueOutcome,
                                  intubate_key::kTrueAttempts,
                                  intubate_key::kTrueDepth,
                                  intubate_key::kTrueAboveCarina,
                                  intubate_key::kTrueTimeline,
                                  intubate_key::kTrueStep,
                                  intubate_key::kTrueAt})};
}

Use intubateRecorded()
{
    static const QByteArray told = toldWords().toLatin1();
    return {.lines = {"RECORDING [--patient WHO] [--anatomy DIR] [--tube MM]",
                      "RECORDING [--site FILE] [--blade NAME] [--told STEP=S]"},
            .text =
                "Takes the poses of tube, laryngoscope and jaw from the recording of a tracker, "
                "and prints what the monitor of intubations makes of them, what becomes of the "
                "patient, and the score. Head and neck lie as in the surfaces.",
            .notes = {{"RECORDING",
                       "in one of the forms that carina-lab track reads; a tool's role is told by "
                       "the file or by its name: Tube or ETT, Laryngoscope or Blade, Jaw or Chin"},
                      {"STEP", told.constData()}},
            .options = {kPatient, kAnatomy, intubate_option::kSite, intubate_option::kBlade,
                        intubate_option::kTube, intubate_option::kTold},
            .schema = intubate_recording_key::kSchema,
            .keys = andTheCourse({intubate_recording_key::kRecording, intubate_key::kPatient,
                                  intubate_key::kTube, intubate_key::kShape,
                                  intubate_recording_key::kBlade, intubate_key::kOutcome,
                                  intubate_key::kConfidence, intubate_key::kAttempts,
                                  intubate_key::kDepth, intubate_key::kAboveCarina})};
}

Use intubateOften()
{
    return {.lines = {"--all-scripts [--seeds N] [--patient WHO] [--anatomy DIR]",
                      "--all-scripts [--tube MM] [--elastic] [--registration MM]"},
            .text = "Runs each motion with the seeds 1 to N, without the patient's vital signs, "
                    "and prints how often and how far the monitor was wrong.",
            .options = {intubate_option::kAll, intubate_option::kSeeds, kPatient, kAnatomy,
                        intubate_option::kTube, intubate_option::kElastic,
                        intubate_option::kRegistration},
            .schema = intubate_all_key::kSchema,
            .keys = {intubate_all_key::kPatient,      intubate_all_key::kTube,
                     intubate_all_key::kShape,        intubate_all_key::kRuns,
                     intubate_all_key::kOutside,      intubate_all_key::kWrong,
                     intubate_all_key::kUnsure,       intubate_all_key::kSurelyRight,
                     intubate_all_key::kConfusion,    intubate_all_key::kTruth,
                     intubate_all_key::kNone,         intubate_all_key::kTrachea,
                     intubate_all_key::kRightMain,    intubate_all_key::kLeftMain,
                     intubate_all_key::kOesophagus,   intubate_all_key::kFrozen,
                     intubate_all_key::kDepth,        intubate_all_key::kMedian,
                     intubate_all_key::k95,           intubate_all_key::kGreatest,
                     intubate_all_key::kWithin,       intubate_all_key::kCarina,
                     intubate_all_key::kTimes,        intubate_all_key::kMedianTime,
                     intubate_all_key::k95Time,       intubate_all_key::kGreatestTime,
                     intubate_all_key::kWithinTime,   intubate_all_key::kMissed,
                     intubate_all_key::kInvented,     intubate_all_key::kAttempts,
                     intubate_all_key::kWrongRuns,    intubate_all_key::kWrongScript,
                     intubate_all_key::kWrongSeed,    intubate_all_key::kWrongTruth,
                     intubate_all_key::kWrongOutcome, intubate_all_key::kWrongConfidence,
                     intubate_all_key::kWrongOutside}};
}

} // namespace

Command intubateCommand()
{
    return {.name = "intubate",
            .theme = "the patient",
            .summary =
                "lets simulated hands intubate, or takes a recording; judges what is understood",
            .uses = {intubateOnce(), intubateRecorded(), intubateOften()},
            .mostFiles = 1,
            .reminder = "intubate needs one motion or recording, or --all-scripts.",
            .experiment = intubate};
}

} // namespace carina::lab
