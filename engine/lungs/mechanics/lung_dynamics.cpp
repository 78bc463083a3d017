#include "engine/lungs/mechanics/lung_dynamics.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// Rates of change of one lung, per second.
struct LungRates {
    double gas = 0.0;
    double limb = 0.0;
    double trapped = 0.0;
};
using ChestRates = std::array<LungRates, 2>;

/// Gas that came through a tear collapses the lung, wholly when it is as much as the lung at rest.
double openShare(const LungMechanics& lung, const LungContent& content)
{
    return std::clamp(1.0 - content.trapped / lung.wallVolume, kLeastOpenShare, 1.0);
}

Pressure recoil(const LungMechanics& lung, const LungContent& content)
{
    PressureVolumeCurve curve = lung.curve;
    curve.span = openShare(lung, content) * curve.span;
    return curve.pressureAt(content.gas) + (0.5 - content.limb) * lung.limbSpread;
}

/// Bronchi close towards the floor of the lung, so that the floor is never reached.
double openBronchi(const LungMechanics& lung, const LungContent& content)
{
    if (lung.bronchi < kShut)
        return 0.0;
    const double open = openShare(lung, content);
    const double share = (content.gas - lung.curve.floor) / (open * lung.curve.span);
    return lung.bronchi.si * open * std::clamp(share / kClosingShare, 0.0, 1.0);
}

/// Of the bronchial conductance to gas that leaves, what is left of it below the closing volume.
double openToLeaving(const LungMechanics& lung, const LungContent& content)
{
    if (content.gas >= lung.closing)
        return 1.0;
    const double share = (content.gas - lung.curve.floor) / (lung.closing - lung.curve.floor);
    return std::clamp(share, kLeastOpenToLeaving, 1.0);
}

/// Pleural pressures, and what the mediastinum gives way, from the contents.
void solvePleura(const RespiratorySystem& system, const ChestContent& content, double muscle,
                 ChestMoment& moment)
{
    std::array<double, 2> alone{}; // with the mediastinum in the middle
    for (std::size_t i = 0; i < 2; ++i) {
        const LungMechanics& lung = system.lungs[i];
        const Volume held = content[i].gas + lung.pleuralGas + content[i].trapped;
        alone[i] =
            (held - lung.wallVolume).si / lung.wall.si - lung.wallRecoil.si - lung.drive * muscle;
    }
    const double stiffness = 1.0 / system.lungs[0].wall.si + 1.0 / system.lungs[1].wall.si;
    const double free = system.mediastinum.si * (alone[0] - alone[1] + system.mediastinalWeight.si)
                        / (1.0 + system.mediastinum.si * stiffness);
    const double most = system.mediastinumMost.si;
    moment.mediastinum = {std::clamp(free, -most, most)};
    moment.pleural[0] = {alone[0] - moment.mediastinum.si / system.lungs[0].wall.si};
    moment.pleural[1] = {alone[1] + moment.mediastinum.si / system.lungs[1].wall.si};
}

/// The branches below the carina as one: a conductance to a mean pressure.
struct Branches {
    double conductance = 0.0;
    double inflow = 0.0; ///< conductance times pressure, summed

    void add(double branch, double pressure)
    {
        conductance += branch;
        inflow += branch * pressure;
    }
    [[nodiscard]] double meanPressure() const { return inflow / conductance; }
};

/// The flow that a pressure at the opening drives through upper airway and branches: the root of
/// (K1 + 1/G) Q + K2 Q |Q| = difference.
double flowAt(double pressure, const RespiratorySystem& system, const Branches& branches)
{
    if (branches.conductance == 0.0)
        return 0.0;
    const double difference = pressure - branches.meanPressure();
    const double linear = system.upperLaminar.si + 1.0 / branches.conductance;
    return 2.0 * difference
           / (linear
              + std::sqrt(linear * linear + 4.0 * system.upperTurbulent * std::abs(difference)));
}

