#pragma once

#include "engine/geometry/chest_field.h"

#include <QMatrix4x4>

namespace carina
{

/// A field and a motion as resources/shaders/organ.vert reads them, in single precision.
[[nodiscard]] QMatrix4x4 chestUniform(const ChestField& field);
[[nodiscard]] QMatrix4x4 motionUniform(const ChestMotion& motion);

} // namespace carina
