#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"
#include "engine/geometry/vec.h"

#include <functional>
#include <string>
#include <vector>

namespace carina
{

/// How the files of a set lie. F is the frame they share: their unit, their axes.
struct SetFrame {
    double metresPerUnit = 1e-3;
    /// Takes directions in F to A; a permutation of the axes with signs. Its determinant is -1 for
    /// files that hold a mirror image.
    Mat3 R_AF = Mat3::Identity();
};

/// Where +x, +y and +z of the files point in the body, such as {"left", "posterior", "superior"}.
[[nodiscard]] std::vector<std::string> axisWords(const SetFrame& frame);

/// A file that could not be used, and why.
struct FileFault {
    std::string file; ///< relative to the set's folder
    Error error;
};

/// A patient made from a folder of surfaces.
struct ImportedSet {
    Anatomy anatomy; ///< without a trachea: its landmarks' path is empty
    SetFrame frame;
    std::vector<FileFault> faults;
    std::vector<std::string> leftOut; ///< surfaces given twice, and whole lungs beside their lobes
};

/// Told how much of an import is done, 0 to 1; the import stops when it answers false. Called in
/// the thread that asked for the import.
using ImportProgress = std::function<bool(double share)>;

} // namespace carina
