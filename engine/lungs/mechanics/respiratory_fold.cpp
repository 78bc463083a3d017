#include "engine/lungs/mechanics/respiratory_fold.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// Mean alveolar pressure, weighted by bronchial conductance: the pressure of the occluded airway.
/// With both bronchi closed it is the pressure at the opening.
Pressure occluded(const RespiratorySystem& system, const ChestMoment& moment)
{
    const double right = system.lungs[0].bronchi.si;
    const double left = system.lungs[1].bronchi.si;
    if (right < kShut.si && left < kShut.si)
        return moment.opening;
    return {(right * moment.alveolar[0].si + left * moment.alveolar[1].si) / (right + left)};
}

/// Share of the gas that reaches alveoli where blood is: what is breathed spreads evenly over the
/// gas of both lungs, of which the alveolar dead space is a part.
double perfusedShare(const RespiratorySystem& system, const ChestContent& content)
{
    const Volume gas = content[0].gas + content[1].gas;
    const Volume dead = system.lungs[0].alveolarDeadSpace + system.lungs[1].alveolarDeadSpace;
    return std::max(0.0, 1.0 - dead / gas);
}

/// An inspiratory fraction with I:E multiplied.
double fractionWith(double fraction, double ratio)
{
    constexpr double kLeast = 0.1;
    constexpr double kMost = 0.9;
    if (ratio == 1.0)
        return fraction;
    return std::clamp(ratio * fraction / (1.0 - fraction + ratio * fraction), kLeast, kMost);
}

/// Drive makes no patient breathe faster than this.
constexpr Frequency kFastestOwn = perMinute(60.0);

/// The ventilator, or the bag in its place.
VentilatorSettings inUse(const RespiratorySettings& settings)
{
    if (settings.bag.rate.si == 0.0)
        return settings.ventilator;
    VentilatorSettings bag = settings.ventilator;
    bag.mode = VentilationMode::VolumeControl;
    bag.peep = {};
    bag.pauseShare = 0.0;
    bag.trigger = {};
    return bag;
}

RespiratorySystem healthyIn(const RespiratorySettings& settings)
{
    RespiratorySystem system = healthySystem(settings.build);
    place(system, settings.position, healthySystem(settings.build));
    return system;
}

} // namespace

RespiratorySystem systemOf(const RespiratorySettings& settings)
{
    RespiratorySystem onBack = healthySystem(settings.build);
    const VentilatorSettings ventilator = inUse(settings);
    const bool isVentilated = ventilator.mode != VentilationMode::Spontaneous;
    const double own = isVentilated ? ventilator.ownEffort : 1.0;
    if (own * settings.ownBreathing == 0.0)
        relax(onBack, settings.position == BodyPosition::Sitting ? 1.0 : kRelaxedRest);
    if (settings.tube.si > 0.0)
        intubate(onBack, settings.tube);
    RespiratorySystem system = afflicted(onBack, settings.conditions);
    place(system, settings.position, onBack);
    return system;
}

RespiratoryFold::RespiratoryFold(const RespiratorySettings& settings)
    : m_clock{settings.pattern.rate}
{
    set(settings);
    m_state.system = m_target;
    m_state.content = restingContent(m_target);
    m_moment = chestMoment(m_state.system, m_state.content, {}, m_state.opening);
    beginBreath();
}

RespiratoryFold::RespiratoryFold(const RespiratorySettings& settings,
                                 const RespiratoryState& checkpoint)
    : m_state{checkpoint}, m_clock{checkpoint.clock}
{
    set(settings);
    m_moment = chestMoment(m_state.system, m_state.content, m_state.muscle, m_state.opening);
}

void RespiratoryFold::set(const RespiratorySettings& settings)
{
    m_settings = settings;
    m_ventilator = inUse(settings);
    m_target = systemOf(settings);
    if (const RespiratorySystem healthy = healthyIn(settings); healthy != m_healthy) {
        m_healthy = healthy;
        m_found.reset();
    }
}

RespiratoryState RespiratoryFold::state() const
{
    RespiratoryState state = m_state;
    state.clock = m_clock.state();
    return state;
}

bool RespiratoryFold::isVentilated() const
{
    return m_ventilator.mode != VentilationMode::Spontaneous;
}

bool RespiratoryFold::isStill() const { return !isVentilated() && m_settings.ownBreathing <= 0.0; }

std::optional<double> RespiratoryFold::inspiration() const
{
    if (m_state.effort.si <= 0.0)
        return std::nullopt;
    return std::clamp(m_state.muscle / m_state.effort, 0.0, 1.0); // the effort may have lessened
}

/// @param seconds since the beginning of the step
Pressure RespiratoryFold::muscleAt(double breaths, double seconds) const
{
    const double share =
        muscleShare(breaths - std::floor(breaths), m_state.breath.inspiratoryFraction);
    if (m_settings.cough == 0.0)
        return share * m_state.effort;
    const double time = static_cast<double>(m_state.steps) * kRespiratoryStep + seconds;
    const double hardest = m_settings.cough * std::min(1.0, m_state.system.strength);
    return share * m_state.effort - hardest * coughShare(time) * kCoughPressure;
}

