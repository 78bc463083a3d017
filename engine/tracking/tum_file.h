#pragma once

#include "engine/core/result.h"
#include "engine/tracking/pose_sample.h"

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

namespace carina
{

/// Reads a trajectory in the text form of the TUM RGB-D benchmark (Sturm et al. 2012): a line for
/// each pose X_FO with eight numbers between blanks,
///
///     seconds x y z qx qy qz qw
///
/// in metres and as a quaternion of length 1 +- 0.01, in ascending order of time. Lines that begin
/// with '#' and empty ones are skipped. The time of a sample counts from the first; of two lines
/// with the same time the first is taken.
///
/// @param name name of the input in errors
/// @returns FileUnreadable; FileEmpty where there is no pose; FileMalformed for a line of another
///          form or one that is earlier than the line before; NotFinite; NotARotation; OutOfRange
///          where the times span more than a century. The detail names input, line and fault.
[[nodiscard]] Result<std::vector<PoseSample>> readTum(std::istream& input, const std::string& name);

/// The same from a file. @returns also FileNotFound.
[[nodiscard]] Result<std::vector<PoseSample>> readTumFile(const std::filesystem::path& path);

} // namespace carina
