#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/geometry/vec.h"

#include <functional>
#include <string>
#include <vector>

namespace carina
{

/// Unit and axes of the files of a set. F is their common frame.
struct SetFrame {
    double metresPerUnit = 1e-3;
    /// Rotates directions from F to A: a permutation of the axes with signs. Its determinant is -1
    /// for files that are a mirror image.
    Mat3 R_AF = Mat3::Identity();
};

/// The directions in the body of +x, +y and +z of the files, such as {"left", "posterior",
/// "superior"}.
[[nodiscard]] std::vector<std::string> axisWords(const SetFrame& frame);

/// A file that could not be used, and the reason.
struct FileFault {
    std::string file; ///< relative to the set's folder
    Error error;
};

/// A patient made from a folder of surfaces.
struct ImportedSet {
    Anatomy anatomy; ///< without a generated trachea: its landmarks' path is empty
    SetFrame frame;
    std::vector<FileFault> faults;
    std::vector<std::string> leftOut; ///< duplicate surfaces, and whole lungs beside their lobes
};

using ImportProgress = Progress;

} // namespace carina
