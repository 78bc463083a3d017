#pragma once

#include "engine/core/progress.h"
#include "engine/tracking/sequence_file.h"

#include <filesystem>
#include <iosfwd>
#include <string>

namespace carina
{

/// Carina's own record of poses, a table of comma-separated values that can be appended to at any
/// time: two lines,
///
///     # carina.poses/1
///     time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,error_mm,state,role,tool
///
/// and one for each sample of a tool, in the order in which they came: its time, the pose X_TO,
/// the error of the fit, "tracked", "partly" or "lost" (the pose is then the last one known), the
/// role as in the description of a tracker, and the tool's name between quotation marks.
namespace pose_record
{

inline constexpr std::string_view kFirstLine = "# carina.poses/1";

/// The two lines at the beginning.
[[nodiscard]] std::string beginning();

/// The line of a sample.
[[nodiscard]] std::string line(const RecordedTool& tool, const PoseSample& sample);

/// Reads a record. A last line without its end is left out: the program was killed within it.
/// @param name of the input in errors
/// @returns FileUnreadable; FileEmpty where there is no sample; FileMalformed, NotFinite,
///          NotARotation, OutOfRange with the line.
[[nodiscard]] Result<TrackerSequence> read(std::istream& input, const std::string& name);

} // namespace pose_record

/// A recording as the text of a sequence file of Plus and 3D Slicer (.igs.mha), that readSequence
/// reads: a frame for each time at which a tool was sampled, with the transforms of the tools
/// sampled then. Names lose what is no letter or digit. Fit errors are not in this form, and a tool
/// that is partly occluded is OK.
/// @returns NameUnclear where two tools have the same name in this form; Cancelled.
[[nodiscard]] Result<std::string> sequenceText(const TrackerSequence& sequence,
                                               const Progress& goesOn = {});

/// The poses of a tool as a TUM trajectory, that readTum reads; lost samples are left out.
[[nodiscard]] std::string tumText(const RecordedTool& tool);

} // namespace carina
