#pragma once

#include "engine/core/result.h"
#include "engine/tracking/tracker.h"

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

namespace carina
{

/// One tool of a recording: its poses X_T<tool>, in the order of the file and with its times.
struct RecordedTool {
    std::string name; ///< as in the file: "Stylus" of StylusToTracker
    ToolRole role = ToolRole::Other;
    std::vector<PoseSample> samples{};
    /// Frames before the tool was first seen. They have no sample, as there is no last pose.
    std::size_t neverSeenYet = 0;
};

/// A recording of a tracker, tools in the order of their first appearance.
struct TrackerSequence {
    std::vector<RecordedTool> tools;
};

/// Reads a sequence in MetaImage form (.igs.mha, written by Plus and 3D Slicer): a text header of
/// `key = value` lines in which every frame NNNN, in ascending order from 0, has
///
///     Seq_FrameNNNN_<Tool>ToTrackerTransform = 16 numbers, row by row, millimetres
///     Seq_FrameNNNN_<Tool>ToTrackerTransformStatus = OK
///     Seq_FrameNNNN_Timestamp = seconds
///
/// up to the line ElementDataFile. Pixels after it, other fields, and transforms to frames other
/// than the tracker's are ignored. Lengths are converted to metres. OK is Tracked; MISSING,
/// INVALID, OUT_OF_VIEW, OUT_OF_VOLUME and REQ_TIMEOUT are Lost and hold the last pose seen.
///
/// @param name name of the input in errors
/// @returns FileUnreadable; FileEmpty; FileMalformed where the header is truncated, the number of
///          frames differs from DimSize, there is no tool, or a frame is out of order, earlier than
///          the one before, incomplete, of unknown status or has a tool twice; NotFinite,
///          NotARotation or OutOfRange for a tracked pose or a time. The detail names input, frame
///          and fault.
[[nodiscard]] Result<TrackerSequence> readSequence(std::istream& input, const std::string& name);

/// The same from a file. @returns also FileNotFound.
[[nodiscard]] Result<TrackerSequence> readSequenceFile(const std::filesystem::path& path);

} // namespace carina
