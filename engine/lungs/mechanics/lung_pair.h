#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/lungs/drawing/chest_pose.h"
#include "engine/lungs/drawing/volume_tensor.h"

#include <array>

namespace carina
{

/// One lobe or whole lung, prepared for drawing.
struct BreathingPart {
    std::size_t index = 0; ///< of the part in Anatomy::parts
    Side side = Side::Right;
    ChestRegion region = ChestRegion::Still;
    std::vector<TriangleMesh> levels; ///< as many as the part has, finest first
};

/// The volume required of one lung, and the poses among which it is sought: given + s along.
struct LungDemand {
    Volume volume;                 ///< to enclose
    LungPose given;                ///< the fixed part of the pose
    LungPose along = kQuietBreath; ///< the part that is scaled by s
    double nearest = 0.0;          ///< of several solutions s, the one nearest to this
};

/// Both lungs of a patient, as surfaces that can be drawn at a given volume.
///
/// The volume of a lung is the sum of its closed parts. At rest, in the finest level of detail, it
/// is the functional residual capacity (FRC) of this patient; a coarser level is drawn with the
/// same volume as the finest, in a pose of its own. The hilum of a lung is assumed at its vertex
/// nearest to the carina. A patient with one lung breathes with that one, in a chest assumed as
/// wide on the other side; a patient without lungs has no parts and stays at rest.
class LungPair
{
public:
    /// The lungs among the parts of an anatomy, found by lungSide of their roles.
    ///
    /// @returns MeshNotClosed, with the part's name, where a level of a part encloses no volume.
    /// @pre each side has either lobes or a whole lung, not both; levels have normals.
    [[nodiscard]] static Result<LungPair> of(const Anatomy& anatomy);

    [[nodiscard]] const std::vector<BreathingPart>& parts() const { return m_parts; }
    /// The deformation field that moves everything in this chest.
    [[nodiscard]] const ChestField& field() const { return m_field; }
    /// Levels of detail of the part that has most; a part with fewer is drawn at its coarsest.
    [[nodiscard]] std::size_t levelCount() const { return m_volumes.size(); }

    /// Volume at functional residual capacity; 0 for a missing lung.
    [[nodiscard]] Volume restVolume(Side side) const;
    /// Volume of one lung after both together have taken in `inspired`, shared in proportion to
    /// their volumes at rest.
    [[nodiscard]] Volume volumeWith(Volume inspired, Side side) const;

    /// The volume of a lung in the poses given + s along, at a level of detail, as a cubic in s.
    /// @param mediastinalShift as ChestPose::mediastinalShift
    /// @pre level < levelCount().
    [[nodiscard]] VolumeCubic volumeAlong(Side side, std::size_t level, const LungPose& given,
                                          const LungPose& along, double mediastinalShift) const;

    /// The pose that gives both lungs the required volumes; a pure function of its arguments.
    ///
    /// @param demands right, left; ignored for a missing lung
    /// @returns VolumeUnreachable where a lung cannot be deformed that far; NotFinite for NaN or
    ///          inf.
    /// @pre level < levelCount(), or there are no lungs.
    [[nodiscard]] Result<ChestPose> pose(const std::array<LungDemand, 2>& demands,
                                         double mediastinalShift, std::size_t level) const;

    /// The pose in quiet breathing: each lung at volumeWith(inspired). What the diaphragm cannot
    /// make of a deeper breath, the ribs do.
    [[nodiscard]] Result<ChestPose> pose(Volume inspired, std::size_t level) const;

private:
    using PerSide = std::array<VolumeTensor, 2>; ///< right, left

    void sumVolumes();

    std::vector<BreathingPart> m_parts;
    ChestField m_field;
    std::vector<PerSide> m_volumes; ///< one per level of detail
};

/// The mesh of a part at a level of the patient; its coarsest where it has fewer levels.
[[nodiscard]] const TriangleMesh& levelOf(const BreathingPart& part, std::size_t level);

} // namespace carina
