#include "engine/physiology/body_fold.h"

#include "engine/physiology/airway_gas.h"
#include "engine/physiology/capnograph.h"
#include "engine/physiology/circulation.h"
#include "engine/physiology/drug_kinetics.h"
#include "engine/physiology/gas_exchange.h"
#include "engine/physiology/heart_curves.h"
#include "engine/physiology/lung_faults.h"
#include "engine/physiology/oximeter.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kRoomOxygen = 0.21;
/// Share of room air that gets beside a mask that is held: with it the alveoli have 0.87 of oxygen
/// after some minutes of pure oxygen, as Benumof et al. assume (Anesthesiology 1997;87:979).
constexpr double kBesideMask = 0.09;

/// The quiet turnover that is left: less in those who sleep, and in those who make no effort to
/// breathe, who are taken for anaesthetised.
double turnover(double hypnosis, bool isRelaxed)
{
    return 1.0 - (1.0 - kUseAsleep) * (isRelaxed ? 1.0 : hypnosis);
}

/// Whether the muscles of breathing rest.
bool isRelaxed(const RespiratoryFold& breathing)
{
    const RespiratorySettings& set = breathing.settings();
    const bool isHelped = breathing.isVentilated() && set.ventilator.ownEffort == 0.0;
    return set.ownBreathing <= 0.0 || isHelped;
}

} // namespace

BodyFold::BodyFold(const BodySettings& settings)
{
    set(settings);
    m_state.blood = quietBlood(m_body);
    m_state.circulation = quietCirculation(m_body);
    m_state.oximeter = settledAt(arterialSaturation(m_state.blood, m_body));
    m_state.capnograph.stomach_mmHg = kStomachAtFirst_mmHg;
    m_effect = effectOf(m_state.drugs);
}

BodyFold::BodyFold(const BodySettings& settings, const BodyState& checkpoint)
    : m_state{checkpoint}, m_effect{effectOf(checkpoint.drugs)}
{
    set(settings);
}

void BodyFold::set(const BodySettings& settings)
{
    if (settings.build != m_settings.build || m_body == BodyFigures{})
        become(bodyFiguresOf(settings.build));
    m_settings = settings;
}

/// Another patient's blood is as saturated as that of the one before.
void BodyFold::become(const BodyFigures& body)
{
    if (m_body.haemoglobin_gPerL > 0.0) {
        const double ratio = body.haemoglobin_gPerL / m_body.haemoglobin_gPerL;
        m_state.blood.arterialOxygen_mlPerL *= ratio;
        m_state.blood.venousOxygen_mlPerL *= ratio;
        m_state.blood.restingOxygen_mlPerL *= ratio;
    }
    m_body = body;
}

void BodyFold::give(const DrugDose& dose) { inject(m_state.drugs, dose); }

double BodyFold::stimulus() const
{
    return std::max(bladeStimulus(m_settings.bladeInMouth), tubeStimulus(m_settings.tube.seat));
}

bool BodyFold::coughs() const
{
    return !m_state.circulation.arrested && coughsAt(stimulus(), m_effect);
}

bool BodyFold::samplesGas() const
{
    return m_settings.gas.maskHeld || m_settings.tube.seat != TubeSeat::None;
}

/// What is at the opening of the airway. Beside a leaking cuff a patient inspires room air; a
/// ventilator loses gas there instead.
GasShares BodyFold::supplied(const RespiratoryFold& breathing) const
{
    const bool hasTube = isThroughCords(m_settings.tube.seat);
    const bool hasMask = m_settings.tube.seat == TubeSeat::None && m_settings.gas.maskHeld;
    if (!hasTube && !hasMask)
        return {kRoomOxygen, 0.0};
    const double leak = breathing.isVentilated() ? 0.0 : m_settings.tube.leak;
    const double beside = hasTube ? leak : kBesideMask;
    return {std::lerp(m_settings.gas.inspiredOxygen, kRoomOxygen, beside), 0.0};
}

double BodyFold::moveGas(const RespiratoryFold& breathing)
{
    constexpr double kMostPressure_Pa = 1e4;
    constexpr double kOpeningTime = 5.0;
    AirwayGas& gas = m_state.gas;
    const double open = isRelaxed(breathing) ? m_body.openWhenStill : 1.0;
    gas.openShare += kBodyStep / kOpeningTime * (open - gas.openShare);
    GasMove how;
    for (std::size_t i = 0; i < 2; ++i) {
        const LungMechanics& lung = breathing.system().lungs[i];
        how.volume_ml[i] = gas.openShare * inMillilitres(breathing.content()[i].gas);
        how.passable_ml[i] = inMillilitres(Volume{lung.bronchi.si * kMostPressure_Pa * kBodyStep});
        how.slant[i] = slantOf(lung, m_settings.tube.obstruction);
    }
    how.deadSpace_ml = inMillilitres(breathing.system().anatomicalDeadSpace);
    how.supplied = supplied(breathing);
    if (!gas.filled)
        fill(gas, how.volume_ml, quietAlveolar());
    return move(gas, how);
}

