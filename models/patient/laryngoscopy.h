#pragma once

#include "engine/anatomy/laryngoscopy/glottic_view.h"
#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"
#include "models/patient/patient_model.h"

namespace carina
{

/// The eye that sees what a laryngoscope shows.
enum class ScopeEye : std::uint8_t {
    Video, ///< the camera of a video laryngoscope, on its blade
    Direct ///< that of who looks past the blade
};

/// A patient, with the mouth shut in its surfaces, and a blade.
class Laryngoscopy
{
public:
    /// @returns NoAirway with what is missing of the patient's upper airway
    /// @pre the patient outlives this
    [[nodiscard]] static Result<Laryngoscopy> of(const PatientModel& patient, BladeKind kind);

    [[nodiscard]] const Blade& blade() const { return *m_blade; }
    /// Blade, jaw and tissue in one step; see laryngoscopyPose.
    [[nodiscard]] LaryngoscopyPose pose(LaryngoscopyStep step, Length lift) const;
    /// The tissue that is pushed by the blade at another pose, as a tracker has it.
    [[nodiscard]] BladeField tissueAt(const RigidTransform& X_AL, const RigidTransform& X_AJ) const;
    /// The glottis, as it is drawn there.
    [[nodiscard]] GlotticLine glottisAt(const LaryngoscopyPose& pose) const;
    /// X_AD and vertical field of view of an eye.
    [[nodiscard]] RigidTransform eyeAt(const LaryngoscopyPose& pose, ScopeEye eye) const;
    [[nodiscard]] static Angle fieldOfView(ScopeEye eye);

private:
    Laryngoscopy() = default;

    const PatientModel* m_patient = nullptr;
    const Blade* m_blade = nullptr;
    UpperAirway m_airway;
};

} // namespace carina
