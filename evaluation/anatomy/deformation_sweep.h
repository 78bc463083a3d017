#pragma once

#include "engine/anatomy/events/airway_event.h"
#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"
#include "engine/core/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// A blade somewhere on its way to the larynx, lifted and levered.
struct SweptBlade {
    BladeKind kind = BladeKind::Macintosh3;
    double progress = 0.0; ///< as of laryngoscopyPose, 0 to 4
    Length lift{};         ///< that of LaryngoscopyStep::Full
    Angle levering{};      ///< by which the handle is then tipped back (levered)
};

/// A jaw as movedJaw has it, of the size of the patient's airway, but not larger than a man's.
struct SweptJaw {
    Angle opening{};  ///< from the shut mouth
    Length forward{}; ///< in a man
};

/// Everything by which the head and neck of a patient are deformed, but for the breath.
struct DeformationCombination {
    std::optional<std::uint32_t> seed{}; ///< of one that was drawn; nothing for a limit
    HeadPosition head{};                 ///< as far as events let it
    /// Nothing: as in the surfaces, which may have been made with the mouth held open. With a blade
    /// the jaw is where the laryngoscopy has it.
    std::optional<SweptJaw> jaw{};
    std::optional<SweptBlade> blade{};
    AirwayEvents events{};
};

/// The limits of a sweep; of head and neck they are those that are drawn (withinReach).
inline constexpr Angle kMostJawOpening = degrees(30.0);
inline constexpr Length kMostJawForward = millimetres(15.0);
inline constexpr Length kMostSweptLift = millimetres(30.0);
inline constexpr Angle kMostLevering = degrees(30.0);

/// Combinations at their limits: the surfaces as they are; head and neck at each limit and each
/// two; the jaw likewise; each blade in each step with the usual lift, and the usual one at its
/// limits of lift and levering, in the corners of head and neck, too; each event at its worst, with
/// and without a lifted blade, and all of them together.
[[nodiscard]] std::vector<DeformationCombination> limitsOfDeformation();

/// One at random within these limits; equal for equal seeds on every machine. Each of blade and
/// events is there in two of three.
[[nodiscard]] DeformationCombination randomCombination(std::uint32_t seed);

/// One part in one combination.
struct DeformedPart {
    std::string name;
    std::size_t level = 0;         ///< of detail
    std::size_t intersections = 0; ///< SurfaceTree::selfIntersections of the deformed surface
    double leastDeterminant = 1.0; ///< of the deformation gradient, at the vertices
    Vec3 p_A_least = Vec3::Zero(); ///< where that is, in the surfaces
};

/// A patient, deformed part by part with the fields by which the programs draw it, in their order:
/// airway events, head and neck, jaw, blade. The breath is left out: it ends below the neck.
class DeformationSweep
{
public:
    /// @param level of detail, 0 being the finest; std::nullopt, or one that a part does not have:
    ///              its coarsest
    /// @returns NoAirway with what is missing of the patient's upper airway.
    /// @pre the patient outlives this
    [[nodiscard]] static Result<DeformationSweep> of(const Anatomy& patient,
                                                     std::optional<std::size_t> level);

    /// The parts that a combination deforms. What it leaves is left out, and so is what it moves as
    /// a rigid body: with the mandible, or with the head, as upper teeth.
    [[nodiscard]] std::vector<DeformedPart>
    deformedBy(const DeformationCombination& combination) const;

private:
    DeformationSweep() = default;

    const Anatomy* m_patient = nullptr;
    std::optional<std::size_t> m_level;
    UpperAirway m_airway;
    ThroatField m_throat;
    RigidTransform m_held; ///< X_AJ of the mandible in the surfaces
};

} // namespace carina