/// The muscle's pressure when the step has gone on for so long: of its breath, and what is still
/// above or below it where the effort was changed, or a cough came or went in its midst.
Pressure RespiratoryFold::relaxedTo(double breaths, double before, double seconds) const
{
    const Pressure aim = muscleAt(breaths, seconds);
    const double most = cmH2O(kMuscleSlew_cmH2OPerS).si * seconds;
    if (std::abs(aim.si - m_state.muscle.si) <= most)
        return aim;
    const double left = (m_state.muscle - muscleAt(before, 0.0)).si;
    return {aim.si + left - std::clamp(left, -most, most)};
}

bool RespiratoryFold::ventilatorBegins() const
{
    const VentilatorTiming timing =
        ventilatorTiming(m_ventilator, m_state.breath, kRespiratoryStep);
    const std::int64_t since = m_state.ventilator.sinceBreath;
    const auto listening =
        timing.inspiration + static_cast<std::int64_t>(kTriggerDelay / kRespiratoryStep);
    const VolumeFlow trigger = m_ventilator.trigger;
    const bool asked = trigger.si > 0.0 && since >= listening && m_moment.airwayFlow > trigger;
    return asked || since >= timing.breath;
}

/// Looked for once for each way to breathe.
Pressure RespiratoryFold::effortOfHealth(const BreathingPattern& pattern)
{
    if (!m_found || m_found->pattern != pattern)
        m_found = FoundEffort{pattern, effortFor(m_healthy, pattern)};
    return m_found->effort;
}

BreathingPattern RespiratoryFold::patternAsSet() const
{
    BreathingPattern pattern = m_settings.pattern;
    if (m_settings.bag.rate.si > 0.0)
        pattern = {m_settings.bag.rate, m_settings.bag.tidalVolume, kBagInspiration};
    pattern.tidalVolume = std::min(pattern.tidalVolume, largestTidalVolume(m_settings.build));
    return pattern;
}

/// Of spontaneous breathing, as set and driven.
Frequency RespiratoryFold::ownRate() const
{
    const double left = m_settings.ownBreathing;
    if (left <= 0.0)
        return {};
    const Frequency set = m_settings.pattern.rate;
    const Frequency whole = std::max(set, std::min(kFastestOwn, drivenRate(m_state.drive) * set));
    return left < 1.0 ? std::max(std::min(whole, kSlowestOwn), left * whole) : whole;
}

void RespiratoryFold::sumUpBreath()
{
    const BreathTally& tally = m_state.tally;
    BreathFigures& last = m_state.last;
    last.tidalVolume = tally.inspired;
    // Gas that swings from one lung to the other is not inspired.
    const Volume right = std::clamp(tally.most[0] - tally.least[0], Volume{}, tally.inspired);
    last.tidalVolumeOfLung = {right, tally.inspired - right};
    last.rate = {1.0 / (static_cast<double>(tally.steps) * kRespiratoryStep)};
    last.peak = tally.peak;
    last.plateau = tally.plateau;
    last.endExpiratory = occluded(m_state.system, m_moment);
    last.autoPeep = last.endExpiratory - m_state.opening.pressure;
    const Volume fresh = std::max(Volume{}, tally.inspired - m_state.system.anatomicalDeadSpace);
    last.alveolarVentilation = {perfusedShare(m_state.system, m_state.content) * fresh.si
                                * last.rate.si};
}

/// The alveolar ventilation that keeps the carbon dioxide normal: that of the set breath in health,
/// or of quiet breathing where nothing of the set breath gets beyond the dead space.
VolumeFlow RespiratoryFold::wantedVentilation() const
{
    BreathingPattern breath = m_settings.pattern;
    breath.tidalVolume = std::min(breath.tidalVolume, largestTidalVolume(m_settings.build));
    if (breath.tidalVolume <= m_healthy.anatomicalDeadSpace)
        breath = restingPattern(m_settings.build);
    return {(breath.tidalVolume - m_healthy.anatomicalDeadSpace).si * breath.rate.si};
}

/// Carbon dioxide and tiredness after the breath that ends.
void RespiratoryFold::takeDrive(double seconds)
{
    const VolumeFlow wanted = wantedVentilation();
    DriveState& drive = m_state.drive;
    const Pressure mean = meanMuscleShare(m_state.breath.inspiratoryFraction) * m_state.effort;
    drive.tiredness = tirednessAfter(seconds, drive, mean, m_state.system.strength);
    drive.carbonDioxide =
        carbonDioxideAfter(seconds, drive.carbonDioxide, wanted, m_state.last.alveolarVentilation);
}