/// Flow at the opening and pressure at the carina.
void solveUpperAirway(const RespiratorySystem& system, const Branches& branches,
                      const AirwayOpening& opening, ChestMoment& moment)
{
    double flow = flowAt(opening.pressure.si, system, branches);
    if (opening.drivesFlow)
        flow = std::min(flow, opening.flow.si);
    const double lost = (system.upperLaminar.si + system.upperTurbulent * std::abs(flow)) * flow;
    moment.airwayFlow = {flow};
    if (branches.conductance == 0.0) {
        moment.opening = opening.pressure;
        moment.carina = opening.pressure;
        return;
    }
    moment.carina = {branches.meanPressure() + flow / branches.conductance};
    moment.opening = opening.drivesFlow ? Pressure{moment.carina.si + lost} : opening.pressure;
}

/// The airway while each lung's gas goes one way or the other, and with the tears that are open.
struct AirwayPaths {
    std::array<double, 2> inward{};  ///< conductance of the bronchi to gas that comes in
    std::array<double, 2> outward{}; ///< and to gas that leaves
    std::array<double, 2> bronchi{};
    std::array<double, 2> tears{};
    std::array<bool, 2> leaves{};
};

/// Pressures and flows in these paths, gas going whichever way they drive it. Bronchi that resist
/// more to gas that leaves make the flow through them a convex function of the carina's pressure;
/// taking it for straight finds a pressure that is too high, so that from the second time on lungs
/// only change from filling to emptying: four times are enough for two of them.
void settleAirway(const RespiratorySystem& system, const AirwayOpening& opening, AirwayPaths& paths,
                  ChestMoment& moment)
{
    constexpr int kMostTimes = 4;
    bool isSettled = false;
    for (int time = 0; time < kMostTimes && !isSettled; ++time) {
        Branches branches;
        for (std::size_t i = 0; i < 2; ++i) {
            paths.bronchi[i] = paths.leaves[i] ? paths.outward[i] : paths.inward[i];
            branches.add(paths.bronchi[i], moment.alveolar[i].si);
            branches.add(paths.tears[i], moment.pleural[i].si);
        }
        solveUpperAirway(system, branches, opening, moment);
        isSettled = true;
        for (std::size_t i = 0; i < 2; ++i) {
            const bool leaves = moment.alveolar[i] > moment.carina;
            isSettled =
                isSettled && (leaves == paths.leaves[i] || paths.inward[i] == paths.outward[i]);
            paths.leaves[i] = leaves;
        }
    }
}

void solveAirway(const RespiratorySystem& system, const ChestContent& content,
                 const AirwayOpening& opening, ChestMoment& moment)
{
    AirwayPaths paths;
    for (std::size_t i = 0; i < 2; ++i) {
        const LungMechanics& lung = system.lungs[i];
        paths.inward[i] = openBronchi(lung, content[i]);
        paths.outward[i] = paths.inward[i] * openToLeaving(lung, content[i]) / lung.compression;
        paths.leaves[i] = !opening.drivesFlow && moment.alveolar[i] > opening.pressure;
    }
    settleAirway(system, opening, paths, moment);
    for (std::size_t i = 0; i < 2; ++i) {
        if (moment.carina > moment.pleural[i])
            paths.tears[i] = system.lungs[i].valve.si;
    }
    if (paths.tears[0] + paths.tears[1] > 0.0)
        settleAirway(system, opening, paths, moment);
    for (std::size_t i = 0; i < 2; ++i) {
        moment.intoLung[i] = {paths.bronchi[i] * (moment.carina - moment.alveolar[i]).si};
        moment.intoPleura[i] = {paths.tears[i]
                                * std::max(0.0, (moment.carina - moment.pleural[i]).si)};
    }
}

