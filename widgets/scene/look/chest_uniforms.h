#pragma once

#include "engine/geometry/deformation/throat_field.h"

#include <QMatrix4x4>

namespace carina
{

/// A field and a motion as resources/shaders/organ.vert reads them, in single precision.
[[nodiscard]] QMatrix4x4 chestUniform(const ChestField& field);
[[nodiscard]] QMatrix4x4 motionUniform(const ChestMotion& motion);

/// Likewise a throat, and how far the jaw is from where it is while the mouth is closed.
[[nodiscard]] QMatrix4x4 throatUniform(const ThroatField& field);
[[nodiscard]] QMatrix4x4 jawUniform(const RigidTransform& X_AJ);
/// Whether there is anything for the shader to do: jawUniform is not all 0.
[[nodiscard]] bool isJawMoved(const RigidTransform& X_AJ);

} // namespace carina
