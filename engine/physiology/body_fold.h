#pragma once

#include "engine/lungs/mechanics/respiratory_fold.h"
#include "engine/lungs/mechanics/tube_place.h"
#include "engine/physiology/body_figures.h"
#include "engine/physiology/body_state.h"
#include "engine/physiology/drug.h"
#include "engine/physiology/drug_effect.h"
#include "engine/physiology/gas_supply.h"
#include "engine/physiology/vitals.h"

namespace carina
{

/// Everything but the breathing itself that people or the tube decide about a patient's body.
struct BodySettings {
    PatientBuild build;
    LungConditions conditions; ///< for shunt, dead space and a tension pneumothorax
    TubePlace tube;
    GasSupply gas;
    /// Rate at which a bag or ventilator blows into the oesophagus; 0: none.
    Frequency stomachBreaths{};
    bool bladeInMouth = false; ///< a laryngoscope stimulates the throat

    friend bool operator==(const BodySettings&, const BodySettings&) = default;
};

/// Gas exchange, circulation and drugs of a patient, in steps of kBodyStep beside the breathing.
///
/// A fold like RespiratoryFold: the same settings, doses and breathing at the same steps give the
/// same state, bit for bit; one made from a checkpoint continues exactly. It reads no clock.
class BodyFold
{
public:
    explicit BodyFold(const BodySettings& settings);
    BodyFold(const BodySettings& settings, const BodyState& checkpoint);

    /// Settings from the next step on.
    void set(const BodySettings& settings);
    void give(const DrugDose& dose);
    /// @param breathing as it is at the end of this step
    void step(const RespiratoryFold& breathing);

    [[nodiscard]] const BodySettings& settings() const { return m_settings; }
    [[nodiscard]] const BodyState& state() const { return m_state; }
    [[nodiscard]] Vitals vitals() const;
    /// Share of the patient's own breathing that drugs leave, 0 to 1; 0 once the heart has stopped.
    [[nodiscard]] double breathingLeft() const
    {
        return m_state.circulation.arrested ? 0.0 : m_effect.breathing;
    }
    /// How far the cords are shut by spasm (stimulated in too light a sleep), 0 to 1.
    [[nodiscard]] double spasm() const { return m_state.spasm; }
    /// Share of a swallow that drugs leave, 0 to 1; 0 once the heart has stopped.
    [[nodiscard]] double swallowingLeft() const
    {
        return m_state.circulation.arrested ? 0.0 : carina::swallowingLeft(m_effect);
    }
    /// Whether the patient coughs against blade or tube.
    [[nodiscard]] bool coughs() const;
    /// Whether a hypnotic or a relaxant acts now (isAnaesthetised).
    [[nodiscard]] bool isAnaesthetised() const { return carina::isAnaesthetised(m_effect); }
    /// Share of the muscles' tone that is left: 0 with full relaxation, 1 awake.
    [[nodiscard]] double tone() const { return m_effect.tone; }

private:
    void become(const BodyFigures& body);
    [[nodiscard]] double stimulus() const;
    [[nodiscard]] GasShares supplied(const RespiratoryFold& breathing) const;
    [[nodiscard]] bool samplesGas() const;
    double moveGas(const RespiratoryFold& breathing);
    void exchangeGas(const RespiratoryFold& breathing);
    void sampleGas(double moved_ml);
    void circulate(const RespiratoryFold& breathing);

    BodySettings m_settings;
    BodyState m_state;
    BodyFigures m_body;
    DrugEffect m_effect; ///< of the drugs in m_state
};

inline constexpr int kRespiratoryStepsPerBodyStep = 10;
inline constexpr double kBodyStep = kRespiratoryStepsPerBodyStep * kRespiratoryStep; ///< 20 ms

} // namespace carina
