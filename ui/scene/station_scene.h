#pragma once

#include "models/intubation/distant_tube.h"
#include "models/intubation/tube_in_airway.h"
#include "models/patient/patient_model.h"
#include "models/station/head_by_mouse.h"
#include "models/station/headset_view.h"
#include "models/station/laryngoscope_sight.h"
#include "models/station/station_view.h"
#include "ui/scene/lifted_figures.h"
#include "ui/scene/people_figures.h"
#include "ui/scene/throat_contents.h"
#include "widgets/scene/view/scene_frame.h"

#include <functional>
#include <optional>
#include <utility>

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

    /// The own laryngoscope has this blade from now on; std::nullopt: that which its name says, as
    /// those of others.
    void showBlade(const std::optional<Blade>& blade) { m_laryngoscope.takeOwnBlade(blade); }

    /// The tube that is drawn with the patient lies so in the airway from now on, where this tells
    /// it; by default it is as at rest. @pre what it reads outlives this
    void bendTubeBy(TubeInAirwayAt source) { m_tubeInAirway = std::move(source); }
    /// Bends it, or the tube of another as that was sent, in a frame that has airway, throat and
    /// blade of the moment.
    TubeDrawing bendTubeAtWork(SceneFrame& frame, const StationMoment& moment);

    /// Selects the output: the eyes of a headset, or a screen. While no tracker here has a tool for
    /// the head, a headset's picture is seen from one that mouse and keys turn in the scene, in
    /// this picture alone: it is not shared.
    void showTo(const HeadsetView& headset, ViewOutput output);
    [[nodiscard]] ViewOutput output() const { return m_output; }
    /// Draws on a screen what a participant sees, whose head is then not drawn; the background only
    /// while it is not tracked. std::nullopt: as the view's own camera sees it.
    void seeThrough(std::optional<ParticipantId> participant) { m_throughEyesOf = participant; }
    [[nodiscard]] const std::optional<ParticipantId>& throughEyesOf() const
    {
        return m_throughEyesOf;
    }

    /// Looks from now on, on a screen and while this program's participant has no tracked head,
    /// from where an instructor does who shows that.
    void followView(bool follows) { m_followsView = follows; }
    /// Whether the latest frame was drawn so.
    [[nodiscard]] bool isViewFollowed() const { return m_viewpoint.has_value(); }

    [[nodiscard]] SceneView& scene() const { return m_scene; }
    [[nodiscard]] const PatientModel& patient() const { return *m_patient; }
    /// The moment of the latest frame.
    [[nodiscard]] const StationMoment& moment() const { return m_moment; }
    /// The same station at another time, for a second picture of it; see StationView::litAt.
    [[nodiscard]] StationMoment momentAt(LocalTime lit, int level) const
    {
        return m_view->litAt(lit, static_cast<std::size_t>(level));
    }
    /// What gives way to a laryngoscope, in this patient.
    [[nodiscard]] StationLaryngoscope& laryngoscope() { return m_laryngoscope; }
    [[nodiscard]] const StationLaryngoscope& laryngoscope() const { return m_laryngoscope; }

    /// Adds a listener.
    void onFrameDrawn(Listener listener);

    /// Whether own hands and the own stylus are drawn: on a screen, if the view gives them, and in
    /// a headset's picture that is turned by mouse. In a tracked one they are where they are seen
    /// anyway.
    [[nodiscard]] static bool drawsOwnHands(const StationMoment& moment, ViewOutput output)
    {
        return moment.ownHandsAreDrawn
               && (output == ViewOutput::Screen || looksByMouse(moment, output));
    }

private:
    [[nodiscard]] SceneFrame frameOf(int level, LocalTime lit);
    /// Has the scene make figures of the people of the moment, of what is lifted out and of what
    /// lies in the throat, if these are others than before.
    void showFigures(const std::vector<ThroatContent>& contents);
    void findViewpoint();
    void steerHead();
    void addHeadset(SceneFrame& frame) const;

    SceneView& m_scene;
    const PatientModel* m_patient;
    const StationView* m_view;
    std::vector<DrawnPerson> m_people;    ///< whose figures the scene has
    std::vector<DrawnLift> m_lifts;       ///< likewise
    std::vector<DrawnContent> m_contents; ///< likewise
    bool m_isTubeApart = false;           ///< and whether one of the tube as it was measured
    StationLaryngoscope m_laryngoscope;
    TubeInAirwayAt m_tubeInAirway = [](const StationMoment&, const TissueAround&) {
        return TubeInAirway{};
    };
    DistantTube m_distantTube; ///< of another
    std::vector<Listener> m_listeners;
    HeadsetView m_standardHeadset; ///< for views through the eyes of others
    std::optional<ParticipantId> m_throughEyesOf;
    std::optional<HeadsetView> m_headset;
    HeadByMouse m_headByMouse;
    ViewOutput m_output = ViewOutput::Screen;
    bool m_followsView = false;
    std::optional<RigidTransform> m_viewpoint; ///< X_AD of who shows their view
    StationMoment m_moment;
};

} // namespace carina
