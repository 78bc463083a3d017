#pragma once

#include "engine/core/result.h"
#include "engine/tracking/pose_sample.h"

#include <QString>

#include <vector>

namespace carina::lab
{

/// The poses of a stylus in a recording, in the frame R that the phantom or divot stands still in:
/// that of the tool Reference where the recording has one, else the tracker's.
struct RecordedStylus {
    bool inReference = false;
    std::vector<PoseSample> samples; ///< X_RS; Lost where either tool was not seen
};

/// Reads a sequence file with the tool Stylus, or with one tool only beside Reference.
/// @returns what readSequenceFile returns; NothingRecognised where no tool is the stylus. The
///          detail is a sentence that names the file.
[[nodiscard]] Result<RecordedStylus> readRecordedStylus(const QString& file);

} // namespace carina::lab
