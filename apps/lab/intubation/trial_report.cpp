#include "apps/lab/intubation/trial_report.h"

#include "apps/lab/intubation/intubate_page.h"
#include "apps/lab/intubation/intubation_words.h"
#include "apps/lab/intubation/trial_patient.h"
#include "engine/scoring/course/depth_rule.h"
#include "engine/scoring/score/rubric.h"

#include <QJsonArray>

#include <algorithm>
#include <array>

namespace carina::lab
{
namespace
{

constexpr Duration kAfterwards = std::chrono::seconds{60};
constexpr int kPrintEvery = 10; ///< of the readings

double sinceStart(SessionTime t) { return toSeconds(t - kTrialStart); }

QJsonObject truthObject(const IntubationTrial& trial)
{
    using namespace intubate_key;
    QJsonArray timeline;
    for (const TrueEvent& event : trial.truth.events)
        timeline +=
            QJsonObject{{kTrueStep, stepWord(stepOf(event.step))}, {kTrueAt, toSeconds(event.at)}};
    const auto above = trial.truth.tipAboveCarina;
    return {{kTrueOutcome, seatWord(seatOf(trial.truth.outcome))},
            {kTrueAttempts, trial.truth.attempts},
            {kTrueDepth, inMillimetres(trial.truth.depthAtTeeth)},
            {kTrueAboveCarina, above ? QJsonValue{inMillimetres(*above)} : QJsonValue{}},
            {kTrueTimeline, timeline}};
}

QJsonArray timelineOf(const IntubationTrial& trial)
{
    using namespace intubate_key;
    std::vector<NotedStep> steps = trial.noted;
    std::ranges::stable_sort(steps, {}, [](const NotedStep& step) { return step.event.at; });
    QJsonArray timeline;
    for (const NotedStep& step : steps)
        timeline += QJsonObject{{kStep, stepWord(step.event.step)},
                                {kAt, sinceStart(step.event.at)},
                                {kNotedAt, sinceStart(step.effect)},
                                {kSeat, seatWord(step.event.seat)},
                                {kStepConfidence, step.event.confidence},
                                {kStepDepth, inMillimetres(step.event.depthAtTeeth)},
                                {kStepAboveCarina, inMillimetres(step.event.tipAboveCarina)}};
    return timeline;
}

QJsonArray vitalsOf(const std::vector<VitalsReading>& readings)
{
    using namespace intubate_key;
    QJsonArray rows;
    for (std::size_t i = 0; i < readings.size(); i += kPrintEvery) {
        const Vitals& now = readings[i].vitals;
        rows += QJsonObject{
            {kVitalsAt, sinceStart(readings[i].at)},
            {kSaturation, 100.0 * now.arterialSaturation},
            {kShown, now.saturation ? QJsonValue{100.0 * *now.saturation} : QJsonValue{}},
            {kEndTidal, now.endTidalCO2 ? QJsonValue{inMmHg(*now.endTidalCO2)} : QJsonValue{}},
            {kHeartRate, inPerMinute(now.heartRate)},
            {kMean, inMmHg(now.mean)}};
    }
    return rows;
}

TubedPatient tubedPatient(const IntubationSubject& subject)
{
    return {.height = subject.build.height,
            .ageInYears = subject.build.ageInYears,
            .isWoman = subject.build.sex == Sex::Female,
            .innerDiameter = subject.innerDiameter};
}

/// With the patient's oxygen. @pre a try has begun
TryMetrics metricsOf(const IntubationSubject& subject, const IntubationTrial& trial,
                     const std::vector<VitalsReading>& readings)
{
    TryCourse course = trial.measured;
    const SessionTime last = readings.back().at;
    const SessionTime ended = course.endedBy(last).value_or(last);
    const SessionTime begun = course.metrics(ended, {}).begun;
    for (const VitalsReading& reading : readings)
        if (reading.at >= begun && reading.at <= ended)
            course.addVitals(reading.at, reading.vitals);
    const TubedPatient patient = tubedPatient(subject);
    return course.metrics(ended, depthBy(usualDepthRule(patient), patient));
}

QString wordOf(ItemVerdict verdict)
{
    constexpr std::array kVerdicts{"met", "missed", "never", "not_measured"};
    return QString::fromLatin1(kVerdicts[static_cast<std::size_t>(verdict)]);
}

QJsonObject scoreObject(const TryMetrics& metrics)
{
    using namespace intubate_key;
    const Rubric rubric = publishedRubric();
    const Score score = scoreOf(metrics, rubric);
    QJsonArray judgements;
    for (const Judgement& judged : score.judgements)
        judgements += QJsonObject{
            {kCriterion, QString::fromStdString(judged.criterion.name)},
            {kMetric, QString::fromLatin1(entryOf(judged.criterion.metric).word)},
            {kVerdict, wordOf(judged.verdict)},
            {kValue, judged.value ? QJsonValue{*judged.value} : QJsonValue{}},
            {kGot, judged.points},
            {kMoment, judged.moment ? QJsonValue{sinceStart(*judged.moment)} : QJsonValue{}}};
    return {{kRubric, QString::fromStdString(rubric.name)},
            {kSource, QString::fromStdString(rubric.source)},
            {kPoints, score.points},
            {kPossible, score.possible},
            {kOfAll, score.ofAll},
            {kJudgements, judgements}};
}

void addScore(QJsonObject& report, const TryMetrics& metrics)
{
    QJsonArray values;
    for (std::size_t i = 0; i < kMetricCount; ++i) {
        const auto metric = static_cast<Metric>(i);
        if (const auto value = valueOf(metrics, metric))
            values += QJsonObject{
                {intubate_key::kMeasuredMetric, QString::fromLatin1(entryOf(metric).word)},
                {intubate_key::kMeasuredValue, *value}};
    }
    QJsonArray missing;
    for (const Metric metric : notMeasured(metrics))
        missing += QString::fromLatin1(entryOf(metric).word);
    report[intubate_key::kMetrics] = values;
    report[intubate_key::kNotMeasured] = missing;
    report[intubate_key::kScore] = scoreObject(metrics);
}

} // namespace

QJsonValue outsideWord(const MotionParameters& parameters)
{
    if (!parameters.outside)
        return {};
    const std::string_view name = rangeOf(*parameters.outside).name;
    return QString::fromLatin1(name.data(), qsizetype(name.size()));
}

QJsonObject trialReport(const IntubationSubject& subject, const IntubationTrial& trial)
{
    using namespace intubate_key;
    const std::vector<VitalsReading> readings =
        patientOf(subject, trial, trial.end() + kAfterwards);
    QJsonObject report{{kSchema, QLatin1StringView{kSchema.help}},
                       {intubate_key::kPatient, QString::fromStdString(subject.name)},
                       {kTube, inMillimetres(subject.innerDiameter)},
                       {kScript, motionWord(trial.kind)},
                       {kSeed, qint64(trial.seed)},
                       {kOutside, outsideWord(trial.parameters)},
                       {kOutcome, seatWord(trial.course.seat)},
                       {kConfidence, trial.course.confidence},
                       {kIsRight, !trial.isWrong()},
                       {kAttempts, trial.course.attempts},
                       {kDepth, inMillimetres(trial.course.tip.depthAtTeeth)},
                       {kAboveCarina, inMillimetres(trial.course.tip.aboveCarina)},
                       {kRegistration, inMillimetres(trial.registrationShare)},
                       {kTruth, truthObject(trial)},
                       {kTimeline, timelineOf(trial)},
                       {kVitals, vitalsOf(readings)},
                       {kScore, QJsonValue{}}};
    if (trial.measured.hasBegun())
        addScore(report, metricsOf(subject, trial, readings));
    return report;
}

} // namespace carina::lab
