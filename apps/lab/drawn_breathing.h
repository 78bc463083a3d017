#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"
#include "engine/lungs/breathing_pattern.h"

#include <array>
#include <optional>
#include <vector>

namespace carina::lab
{

/// A patient that breathes the same breath again and again while it is drawn 60 times a second.
struct BreathingTrial {
    BreathingPattern pattern;
    double seconds = 60.0;
    std::optional<std::size_t> level; ///< one level of detail; every level without
};

/// What one lung was drawn like in one level of detail.
struct DrawnLung {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    Volume restVolume;   ///< in the pose at rest
    Volume largestError; ///< largest distance of the volume drawn from the volume commanded
};

/// What both lungs were drawn like in one level of detail.
struct DrawnLevel {
    std::size_t level = 0;
    std::size_t frames = 0;
    std::array<DrawnLung, 2> lungs; ///< right, left
    Volume largestError;            ///< of both lungs together
    Volume tidalVolume;             ///< greatest less least volume drawn, both lungs together
};

struct DrawnBreathing {
    Volume functionalResidualCapacity; ///< both lungs at rest in the finest level
    std::vector<DrawnLevel> levels;
};

inline constexpr int kFramesPerSecond = 60;

/// Draws the lungs with the shader that draws them everywhere, reads the vertices back, and
/// compares the volume they enclose (a sum of its own, in double) with the volume commanded:
/// the lung's volume at rest in the finest level and its share of the inspired gas.
///
/// @returns NothingRecognised when the anatomy has no lungs; OutOfRange when it has no such level;
///          MeshNotClosed, VolumeUnreachable and NoGraphics as lungs and graphics give them.
/// @pre there is a QGuiApplication.
[[nodiscard]] Result<DrawnBreathing> drawBreathing(const Anatomy& anatomy,
                                                   const BreathingTrial& trial);

} // namespace carina::lab
