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

/// A real anatomy set, drawn during quiet breathing, without a session.
class PatientScene
{
public:
    /// @param fromCache true: read it from the cache only
    /// @returns the errors of reading the set; FileNotFound if it must be and is not in the cache.
    [[nodiscard]] static Result<PatientScene> of(const std::filesystem::path& folder,
                                                 bool fromCache);

    [[nodiscard]] const std::vector<ScenePart>& parts() const { return m_parts; }
    /// The bounds in A of the parts that presets frame.
    [[nodiscard]] Box framed() const;
    /// Looks that make all parts opaque.
    [[nodiscard]] PartLooks solid() const;
    /// The frame at a time after the start, with the lungs in this level of detail.
    [[nodiscard]] SceneFrame frameAt(double seconds, int level) const;
    /// The throat with the mandible opened by 15 degrees.
    [[nodiscard]] FollowingThroat openThroat() const;

private:
    explicit PatientScene(SharedPatientModel patient);

    SharedPatientModel m_patient;
    std::vector<ScenePart> m_parts;
    RespirationTimeline m_timeline;
    mutable RespirationFollower m_breathing; ///< a cache
};

} // namespace carina::bench
