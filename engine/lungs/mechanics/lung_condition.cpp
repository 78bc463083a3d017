#include "engine/lungs/mechanics/lung_condition.h"

#include "engine/core/expects.h"
#include "engine/lungs/mechanics/lung_dynamics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace carina
{
namespace
{

/// Values at the severities 0, 0.3, 0.6 and 0.9, on straight lines between and beyond.
using SeverityTable = std::array<double, 4>;

double lookedUp(const SeverityTable& table, double severity)
{
    const double place = severity / 0.3;
    const std::size_t from = std::min<std::size_t>(2, static_cast<std::size_t>(place));
    return table[from] + (place - static_cast<double>(from)) * (table[from + 1] - table[from]);
}

// Pulse's table of diseases; fatigue is a factor on the tidal volume.
constexpr SeverityTable kArdsOpen{1.0, 0.7, 0.5, 0.4};
constexpr SeverityTable kArdsInspiration{1.0, 0.7 / 0.5, 1.1 / 0.5, 1.5 / 0.5}; // of I:E
constexpr SeverityTable kArdsFatigue{1.0, 0.76, 0.52, 0.28};
constexpr SeverityTable kArdsDeadSpace_l{0.0, 0.0, 0.03, 0.15};
constexpr SeverityTable kCopdCompliance{1.0, 1.0, 1.1, 1.4};
constexpr SeverityTable kCopdResistance{1.0, 0.85 / 0.45, 1.7 / 0.45, 2.4 / 0.45};
// To gas that leaves, over that to gas that comes in: of 24.4 cmH2O s/L in severe COPD (the mean of
// "An identifiable model of lung mechanics to diagnose and monitor COPD") 1.125 lie above the
// carina. The straight line to it is ours.
constexpr SeverityTable kCopdCompression{1.0, 3.9, 6.8, 9.7};
constexpr SeverityTable kCopdInspiration{1.0, 0.35 / 0.5, 0.22 / 0.5, 0.12 / 0.5}; // of I:E
constexpr SeverityTable kCopdFatigue{1.0, 0.87, 0.76, 0.64};
constexpr SeverityTable kCopdDeadSpace_l{0.0, 0.3, 0.6, 0.9};
constexpr double kCopdClosing = 1.7;
constexpr double kAsthmaCompression = 2.3;
constexpr double kAsthmaClosing = 1.6;
// Total capacity times resistance of the bronchi of an adult in health: 6.16 L, 0.45 cmH2O s/L.
// Relaxed muscles change neither. The exponent is ours: with it severe asthma and COPD trap as much
// gas at 20 breaths a minute at all ages.
constexpr double kAdultNarrowness = 6.16 * 0.45; // cmH2O s
constexpr double kCompressionByNarrowness = -1.25;
constexpr double kPulseRest_l = 2.31; // resting volume of the patient the dead spaces are of
// Emphysema (AJRCCM 158:3), reached at 0.9.
constexpr SeverityTable kCopdRest{1.0, 1.0 + 0.77 / 3.0, 1.0 + 1.54 / 3.0, 1.77};
constexpr SeverityTable kCopdCapacity{1.0, 1.0 + 0.40 / 3.0, 1.0 + 0.80 / 3.0, 1.40};
constexpr SeverityTable kCopdFloor{1.0, 1.0 + 1.42 / 3.0, 1.0 + 2.84 / 3.0, 2.42};

bool affects(const LungCondition& condition, std::size_t lung)
{
    return condition.side == ConditionSide::Both
           || (condition.side == ConditionSide::Right) == (lung == 0);
}

Volume ceilingOf(const PressureVolumeCurve& curve) { return curve.floor + curve.span; }

/// Leaves a share of the lung open, which rested at `restBefore` between its wall and what gas is
/// in the pleural space. The wall comes in and pulls more on what is left.
void closeAllBut(LungMechanics& lung, double open, Volume restBefore)
{
    const PressureVolumeCurve& before = lung.curve;
    const Volume nearEnd = kStraightShare * before.span;
    restBefore = std::clamp(restBefore, before.floor + nearEnd, ceilingOf(before) - nearEnd);
    const Volume rest = before.floor + open * (restBefore - before.floor);
    const Pressure recoil =
        before.pressureAt(restBefore) + Pressure{(restBefore - rest).si / lung.wall.si};
    lung.curve = PressureVolumeCurve::through(before.floor, before.floor + open * before.span, rest,
                                              recoil, open * before.complianceAt(restBefore));
}

/// The effort that brings `fatigue` times the tidal volume when the lung's compliance is multiplied
/// and the wall, as compliant as a healthy lung, stays as it is.
double tiredEffort(double fatigue, double compliance)
{
    return fatigue * (1.0 + 1.0 / compliance) / 2.0;
}

void makeArds(LungMechanics& lung, double severity, Volume restBefore)
{
    closeAllBut(lung, lookedUp(kArdsOpen, severity), restBefore);
    lung.limbSpread = (1.0 + severity) * lung.limbSpread;
    lung.alveolarDeadSpace =
        lung.alveolarDeadSpace
        + lookedUp(kArdsDeadSpace_l, severity) / kPulseRest_l * lung.wallVolume;
}

/// @param compression share of an adult's compression of the bronchi, beyond none
void makeCopd(LungMechanics& lung, double severity, double compression)
{
    const PressureVolumeCurve& before = lung.curve;
    const Volume healthyRest = lung.wallVolume;
    lung.wallVolume = lookedUp(kCopdRest, severity) * healthyRest;
    lung.wallRecoil = (1.0 - 0.5 * severity) * lung.wallRecoil;
    lung.curve = PressureVolumeCurve::through(
        lookedUp(kCopdFloor, severity) * before.floor,
        lookedUp(kCopdCapacity, severity) * ceilingOf(before), lung.wallVolume, lung.wallRecoil,
        lookedUp(kCopdCompliance, severity) * before.complianceAt(healthyRest));
    lung.bronchi = (1.0 / lookedUp(kCopdResistance, severity)) * lung.bronchi;
    lung.compression *= 1.0 + compression * (lookedUp(kCopdCompression, severity) - 1.0);
    lung.closing = std::max(lung.closing, severity * kCopdClosing * lung.wallVolume);
    lung.alveolarDeadSpace =
        lung.alveolarDeadSpace + lookedUp(kCopdDeadSpace_l, severity) / kPulseRest_l * healthyRest;
}

/// Of the natural airway 1.125 of 1.575 cmH2O s/L lie above the carina, and stay.
void makeAsthma(LungMechanics& lung, double severity, double compression)
{
    lung.bronchi = (1.0 / (1.0 + 14.0 * severity * 1.575 / 0.45)) * lung.bronchi;
    lung.compression *= 1.0 + compression * severity * (kAsthmaCompression - 1.0);
    lung.closing = std::max(lung.closing, severity * kAsthmaClosing * lung.wallVolume);
}

/// What the mediastinum gives way to a rise of the pleural pressure on one side: the other side
/// takes it with its lung and its wall.
Volume givenWay(const RespiratorySystem& healthy, const LungMechanics& other, Pressure rise)
{
    const double taken = other.wall.si + other.curve.complianceAt(other.wallVolume).si;
    return {healthy.mediastinum.si * rise.si / (1.0 + healthy.mediastinum.si / taken)};
}

void makePneumothorax(LungMechanics& lung, double severity, Volume mediastinum)
{
    const Volume rest = (1.0 - 0.75 * severity) * lung.wallVolume;
    const Pressure recoil = (1.0 - severity) * lung.wallRecoil;
    const double open =
        std::clamp((rest - lung.curve.floor) / (lung.curve.volumeAt(recoil) - lung.curve.floor),
                   kLeastOpenShare, 1.0);
    lung.curve.span = open * lung.curve.span;
    lung.bronchi = open * lung.bronchi;
    lung.pleuralGas =
        lung.wallVolume - rest + Volume{severity * lung.wallRecoil.si * lung.wall.si} + mediastinum;
}

void makeTension(LungMechanics& lung, double severity)
{
    // Of an adult's lung: 50 cmH2O s/L times 0.1 L/cmH2O.
    constexpr double kFilling_s = 5.0;
    if (severity == 0.0)
        return;
    lung.valve = {severity * severity * lung.wall.si / kFilling_s};
    lung.relief = {};
}

void blockBehindTube(LungMechanics& lung, double severity)
{
    lung.bronchi = (1.0 - severity) * (1.0 - severity) * lung.bronchi;
    lung.uptake = {severity / 180.0};
    lung.uptakeEnd = 0.45 * lung.wallVolume;
}

/// A short narrow place of an open share of the trachea's section loses the head of its jet. With
/// the last hundredth of the section closed nothing passes to either lung.
void narrowTrachea(RespiratorySystem& system, double severity)
{
    constexpr double kDensity = 1.2; // kg/m^3
    constexpr double kLeastOpen = 0.01;
    const double open = 1.0 - severity;
    const double jet = (1.0 / std::max(kLeastOpen, open) - 1.0) / kTracheaSection;
    system.upperTurbulent += 0.5 * kDensity * jet * jet;
    for (LungMechanics& lung : system.lungs)
        lung.bronchi = std::min(1.0, open / kLeastOpen) * lung.bronchi;
}

void afflict(LungMechanics& lung, const LungCondition& condition, Volume restBefore,
             double compression)
{
    const double severity = condition.severity;
    switch (condition.kind) {
    case ConditionKind::Ards:
        return makeArds(lung, severity, restBefore);
    case ConditionKind::Copd:
        return makeCopd(lung, severity, compression);
    case ConditionKind::Asthma:
        return makeAsthma(lung, severity, compression);
    case ConditionKind::TensionPneumothorax:
        return makeTension(lung, severity);
    case ConditionKind::Atelectasis:
        closeAllBut(lung, 1.0 - 0.9 * severity, restBefore);
        lung.bronchi = (1.0 - 0.9 * severity) * lung.bronchi;
        return;
    case ConditionKind::Obstruction:
        lung.bronchi = (1.0 - severity) * (1.0 - severity) * lung.bronchi;
        return;
    case ConditionKind::StiffChest:
        lung.wall = (1.0 / (1.0 + 4.0 * severity)) * lung.wall;
        return;
    case ConditionKind::Normal:
    case ConditionKind::SimplePneumothorax:
    case ConditionKind::MainstemIntubation:
        return;
    }
}

/// What a condition of both lungs makes of the muscles, and of how they are used.
struct Muscles {
    double effort = 1.0;   ///< RespiratorySystem::effort
    double strength = 1.0; ///< RespiratorySystem::strength
    double inspiration = 1.0;
};

Muscles musclesOf(const LungCondition& condition)
{
    const double severity = condition.severity;
    if (condition.kind == ConditionKind::Ards) {
        const double fatigue = lookedUp(kArdsFatigue, severity);
        return {tiredEffort(fatigue, lookedUp(kArdsOpen, severity)), fatigue,
                lookedUp(kArdsInspiration, severity)};
    }
    if (condition.kind == ConditionKind::Copd) {
        const double fatigue = lookedUp(kCopdFatigue, severity);
        return {tiredEffort(fatigue, lookedUp(kCopdCompliance, severity)), fatigue,
                lookedUp(kCopdInspiration, severity)};
    }
    return {};
}

/// A condition of one lung changes muscles and timing by half as much.
void useMuscles(const LungCondition& condition, RespiratorySystem& system)
{
    const Muscles muscles = musclesOf(condition);
    const double share = condition.side == ConditionSide::Both ? 1.0 : 0.5;
    const auto part = [share](double factor) { return 1.0 + share * (factor - 1.0); };
    system.effort *= part(muscles.effort);
    system.strength *= part(muscles.strength);
    system.inspiratoryRatio *= part(muscles.inspiration);
}

/// Airways that are narrow in health, as a child's, are compressed less than an adult's, so that as
/// much gas stays behind.
double compressionShare(const RespiratorySystem& healthy)
{
    const auto& [right, left] = healthy.lungs;
    const double bronchi = right.bronchi.si + left.bronchi.si;
    const Volume capacity = ceilingOf(right.curve) + ceilingOf(left.curve);
    const double narrowness = inCmH2O(Pressure{capacity.si / bronchi});
    return std::pow(narrowness / kAdultNarrowness, kCompressionByNarrowness);
}

/// The share of a breath that leaves in the time a quiet one has for it, by the time constant of
/// the bronchi and the system: the mean of bronchi that are wide and those at the resting volume.
double shareThatLeaves(const RespiratorySystem& system)
{
    constexpr double kQuietExpiration = 2.2; // s, of an adult, once the muscles have let go
    double conductance = 0.0;
    double compliance = 0.0;
    for (const LungMechanics& lung : system.lungs) {
        const Volume room = lung.wallVolume - lung.curve.floor;
        const double open = std::min(1.0, room / std::max(room, lung.closing - lung.curve.floor));
        conductance += 0.5 * (1.0 + open) * lung.bronchi.si / lung.compression;
        compliance +=
            1.0 / (1.0 / lung.curve.complianceAt(lung.wallVolume).si + 1.0 / lung.wall.si);
    }
    const double tau = (system.upperLaminar.si + 1.0 / conductance) * compliance;
    return 1.0 - std::exp(-kQuietExpiration / tau);
}

/// @param compression by compressionShare of the patient in health, who may have other conditions
RespiratorySystem withCondition(const RespiratorySystem& before, const LungCondition& condition,
                                double compression)
{
    const double severity = condition.severity;
    CARINA_EXPECTS(severity >= 0.0 && severity <= 1.0);
    const bool isMainstem = condition.kind == ConditionKind::MainstemIntubation;
    CARINA_EXPECTS(!isMainstem || condition.side != ConditionSide::Both);
    RespiratorySystem system = before;
    if (condition.kind == ConditionKind::Obstruction && condition.side == ConditionSide::Both) {
        narrowTrachea(system, severity);
        return system;
    }
    const ChestContent rest = restingContent(before);
    for (std::size_t i = 0; i < 2; ++i) {
        const LungMechanics& other = before.lungs[1 - i];
        if (isMainstem && !affects(condition, i))
            blockBehindTube(system.lungs[i], severity);
        if (!affects(condition, i))
            continue;
        if (condition.kind == ConditionKind::SimplePneumothorax) {
            const bool alone = condition.side != ConditionSide::Both;
            makePneumothorax(system.lungs[i], severity,
                             alone ? givenWay(before, other, severity * other.wallRecoil)
                                   : Volume{});
        }
        afflict(system.lungs[i], condition, rest[i].gas, compression);
    }
    useMuscles(condition, system);
    // The tidal volumes of the table are breathed on top of what stays behind.
    if (condition.kind == ConditionKind::Copd)
        system.effort *= shareThatLeaves(before) / shareThatLeaves(system);
    return system;
}

} // namespace

bool overlap(const LungCondition& a, const LungCondition& b)
{
    const bool isOneLung =
        a.side == b.side || a.side == ConditionSide::Both || b.side == ConditionSide::Both;
    const bool isTube = a.kind == ConditionKind::MainstemIntubation;
    return a.kind == b.kind && (isOneLung || isTube);
}

bool canCoexist(const LungConditions& conditions)
{
    if (conditions.size() > kMostConditions)
        return false;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
        if (conditions[i].kind == ConditionKind::Normal)
            return false;
        for (std::size_t j = 0; j < i; ++j)
            if (overlap(conditions[i], conditions[j]))
                return false;
    }
    return true;
}

RespiratorySystem afflicted(const RespiratorySystem& healthy, LungConditions conditions)
{
    CARINA_EXPECTS(canCoexist(conditions));
    std::ranges::sort(conditions, {}, [](const LungCondition& condition) {
        return std::tuple{condition.kind != ConditionKind::Copd, condition.kind, condition.side};
    });
    const double compression = compressionShare(healthy);
    RespiratorySystem system = healthy;
    for (const LungCondition& condition : conditions)
        system = withCondition(system, condition, compression);
    return system;
}

} // namespace carina
