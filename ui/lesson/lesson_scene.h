#pragma once

#include "models/lesson/lesson_model.h"
#include "widgets/scene/view/scene_view.h"

namespace carina
{

/// What a view draws, as a lesson; without whether it shows from where it is looked at. Of more
/// looks than a lesson has room for, those of the last parts are left out.
[[nodiscard]] Lesson lessonOf(const SceneSettings& settings);

/// A lesson as settings of a view with these parts.
[[nodiscard]] SceneSettings settingsOf(const Lesson& lesson, std::span<const ScenePart> parts);

/// X_AD of a camera: +x right, +y up, looking along -z.
[[nodiscard]] RigidTransform viewpointOf(const CameraPose& camera);

/// X_AP of something with its tip at a point, that points at it from beside a camera, along -z.
[[nodiscard]] RigidTransform pointingAt(const Vec3& p_A, const CameraPose& camera);

} // namespace carina