void BodyFold::exchangeGas(const RespiratoryFold& breathing)
{
    ExchangeConditions conditions;
    conditions.cardiacOutput_mlPerS = cardiacOutput_mlPerS(m_state.circulation, m_body);
    conditions.use = turnover(m_effect.hypnosis, isRelaxed(breathing));
    conditions.shunt = shuntOf(m_settings.conditions, breathing, isRelaxed(breathing));
    conditions.wasted = wastedOf(breathing);
    exchange(m_state.gas, m_state.blood, m_body, conditions, kBodyStep);
}

void BodyFold::sampleGas(double moved_ml)
{
    constexpr double kConnectorShare = 0.1; // of an awake patient's dead space (ours)
    const TubePlace& tube = m_settings.tube;
    SampledGas sampled;
    sampled.moved_ml = moved_ml;
    sampled.uptake_ml = m_body.oxygenUse_mlPerS / kStandardPerBody * kBodyStep;
    sampled.exhaled_mmHg = kDryPressure_mmHg * m_state.gas.airway.front().carbonDioxide;
    if (tube.seat == TubeSeat::Oesophagus)
        sampled.stomachRate_perS = m_settings.stomachBreaths.si;
    else if (isThroughCords(tube.seat))
        sampled.passing = passingShare(tube, exhaledShare(m_state.gas));
    else if (!m_settings.gas.maskHeld)
        sampled.passing = 0.0;
    sampled.connector_ml = kConnectorShare * 2.2 * m_body.weight_kg;
    sample(m_state.capnograph, sampled, kBodyStep);
}

void BodyFold::circulate(const RespiratoryFold& breathing)
{
    CirculatoryLoad load;
    load.saturation = arterialSaturation(m_state.blood, m_body);
    load.bladeStimulus = bladeStimulus(m_settings.bladeInMouth);
    load.tubeStimulus = tubeStimulus(m_settings.tube.seat);
    load.analgesia = m_effect.analgesia;
    load.pressureByDrugs = m_effect.pressure;
    load.rateByDrugs = m_effect.heartRate;
    load.tension = inMillilitres(trappedGas(breathing)) / (2.0 * m_body.restingVolume_ml);
    advance(m_state.circulation, m_body, load, kBodyStep);
    watch(m_state.oximeter, load.saturation, kBodyStep);
}

void BodyFold::step(const RespiratoryFold& breathing)
{
    constexpr double kSpasmTime = 3.0;
    const double flow =
        cardiacOutput_mlPerS(m_state.circulation, m_body) / m_body.cardiacOutput_mlPerS;
    spread(m_state.drugs, m_body.weight_kg, flow, kBodyStep);
    m_effect = effectOf(m_state.drugs);
    sampleGas(moveGas(breathing));
    exchangeGas(breathing);
    circulate(breathing);
    const double spasm = spasmAt(stimulus(), m_effect, m_settings.tube.seat);
    m_state.spasm += kBodyStep / kSpasmTime * (spasm - m_state.spasm);
    ++m_state.steps;
}

Vitals BodyFold::vitals() const
{
    constexpr double kLeastPulse = 0.15; // of the normal pulse pressure, for the probe (ours)
    const CirculationState& heart = m_state.circulation;
    const double pulse = std::clamp(heart.pulse_mmHg / m_body.pulse_mmHg, 0.0, 1.0);
    Vitals vitals;
    vitals.arterialSaturation = arterialSaturation(m_state.blood, m_body);
    vitals.heartRate = {heart.heartRate_perS};
    vitals.mean = mmHg(heart.mean_mmHg);
    vitals.systolic = mmHg(heart.mean_mmHg + 2.0 / 3.0 * heart.pulse_mmHg);
    vitals.diastolic = mmHg(heart.mean_mmHg - heart.pulse_mmHg / 3.0);
    if (heart.heartRate_perS > 0.0)
        vitals.electrocardiogram =
            electrocardiogramPeak_mV(heart.beat, heart.heartRate_perS, kBodyStep);
    vitals.probeIsOn = m_settings.gas.probeOn;
    if (vitals.probeIsOn && heart.heartRate_perS > 0.0) {
        vitals.pulseWave = pulse * pulseWave(heart.beat, heart.heartRate_perS);
        if (pulse > kLeastPulse)
            vitals.saturation = m_state.oximeter.shown;
    }
    if (samplesGas())
        vitals.exhaledCO2 = mmHg(m_state.capnograph.sensor_mmHg);
    if (m_state.capnograph.hasBreath) {
        vitals.endTidalCO2 = mmHg(m_state.capnograph.endTidal_mmHg);
        vitals.sinceBreath_s = m_state.capnograph.sinceBreath_s;
    }
    vitals.capnographRate = {m_state.capnograph.rate_perS};
    return vitals;
}

} // namespace carina
