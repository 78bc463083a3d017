#pragma once

#include "models/station/shared_tools.h"
#include "widgets/scene/figures/figure_shapes.h"

namespace carina::program
{

/// The blade of the own laryngoscope as it was touched; null where it was not.
[[nodiscard]] FigureShapes::Mesh bladeOf(const SharedTools& tools);

} // namespace carina::program