/// The breath that ends is summed up, and the settings hold for the one that begins.
void RespiratoryFold::beginBreath()
{
    BreathTally& tally = m_state.tally;
    if (tally.steps > 0) {
        sumUpBreath();
        takeDrive(static_cast<double>(tally.steps) * kRespiratoryStep);
    }
    const std::array<Volume, 2> gas{m_state.content[0].gas, m_state.content[1].gas};
    tally = {0, {}, gas, gas, m_moment.opening, {}};
    m_state.breath = patternAsSet();
    m_state.ventilator.sinceBreath = 0;
    const double own = (isVentilated() ? m_ventilator.ownEffort : 1.0) * m_settings.ownBreathing;
    if (own == 0.0) {
        m_state.effort = {};
        return;
    }
    const RespiratorySystem& system = m_state.system;
    const Pressure quiet = effortOfHealth(m_state.breath);
    DriveState driving = m_state.drive;
    if (isVentilated())
        driving.carbonDioxide = 1.0; // rate and effort are those set
    m_state.effort = own * drivenEffort(driving, quiet, system.strength, system.effort) * quiet;
    if (isVentilated())
        return;
    m_state.breath.rate = ownRate();
    m_state.breath.inspiratoryFraction =
        fractionWith(m_state.breath.inspiratoryFraction, system.inspiratoryRatio);
}

/// No breath is under way, and none is counted: the clock stands at the beginning of the next one.
void RespiratoryFold::beStill()
{
    if (m_state.breath.rate.si > 0.0) {
        BreathClock::State clock = m_clock.state();
        clock.breaths = std::ceil(clock.breaths);
        clock.rate = {};
        m_clock = BreathClock{clock};
        const std::array<Volume, 2> gas{m_state.content[0].gas, m_state.content[1].gas};
        m_state.tally = {0, {}, gas, gas, m_moment.opening, {}};
        m_state.breath.rate = {};
        m_state.effort = {};
        m_state.last = {};
    }
    m_state.drive.carbonDioxide =
        carbonDioxideAfter(kRespiratoryStep, m_state.drive.carbonDioxide, wantedVentilation(), {});
}

void RespiratoryFold::step()
{
    approach(m_state.system, m_target, kRespiratoryStep / kChangeTime);
    if (isStill()) {
        beStill();
    } else if (m_state.breath.rate.si == 0.0) {
        m_state.tally.steps = 0; // of the time without a breath
        beginBreath();
    } else if (isVentilated() && ventilatorBegins()) {
        beginBreath();
    }
    const double before = m_clock.state().breaths;
    const Frequency own =
        isVentilated() ? m_settings.ownBreathing * m_ventilator.ownRate : ownRate();
    m_clock.advance(own, kRespiratoryStep);
    const double after = m_clock.state().breaths;
    const std::array<Pressure, 3> muscle{
        m_state.muscle, relaxedTo(0.5 * (before + after), before, 0.5 * kRespiratoryStep),
        relaxedTo(after, before, kRespiratoryStep)};
    m_state.opening = openingNow();
    const ChestContent content =
        advanced(m_state.system, m_state.content, muscle, m_state.opening, kRespiratoryStep);
    m_state.muscle = muscle[2];
    m_moment = chestMoment(m_state.system, content, m_state.muscle, m_state.opening);
    tally(content);
    m_state.content = content;
    ++m_state.steps;
    ++m_state.ventilator.sinceBreath;
    if (!isVentilated() && !isStill() && std::floor(after) > std::floor(before))
        beginBreath();
}

AirwayOpening RespiratoryFold::openingNow() const
{
    if (!isVentilated())
        return AirwayOpening::at({});
    const VentilatorTiming timing =
        ventilatorTiming(m_ventilator, m_state.breath, kRespiratoryStep);
    return ventilatorOpening(m_ventilator, timing, m_state.breath.tidalVolume, m_state.ventilator,
                             kRespiratoryStep);
}

bool RespiratoryFold::inspires() const
{
    if (!isVentilated())
        return m_clock.phase() <= m_state.breath.inspiratoryFraction;
    const VentilatorTiming timing =
        ventilatorTiming(m_ventilator, m_state.breath, kRespiratoryStep);
    return m_state.ventilator.sinceBreath < timing.inspiration;
}

/// Counts a step that ends with these contents into the present breath.
void RespiratoryFold::tally(const ChestContent& content)
{
    BreathTally& tally = m_state.tally;
    std::array<double, 2> gained{};
    for (std::size_t i = 0; i < 2; ++i) {
        const LungContent& before = m_state.content[i];
        const double lost =
            m_moment.uptake[i].si + m_state.system.lungs[i].relief.si * content[i].trapped.si;
        gained[i] = (content[i].gas - before.gas + content[i].trapped - before.trapped).si
                    + lost * kRespiratoryStep;
    }
    if (gained[0] + gained[1] > 0.0) {
        tally.inspired.si += gained[0] + gained[1];
        for (std::size_t i = 0; i < 2; ++i)
            tally.most[i].si = std::max(0.0, tally.most[i].si + gained[i]);
    }
    tally.peak = std::max(tally.peak, m_moment.opening);
    if (inspires())
        tally.plateau = m_moment.carina;
    ++tally.steps;
}

} // namespace carina
