#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/lungs/drawing/chest_pose.h"
#include "engine/lungs/drawing/volume_tensor.h"

#include <array>

namespace carina
{

/// One lobe or whole lung, ready to be drawn breathing.
struct BreathingPart {
    std::size_t index = 0; ///< of the part in Anatomy::parts
    Side side = Side::Right;
    ChestRegion region = ChestRegion::Still;
    std::vector<TriangleMesh> levels; ///< as many as the part has, finest first
};

/// What is asked of one lung.
struct LungDemand {
    Volume volume;                 ///< to enclose
    LungPose given;                ///< what is known of its pose
    LungPose along = kQuietBreath; ///< what is added to it, as often as the volume takes
    double nearest = 0.0;          ///< of several amounts that would do, the one nearest to this
};

/// Both lungs of a patient, which can be drawn with any volume asked for.
///
/// The volume of a lung is the sum of its closed parts. At rest, in the finest level, it is the
/// functional residual capacity (FRC) of this patient; a coarser level is drawn with the same
/// volume as the finest, in a pose of its own. The hilum of a lung is taken where the lung comes
/// nearest to the carina. A patient with one lung breathes with that one, in a chest that is as
/// wide on the other side; one without lungs has no parts, and stays at rest.
class LungPair
{
public:
    /// The lungs among the parts of an anatomy, by lungSide of their roles.
    ///
    /// @returns MeshNotClosed, with the part's name, when a level of a part encloses no volume.
    /// @pre an anatomy has lobes or whole lungs on one side, not both; levels have normals.
    [[nodiscard]] static Result<LungPair> of(const Anatomy& anatomy);

    [[nodiscard]] const std::vector<BreathingPart>& parts() const { return m_parts; }
    /// How everything in this chest moves in a pose.
    [[nodiscard]] const ChestField& field() const { return m_field; }
    /// Levels of detail of the part that has most; a part with fewer is drawn at its coarsest.
    [[nodiscard]] std::size_t levelCount() const { return m_volumes.size(); }

    /// Volume at functional residual capacity.
    [[nodiscard]] Volume restVolume(Side side) const;
    /// Volume of one lung once `inspired` was drawn into both together, which divide it as they
    /// divide the volume at rest.
    [[nodiscard]] Volume volumeWith(Volume inspired, Side side) const;

    /// The volume of a lung in the poses given + s along, in a level of detail, in a chest whose
    /// mediastinum is shifted.
    /// @pre level < levelCount().
    [[nodiscard]] VolumeCubic volumeAlong(Side side, std::size_t level, const LungPose& given,
                                          const LungPose& along, double mediastinalShift) const;

    /// The pose that gives both lungs the volumes asked for, a pure function of its arguments.
    ///
    /// @param demands right, left; of a lung that is not there it is ignored
    /// @returns VolumeUnreachable when a lung cannot be deformed that far; NotFinite for NaN, inf.
    /// @pre level < levelCount(), or there are no lungs.
    [[nodiscard]] Result<ChestPose> pose(const std::array<LungDemand, 2>& demands,
                                         double mediastinalShift, std::size_t level) const;

    /// The same in quiet breathing: both lungs with their share of the gas inspired.
    [[nodiscard]] Result<ChestPose> pose(Volume inspired, std::size_t level) const;

private:
    using PerSide = std::array<VolumeTensor, 2>; ///< right, left

    void sumVolumes();

    std::vector<BreathingPart> m_parts;
    ChestField m_field;
    std::vector<PerSide> m_volumes; ///< one per level of detail
};

/// The level of a part that is drawn at level `level` of the patient.
[[nodiscard]] const TriangleMesh& levelOf(const BreathingPart& part, std::size_t level);

} // namespace carina
