#include "ui/station_scene.h"

#include "ui/scene_parts.h"
#include "widgets/scene/scene_view.h"

namespace carina
{

StationScene::StationScene(SceneView& scene, const PatientModel& patient, const StationView& view)
    : m_scene{scene}, m_patient{patient}, m_view{view}
{
    m_scene.setParts(sceneParts(m_patient));
    m_scene.setFrameSource([this](int level) {
        m_moment = m_view.now(static_cast<std::size_t>(level));
        return sceneFrame(m_moment);
    });
}

void StationScene::onFrameDrawn(Listener listener)
{
    m_scene.onFrameDrawn(
        [this, told = std::move(listener)](const DrawnFrame& frame) { told(frame, m_moment); });
}

} // namespace carina
