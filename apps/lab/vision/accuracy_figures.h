#pragma once

#include "apps/lab/command/command.h"
#include "evaluation/vision/marker_accuracy.h"

#include <QJsonObject>

#include <vector>

namespace carina::lab
{

/// How exactly a body was seen at one distance, in millimetres, degrees and pixels; without the
/// error of its corners.
[[nodiscard]] QJsonObject accuracyFigures(const MarkerAccuracy& accuracy);

/// A command's keys, and behind them those of the objects of accuracyFigures.
[[nodiscard]] std::vector<Key> withAccuracyKeys(std::vector<Key> keys);

} // namespace carina::lab
