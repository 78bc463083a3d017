#pragma once

#include "engine/anatomy/larynx/epiglottis_shape.h"
#include "engine/anatomy/larynx/larynx_frame.h"

namespace carina
{

/// The tongue with tip, dorsum and base, down to the vallecula: the hollow between it and the
/// epiglottis; and the median fold that crosses the vallecula. On each side of that fold its base
/// has a hollow (Gray 1918: the depressions on either side of the median fold are the valleculae).
/// At rest it fills the mouth, held by a laryngoscope it lies on the mouth's floor behind the lower
/// teeth. Frame A, metres.
class Tongue
{
public:
    Tongue(const BodyPlan& plan, const LarynxFrame& larynx, const Epiglottis& epiglottis);

    /// Approximate signed distance.
    [[nodiscard]] double distance(const Vec3& p_A) const;
    [[nodiscard]] Box bounds() const { return m_bounds; }

    /// The median glosso-epiglottic fold.
    [[nodiscard]] ImplicitShape medianFold() const;

private:
    [[nodiscard]] double hollow(const Vec3& p_A) const;

    LarynxFrame m_larynx;
    Epiglottis m_epiglottis;
    std::vector<Vec2> m_outline; ///< y and z of its midsagittal section, closed
    std::vector<Vec2> m_fold;    ///< the same of the median fold
    Box m_bounds;
    Vec3 m_base;        ///< in the midline above the vallecula
    double m_unit;      ///< metres per reference millimetre of the face
    double m_halfWidth; ///< reference millimetres
    double m_sulcus;    ///< y in front of which the dorsum has its groove
};

} // namespace carina
