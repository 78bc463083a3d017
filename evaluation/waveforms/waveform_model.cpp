#include "evaluation/waveforms/waveform_model.h"

#include "engine/lungs/mechanics/lung_dynamics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace carina
{
namespace
{

constexpr std::array<Pressure, 3> kNoMuscle{};
constexpr Pressure kNoLimit = cmH2O(1e6);
constexpr double kBefore = 0.05; // s

/// A lung without a chest, behind a resistance at the opening: two halves in walls that give way,
/// of a capacity so large that their curves are straight.
RespiratorySystem bareLung(const LinearLung& lung, Resistance outlet)
{
    constexpr Volume kLarge = litres(1e4);
    RespiratorySystem system;
    for (LungMechanics& half : system.lungs) {
        half.curve = PressureVolumeCurve::through((-1.0) * kLarge, kLarge, {}, lung.baseline,
                                                  0.5 * lung.compliance);
        half.limbVolume = litres(1.0);
        half.bronchi = {0.5 / lung.resistance.si};
        half.wall = litresPerCmH2O(1e9);
        half.wallVolume = litres(1.0);
    }
    system.upperLaminar = outlet;
    return system;
}

/// Flow and valve as the model sees them.
struct Driving {
    const RecordedWaveform& waveform;
    VolumeFlow inspiratoryFlow;
    std::optional<ExpiratoryValve> valve;

    [[nodiscard]] AirwayOpening openingAt(const RecordedBreath& breath, std::size_t i) const
    {
        if (!waveform.flow_lPerS.empty())
            return AirwayOpening::driven(litresPerSecond(waveform.flow_lPerS[i]), kNoLimit);
        if (i < breath.expiration)
            return AirwayOpening::driven(inspiratoryFlow, kNoLimit);
        return AirwayOpening::at(valve->pressure);
    }
};

/// Sum of the squares of modelled less recorded pressure over a breath, cmH2O^2. The pressure is
/// measured between the lung and its valve.
double squaresOf(const Driving& driving, const RecordedBreath& breath, const LinearLung& lung)
{
    const double step = 1.0 / driving.waveform.rate_hz;
    const RespiratorySystem inspiring = bareLung(lung, {});
    const RespiratorySystem expiring =
        driving.valve ? bareLung(lung, driving.valve->resistance) : inspiring;
    ChestContent content;
    double squares = 0.0;
    for (std::size_t i = breath.begin; i < breath.end; ++i) {
        const AirwayOpening opening = driving.openingAt(breath, i);
        const RespiratorySystem& system = i < breath.expiration ? inspiring : expiring;
        const auto pressure = [&] {
            return inCmH2O(chestMoment(system, content, {}, opening).carina);
        };
        const double before = pressure();
        content = advanced(system, content, kNoMuscle, opening, step);
        const double modelled = 0.5 * (before + pressure());
        squares += std::pow(modelled - driving.waveform.pressure_cmH2O[i], 2);
    }
    return squares;
}

using LungOfBreath = std::function<LinearLung(const FittedBreath&)>;

Pressure rmsOf(const Driving& driving, const std::vector<FittedBreath>& breaths,
               const LungOfBreath& lungOf)
{
    double squares = 0.0;
    std::size_t samples = 0;
    for (const FittedBreath& breath : breaths) {
        squares += squaresOf(driving, breath.samples, lungOf(breath));
        samples += breath.samples.end - breath.samples.begin;
    }
    return cmH2O(std::sqrt(squares / double(samples)));
}

LinearLung ownLung(const FittedBreath& breath) { return breath.lung; }

/// What tells the lung of a breath.
LungSamples tellingSamples(const RecordedWaveform& waveform, const RecordedBreath& breath,
                           VolumeFlow inspiratoryFlow)
{
    const bool recorded = !waveform.flow_lPerS.empty();
    const auto before =
        recorded ? std::size_t{0} : std::min(breath.begin, std::size_t(kBefore * waveform.rate_hz));
    const double step = 1.0 / waveform.rate_hz;
    LungSamples samples;
    double volume_l = 0.0;
    for (std::size_t i = breath.begin - before; i < (recorded ? breath.end : breath.expiration);
         ++i) {
        const double flow = recorded           ? waveform.flow_lPerS[i]
                            : i < breath.begin ? 0.0
                                               : inLitresPerSecond(inspiratoryFlow);
        samples.pressure_cmH2O.push_back(waveform.pressure_cmH2O[i]);
        samples.flow_lPerS.push_back(flow);
        samples.volume_l.push_back(volume_l + 0.5 * step * flow);
        volume_l += step * flow;
    }
    return samples;
}

/// A dozen breaths, spread over all.
std::vector<FittedBreath> someOf(const std::vector<FittedBreath>& breaths)
{
    const std::size_t stride = 1 + breaths.size() / 12;
    std::vector<FittedBreath> some;
    for (std::size_t i = 0; i < breaths.size(); i += stride)
        some.push_back(breaths[i]);
    return some;
}

/// The valve with which the model is nearest to the recording: from what the first breath suggests
/// on, steps to the best neighbour, halved where none is better.
ExpiratoryValve findValve(Driving driving, const std::vector<FittedBreath>& breaths)
{
    constexpr double kFinest = 0.025; // cmH2O, and of the logarithm of the resistance
    // A higher pressure behind less resistance is nearly as good: the way goes across.
    constexpr std::pair<double, double> kNeighbours[]{{1, 0},  {-1, 0}, {0, 1}, {0, -1},
                                                      {1, -1}, {-1, 1}, {1, 1}, {-1, -1}};
    const auto rmsWith = [&](const ExpiratoryValve& valve) {
        driving.valve = valve;
        return rmsOf(driving, breaths, ownLung);
    };
    const double end = driving.waveform.pressure_cmH2O[breaths.front().samples.end - 1];
    ExpiratoryValve best{cmH2O(end), breaths.front().lung.resistance};
    Pressure least = rmsWith(best);
    for (double step = 0.8; step > kFinest;) {
        const ExpiratoryValve centre = best;
        for (const auto& [up, wider] : kNeighbours) {
            const ExpiratoryValve tried{centre.pressure + cmH2O(up * step),
                                        std::exp(wider * step) * centre.resistance};
            const Pressure rms = rmsWith(tried);
            if (rms < least) {
                least = rms;
                best = tried;
            }
        }
        if (best == centre)
            step *= 0.5;
    }
    return best;
}

/// The middle of what a figure of the breaths comes to.
template <class Figure> auto medianOver(const std::vector<FittedBreath>& breaths, Figure figure)
{
    std::vector<decltype(figure(breaths.front()))> values;
    for (const FittedBreath& breath : breaths)
        values.push_back(figure(breath));
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

Result<WaveformModel> modelOf(const RecordedWaveform& waveform,
                              const std::vector<BreathPart>& parts, VolumeFlow inspiratoryFlow)
{
    WaveformModel model;
    for (const RecordedBreath& breath : breathsOf(parts)) {
        const LungSamples samples = tellingSamples(waveform, breath, inspiratoryFlow);
        if (const auto lung = fitLinear(samples))
            model.breaths.push_back({breath, *lung});
        else
            ++model.unfit;
    }
    if (model.breaths.empty())
        return fail(Errc::NothingRecognised, "no breath that tells resistance and compliance");
    const std::vector<FittedBreath>& breaths = model.breaths;
    Driving driving{waveform, inspiratoryFlow, {}};
    if (waveform.flow_lPerS.empty())
        driving.valve = model.valve = findValve(driving, someOf(breaths));
    model.median = {medianOver(breaths, [](const FittedBreath& b) { return b.lung.baseline; }),
                    medianOver(breaths, [](const FittedBreath& b) { return b.lung.resistance; }),
                    medianOver(breaths, [](const FittedBreath& b) { return b.lung.compliance; })};
    model.rms = rmsOf(driving, breaths, ownLung);
    model.rmsOneLung = rmsOf(driving, breaths, [&](const FittedBreath&) { return model.median; });
    return model;
}

} // namespace carina
