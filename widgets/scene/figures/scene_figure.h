#pragma once

#include "widgets/scene/surfaces/scene_part.h"

#include <QString>

#include <string>
#include <vector>

namespace carina
{

/// Something beside the patient that comes and goes, such as another person's head: the parts of a
/// moving body and its name, which is written beside it. Without parts it names a body whose parts
/// are those of the scene.
struct SceneFigure {
    std::string body; ///< of SceneFrame::bodies; where it is not listed, nothing is drawn
    QString name;     ///< empty: none is written
    Vec3 p_F_name = Vec3::Zero();   ///< the point beside which it is written, in the body's frame
    std::vector<ScenePart> parts{}; ///< of that body; ids unique among all parts of the scene
};

} // namespace carina
