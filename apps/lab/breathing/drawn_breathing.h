#pragma once

#include "apps/lab/breathing/breathing_trial.h"
#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace carina::lab
{

/// How far the volumes drawn were from those of the mechanics, at the most.
struct DrawnErrors {
    std::array<Volume, 2> lungs; ///< right, left
    Volume both;                 ///< of both lungs together

    [[nodiscard]] Volume largest() const;
};

/// What one lung is in one level of detail.
struct DrawnLung {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    Volume restVolume; ///< in the pose at rest
};

/// One trial in one level of detail.
struct DrawnTrial {
    std::size_t frames = 0;
    DrawnErrors errors;
    Volume tidalVolume; ///< greatest less least volume drawn, both lungs together
};

/// What both lungs were drawn like in one level of detail.
struct DrawnLevel {
    std::size_t level = 0;
    std::array<DrawnLung, 2> lungs; ///< right, left
    std::vector<DrawnTrial> trials; ///< in the order in which they were asked for
};

struct DrawnBreathing {
    Volume functionalResidualCapacity; ///< both lungs at rest in the finest level
    std::vector<DrawnLevel> levels;
};

/// Draws the lungs with the shader that draws them everywhere, in the poses that every screen draws
/// them in, reads the vertices back, and compares the volume they enclose (a sum of its own, in
/// double) with the mechanics: the lung's volume at rest in the finest level, and the gas that the
/// mechanics have in it more than at rest in health.
///
/// @param level one level of detail; every level without
/// @returns NothingRecognised when the anatomy has no lungs; OutOfRange when it has no such level;
///          MeshNotClosed and NoGraphics as lungs and graphics give them.
/// @pre there is a QGuiApplication.
[[nodiscard]] Result<DrawnBreathing> drawBreathing(const Anatomy& anatomy,
                                                   std::span<const BreathingTrial> trials,
                                                   std::optional<std::size_t> level);

} // namespace carina::lab
