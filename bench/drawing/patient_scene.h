#pragma once

#include "engine/session/respiration/respiration_follower.h"
#include "models/patient/patient_source.h"
#include "widgets/scene/look/part_look.h"
#include "widgets/scene/view/scene_frame.h"

#include <vector>

namespace carina::bench
{

inline constexpr int kWidth = 1280;  ///< pixels of the picture
inline constexpr int kHeight = 1024; ///< pixels

/// The real set, as it is drawn while it breathes quietly. Nobody is connected.
class PatientScene
{
public:
    /// @param fromCache whether it may only come from the cache
    /// @returns what reading the set fails with; FileNotFound where it is not in the cache.
    [[nodiscard]] static Result<PatientScene> of(const std::filesystem::path& folder,
                                                 bool fromCache);

    [[nodiscard]] const std::vector<ScenePart>& parts() const { return m_parts; }
    /// What presets frame of them.
    [[nodiscard]] Box framed() const;
    /// Everything opaque.
    [[nodiscard]] PartLooks solid() const;
    /// How it is drawn so long after the beginning, its lungs in that level of detail.
    [[nodiscard]] SceneFrame frameAt(double seconds, int level) const;
    /// With the lower jaw turned open by 15 degrees.
    [[nodiscard]] FollowingThroat openThroat() const;

private:
    explicit PatientScene(SharedPatientModel patient);

    SharedPatientModel m_patient;
    std::vector<ScenePart> m_parts;
    RespirationTimeline m_timeline;
    mutable RespirationFollower m_breathing; ///< what it keeps only makes it quick
};

} // namespace carina::bench
