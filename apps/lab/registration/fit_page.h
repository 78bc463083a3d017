#pragma once

#include "apps/lab/command/command.h"

namespace carina::lab
{

// Options of `fit`, and the keys of what it prints.

namespace fit_option
{
inline constexpr Option kCovariance{
    "covariance", "",
    "weights each landmark by the covariance of its touch, which PAIRS.csv then holds"};
inline constexpr Option kFle{
    "fle", "MM",
    "root mean square error of a touch; 2 unless given. Landmarks are taken for exchanged only "
    "where errors of this size do not explain the touches"};
inline constexpr Option kRepairOrder{
    "repair-order", "",
    "fits landmarks that were exchanged to their own touches; without it they are named and "
    "refused. A mirror image is refused in any case"};
inline constexpr Option kRecording{
    "recording", "FILE",
    "a recording of the stylus (.igs.mha); where it has the tool Reference, that tool is fixed to "
    "what is touched"};
inline constexpr Option kPlusConfig{
    "plus-config", "FILE",
    "a configuration of Plus: the stylus tip (transform StylusTip to Stylus), and the landmarks in "
    "the order in which they were touched"};
} // namespace fit_option

namespace fit_key
{
inline constexpr Key kSchema{"schema", "carina.fit/1"};
inline constexpr Key kPose{"X_AM_mm", "the pose: four rows of four numbers, its translation in mm"};
inline constexpr Key kRms{"rms_mm", "root mean square of the residuals"};
inline constexpr Key kResiduals{"residuals_mm", "one object per landmark:"};
inline constexpr Key kName{"name", "of the landmark", 1};
inline constexpr Key kResidual{"mm", "distance that the fit leaves", 1};
inline constexpr Key kOrder{"order", "in which the landmarks were touched:"};
inline constexpr Key kFound{"found", "\"as given\", \"exchanged\" or \"unexplained\"", 1};
inline constexpr Key kTouchOf{
    "touch_of", "for each landmark the name of the landmark whose touch belongs to it", 1};
inline constexpr Key kOrderRms{"rms_mm", "root mean square of the residuals in this order", 1};
inline constexpr Key kExplanations{"explanations", "how many orders explain the touches", 1};
inline constexpr Key kWarnings{
    carina::lab::kWarnings.name,
    "sentences, on stderr, too; only where there are any: landmarks that lie nearly on one line, "
    "touches that no order explains"};
inline constexpr Key kFle{"fle_mm",
                          "without --covariance: error of a touch, estimated from the residuals:"};
inline constexpr Key kFleRms{"rms", "root mean square", 1};
inline constexpr Key kFleLimit{"limit95", "with 95 % confidence the error is below this", 1};
inline constexpr Key kFleDegrees{"degrees", "degrees of freedom of the estimate", 1};
inline constexpr Key kLeaveOneOut{"leave_one_out_mm",
                                  "without --covariance: one object per landmark:"};
inline constexpr Key kLeftOut{
    "mm", "its distance from the fit of all other landmarks; null where they are too few for a fit",
    1};
inline constexpr Key kChiSquared{"chi_squared",
                                 "with --covariance: sum of the squared weighted residuals"};
inline constexpr Key kDegrees{"degrees", "with --covariance: degrees of freedom of chi_squared"};
inline constexpr Key kScale{
    "scale", "with --covariance: the factor that would make the covariances agree with the "
             "residuals"};
inline constexpr Key kDwells{
    "dwells", "with --recording: how often the stylus was held still. Where that is more often "
              "than there are landmarks, those that fit best in their order were taken"};
} // namespace fit_key

} // namespace carina::lab
