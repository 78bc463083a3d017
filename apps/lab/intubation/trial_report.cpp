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

namespace key = intubate_key;

constexpr Duration kAfterwards = std::chrono::seconds{60};
constexpr int kPrintEvery = 10; ///< of the readings

double sinceStart(SessionTime t) { return toSeconds(t - kTrialStart); }

QJsonObject truthObject(const IntubationTrial& trial)
{
    QJsonArray timeline;
    for (const TrueEvent& event : trial.truth.events)
        timeline += QJsonObject{{key::kTrueStep, stepWord(stepOf(event.step))},
                                {key::kTrueAt, toSeconds(event.at)}};
    const auto above = trial.truth.tipAboveCarina;
    return {{key::kTrueOutcome, seatWord(seatOf(trial.truth.outcome))},
            {key::kTrueAttempts, trial.truth.attempts},
            {key::kTrueDepth, inMillimetres(trial.truth.depthAtTeeth)},
            {key::kTrueAboveCarina, above ? QJsonValue{inMillimetres(*above)} : QJsonValue{}},
            {key::kTrueTimeline, timeline}};
}

/// No way leads there from the oesophagus.
QJsonValue aboveCarina(TubeSeat seat, Length above)
{
    return seat == TubeSeat::Oesophagus ? QJsonValue{} : inMillimetres(above);
}

/// @param isFrozen no depth is known, as both shapes are apart
QJsonObject stepObject(const NotedStep& step, bool isFrozen)
{
    const auto known = [isFrozen](const QJsonValue& told) {
        return isFrozen ? QJsonValue{} : told;
    };
    return {
        {key::kStep, stepWord(step.event.step)},
        {key::kAt, sinceStart(step.event.at)},
        {key::kNotedAt, sinceStart(step.effect)},
        {key::kSeat, seatWord(step.event.seat)},
        {key::kStepConfidence, step.event.confidence},
        {key::kStepDepth, known(inMillimetres(step.event.depthAtTeeth))},
        {key::kStepAboveCarina, known(aboveCarina(step.event.seat, step.event.tipAboveCarina))}};
}

QJsonArray timelineOf(const WatchedIntubation& watched)
{
    std::vector<std::pair<SessionTime, QJsonObject>> steps;
    TubeTimeline tube;
    for (const NotedStep& step : watched.noted) {
        tube.note(step.effect, step.event, {});
        steps.emplace_back(step.event.at, stepObject(step, tube.areShapesApartAt(step.effect)));
    }
    std::ranges::stable_sort(steps, {}, &std::pair<SessionTime, QJsonObject>::first);
    QJsonArray timeline;
    for (const auto& [at, step] : steps)
        timeline += step;
    return timeline;
}

