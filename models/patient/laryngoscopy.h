#pragma once

#include "engine/anatomy/events/airway_changes.h"
#include "engine/anatomy/events/airway_contents.h"
#include "engine/anatomy/laryngoscopy/blade_levering.h"
#include "engine/anatomy/laryngoscopy/glottic_view.h"
#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"
#include "engine/session/scripted_laryngoscopy.h"
#include "engine/session/touched_blade.h"
#include "models/patient/patient_model.h"

#include <optional>
#include <vector>

namespace carina
{

/// The eye that sees what a laryngoscope shows.
enum class ScopeEye : std::uint8_t {
    Video, ///< the camera of a video laryngoscope, on its blade
    Direct ///< that of who looks past the blade
};

/// The blade of a laryngoscope of which none is known.
inline constexpr BladeKind kUsualBlade = BladeKind::Macintosh3;

/// A patient and a blade.
class Laryngoscopy
{
public:
    /// @returns NoAirway with what is missing of the patient's upper airway
    /// @pre the patient outlives this
    [[nodiscard]] static Result<Laryngoscopy> of(const PatientModel& patient, const Blade& blade);

    [[nodiscard]] const Blade& blade() const { return m_blade; }
    /// The same patient and another blade from now on.
    void takeBlade(const Blade& blade) { m_blade = blade; }
    /// The airway is changed by these events from now on, and by the breath; blade, views and
    /// glottis are those of the changed airway, but the script's.
    /// @pre as airwayChanges
    void changeAirway(const AirwayEvents& events, double inspiration = kInspirationAsMade);
    /// Head and neck lie so from now on, in pose(), glottisAt(pose) and eyeAt(), but not in the
    /// script.
    void layHead(const HeadPosition& position);
    /// How they lie, as it is drawn.
    [[nodiscard]] const HeadPosition& headPosition() const { return m_position; }
    /// The angles of the airway's axes there.
    [[nodiscard]] AirwayAxes axes() const;
    /// How it is changed now: to be drawn before tissue follows the jaw.
    [[nodiscard]] const AirwayField& changes() const { return m_changes; }
    /// Whether the patient's surfaces have what an event changes.
    [[nodiscard]] bool canShow(AirwayEventKind kind) const
    {
        return carina::canShow(m_airway, kind);
    }
    /// Blade, jaw and tissue in one step; see laryngoscopyPose.
    [[nodiscard]] LaryngoscopyPose pose(LaryngoscopyStep step, Length lift) const;
    /// The same of who levers instead of lifting: up to the epiglottis as usual, then not lifted
    /// and tipped back (levered) by the angle as others lift, 0.7 of it and the whole.
    [[nodiscard]] LaryngoscopyPose leveredPose(LaryngoscopyStep step, Angle angle) const;
    /// What a blade at a pose touches, after those that the watch has seen before.
    [[nodiscard]] BladeEffort effortAt(const RigidTransform& X_AL, const FollowingThroat& throat,
                                       LeveringWatch& watch) const;
    /// The same where a pose of one of these ways has come about: by a lift, or by levering.
    [[nodiscard]] BladeEffort effortIn(LaryngoscopyStep step, Length lift) const;
    [[nodiscard]] BladeEffort effortLevered(LaryngoscopyStep step, Angle angle) const;
    /// The whole of it, for a simulated tracker.
    [[nodiscard]] LaryngoscopyScript script() const;
    /// The tissue that is pushed by the blade at another pose, as a tracker has it.
    /// @param throat of this patient, with the jaw as it is drawn
    [[nodiscard]] BladeField tissueAt(const RigidTransform& X_AL,
                                      const FollowingThroat& throat) const;
    /// Whether that blade is in mouth or throat (isInMouth).
    [[nodiscard]] bool isInMouth(const RigidTransform& X_AL, const FollowingThroat& throat) const;
    /// The glottis, as it is drawn there.
    [[nodiscard]] GlotticLine glottisAt(const FollowingThroat& throat,
                                        const BladeField& tissue) const;
    [[nodiscard]] GlotticLine glottisAt(const LaryngoscopyPose& pose) const;
    /// What lies in the throat by events, as it is drawn there: fluids level as the neck lies,
    /// those in the vallecula and a solid with the larynx.
    [[nodiscard]] std::vector<ThroatContent> contentsAt(const FollowingThroat& throat,
                                                        const BladeField& tissue) const;
    [[nodiscard]] std::vector<ThroatContent> contentsAt(const LaryngoscopyPose& pose) const;
    /// X_AD and vertical field of view of an eye.
    [[nodiscard]] RigidTransform eyeAt(const LaryngoscopyPose& pose, ScopeEye eye) const;
    [[nodiscard]] static Angle fieldOfView(ScopeEye eye);

private:
    Laryngoscopy() = default;
    /// The upper incisors' edge as events and the neck have moved it.
    [[nodiscard]] Vec3 p_A_edge() const;
    [[nodiscard]] FollowingThroat throatIn(const LaryngoscopyPose& pose) const;
    /// Where a place at the larynx, as in the surfaces, is drawn.
    [[nodiscard]] Vec3 drawnAtLarynx(Vec3 p_A, const FollowingThroat& throat,
                                     const BladeField& tissue) const;

    const PatientModel* m_patient = nullptr;
    Blade m_blade;
    UpperAirway m_airway;  ///< as in the surfaces
    UpperAirway m_changed; ///< and changed
    AirwayField m_changes;
    AirwayEvents m_events;
    HeadPosition m_position;
};

} // namespace carina