ChestRates ratesAt(const RespiratorySystem& system, const ChestContent& content, Pressure muscle,
                   const AirwayOpening& opening)
{
    const ChestMoment moment = chestMoment(system, content, muscle, opening);
    ChestRates rates;
    for (std::size_t i = 0; i < 2; ++i) {
        const LungMechanics& lung = system.lungs[i];
        const double flow = moment.intoLung[i].si;
        const double limbOfFlow = flow > 0.0 ? 0.0 : 1.0;
        rates[i].gas = flow - moment.uptake[i].si;
        rates[i].limb = std::abs(flow) / lung.limbVolume.si * (limbOfFlow - content[i].limb);
        rates[i].trapped = moment.intoPleura[i].si - lung.relief.si * content[i].trapped.si;
    }
    return rates;
}

ChestContent moved(const ChestContent& content, const ChestRates& rates, double seconds)
{
    ChestContent to = content;
    for (std::size_t i = 0; i < 2; ++i) {
        to[i].gas.si += seconds * rates[i].gas;
        to[i].limb += seconds * rates[i].limb;
        to[i].trapped.si += seconds * rates[i].trapped;
    }
    return to;
}

} // namespace

ChestMoment chestMoment(const RespiratorySystem& system, const ChestContent& content,
                        Pressure muscle, const AirwayOpening& opening)
{
    ChestMoment moment;
    solvePleura(system, content, muscle.si, moment);
    for (std::size_t i = 0; i < 2; ++i) {
        const LungMechanics& lung = system.lungs[i];
        moment.alveolar[i] = moment.pleural[i] + recoil(lung, content[i]);
        moment.uptake[i] = {lung.uptake.si * std::max(0.0, (content[i].gas - lung.uptakeEnd).si)};
    }
    solveAirway(system, content, opening, moment);
    return moment;
}

ChestContent advanced(const RespiratorySystem& system, const ChestContent& content,
                      const std::array<Pressure, 3>& muscle, const AirwayOpening& opening,
                      double seconds)
{
    const double half = 0.5 * seconds;
    const ChestRates k1 = ratesAt(system, content, muscle[0], opening);
    const ChestRates k2 = ratesAt(system, moved(content, k1, half), muscle[1], opening);
    const ChestRates k3 = ratesAt(system, moved(content, k2, half), muscle[1], opening);
    const ChestRates k4 = ratesAt(system, moved(content, k3, seconds), muscle[2], opening);
    ChestRates mean;
    for (std::size_t i = 0; i < 2; ++i) {
        mean[i].gas = (k1[i].gas + 2.0 * (k2[i].gas + k3[i].gas) + k4[i].gas) / 6.0;
        mean[i].limb = (k1[i].limb + 2.0 * (k2[i].limb + k3[i].limb) + k4[i].limb) / 6.0;
        mean[i].trapped =
            (k1[i].trapped + 2.0 * (k2[i].trapped + k3[i].trapped) + k4[i].trapped) / 6.0;
    }
    ChestContent to = moved(content, mean, seconds);
    for (LungContent& lung : to) // of little lungs a step may lead beyond
        lung.limb = std::clamp(lung.limb, 0.0, 1.0);
    return to;
}

ChestContent restingContent(const RespiratorySystem& system)
{
    // Both lungs move towards balance with the opening, each by a part of its imbalance that its
    // own lung and wall cannot overshoot.
    constexpr double kNear = 1e-12; // m^3
    constexpr int kMostRounds = 10000;
    ChestContent content;
    for (std::size_t i = 0; i < 2; ++i)
        content[i].gas = system.lungs[i].curve.floor + 0.5 * system.lungs[i].curve.span;
    for (int round = 0; round < kMostRounds; ++round) {
        ChestMoment moment;
        solvePleura(system, content, 0.0, moment);
        double furthest = 0.0;
        for (std::size_t i = 0; i < 2; ++i) {
            const LungMechanics& lung = system.lungs[i];
            const double imbalance = (moment.pleural[i] + recoil(lung, content[i])).si;
            const double stiffness =
                1.0 / lung.wall.si + 1.0 / lung.curve.complianceAt(content[i].gas).si;
            const double step = -0.5 * imbalance / stiffness;
            content[i].gas.si += step;
            furthest = std::max(furthest, std::abs(step));
        }
        if (furthest < kNear)
            break;
    }
    return content;
}

} // namespace carina
