#pragma once

#include <QString>

#include <cstdint>

namespace carina
{

/// How the tube at work is drawn.
enum class TubeDrawing : std::uint8_t {
    AsMeasured, ///< as its pose has it: no other shape of it is looked for here
    Awaited,    ///< likewise, while the lumen of the airway is being measured
    NoLumen,    ///< likewise, because the lumen of this patient cannot be measured
    InAirway,   ///< as it bends in the airway
    Apart, ///< likewise, farther than IntubationMonitor::kShapesApart from where it was measured
};

/// What a person is told of it: that the tube does not bend, or lies beside the tracked one; empty
/// else.
[[nodiscard]] QString drawingText(TubeDrawing drawing);

} // namespace carina