QJsonArray vitalsOf(const std::vector<VitalsReading>& readings)
{
    QJsonArray rows;
    for (std::size_t i = 0; i < readings.size(); i += kPrintEvery) {
        const Vitals& now = readings[i].vitals;
        rows += QJsonObject{
            {key::kVitalsAt, sinceStart(readings[i].at)},
            {key::kSaturation, 100.0 * now.arterialSaturation},
            {key::kShown, now.saturation ? QJsonValue{100.0 * *now.saturation} : QJsonValue{}},
            {key::kEndTidal, now.endTidalCO2 ? QJsonValue{inMmHg(*now.endTidalCO2)} : QJsonValue{}},
            {key::kHeartRate, inPerMinute(now.heartRate)},
            {key::kMean, inMmHg(now.mean)}};
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
TryMetrics metricsOf(const IntubationSubject& subject, const WatchedIntubation& watched,
                     const std::vector<VitalsReading>& readings)
{
    TryCourse course = watched.measured;
    const SessionTime last = readings.back().at;
    const SessionTime ended = course.endedBy(last).value_or(last);
    const SessionTime begun = course.metrics(ended, {}).begun;
    for (const VitalsReading& reading : readings)
        if (reading.at >= begun && reading.at <= ended)
            course.addVitals(reading.at, reading.vitals);
    const TubedPatient patient = tubedPatient(subject);
    TryMetrics metrics = course.metrics(ended, depthBy(usualDepthRule(patient), patient));
    metrics.isViewRead = false; // nothing is drawn
    return metrics;
}

QString verdictWord(ItemVerdict verdict)
{
    constexpr std::array kVerdicts{"met", "missed", "never", "not_measured"};
    return QString::fromLatin1(kVerdicts[static_cast<std::size_t>(verdict)]);
}

/// One without a name is called by its metric.
QString nameOf(const Criterion& criterion)
{
    return criterion.name.empty() ? QString::fromLatin1(entryOf(criterion.metric).word)
                                  : QString::fromStdString(criterion.name);
}

QJsonObject scoreObject(const TryMetrics& metrics)
{
    const Rubric rubric = publishedRubric();
    const Score score = scoreOf(metrics, rubric);
    QJsonArray judgements;
    for (const Judgement& judged : score.judgements)
        judgements += QJsonObject{
            {key::kCriterion, nameOf(judged.criterion)},
            {key::kMetric, QString::fromLatin1(entryOf(judged.criterion.metric).word)},
            {key::kVerdict, verdictWord(judged.verdict)},
            {key::kValue, judged.value ? QJsonValue{*judged.value} : QJsonValue{}},
            {key::kGot, judged.points},
            {key::kMoment, judged.moment ? QJsonValue{sinceStart(*judged.moment)} : QJsonValue{}}};
    return {{key::kRubric, QString::fromStdString(rubric.name)},
            {key::kSource, QString::fromStdString(rubric.source)},
            {key::kPoints, score.points},
            {key::kPossible, score.possible},
            {key::kOfAll, score.ofAll},
            {key::kJudgements, judgements}};
}

void addScore(QJsonObject& report, const TryMetrics& metrics)
{
    QJsonArray values;
    for (std::size_t i = 0; i < kMetricCount; ++i) {
        const auto metric = static_cast<Metric>(i);
        if (const auto value = valueOf(metrics, metric))
            values += QJsonObject{{key::kMeasuredMetric, QString::fromLatin1(entryOf(metric).word)},
                                  {key::kMeasuredValue, *value}};
    }
    QJsonArray missing;
    for (const Metric metric : notMeasured(metrics))
        missing += QString::fromLatin1(entryOf(metric).word);
    report[key::kMetrics] = values;
    report[key::kNotMeasured] = missing;
    report[key::kScore] = scoreObject(metrics);
}

/// Of a depth that is frozen, nothing.
QJsonValue toldBy(const IntubationCourse& course, const QJsonValue& told)
{
    return course.shapes.isIn ? QJsonValue{} : told;
}

} // namespace

QJsonValue outsideWord(const MotionParameters& parameters)
{
    if (!parameters.outside)
        return {};
    const std::string_view name = rangeOf(*parameters.outside).name;
    return QString::fromLatin1(name.data(), qsizetype(name.size()));
}

QString shapeWord(const IntubationSubject& subject)
{
    return subject.lumen ? QStringLiteral("rod") : QStringLiteral("rigid");
}

QJsonObject watchedReport(const IntubationSubject& subject, const WatchedIntubation& watched)
{
    const std::vector<VitalsReading> readings =
        patientOf(subject, watched, watched.end() + kAfterwards);
    QJsonObject report{
        {key::kPatient, QString::fromStdString(subject.name)},
        {key::kTube, inMillimetres(subject.innerDiameter)},
        {key::kShape, shapeWord(subject)},
        {key::kOutcome, seatWord(watched.course.seat)},
        {key::kConfidence, watched.course.confidence},
        {key::kAttempts, watched.course.attempts},
        {key::kDepth, toldBy(watched.course, inMillimetres(watched.course.tip.depthAtTeeth))},
        {key::kAboveCarina,
         toldBy(watched.course, aboveCarina(watched.course.seat, watched.course.tip.aboveCarina))},
        {key::kTimeline, timelineOf(watched)},
        {key::kVitals, vitalsOf(readings)},
        {key::kScore, QJsonValue{}}};
    if (watched.measured.hasBegun())
        addScore(report, metricsOf(subject, watched, readings));
    return report;
}

QJsonObject trialReport(const IntubationSubject& subject, const IntubationTrial& trial)
{
    QJsonObject report = watchedReport(subject, trial);
    report[key::kSchema] = QLatin1StringView{key::kSchema.help};
    report[key::kScript] = motionWord(trial.kind);
    report[key::kSeed] = qint64(trial.seed);
    report[key::kOutside] = outsideWord(trial.parameters);
    report[key::kIsRight] = !trial.isWrong();
    report[key::kRegistration] = inMillimetres(trial.registrationAtTip);
    report[key::kRegistrationAtTeeth] = inMillimetres(trial.registrationAtTeeth);
    report[key::kTruth] = truthObject(trial);
    return report;
}

} // namespace carina::lab
