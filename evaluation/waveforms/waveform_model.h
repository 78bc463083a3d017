#pragma once

#include "engine/core/units.h"
#include "evaluation/waveforms/lung_fit.h"
#include "evaluation/waveforms/recorded_waveform.h"

#include <optional>
#include <vector>

namespace carina
{

/// A breath of a recording and the lung that was found from it.
struct FittedBreath {
    RecordedBreath samples;
    LinearLung lung;
};

/// What lets gas out of a lung: an outlet that holds a pressure, behind a resistance.
struct ExpiratoryValve {
    Pressure pressure;
    Resistance resistance;

    friend bool operator==(const ExpiratoryValve&, const ExpiratoryValve&) = default;
};

/// How a lung with its ventilator was found in a recording, and how well it does.
struct WaveformModel {
    std::vector<FittedBreath> breaths;
    int unfit = 0;                        ///< breaths that no lung was found from
    std::optional<ExpiratoryValve> valve; ///< where no flow was recorded
    LinearLung median;                    ///< the median of each figure
    Pressure rms;        ///< modelled against recorded, each breath with its own lung
    Pressure rmsOneLung; ///< all with the median one
};

/// Finds a lung from each breath and drives the equation of motion of engine/lungs with it.
///
/// With recorded flow both phases of a breath are fitted, and the flow drives the model. Without,
/// the ventilator is taken to drive `inspiratoryFlow` in: the lung is found from the inspiration
/// and the 50 ms before it, the model is driven by that flow, and empties through the valve, one
/// for all of the recording, with which it comes nearest to it. R and 1/C are then in proportion to
/// one over the flow assumed; R C, and how well the model does, are not.
/// @returns NothingRecognised where no breath tells a lung.
[[nodiscard]] Result<WaveformModel> modelOf(const RecordedWaveform& waveform,
                                            const std::vector<BreathPart>& parts,
                                            VolumeFlow inspiratoryFlow);

} // namespace carina
