#pragma once

#include "engine/core/units.h"
#include "evaluation/waveforms/lung_fit.h"
#include "evaluation/waveforms/recorded_waveform.h"

#include <optional>
#include <vector>

namespace carina
{

/// A breath of a recording and the lung model fitted to it.
struct FittedBreath {
    RecordedBreath samples;
    LinearLung lung;
};

/// An expiratory valve: constant pressure behind a resistance.
struct ExpiratoryValve {
    Pressure pressure;
    Resistance resistance;

    friend bool operator==(const ExpiratoryValve&, const ExpiratoryValve&) = default;
};

/// Lung and ventilator identified from a recording, and the error of the model.
struct WaveformModel {
    std::vector<FittedBreath> breaths;
    int unfit = 0;                        ///< number of breaths that could not be fitted
    std::optional<ExpiratoryValve> valve; ///< if no flow was recorded
    LinearLung median;                    ///< the median of each parameter
    Pressure rms;        ///< RMS error of the modelled pressure, each breath with its own lung
    Pressure rmsOneLung; ///< the same, all breaths with the median lung
};

/// Fits a lung to each breath and simulates it with the equation of motion of engine/lungs.
///
/// With recorded flow both phases of a breath are fitted, and the flow drives the model. Without
/// it, a constant `inspiratoryFlow` is assumed: the lung is fitted to the inspiration and the 50 ms
/// before it, the model is driven by that flow, and it empties through one valve for the whole
/// recording, chosen for the smallest RMS error. R and 1/C are then inversely proportional to the
/// assumed flow; R C and the RMS error do not depend on it.
/// @returns NothingRecognised if no breath can be fitted.
[[nodiscard]] Result<WaveformModel> modelOf(const RecordedWaveform& waveform,
                                            const std::vector<BreathPart>& parts,
                                            VolumeFlow inspiratoryFlow);

} // namespace carina
