#pragma once

#include "engine/anatomy/patient/body_plan.h"

namespace carina
{

/// The skull without maxilla and lower jaw: braincase, orbits, nasal bones, zygomatic bones and
/// arches, mastoid processes, and the occiput with its foramen and condyles on the atlas. A solid:
/// its outer surface is what is drawn.
///
/// Points are given in reference millimetres of the face (BodyPlan), from the edge of the upper
/// incisors. The face has the plan's scale; the braincase is larger for it the younger a patient is
/// (`share`), and rests on the base, between the joints of the jaw.
class Cranium
{
public:
    explicit Cranium(const BodyPlan& plan);

    /// Size of the braincase, the reference man's for his face being 1: 0.91 in grown people, whose
    /// heads are then 190 mm (men) and 180 mm long with their skin; 1.03 at six years. Farkas 1992:
    /// 189.2 and 182.7 mm when grown, at 14 and 10 years.
    [[nodiscard]] double share() const { return m_share; }

    /// Approximate signed distances, reference millimetres.
    [[nodiscard]] double distance(const Vec3& p_mm) const;
    /// To the braincase without base and face, which the skin covers.
    [[nodiscard]] double braincase(const Vec3& p_mm) const;

    /// A box around it.
    [[nodiscard]] Box bounds() const;

private:
    [[nodiscard]] double base(const Vec3& p_mm) const;
    [[nodiscard]] double onAtlas(const Vec3& p_mm) const;

    double m_share;
    Vec3 m_centre; ///< of the braincase
    Vec3 m_radii;
    Vec3 m_atlas;      ///< middle of the atlas
    double m_vertebra; ///< millimetres of the neck's bones in those of the face
    double m_vault;    ///< how far back the pharynx reaches below the base
};

/// The space of an orbit, of both by symmetry; reference millimetres of the face.
[[nodiscard]] double orbitDistance(const Vec3& p_mm);

/// The part.
[[nodiscard]] PartPlan cranium(const BodyPlan& plan);

} // namespace carina
