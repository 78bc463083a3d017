#pragma once

#include "models/patient/laryngoscopy.h"
#include "ui/scene/throat_contents.h"
#include "widgets/scene/look/part_look.h"
#include "widgets/scene/look/tissue_colors.h"
#include "widgets/scene/view/scene_frame.h"
#include "widgets/scene/view/scene_view.h"

#include <vector>

namespace carina
{

/// The body of the laryngoscope that is drawn with the patient.
inline constexpr const char* kScopeBody = "laryngoscope";

/// The parts of a scene that a laryngoscope shows, and what each of them is to a person.
struct ScopeScene {
    /// Of the patient, with the tube, blade and handle, and what may lie in the throat, which
    /// addContents() has a frame draw.
    std::vector<ScenePart> parts;
    PartLooks looks; ///< opaque, but the tube as usual; hidden what is not to be seen in there
    /// By the id of the part.
    std::vector<SeenStructure> structures;
};
/// @param colors of its tissue, which stay where the next scene is of the same patient
[[nodiscard]] ScopeScene scopeScene(const PatientModel& patient, const Blade& blade,
                                    TissueColors& colors);

/// Has a view draw such a scene and nothing else, in the light of the eye that sees it.
void showScope(SceneView& view, const ScopeScene& scene, ScopeEye eye);

/// Eye and frustum of a picture with these sides, from an eye with this vertical field of view.
[[nodiscard]] EyePicture scopePicture(const RigidTransform& X_AD, Angle fieldOfView,
                                      double widthOverHeight);

/// What the ids of a picture say of the glottis, as the eye saw it.
/// @param line the glottis as it is drawn
/// @pre the picture is not empty
[[nodiscard]] GlotticView measuredView(const IdPicture& picture, const ScopeScene& scene,
                                       const EyePicture& eye, const GlotticLine& line);

} // namespace carina
