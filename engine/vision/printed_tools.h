#pragma once

#include "engine/core/units.h"
#include "engine/tracking/tracker.h"
#include "engine/vision/marker_body.h"
#include "engine/vision/marker_dictionary.h"

#include <string>
#include <vector>

namespace carina
{

/// The dictionary of the printed tools.
inline constexpr MarkerDictionary kPrintedDictionary = MarkerDictionary::Bits4Of50;

/// A piece of paper with markers, which makes a thing a tracked tool.
///
/// A sheet lies flat: its frame B has the origin in its middle, +x to the right, +y up, +z out of
/// the paper. A sleeve is folded to a box of square section around a tube, a pencil or a handle: B
/// has its origin in the middle of the lower end, and +z along the axis to the upper end, which is
/// the upper edge of the printed strip. Its faces follow each other about +z, the first faces +x.
struct PrintedTool {
    std::string name;
    ToolRole role = ToolRole::Other;
    MarkerBody body{};
    bool isSleeve = false;
    Length width{};  ///< of the sheet, or of one face
    Length height{}; ///< of the sheet, or of the sleeve along its axis
    Length hole{};   ///< in both ends of a sleeve, its diameter
};

/// What is printed: sheets for the manikin's chest and chin, sleeves for tube, stylus and
/// laryngoscope. No marker is on two of them.
[[nodiscard]] const std::vector<PrintedTool>& printedTools();

/// White that a printed marker has around it, of its side: a cell.
inline constexpr double kQuietZone = 1.0 / 6.0;

} // namespace carina
