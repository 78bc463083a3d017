#pragma once

#include "apps/lab/figures/drift_figure.h"

#include <span>

namespace carina::lab
{

/// What a figure of Hamza-Lup et al. 2004 says, and ours of the same.
struct PaperValue {
    int number = 0;                      ///< of the paper's figure
    const DriftFigure* figure = nullptr; ///< ours
    std::string quantity{};              ///< of ours, in degrees: of the drift or of 2 acos(w)
    std::string printed{};               ///< by the paper: a number, "above" one, or nothing
    double measured = 0.0;               ///< by ours
    std::string trend{};                 ///< that the paper draws through its points
};

/// The values that the paper prints, all at 100 deg/s, for those of the figures that have them, to
/// which they point. It prints none for 3, 4 and 5 participants, and none in its figure 12. That of
/// its figure 9 is an angle 2 acos(w), which ours is only where FigureSettings::isAngleRaw.
[[nodiscard]] std::vector<PaperValue> besidePaper(std::span<const DriftFigure> figures);

} // namespace carina::lab
