#pragma once

#include "apps/lab/command/command.h"

namespace carina::lab
{

// Options of `mechanics`, and the keys of what its two ways print.

namespace mechanics_option
{
inline constexpr Option kRate{
    "rate-per-min", "R",
    "breaths per minute, 4 to 60; as many as the patient breathes at rest unless given"};
inline constexpr Option kOnly{"condition", "NAME", "this condition alone; all unless given"};
inline constexpr Option kWaveform{
    "waveform", "FILE",
    "the recording: a line \"#samplerate,HZ\", a line of names with pressure (cmH2O) and flow "
    "(L/min), then a line for each sample"};
inline constexpr Option kInspiratoryFlow{
    "inspiratory-flow-l-per-min", "F",
    "inspiratory flow of the ventilator where none was recorded, 1 to 200; 30 unless given"};
} // namespace mechanics_option

namespace mechanics_key
{
inline constexpr Key kSchema{"schema", "carina.mechanics/2"};
inline constexpr Key kPosition{"position", "position of the patient"};
inline constexpr Key kPatient{"patient", "the patient, supine:"};
inline constexpr Key kHeight{"height_mm", "body height", 1};
inline constexpr Key kWeight{"weight_kg", "body weight", 1};
inline constexpr Key kAge{"age_years", "age", 1};
inline constexpr Key kResidualVolume{
    "rv_ml", "residual volume; lungs empty to the floor of their curve, which is below it", 1};
inline constexpr Key kFunctionalResidualCapacity{"frc_ml", "functional residual capacity", 1};
inline constexpr Key kDrawnRest{"frc_drawn_ml",
                                "what the surfaces of both lungs enclose at rest, finest level", 1};
inline constexpr Key kDrawnDifference{"frc_difference_percent", "of that from frc_ml", 1};
inline constexpr Key kTotalCapacity{"tlc_ml", "total lung capacity", 1};
inline constexpr Key kPatientCompliance{"compliance_ml_per_cmh2o",
                                        "of lungs and chest wall together, at rest", 1};
inline constexpr Key kResistance{"resistance_cmh2o_s_per_l", "of all airways together", 1};
inline constexpr Key kQuietRate{"rate_per_min", "of quiet breathing", 1};
inline constexpr Key kQuietTidalVolume{"tidal_volume_ml", "of a quiet breath", 1};
inline constexpr Key kInspiratoryFraction{"inspiratory_fraction",
                                          "share of a quiet breath that is inspiration", 1};
inline constexpr Key kSeconds{"seconds", "breathed in each case, spontaneously"};
inline constexpr Key kTiredSeconds{"tired_seconds", "breathed in each case of \"tired\""};
inline constexpr Key kVentilatedSeconds{"ventilated_seconds",
                                        "breathed in each case of volume control"};
inline constexpr Key kRate{"rate_per_min", "set in each case"};
inline constexpr Key kConditions{"conditions", "one object per condition and severity:"};
inline constexpr Key kCondition{"condition",
                                "normal, ards, copd, asthma, simple_pneumothorax, "
                                "tension_pneumothorax, atelectasis, mainstem_intubation, "
                                "obstruction or stiff_chest",
                                1};
inline constexpr Key kSeverity{"severity", "0 of normal, else 0.3, 0.6 or 0.9", 1};
inline constexpr Key kSide{"side", "both, right or left", 1};
inline constexpr Key kRestVolume{"rest_volume_ml", "gas in both lungs at rest", 1};
inline constexpr Key kCompliance{"compliance_ml_per_cmh2o", "as of the patient, at rest", 1};
inline constexpr Key kSpontaneous{"spontaneous", "quiet breathing, an object:", 1};
inline constexpr Key kTired{"tired", "the same keys, after tired_seconds; at severity 0.9", 1};
inline constexpr Key kVolumeControl{
    "volume_control", "the same keys, for volume control through a tube with a PEEP of 5 cmH2O", 1};
inline constexpr Key kRateBreathed{"rate_per_min", "of the last breath", 2};
inline constexpr Key kEffort{"effort_cmh2o", "peak pressure of the inspiratory muscles", 2};
inline constexpr Key kInspiratoryShare{"inspiratory_fraction",
                                       "share of the last breath that was inspiration", 2};
inline constexpr Key kTiredness{"tiredness", "of the muscles: 0 fresh to 1 exhausted", 2};
inline constexpr Key kTidalVolume{"tidal_volume_ml", "of the last breath", 2};
inline constexpr Key kTidalVolumeRight{"tidal_volume_right_ml", "of it, the right lung's", 2};
inline constexpr Key kTidalVolumeLeft{"tidal_volume_left_ml", "of it, the left lung's", 2};
inline constexpr Key kPeak{"peak_cmh2o", "peak pressure of the last breath", 2};
inline constexpr Key kPlateau{"plateau_cmh2o", "plateau pressure of the last breath", 2};
inline constexpr Key kAutoPeep{"auto_peep_cmh2o", "auto-PEEP of the last breath", 2};
inline constexpr Key kAlveolarVentilation{"alveolar_ventilation_l_per_min", "of the last breath",
                                          2};
inline constexpr Key kRightLung{"right_lung_ml", "gas in the right lung at the end", 2};
inline constexpr Key kLeftLung{"left_lung_ml", "gas in the left lung at the end", 2};
inline constexpr Key kRightPleura{"right_pleura_cmh2o", "right pleural pressure at the end", 2};
inline constexpr Key kLeftPleura{"left_pleura_cmh2o", "left pleural pressure at the end", 2};
inline constexpr Key kMediastinalShift{"mediastinal_shift_mm",
                                       "at the end, towards the patient's left", 2};
inline constexpr Key kCourse{"course",
                             "of a tension pneumothorax: an object each after 1, 3, 5 and 10 "
                             "minutes of spontaneous breathing, of its last ten seconds; with "
                             "rate_per_min and effort_cmh2o as above",
                             1};
inline constexpr Key kMinutes{"minutes", "breathed", 2};
inline constexpr Key kPleuralGas{"pleural_gas_ml", "in the right pleural space at the end", 2};
inline constexpr Key kLeastPleura{"right_pleura_least_cmh2o", "least right pleural pressure", 2};
inline constexpr Key kGreatestPleura{"right_pleura_greatest_cmh2o",
                                     "greatest right pleural pressure", 2};
inline constexpr Key kLeastShift{"mediastinal_shift_least_mm", "towards the patient's left", 2};
inline constexpr Key kGreatestShift{"mediastinal_shift_greatest_mm", "the same", 2};
inline constexpr Key kRanges{
    "ranges", "one object per figure with a published range for a patient of this age:", 1};
inline constexpr Key kFigure{"figure", "its name", 2};
inline constexpr Key kValue{"value", "of this patient", 2};
inline constexpr Key kLeast{"least", "of the range", 2};
inline constexpr Key kGreatest{"greatest",
                               "of the range; equal to least for a single published value; left "
                               "out where there is no limit",
                               2};
inline constexpr Key kSource{"source", "of the range", 2};
inline constexpr Key kIsByConstruction{
    "by_construction",
    "true where the model was given this figure, so that only its code is checked; false where the "
    "figure follows from the rest of the model",
    2};
inline constexpr Key kIsWithin{
    "within", "whether the value lies in the range; a single published value is met to 0.5 %", 2};
inline constexpr Key kTargets{"targets",
                              "the same keys, without source and by_construction, for ranges that "
                              "we ask of the model where no publication was found",
                              1};
inline constexpr Key kNoRange{
    "no_range", "a sentence, where there is no published range for a patient of this age", 1};
inline constexpr Key kOutside{
    "outside", "one line for each figure of ranges and targets that lies outside its range"};
} // namespace mechanics_key

namespace mechanics_waveform_key
{
inline constexpr Key kSchema{"schema", "carina.mechanics.waveform/1"};
inline constexpr Key kSamples{"samples", "that were recorded"};
inline constexpr Key kSampleRate{"rate_hz", "samples per second"};
inline constexpr Key kFlow{"flow", "\"recorded\" or \"assumed\""};
inline constexpr Key kInspiratoryFlow{"inspiratory_flow_l_per_min",
                                      "F, where the flow was assumed"};
inline constexpr Key kBreaths{"breaths", "that are whole and were fitted"};
inline constexpr Key kUnfitBreaths{
    "unfit_breaths", "that are whole, but whose resistance or compliance would not be above 0"};
inline constexpr Key kResistance{"resistance_cmh2o_s_per_l",
                                 "[least, median, greatest] of the breaths"};
inline constexpr Key kCompliance{"compliance_ml_per_cmh2o",
                                 "[least, median, greatest] of the breaths"};
inline constexpr Key kTimeConstant{"time_constant_s", "of the two medians"};
inline constexpr Key kValve{"valve", "where the flow was assumed, the expiratory valve:"};
inline constexpr Key kValvePressure{"pressure_cmh2o", "behind it: the PEEP of the ventilator", 1};
inline constexpr Key kValveResistance{"resistance_cmh2o_s_per_l", "of the valve", 1};
inline constexpr Key kError{"rms_cmh2o", "root mean square of modelled minus recorded pressure, "
                                         "each breath with its own resistance and compliance"};
inline constexpr Key kErrorOfOneLung{"rms_one_lung_cmh2o",
                                     "the same, all breaths with the two medians"};
inline constexpr Key kDisconnected{
    "disconnected_s",
    "duration for which the tube was disconnected; it is excluded from all figures"};
} // namespace mechanics_waveform_key

} // namespace carina::lab
