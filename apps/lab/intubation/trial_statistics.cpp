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

/// Of sorted numbers, the one that a share of them does not exceed; 0 of none.
double quantile(std::vector<double> numbers, double share)
{
    if (numbers.empty())
        return 0.0;
    std::ranges::sort(numbers);
    const auto rank = std::ceil(share * double(numbers.size())) - 1.0;
    return numbers[static_cast<std::size_t>(std::max(rank, 0.0))];
}

double shareOf(int count, std::size_t all) { return all == 0 ? 1.0 : count / double(all); }

} // namespace

void TrialStatistics::Errors::add(double size, double bound)
{
    sizes.push_back(size);
    within += size <= bound ? 1 : 0;
}

void TrialStatistics::add(const IntubationTrial& trial)
{
    using namespace intubate_all_key;
    ++m_runs;
    m_outside += trial.parameters.outside ? 1 : 0;
    const TubeSeat truth = seatOf(trial.truth.outcome);
    ++m_seen[static_cast<std::size_t>(truth)][static_cast<std::size_t>(trial.course.seat)];
    m_wrongAttempts += trial.course.attempts == trial.truth.attempts ? 0 : 1;
    addTimes(trial);
    const bool isSure = trial.course.confidence >= kSure;
    if (!trial.isWrong()) {
        m_rightSure += isSure ? 1 : 0;
        addDepth(trial);
        return;
    }
    ++m_wrong;
    m_wrongUnsure += isSure ? 0 : 1;
    m_wrongRuns += QJsonObject{{kWrongScript, motionWord(trial.kind)},
                               {kWrongSeed, qint64(trial.seed)},
                               {kWrongTruth, seatWord(truth)},
                               {kWrongOutcome, seatWord(trial.course.seat)},
                               {kWrongConfidence, trial.course.confidence},
                               {kWrongOutside, outsideWord(trial.parameters)}};
}

void TrialStatistics::addDepth(const IntubationTrial& trial)
{
    const double bound = (kDepthWithin + trial.registrationShare).si;
    const TipReading& tip = trial.course.tip;
    m_depth.add(std::abs((tip.depthAtTeeth - trial.truth.depthAtTeeth).si), bound);
    if (trial.truth.tipAboveCarina)
        m_carina.add(std::abs((tip.aboveCarina - *trial.truth.tipAboveCarina).si), bound);
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
    using namespace intubate_all_key;
    QJsonArray rows;
    for (const TubeSeat truth : kTubeSeats) {
        const auto& seen = m_seen[static_cast<std::size_t>(truth)];
        const auto as = [&seen](TubeSeat seat) { return seen[static_cast<std::size_t>(seat)]; };
        rows += QJsonObject{
            {kTruth, seatWord(truth)},           {kNone, as(TubeSeat::None)},
            {kTrachea, as(TubeSeat::Trachea)},   {kRightMain, as(TubeSeat::RightMain)},
            {kLeftMain, as(TubeSeat::LeftMain)}, {kOesophagus, as(TubeSeat::Oesophagus)}};
    }
    return rows;
}

QJsonObject TrialStatistics::lengthsOf(const Errors& errors)
{
    using namespace intubate_all_key;
    return {{kMedian, 1e3 * quantile(errors.sizes, 0.5)},
            {k95, 1e3 * quantile(errors.sizes, 0.95)},
            {kGreatest, 1e3 * quantile(errors.sizes, 1.0)},
            {kWithin, shareOf(errors.within, errors.sizes.size())}};
}

QJsonObject TrialStatistics::times() const
{
    using namespace intubate_all_key;
    return {{kMedianTime, 1e3 * quantile(m_times.sizes, 0.5)},
            {k95Time, 1e3 * quantile(m_times.sizes, 0.95)},
            {kGreatestTime, 1e3 * quantile(m_times.sizes, 1.0)},
            {kWithinTime, shareOf(m_times.within, m_times.sizes.size())},
            {kMissed, m_missed},
            {kInvented, m_invented}};
}

QJsonObject TrialStatistics::report(const IntubationSubject& subject) const
{
    using namespace intubate_all_key;
    return {{kSchema, QLatin1StringView{kSchema.help}},
            {intubate_all_key::kPatient, QString::fromStdString(subject.name)},
            {kTube, inMillimetres(subject.innerDiameter)},
            {kRuns, m_runs},
            {kOutside, m_outside},
            {kWrong, m_wrong},
            {kUnsure, m_wrongUnsure},
            {kSurelyRight, m_rightSure},
            {kConfusion, confusion()},
            {kDepth, lengthsOf(m_depth)},
            {kCarina, lengthsOf(m_carina)},
            {kTimes, times()},
            {kAttempts, m_wrongAttempts},
            {kWrongRuns, m_wrongRuns}};
}

} // namespace carina::lab
