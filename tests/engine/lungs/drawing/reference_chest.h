#pragma once

#include <array>
#include <cmath>
#include <functional>

namespace carina::test
{

/// Two lungs in a chest, written from docs/mechanics.md anew: litres, cmH2O and seconds, pressures
/// of the airway found by bisection, sides of the chest by Cramer's rule, and the method of Heun
/// with many small steps. It shares nothing with the engine.
struct ReferenceChest {
    struct Lung {
        double floor, span, centre, width;
        double limbSpread, limbVolume;
        double bronchi;     ///< resistance
        double compression; ///< of that, when gas leaves
        double wall, wallVolume, wallRecoil;
        double gas, limb;
    };
    using Rates = std::array<double, 4>; ///< gas right and left, limb right and left

    std::array<Lung, 2> lungs;
    double k1 = 0.0;
    double k2 = 0.0;
    double mediastinum = 0.0;

    [[nodiscard]] double recoil(const Lung& lung) const
    {
        const double above = lung.gas - lung.floor;
        const double below = lung.floor + lung.span - lung.gas;
        return lung.centre + lung.width * std::log(above / below)
               + (0.5 - lung.limb) * lung.limbSpread;
    }

    /// Pleural pressures p: p_i = wall_i(gas_i -+ M (p_right - p_left)) - muscle.
    [[nodiscard]] std::array<double, 2> pleural(double muscle) const
    {
        std::array<double, 2> rightHandSide{};
        std::array<double, 2> m{}; // of the mediastinum, per pressure
        for (std::size_t i = 0; i < 2; ++i) {
            const Lung& lung = lungs[i];
            rightHandSide[i] = (lung.gas - lung.wallVolume) / lung.wall - lung.wallRecoil - muscle;
            m[i] = mediastinum / lung.wall;
        }
        const double determinant = (1.0 + m[0]) * (1.0 + m[1]) - m[0] * m[1];
        return {((1.0 + m[1]) * rightHandSide[0] + m[0] * rightHandSide[1]) / determinant,
                ((1.0 + m[0]) * rightHandSide[1] + m[1] * rightHandSide[0]) / determinant};
    }

    /// Flow into each lung where the opening is at a pressure.
    [[nodiscard]] std::array<double, 2> flows(double opening, double muscle) const
    {
        const auto pleura = pleural(muscle);
        const std::array<double, 2> alveolar{pleura[0] + recoil(lungs[0]),
                                             pleura[1] + recoil(lungs[1])};
        const auto into = [&](std::size_t i, double carina) {
            const double difference = carina - alveolar[i];
            const double narrower = difference < 0.0 ? lungs[i].compression : 1.0;
            return difference / (narrower * lungs[i].bronchi);
        };
        const auto excess = [&](double flow) { // that the lungs would take above it
            const double carina = opening - k1 * flow - k2 * flow * std::abs(flow);
            return into(0, carina) + into(1, carina) - flow;
        };
        double low = -50.0;
        double high = 50.0; // L/s
        for (int i = 0; i < 48; ++i) {
            const double middle = 0.5 * (low + high);
            (excess(middle) > 0.0 ? low : high) = middle;
        }
        const double flow = 0.5 * (low + high);
        const double carina = opening - k1 * flow - k2 * flow * std::abs(flow);
        return {into(0, carina), into(1, carina)};
    }

    [[nodiscard]] Rates rates(double opening, double muscle) const
    {
        const auto in = flows(opening, muscle);
        Rates rates{in[0], in[1], 0.0, 0.0};
        for (std::size_t i = 0; i < 2; ++i)
            rates[2 + i] =
                std::abs(in[i]) / lungs[i].limbVolume * ((in[i] > 0.0 ? 0.0 : 1.0) - lungs[i].limb);
        return rates;
    }

    void add(const Rates& rates, double seconds)
    {
        for (std::size_t i = 0; i < 2; ++i) {
            lungs[i].gas += seconds * rates[i];
            lungs[i].limb += seconds * rates[2 + i];
        }
    }

    /// From `from` on for `steps` small steps.
    void run(double from, int steps, double step, const std::function<double(double)>& opening,
             const std::function<double(double)>& muscle)
    {
        for (int i = 0; i < steps; ++i) {
            const double t = from + i * step;
            const Rates before = rates(opening(t), muscle(t));
            ReferenceChest there = *this;
            there.add(before, step);
            const Rates after = there.rates(opening(t + step), muscle(t + step));
            add(before, 0.5 * step);
            add(after, 0.5 * step);
        }
    }
};

} // namespace carina::test
