#pragma once

#include "engine/geometry/deformation/airway_field.h"
#include "engine/geometry/deformation/blade_field.h"
#include "engine/geometry/deformation/throat_field.h"

#include <QMatrix4x4>

#include <array>
#include <optional>

namespace carina
{

/// The uniforms of resources/shaders/organ.vert for a chest field and a motion, in single
/// precision.
[[nodiscard]] QMatrix4x4 chestUniform(const ChestField& field);
[[nodiscard]] QMatrix4x4 motionUniform(const ChestMotion& motion);

/// The uniforms for a throat field, and for the displacement of the jaw from the closed mouth.
[[nodiscard]] QMatrix4x4 throatUniform(const ThroatField& field);
[[nodiscard]] QMatrix4x4 jawUniform(const RigidTransform& X_AJ);
/// The uniforms for a laryngoscope's blade: the tissue that it pushes, and the larynx that it
/// tilts. All 0 without a blade.
[[nodiscard]] QMatrix4x4 bladeUniform(const BladeField& field);
[[nodiscard]] QMatrix4x4 tiltUniform(const BladeField& field);
/// The uniforms for what events change of an airway, each by the name that it has in the shader.
/// All 0 where nothing is changed.
struct NamedUniform {
    const char* name;
    QMatrix4x4 value;
};
inline constexpr std::size_t kAirwayUniforms = 6 + kMostSwellings + kMostTints;
[[nodiscard]] std::array<NamedUniform, kAirwayUniforms> airwayUniforms(const AirwayField& field);
/// The same for a neck: both bends, the pose of the head, and the way from the frame of what is
/// bent to A and back.
/// @param X_AF of SceneFrame::bentInPlace; std::nullopt: what is bent is in A, before and after
inline constexpr std::size_t kNeckUniforms = 5;
[[nodiscard]] std::array<NamedUniform, kNeckUniforms>
neckUniforms(const NeckField& field, const std::optional<RigidTransform>& X_AF = {});
/// Whether the jaw is displaced: jawUniform is not all 0.
[[nodiscard]] bool isJawMoved(const RigidTransform& X_AJ);

} // namespace carina
