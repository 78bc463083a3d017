#pragma once

#include "evaluation/waveforms/recorded_waveform.h"

#include <cmath>
#include <random>
#include <vector>

namespace carina::test
{

inline constexpr double kRate_hz = 100.0;
inline constexpr double kFlow_lPerS = 0.5;
inline constexpr int kShutSamples = 5; // samples

/// A ventilator and a lung P = P0 + R Q + V/C, breath by breath in closed form: a steady flow for a
/// time in, then out through a valve, V(t) = Ve + (V0 - Ve) e^(-t/tau) with tau = (R + Rv) C.
struct SyntheticBreaths {
    double baseline = 12.0;   // cmH2O
    double resistance = 8.0;  // cmH2O s/L
    double compliance = 0.03; // L/cmH2O
    double valve = 14.0;      // cmH2O
    double valveResistance = 10.0;
    double noise = 0.0;

    RecordedWaveform waveform{kRate_hz, {}, {}};
    std::vector<double> flow_lPerS{};
    std::mt19937 random{7};

    void sample(double pressure, double flow)
    {
        std::normal_distribution<double> error{0.0, 1.0};
        waveform.pressure_cmH2O.push_back(pressure + noise * error(random));
        flow_lPerS.push_back(flow);
    }
    /// Samples are of the middle of their time.
    void breathe(double inspired_s, double expired_s)
    {
        const double step = 1.0 / kRate_hz;
        for (int i = 0; i < std::lround(inspired_s * kRate_hz); ++i)
            sample(baseline + resistance * kFlow_lPerS
                       + (i + 0.5) * step * kFlow_lPerS / compliance,
                   kFlow_lPerS);
        const double full = inspired_s * kFlow_lPerS;
        const double left = (valve - baseline) * compliance;
        const double tau = (resistance + valveResistance) * compliance;
        for (int i = 0; i < std::lround(expired_s * kRate_hz); ++i) {
            const double flow = -(full - left) / tau * std::exp(-(i + 0.5) * step / tau);
            sample(valve - valveResistance * flow, flow);
        }
        // The valve shuts, and what is left leaks out unseen.
        for (int i = 0; i < kShutSamples; ++i)
            sample(baseline, 0.0);
    }
    void open(double seconds)
    {
        for (int i = 0; i < std::lround(seconds * kRate_hz); ++i)
            sample(5.0, 0.0);
    }
};

inline SyntheticBreaths someBreaths(int count, double noise = 0.0)
{
    SyntheticBreaths breaths;
    breaths.noise = noise;
    breaths.sample(12.0, 0.0);
    for (int i = 0; i < count; ++i)
        breaths.breathe(0.8 + 0.02 * i, 1.5);
    return breaths;
}

} // namespace carina::test
