#pragma once

#include "engine/lungs/mechanics/tube_place.h"
#include "engine/physiology/body_state.h"

namespace carina
{

/// What the drugs in a body do. Shares are 0 to 1.
struct DrugEffect {
    double hypnosis = 0.0;   ///< asleep above one half
    double analgesia = 0.0;  ///< dulls the response to a stimulus
    double relaxation = 0.0; ///< of the muscles of larynx and limbs
    double breathing = 1.0;  ///< share of the own breathing that is left
    double tone = 1.0;       ///< share of the muscles' tone that is left
    double pressure = 1.0;   ///< factor on the mean blood pressure
    double heartRate = 1.0;  ///< factor on the heart rate

    friend bool operator==(const DrugEffect&, const DrugEffect&) = default;
};

/// Effects by the concentrations at the effect sites, as E = c^g / (c^g + c50^g) (Hill). Relaxation
/// by rocuronium: c50 0.92 mg/L, g 4.8 (0.823 and 4.79 by Plaud et al., Clin Pharmacol Ther
/// 1995;58:185). The figures are ours, so that doses have the onset and duration of textbooks. The
/// diaphragm takes a higher concentration than the larynx.
[[nodiscard]] DrugEffect effectOf(const DrugsInBody& drugs);

/// Whether a hypnotic or a relaxant acts now, by kAnaesthesiaFrom at least.
[[nodiscard]] bool isAnaesthetised(const DrugEffect& effect);

/// How strongly blade and tube stimulate, 0 to 1 (ours).
[[nodiscard]] double bladeStimulus(bool inMouth);
[[nodiscard]] double tubeStimulus(TubeSeat seat);

/// How much of a stimulus gets through to a patient that sleeps so deeply, 0 to 1.
[[nodiscard]] double felt(double stimulus, const DrugEffect& effect);

/// Whether a patient coughs: the stimulus is felt and the muscles can.
[[nodiscard]] bool coughsAt(double stimulus, const DrugEffect& effect);

/// How far the cords shut in the end: only in a sleep that is too light, with muscles that can, and
/// no tube between them. Awake people gag and cough instead.
[[nodiscard]] double spasmAt(double stimulus, const DrugEffect& effect, TubeSeat seat);

/// The share of a swallow that drugs leave: of muscles that can, of who is not deeply asleep (ours;
/// in anaesthesia people swallow 1.7 times an hour instead of 28, D'Angelo et al., Anesthesiology
/// 2014;121:1175). 1 without drugs.
[[nodiscard]] double swallowingLeft(const DrugEffect& effect);

inline constexpr double kCoughsFrom = 0.35;      ///< of what is felt (ours)
inline constexpr double kAnaesthesiaFrom = 0.05; ///< of hypnosis or relaxation (ours)

} // namespace carina
