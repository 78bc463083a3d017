#include "apps/lab/intubation/trial_statistics.h"

#include "apps/lab/intubation/intubate_page.h"
#include "apps/lab/intubation/intubation_words.h"
#include "apps/lab/intubation/trial_report.h"

#include <algorithm>
#include <cmath>

namespace carina::lab
{
namespace
{

namespace all_key = intubate_all_key;

/// In thousandths, the one of numbers that a share of them does not exceed; null of none.
QJsonValue quantile(std::vector<double> numbers, double share)
{
    if (numbers.empty())
        return {};
    std::ranges::sort(numbers);
    const auto rank = std::ceil(share * double(numbers.size())) - 1.0;
    return 1e3 * numbers[static_cast<std::size_t>(std::max(rank, 0.0))];
}

/// Null of none.
QJsonValue shareOf(int count, std::size_t all)
{
    return all == 0 ? QJsonValue{} : QJsonValue{count / double(all)};
}

} // namespace

void TrialStatistics::Errors::add(double size, double bound)
{
    sizes.push_back(size);
    within += size <= bound ? 1 : 0;
}

void TrialStatistics::add(const IntubationTrial& trial)
{
    ++m_runs;
    m_outside += trial.parameters.outside ? 1 : 0;
    const TubeSeat truth = seatOf(trial.truth.outcome);
    ++m_seen[static_cast<std::size_t>(truth)][static_cast<std::size_t>(trial.course.seat)];
    m_wrongAttempts += trial.course.attempts == trial.truth.attempts ? 0 : 1;
    addTimes(trial);
    const bool isSure = trial.course.confidence >= kSure;
    if (!trial.isWrong()) {
        m_rightSure += isSure ? 1 : 0;
        if (trial.course.shapes.isIn)
            ++m_frozen;
        else
            addDepth(trial);
        return;
    }
    ++m_wrong;
    m_wrongUnsure += isSure ? 0 : 1;
    m_wrongRuns += QJsonObject{{all_key::kWrongScript, motionWord(trial.kind)},
                               {all_key::kWrongSeed, qint64(trial.seed)},
                               {all_key::kWrongTruth, seatWord(truth)},
                               {all_key::kWrongOutcome, seatWord(trial.course.seat)},
                               {all_key::kWrongConfidence, trial.course.confidence},
                               {all_key::kWrongOutside, outsideWord(trial.parameters)}};
}

void TrialStatistics::addDepth(const IntubationTrial& trial)
{
    const TipReading& tip = trial.course.tip;
    m_depth.add(std::abs((tip.depthAtTeeth - trial.truth.depthAtTeeth).si),
                (kDepthWithin + trial.registrationAtTeeth).si);
    if (trial.truth.tipAboveCarina)
        m_carina.add(std::abs((tip.aboveCarina - *trial.truth.tipAboveCarina).si),
                     (kDepthWithin + trial.registrationAtTip).si);
}

void TrialStatistics::addTimes(const IntubationTrial& trial)
{
    const StepErrors errors = stepErrors(trial);
    for (const Duration error : errors.times)
        m_times.add(std::abs(toSeconds(error)), toSeconds(kTimeWithin));
    m_missed += int(errors.missed.size());
    m_invented += int(errors.invented.size());
}

QJsonArray TrialStatistics::confusion() const
{
    QJsonArray rows;
    for (const TubeSeat truth : kTubeSeats) {
        const auto& seen = m_seen[static_cast<std::size_t>(truth)];
        const auto as = [&seen](TubeSeat seat) { return seen[static_cast<std::size_t>(seat)]; };
        rows += QJsonObject{{all_key::kTruth, seatWord(truth)},
                            {all_key::kNone, as(TubeSeat::None)},
                            {all_key::kTrachea, as(TubeSeat::Trachea)},
                            {all_key::kRightMain, as(TubeSeat::RightMain)},
                            {all_key::kLeftMain, as(TubeSeat::LeftMain)},
                            {all_key::kOesophagus, as(TubeSeat::Oesophagus)}};
    }
    return rows;
}

QJsonObject TrialStatistics::lengthsOf(const Errors& errors)
{
    return {{all_key::kMedian, quantile(errors.sizes, 0.5)},
            {all_key::k95, quantile(errors.sizes, 0.95)},
            {all_key::kGreatest, quantile(errors.sizes, 1.0)},
            {all_key::kWithin, shareOf(errors.within, errors.sizes.size())}};
}

QJsonObject TrialStatistics::times() const
{
    return {{all_key::kMedianTime, quantile(m_times.sizes, 0.5)},
            {all_key::k95Time, quantile(m_times.sizes, 0.95)},
            {all_key::kGreatestTime, quantile(m_times.sizes, 1.0)},
            {all_key::kWithinTime, shareOf(m_times.within, m_times.sizes.size())},
            {all_key::kMissed, m_missed},
            {all_key::kInvented, m_invented}};
}

QJsonObject TrialStatistics::report(const IntubationSubject& subject) const
{
    return {{all_key::kSchema, QLatin1StringView{all_key::kSchema.help}},
            {all_key::kPatient, QString::fromStdString(subject.name)},
            {all_key::kTube, inMillimetres(subject.innerDiameter)},
            {all_key::kShape, shapeWord(subject)},
            {all_key::kRuns, m_runs},
            {all_key::kOutside, m_outside},
            {all_key::kWrong, m_wrong},
            {all_key::kUnsure, m_wrongUnsure},
            {all_key::kSurelyRight, m_rightSure},
            {all_key::kConfusion, confusion()},
            {all_key::kFrozen, m_frozen},
            {all_key::kDepth, lengthsOf(m_depth)},
            {all_key::kCarina, lengthsOf(m_carina)},
            {all_key::kTimes, times()},
            {all_key::kAttempts, m_wrongAttempts},
            {all_key::kWrongRuns, m_wrongRuns}};
}

} // namespace carina::lab
