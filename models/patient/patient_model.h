#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/events/airway_event.h"
#include "engine/anatomy/organ_group.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/geometry/deformation/throat_field.h"
#include "engine/lungs/mechanics/lung_pair.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// The body that a surface of a patient moves with.
enum class SurfaceBody : std::uint8_t {
    Anatomy,  ///< frame A, at rest or breathing
    Mandible, ///< frame J, which coincides with A while the jaw is as in the surfaces
    Tube,     ///< the connector's frame E
};

/// One surface of a patient or of the tube, as viewers draw it.
struct PatientSurface {
    std::string name;
    AnatomyPart description; ///< without meshes
    SurfaceBody body = SurfaceBody::Anatomy;
    /// Levels of detail, finest first. Shared with the lungs, whose volumes are computed from these
    /// same meshes.
    std::vector<std::shared_ptr<const TriangleMesh>> levels;
};

/// A patient ready to be drawn: surfaces, lungs (which move some of the surfaces) and tube.
class PatientModel
{
public:
    /// @param innerDiameter of this patient's tube
    /// @returns MeshNotClosed with the name of a part of a lung that encloses no volume; the errors
    ///          of makeTube.
    [[nodiscard]] static Result<PatientModel> of(Anatomy anatomy, Length innerDiameter);

    [[nodiscard]] const std::string& name() const { return m_name; }
    [[nodiscard]] const std::string& contentHash() const { return m_contentHash; }
    [[nodiscard]] const AirwayLandmarks& landmarks() const { return m_landmarks; }
    [[nodiscard]] const std::vector<std::string>& attributions() const { return m_attributions; }
    [[nodiscard]] const std::vector<PatientSurface>& surfaces() const { return m_surfaces; }
    [[nodiscard]] const LungPair& lungs() const { return *m_lungs; }
    /// The deformation of neck and throat, between head and carina, that follows head and jaw.
    /// @param X_AJ     pose of the mandible in the frame of the head, the identity with the mouth
    ///                 closed; std::nullopt, and where no jaw can be (reachesJaw): as in the
    ///                 surfaces
    /// @param position of head and neck; where it is out of reach the nearest is taken
    /// @param events   that limit how far the mouth opens (withinOpening), also as in the surfaces
    [[nodiscard]] FollowingThroat throat(const std::optional<RigidTransform>& X_AJ,
                                         const HeadPosition& position = {},
                                         const AirwayEvents& events = {}) const;
    /// Of the way from incisors to glottis, kReferenceWay being 1.
    [[nodiscard]] double size() const;
    /// Whether its jaw can have this pose in the frame of the head (isInReachOfJaw).
    [[nodiscard]] bool reachesJaw(const RigidTransform& X_AJ) const;
    /// How head and neck move to lie so.
    [[nodiscard]] NeckField neck(const HeadPosition& position) const
    {
        return {m_landmarks.p_A_glottis, m_landmarks.p_A_incisors, position};
    }
    /// The finest mesh of a surface with the mouth closed, as for landmarks touched on a manikin.
    [[nodiscard]] std::shared_ptr<const TriangleMesh> shutMesh(const PatientSurface& surface) const;
    /// X_AJ of the mandible in the surfaces, the identity with the mouth closed.
    [[nodiscard]] const RigidTransform& jawInSurfaces() const { return m_heldJaw; }
    [[nodiscard]] const TubeShape& tube() const { return m_tube; }
    /// The tube with which it was made, in every program the same: it fits the airway.
    [[nodiscard]] const TubeShape& ownTube() const { return m_ownTube; }
    /// The same patient with a tube of another shape (tubeAlong), as it was touched.
    [[nodiscard]] PatientModel withTube(std::span<const Vec3> p_E_centre,
                                        Length outerDiameter) const;
    /// The same patient with the tube of another one.
    [[nodiscard]] PatientModel withTubeOf(const PatientModel& other) const;
    /// The groups of organs that it has.
    [[nodiscard]] std::vector<OrganGroup> groups() const;
    /// The centre in A of a group's bounds at rest, about which it is turned and scaled when it is
    /// lifted out; std::nullopt for a group that the patient does not have.
    [[nodiscard]] std::optional<Vec3> centreOf(OrganGroup group) const;
    /// The centre in E of the tube's bounds.
    [[nodiscard]] Vec3 tubeCentre() const { return m_tubeBounds.centre(); }
    /// The box in A of the lungs as drawn at end-inspiration in severe COPD, extended up to the top
    /// of the head, for a view that shows both whole. Empty for a patient without lungs.
    [[nodiscard]] Box reach() const;
    /// The largest z in A of the patient's surfaces, metres.
    [[nodiscard]] double top() const;

private:
    PatientModel() = default;
    void addAnatomy(std::vector<AnatomyPart> parts);
    void addTube();
    void takeTubeAway();

    std::string m_name;
    std::string m_contentHash;
    AirwayLandmarks m_landmarks;
    std::vector<std::string> m_attributions;
    std::vector<PatientSurface> m_surfaces;
    std::shared_ptr<const LungPair> m_lungs; // owned with the surfaces that alias its meshes
    ThroatField m_throat;
    RigidTransform m_heldJaw; ///< X_AJ in the surfaces
    TubeShape m_tube;
    std::map<OrganGroup, Box> m_groups; ///< the bounds of each, in A
    Box m_tubeBounds;                   ///< in E
    TubeShape m_ownTube;
};

} // namespace carina
