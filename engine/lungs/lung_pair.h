#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/deformable_mesh.h"
#include "engine/lungs/volume_cubic.h"

#include <array>

namespace carina
{

/// One lobe or whole lung, ready to be drawn breathing.
struct BreathingPart {
    std::size_t index = 0; ///< of the part in Anatomy::parts
    Side side = Side::Right;
    std::vector<DeformableMesh> levels; ///< as many as the part has, finest first
};

/// What the vertex shader needs at one moment.
struct LungAmplitudes {
    float right = 0.0F;
    float left = 0.0F;
};

/// Both lungs of a patient, which can be drawn with any volume asked for.
///
/// The volume of a lung is the sum of its closed parts. At rest, in the finest level, it is the
/// functional residual capacity (FRC) of this patient; a coarser level is drawn with the same
/// volume as the finest, at an amplitude of its own. Inspired gas divides between the lungs as
/// their volumes at rest do. The hilum of a lung is taken where the lung comes nearest to the
/// carina. A patient with one lung breathes with that one; one without lungs has no parts, and
/// amplitudes of 0.
class LungPair
{
public:
    /// The lungs among the parts of an anatomy, by lungSide of their roles.
    ///
    /// @returns MeshNotClosed, with the part's name, when a level of a part encloses no volume.
    /// @pre an anatomy has lobes or whole lungs on one side, not both; levels have normals.
    [[nodiscard]] static Result<LungPair> of(const Anatomy& anatomy);

    [[nodiscard]] const std::vector<BreathingPart>& parts() const { return m_parts; }
    /// Levels of detail of the part that has most; a part with fewer is drawn at its coarsest.
    [[nodiscard]] std::size_t levelCount() const { return m_cubics.size(); }

    /// Volume at functional residual capacity.
    [[nodiscard]] Volume restVolume(Side side) const;
    /// Volume of one lung once `inspired` was drawn into both together.
    [[nodiscard]] Volume volumeWith(Volume inspired, Side side) const;

    /// The amplitudes that give both lungs their volumes, a pure function of its arguments: of
    /// several that would, the one nearest to rest.
    ///
    /// @returns VolumeUnreachable when a lung cannot be deformed that far; NotFinite for NaN, inf.
    /// @pre level < levelCount(), or there are no lungs.
    [[nodiscard]] Result<LungAmplitudes> amplitudes(Volume inspired, std::size_t level) const;

    /// Everything the lung's vertices reach at any amplitude, for culling; empty without a lung.
    [[nodiscard]] Box bounds(Side side) const;

private:
    using PerSide = std::array<VolumeCubic, 2>; ///< right, left

    void sumVolumes();

    std::vector<BreathingPart> m_parts;
    std::vector<PerSide> m_cubics; ///< one per level of detail
};

/// The level of a part that is drawn at level `level` of the patient.
[[nodiscard]] const DeformableMesh& levelOf(const BreathingPart& part, std::size_t level);

} // namespace carina
