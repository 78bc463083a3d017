#include "ui/scene/station_scene.h"

#include "ui/scene/scene_parts.h"
#include "widgets/scene/view/scene_view.h"

namespace carina
{

StationScene::StationScene(SceneView& scene, const PatientModel& patient, const StationView& view)
    : m_scene{scene}, m_patient{&patient}, m_view{&view}
{
    m_scene.setParts(sceneParts(patient), patient.reach());
    m_scene.nameSides(kPatientBody);
    m_scene.setFrameSource([this](int level, LocalTime lit) {
        m_moment = m_view->litAt(lit, static_cast<std::size_t>(level));
        SceneFrame frame =
            sceneFrame(m_moment, m_patient->lungs().field(), throatAt(m_moment, *m_patient));
        if (m_headset)
            frame.eyes = m_headset->eyes(m_output, m_moment.head);
        return frame;
    });
}

void StationScene::show(const PatientModel& patient, const StationView& view)
{
    m_patient = &patient;
    m_view = &view;
    m_scene.setParts(sceneParts(patient), patient.reach());
}

void StationScene::showTo(const HeadsetView& headset, ViewOutput output)
{
    m_headset = headset;
    m_output = output;
}

void StationScene::onFrameDrawn(Listener listener)
{
    m_scene.onFrameDrawn(
        [this, told = std::move(listener)](const DrawnFrame& frame) { told(frame, m_moment); });
}

} // namespace carina
