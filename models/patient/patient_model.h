#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/geometry/deformation/throat_field.h"
#include "engine/lungs/mechanics/lung_pair.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// What a surface of a patient is fixed to.
enum class SurfaceBody : std::uint8_t {
    Anatomy,  ///< frame A, at rest or breathing
    Mandible, ///< the frame that coincides with A while the jaw is where the surfaces have it
    Tube,     ///< the connector's frame E
};

/// One surface of a patient or of the tube, as viewers draw it.
struct PatientSurface {
    std::string name;
    AnatomyPart description; ///< without meshes
    SurfaceBody body = SurfaceBody::Anatomy;
    /// Finest first. Shared with the lungs, whose volumes are those of these very meshes.
    std::vector<std::shared_ptr<const TriangleMesh>> levels;
};

/// A patient ready to be drawn: the surfaces, the lungs that move some of them, and the tube.
class PatientModel
{
public:
    /// @param innerDiameter of the tube that goes with this patient
    /// @returns MeshNotClosed with the name of a lung's part that encloses no volume; what makeTube
    ///          fails with.
    [[nodiscard]] static Result<PatientModel> of(Anatomy anatomy, Length innerDiameter);

    [[nodiscard]] const std::string& name() const { return m_name; }
    [[nodiscard]] const std::string& contentHash() const { return m_contentHash; }
    [[nodiscard]] const AirwayLandmarks& landmarks() const { return m_landmarks; }
    [[nodiscard]] const std::vector<std::string>& attributions() const { return m_attributions; }
    [[nodiscard]] const std::vector<PatientSurface>& surfaces() const { return m_surfaces; }
    [[nodiscard]] const LungPair& lungs() const { return *m_lungs; }
    /// How what lies between jaw and carina follows the jaw.
    /// @param X_AJ of the mandible, the identity with the mouth shut; nothing: as the surfaces have
    ///        it
    [[nodiscard]] FollowingThroat throat(const std::optional<RigidTransform>& X_AJ) const;
    /// The finest mesh of a surface as it is with the mouth shut, on which a manikin is touched.
    [[nodiscard]] std::shared_ptr<const TriangleMesh> shutMesh(const PatientSurface& surface) const;
    [[nodiscard]] const TubeShape& tube() const { return m_tube; }
    /// What the lungs take up, in A, as they are drawn at the end of a breath in severe COPD, and
    /// up to the top of the head: a view that holds it cuts off neither. Empty without lungs.
    [[nodiscard]] Box reach() const;
    /// How high the patient reaches along +z of A, m.
    [[nodiscard]] double top() const;

private:
    PatientModel() = default;
    void addAnatomy(std::vector<AnatomyPart> parts);
    void addTube();

    std::string m_name;
    std::string m_contentHash;
    AirwayLandmarks m_landmarks;
    std::vector<std::string> m_attributions;
    std::vector<PatientSurface> m_surfaces;
    std::shared_ptr<const LungPair> m_lungs; // owned with the surfaces that alias its meshes
    ThroatField m_throat;
    RigidTransform m_heldJaw; ///< X_AJ as the surfaces have it
    TubeShape m_tube;
};

} // namespace carina
