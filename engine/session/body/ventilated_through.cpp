#include "engine/session/body/ventilated_through.h"

#include "engine/session/facts/fact_rules.h"

#include <algorithm>
#include <numbers>

namespace carina
{
namespace
{

void add(LungConditions& conditions, const LungCondition& wanted)
{
    const auto same = std::ranges::find_if(conditions, [&](const LungCondition& known) {
        return known.kind == wanted.kind && known.side == wanted.side;
    });
    if (same != conditions.end())
        same->severity = std::max(same->severity, wanted.severity);
    else if (conditions.size() < kMostConditions)
        conditions.push_back(wanted);
    else
        *std::ranges::min_element(conditions, {}, &LungCondition::severity) = wanted;
}

/// Whether a bag or ventilator is in use.
bool isDelivering(const RespiratorySettings& settings)
{
    return settings.bag.rate.si > 0.0 || settings.ventilator.mode != VentilationMode::Spontaneous;
}

void intubateOneSide(LungConditions& conditions, TubeSeat seat)
{
    const bool isSet = std::ranges::any_of(conditions, [](const LungCondition& known) {
        return known.kind == ConditionKind::MainstemIntubation;
    });
    if (!isSet)
        add(conditions, {ConditionKind::MainstemIntubation, 1.0,
                         seat == TubeSeat::RightMain ? ConditionSide::Right : ConditionSide::Left});
}

/// The severity of an Obstruction with a jet as fast, above the flow that is there, as that of a
/// tube of which this share is lost: the jet of a narrow place is its flow times
/// (1 / open share - 1) / section.
double severityInTrachea(const TubePlace& tube)
{
    const double radius = 0.5 * tube.innerDiameter.si;
    const double section = std::numbers::pi * radius * radius;
    if (tube.obstruction >= 1.0 || section <= 0.0)
        return tube.obstruction;
    const double jet = tube.obstruction / (1.0 - tube.obstruction) * kTracheaSection / section;
    return jet / (1.0 + jet);
}

Volume leftOf(Volume delivered, double leak)
{
    return std::max(std::min(delivered, kSmallestTidalVolume), (1.0 - leak) * delivered);
}

} // namespace

bool reachesLungs(const TubePlace& tube, const GasSupply& gas)
{
    if (tube.seat == TubeSeat::Oesophagus)
        return false;
    const bool isWatchedOutside = tube.seat == TubeSeat::None && tube.innerDiameter.si > 0.0;
    return !isWatchedOutside || gas.maskHeld;
}

void obstruct(LungConditions& conditions, double severity)
{
    if (severity <= 0.0)
        return;
    const bool isSided = std::ranges::any_of(conditions, [](const LungCondition& known) {
        return known.kind == ConditionKind::Obstruction && known.side != ConditionSide::Both;
    });
    if (!isSided)
        return add(conditions, {ConditionKind::Obstruction, severity, ConditionSide::Both});
    for (const ConditionSide side : {ConditionSide::Right, ConditionSide::Left})
        add(conditions, {ConditionKind::Obstruction, severity, side});
}

RespiratorySettings ventilatedThrough(const RespiratorySettings& settings, const TubePlace& tube,
                                      const GasSupply& gas)
{
    RespiratorySettings through = settings;
    through.tube = isThroughCords(tube.seat) ? tube.innerDiameter : Length{};
    if (!reachesLungs(tube, gas)) {
        through.ventilator.mode = VentilationMode::Spontaneous;
        through.bag.rate = {};
        return through;
    }
    if (!isThroughCords(tube.seat))
        return through;
    if (tube.seat != TubeSeat::Trachea)
        intubateOneSide(through.conditions, tube.seat);
    obstruct(through.conditions, severityInTrachea(tube));
    through.bag.tidalVolume = leftOf(through.bag.tidalVolume, tube.leak);
    if (through.ventilator.mode == VentilationMode::VolumeControl)
        through.pattern.tidalVolume = leftOf(through.pattern.tidalVolume, tube.leak);
    return through;
}

Frequency stomachBreaths(const RespiratorySettings& settings, const TubePlace& tube)
{
    if (tube.seat != TubeSeat::Oesophagus || !isDelivering(settings))
        return {};
    return settings.bag.rate.si > 0.0 ? settings.bag.rate : settings.pattern.rate;
}

} // namespace carina
