#pragma once

#include "engine/anatomy/mouth/curtain.h"
#include "engine/anatomy/mouth/throat_air.h"
#include "engine/anatomy/mouth/tongue_shape.h"

#include <vector>

namespace carina
{

/// The soft palate with the uvula, and the arches between which one looks from the mouth into the
/// pharynx (Gray 1918): the palatoglossal one runs from the palate down and forward to the side of
/// the tongue, the palatopharyngeal one behind it down and back to the side of the pharynx. Frame
/// A, metres; signed distances, both sides alike.
///
/// Soft palate and arches are curtains with a free edge. That of the palate is a double arch beside
/// the uvula and goes over into the palatopharyngeal arches. Each arch has a fillet where it joins
/// palate, tongue and wall, and ends within them; towards the midline it sinks into the palate. How
/// they curve, how thick they are (soft palate 4.0 to 5.6, arches 3 to 4 mm in the reference man)
/// and how wide their openings, is of ours; no figures were at hand.
class Fauces
{
public:
    Fauces(const BodyPlan& plan, const LarynxFrame& larynx, const Tongue& tongue);

    [[nodiscard]] double softPalate(const Vec3& p_A) const;
    [[nodiscard]] double palatoglossalArch(const Vec3& p_A) const;
    [[nodiscard]] double palatopharyngealArch(const Vec3& p_A) const;

    /// A conical process that hangs from the middle of the soft palate's lower border (Gray 1918)
    /// and widens into it: 12 mm long below that border in the reference man, where 10 to 15 are
    /// usual, with a round tip.
    /// It is not drawn out with a child's throat, and as small as the child's windpipe for its
    /// face: of ours, no figure was found. In proportion to the face it hid what lies behind it.
    [[nodiscard]] double uvula(const Vec3& p_A) const;

    /// These as parts, and the tonsils between the arches.
    [[nodiscard]] std::vector<PartPlan> parts() const;

private:
    [[nodiscard]] Vec3 inFront_mm(const Vec3& p_A) const;
    [[nodiscard]] double archOf(const Curtain& curtain, double joined_m, double top_mm,
                                const Vec3& p_A) const;
    [[nodiscard]] PartPlan uvulaPart() const;

    BodyPlan m_plan;
    ThroatAir m_air;
    Tongue m_tongue;
    Curtain m_palate;
    Curtain m_front;
    Curtain m_back;
    Vec3 m_p_A_uvula; ///< where it hangs from the palate
    double m_unitOfUvula;
};

} // namespace carina
