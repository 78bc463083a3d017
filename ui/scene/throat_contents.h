#pragma once

#include "models/patient/laryngoscopy.h"
#include "widgets/scene/figures/scene_figure.h"
#include "widgets/scene/view/scene_frame.h"

#include <QColor>

#include <string>
#include <vector>

namespace carina
{

/// The body of what lies in a throat, one for each event and place.
[[nodiscard]] std::string bodyOfContent(AirwayEventKind kind, ContentPlace place);
[[nodiscard]] QColor colorOfContent(AirwayEventKind kind);
[[nodiscard]] MaterialGroup materialOfContent(AirwayEventKind kind);
/// A foreign body in a man; a little longer than wide.
[[nodiscard]] TriangleMesh foreignBodyMesh();

/// Has a frame of sceneFrame(), in which nothing lies in the patient's throat, draw this there; it
/// goes with a patient that is moved.
void addContents(SceneFrame& frame, const std::vector<ThroatContent>& contents);

/// What of it a view of the whole patient has figures of. A fluid in the throat has another form
/// for each kDepthStep of its depth, as its pool ends at the walls.
struct DrawnContent {
    AirwayEventKind kind = AirwayEventKind::Secretions;
    ContentPlace place = ContentPlace::Throat;
    int depthSteps = 0;

    friend bool operator==(const DrawnContent&, const DrawnContent&) = default;
};
inline constexpr Length kDepthStep = millimetres(2.0); ///< in a man

[[nodiscard]] std::vector<DrawnContent> drawnContents(const std::vector<ThroatContent>& contents);
/// Their figures, without names.
[[nodiscard]] std::vector<SceneFigure> contentFigures(const std::vector<DrawnContent>& contents);

} // namespace carina
