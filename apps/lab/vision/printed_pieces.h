#pragma once

#include "engine/vision/board_calibration.h"
#include "engine/vision/printed_tools.h"
#include "widgets/report/cutting_sheet.h"

namespace carina::lab
{

/// A tool's sheet or sleeve as a piece of paper. A sleeve is a strip of four faces and a flap, with
/// an end at the top and at the bottom of the first face.
[[nodiscard]] CutPiece pieceOf(const PrintedTool& tool);

/// The board that a camera is calibrated with.
[[nodiscard]] CutPiece pieceOf(const CalibrationBoard& board);

} // namespace carina::lab
