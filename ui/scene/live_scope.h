#pragma once

#include "models/patient/resting_patient.h"
#include "models/station/flown_endoscope.h"
#include "models/station/laryngoscope_sight.h"
#include "ui/scene/scope_scene.h"
#include "widgets/scene/view/scene_view.h"

#include <optional>
#include <string>

namespace carina
{

class StationScene;

/// The picture of the camera on the laryngoscope of a station, live, and what it shows of the
/// larynx: a view draws the throat of the station's patient as that camera and its lamp have it
/// (ScopeScene), and reads a few times a second which structure each pixel shows. Whoever was made
/// is seen there as at rest, but for what jaw and blade do: elsewhere tongue and larynx are drawn
/// as a blade holds them, and would be lifted twice. While the patient at rest is made nothing is
/// drawn.
///
/// Or the picture of an endoscope that a person flies there, in the same light, with or without a
/// laryngoscope: then nothing is read, as grades are of a laryngoscope's view.
class LiveScope
{
public:
    /// How often it is drawn and read at most.
    static constexpr std::chrono::milliseconds kDrawn{80};
    static constexpr Duration kRead = std::chrono::milliseconds{300};

    /// @param endoscope whose picture it is while it is flown
    /// @pre all outlive this; the view's frames are nobody else's
    LiveScope(SceneView& view, StationScene& station, FlownEndoscope& endoscope);

    /// As of the latest frame.
    [[nodiscard]] const LaryngoscopeSight& sight() const { return m_sight; }
    /// Whether the patient at rest is being made, so that a blade shows nothing yet.
    [[nodiscard]] bool isPreparing() const
    {
        return m_patient == nullptr && m_sight.state == LaryngoscopeState::Live;
    }
    /// What was read last; nothing while the laryngoscope is not graded, and once that is of a
    /// frame kMostAge before the latest.
    [[nodiscard]] std::optional<GlotticView> read() const;
    /// The same, where it tells of the glottis.
    [[nodiscard]] std::optional<GlotticView> seen() const;
    static constexpr Duration kMostAge = std::chrono::seconds{1};

private:
    /// Of what the scene is made.
    struct Shown {
        const PatientModel* laid = nullptr; ///< whose tube it has
        std::string contentHash;            ///< of the patient that is drawn
        Blade blade{};
        bool isFlown = false; ///< and so it is lit

        [[nodiscard]] bool is(const Shown& other) const;
    };

    struct Measured {
        GlotticView view;
        SessionTime time; ///< of the frame
    };

    [[nodiscard]] SceneFrame frameOf(int level, LocalTime lit);
    void findPatient();
    [[nodiscard]] FollowingThroat throatIn(const StationMoment& moment) const;
    [[nodiscard]] Shown toBeShown() const;
    void addBlade(SceneFrame& frame) const;
    void addEye(SceneFrame& frame, const RigidTransform& X_AD) const;
    [[nodiscard]] bool isFlown() const;
    [[nodiscard]] bool isGraded() const
    {
        return m_patient != nullptr && !isFlown() && m_sight.isGraded();
    }
    /// Whether there is something to be drawn.
    [[nodiscard]] bool isSeen() const
    {
        return m_patient != nullptr && (isFlown() || m_sight.state == LaryngoscopeState::Live);
    }
    [[nodiscard]] Blade blade() const;
    void prepare();
    void ask(SessionTime now);
    void measure(const IdPicture& ids, const SceneFrame& frame);

    SceneView& m_view;
    StationScene& m_station;
    FlownEndoscope& m_endoscope;
    RestingPatient m_resting;
    const PatientModel* m_patient = nullptr; ///< that is drawn; nullptr while it is made
    const PatientModel* m_lying = nullptr;   ///< in whom the laryngoscope is
    std::string m_laidHash;                  ///< another patient can be where one was before
    StationLaryngoscope m_laryngoscope;
    Shown m_shown;
    TissueColors m_colors;
    ScopeScene m_scene;
    LaryngoscopeSight m_sight;
    std::optional<Measured> m_read;
    SessionTime m_drawn{}; ///< time of the latest frame
    std::optional<SessionTime> m_asked;
};

} // namespace carina
