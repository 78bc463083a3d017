#pragma once

#include "models/patient/patient_model.h"
#include "models/station/headset_view.h"
#include "models/station/station_view.h"
#include "widgets/scene/view/scene_frame.h"

#include <functional>
#include <optional>

namespace carina
{

class SceneView;

/// Connects a scene to a station: gives it the patient's surfaces once and, before each frame, the
/// station's moment at the time when the frame will be lit.
class StationScene
{
public:
    /// Called with a drawn frame and the moment it shows.
    using Listener = std::function<void(const DrawnFrame&, const StationMoment&)>;

    /// @pre all outlive this.
    StationScene(SceneView& scene, const PatientModel& patient, const StationView& view);

    /// Draws another patient from now on. @pre both outlive this, or live until the next show().
    void show(const PatientModel& patient, const StationView& view);

    /// Selects the output: the eyes of a headset, or a screen.
    void showTo(const HeadsetView& headset, ViewOutput output);
    [[nodiscard]] ViewOutput output() const { return m_output; }

    [[nodiscard]] SceneView& scene() const { return m_scene; }
    [[nodiscard]] const PatientModel& patient() const { return *m_patient; }
    /// The moment of the latest frame.
    [[nodiscard]] const StationMoment& moment() const { return m_moment; }

    void onFrameDrawn(Listener listener);

private:
    SceneView& m_scene;
    const PatientModel* m_patient;
    const StationView* m_view;
    std::optional<HeadsetView> m_headset;
    ViewOutput m_output = ViewOutput::Screen;
    StationMoment m_moment;
};

} // namespace carina
