#pragma once

#include "models/patient_model.h"
#include "models/station_view.h"
#include "widgets/scene/scene_frame.h"

#include <functional>

namespace carina
{

class SceneView;

/// Ties a scene to a station: gives it the patient's surfaces once and the station's moment before
/// each frame.
class StationScene
{
public:
    /// A frame that was drawn, and the moment it shows.
    using Listener = std::function<void(const DrawnFrame&, const StationMoment&)>;

    /// @pre all outlive this.
    StationScene(SceneView& scene, const PatientModel& patient, const StationView& view);

    [[nodiscard]] SceneView& scene() const { return m_scene; }
    [[nodiscard]] const PatientModel& patient() const { return m_patient; }
    /// The moment of the latest frame.
    [[nodiscard]] const StationMoment& moment() const { return m_moment; }

    void onFrameDrawn(Listener listener);

private:
    SceneView& m_scene;
    const PatientModel& m_patient;
    const StationView& m_view;
    StationMoment m_moment;
};

} // namespace carina
