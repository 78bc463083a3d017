#include "engine/tracking/prediction/motion_predictor.h"

#include "engine/geometry/rotation.h"
#include "engine/tracking/prediction/prediction.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kSettlingSamples = 30; // until then a filter expects what it was begun with
constexpr double kBetter = 0.95;     // of the errors of the one that predicts, for another to do so
constexpr double kLeastScale = 1e-3; // of what is expected: a motion may be predicted exactly

MotionFilter::Noise withJerk(double factor)
{
    MotionFilter::Noise noise = MotionFilter::handsAndHeads();
    noise.position.jerk *= factor;
    noise.rotation.jerk *= factor;
    return noise;
}

ErrorGrowth::Polynomial scaled(ErrorGrowth::Polynomial variance, double factor)
{
    for (double& c : variance)
        c *= factor;
    return variance;
}

template <typename Records> std::size_t bestOf(const Records& records, std::size_t now)
{
    const auto best = std::ranges::min_element(records, {}, [](const auto& r) { return r.found; });
    const bool isBetter = best->found < kBetter * kBetter * records[now].found;
    return isBetter ? std::size_t(best - records.begin()) : now;
}

} // namespace

MotionPredictor::MotionPredictor()
{
    for (std::size_t i = 0; i < kFilters; ++i)
        m_filters[i] = MotionFilter{withJerk(std::exp2(kLeastPower + int(i)))};
}

void MotionPredictor::add(const PoseSample& sample)
{
    if (sample.validity == Validity::Lost || (m_newest && sample.time <= m_newest->time))
        return;
    if (!m_newest || sample.time - m_newest->time > MotionFilter::kLongestGap) {
        m_forecasts.clear();
        m_inARow = 0;
    }
    for (; !m_forecasts.empty() && m_forecasts.front().due <= sample.time; m_forecasts.pop_front())
        compare(m_forecasts.front(), interpolate(m_newest->X_FO, sample.X_FO,
                                                 toSeconds(m_forecasts.front().due - m_newest->time)
                                                     / toSeconds(sample.time - m_newest->time)));
    for (MotionFilter& filter : m_filters)
        filter.add(sample);
    m_newest = sample;
    m_inARow = std::min(m_inARow + 1, kSettlingSamples);
    choose();
    if (m_inARow == kSettlingSamples)
        forecast();
}

void MotionPredictor::forecast()
{
    const double ahead = toSeconds(kForecast);
    Forecast made{.due = m_newest->time + kForecast};
    for (std::size_t i = 0; i < kFilters; ++i) {
        Motion motion = *m_filters[i].motion();
        made.expected[i] = {metres(ErrorGrowth::rmsAfter(ahead, motion.growth->position)),
                            radians(ErrorGrowth::rmsAfter(ahead, motion.growth->rotation))};
        made.X_FO[i] = movedOn(m_filters[i].pose(), motion, ahead);
    }
    m_forecasts.push_back(made);
}

void MotionPredictor::compare(const Forecast& forecast, const RigidTransform& measured)
{
    const Duration since = m_forecasts.size() > 1 ? m_forecasts[1].due - forecast.due : Duration{};
    const double kept = std::exp(-toSeconds(since) / toSeconds(kMemory));
    const auto add = [kept](Record& record, double found, double expected) {
        record.found = kept * record.found + found * found;
        record.expected = kept * record.expected + expected * expected;
    };
    for (std::size_t i = 0; i < kFilters; ++i) {
        const RigidTransform& X_FO = forecast.X_FO[i];
        const PoseDeviation& expected = forecast.expected[i];
        add(m_positions[i], (X_FO.translation() - measured.translation()).norm(),
            expected.position.si);
        add(m_rotations[i], angleBetween(X_FO.rotation(), measured.rotation()).si,
            expected.rotation.si);
    }
    m_compared = std::min(m_compared + 1, kForecastsNeeded);
}

void MotionPredictor::choose()
{
    if (m_compared < kForecastsNeeded)
        return;
    m_position = bestOf(m_positions, m_position);
    m_rotation = bestOf(m_rotations, m_rotation);
}

std::optional<MotionPredictor::Estimate> MotionPredictor::estimate() const
{
    const std::optional<Motion> place = m_filters[m_position].motion();
    const std::optional<Motion> turn = m_filters[m_rotation].motion();
    if (!place || !turn)
        return std::nullopt;
    const auto found = [this](const Record& record) {
        return m_compared < kForecastsNeeded
                   ? 1.0
                   : std::max(kLeastScale * kLeastScale, record.found / record.expected);
    };
    return Estimate{
        .X_FO = {m_filters[m_rotation].pose().rotation(),
                 m_filters[m_position].pose().translation()},
        .motion = {
            .v_FO = place->v_FO,
            .w_FO = turn->w_FO,
            .a_FO = place->a_FO,
            .alpha_FO = turn->alpha_FO,
            .growth = ErrorGrowth{
                .position = scaled(place->growth->position, found(m_positions[m_position])),
                .rotation = scaled(turn->growth->rotation, found(m_rotations[m_rotation]))}}};
}

} // namespace carina
