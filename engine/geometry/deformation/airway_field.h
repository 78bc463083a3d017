#pragma once

#include "engine/core/units.h"
#include "engine/geometry/deformation/airway_formula.h"
#include "engine/geometry/mesh/vertex_color.h"

namespace carina
{

/// Tissue that swells within a spheroid about a centre.
struct Swelling {
    Vec3 p_A_centre = Vec3::Zero();
    Vec3 axis_A = Vec3::UnitZ();     ///< unit
    Length across{};                 ///< reach of the spheroid across its axis
    Length along{};                  ///< and along it
    Length outward{};                ///< away from the centre; at most so far
    Vec3 shift_A = Vec3::Zero();     ///< and what is in the middle so far to one side, metres
    Length depth = millimetres(2.0); ///< within which `outward` grows from the centre
    bool isFlat = false; ///< outward along the axis only, to both sides of the plane across it
    AirwayTissues tissues = kThroatTissues;
};

/// Tissue that takes another colour within a spheroid about a centre.
struct Tint {
    Vec3 p_A_centre = Vec3::Zero();
    Vec3 axis_A = Vec3::UnitZ(); ///< unit
    Length across{};             ///< reach of the spheroid across its axis
    Length along{};              ///< and along it
    Rgb color{};
    double share = 1.0; ///< of that colour in the middle; the rest is the tissue's own
    AirwayTissues tissues = kThroatTissues;
};

/// A lumen that has a midplane, as the glottis between the cords.
struct Lumen {
    Vec3 p_A_front = Vec3::Zero();     ///< in the midplane, at its level
    Vec3 right_A = Vec3::UnitX();      ///< unit, across the midplane to either side
    Vec3 back_A = Vec3::UnitY();       ///< unit
    Vec3 up_A = Vec3::UnitZ();         ///< unit; the three are perpendicular
    Length toWidest = millimetres(15); ///< from the front
    Length halfInFront{};              ///< half its width there, above 0
    Length halfAtWidest{};             ///< from `toWidest` on, not less
    double outer = 2.4;                ///< tissue moves up to so many half widths, above 1
};

/// What events change of the soft tissue of an airway at rest, before jaw and blade move it: its
/// form and its colour. With
/// u = 1 at the surface of a spheroid and s(u) = (1 - u^2)^2 within it, a swelling moves a point to
///
///     x = p + s(u) (h y / sqrt(y^2 + depth^2) + shift)
///
/// where y is the way from the centre (of a flat one, its part along the axis) and h `outward`; and
/// a narrowing moves what lies X beside its midplane to
///
///     X' = X (1 - k w),   w = b(X / e) l
///
/// where e is half the width of the lumen, b is 1 up to X = e and fades to 0 at outer e, and l
/// fades in front of the lumen, behind it, above and below. In the midplane nothing moves.
///
/// Nothing folds. With h + |shift| at most 0.6 R, R the lesser reach, the determinant of the
/// deformation gradient of a swelling is at least 1 - 0.6 * 8 / sqrt(27) > 0.07: it is det(I + M)
/// (1 + g . (I + M)^-1 b) with M symmetric and not negative, |b| <= h + |shift|, and |g| = |grad s|
/// at most 8 / sqrt(27) / R. That of a narrowing is 1 - k (w + X dw/dX), at least 1 - k for k > 0,
/// since w falls to the sides; for k < 0 at least 1 - |k| 1.5 outer / (outer - 1), which is 0.1 or
/// more for k >= -0.3 and outer >= 2. One follows another, so that the determinants are multiplied:
/// each takes space onto itself one to one, and so do all together. What was apart stays apart,
/// where tissues are moved alike.
///
/// A tint mixes its colour with that of the tissue, in linear light, by the share S(2 (1 - u^2)) of
/// `share`, S(t) = t^2 (3 - 2 t) from 0 to 1: whole up to u = 0.707, and nothing from u = 1 on. u
/// is that of the place in the surfaces, so that a colour goes with the tissue that has it.
class AirwayField
{
public:
    /// Nothing changes.
    AirwayField() = default;

    static constexpr double kMostOfReach = 0.6;
    static constexpr double kMostClosing = 0.98;
    static constexpr double kMostOpening = 0.3;

    /// Adds a swelling. @pre there are fewer than kMostSwellings; reaches and depth above 0;
    /// outward at least 0; it and the shift at most kMostOfReach of the lesser reach
    void swell(const Swelling& swelling);

    /// Adds a colour, over those that were added before. @pre there are fewer than kMostTints;
    /// reaches above 0; the share is 0 to 1
    void tint(const Tint& tint);

    /// Closes the glottis by a share of its width, from -kMostOpening to kMostClosing.
    /// @pre as said, and for less than 0 outer is at least 2
    void closeCords(const Lumen& glottis, double share) { close(m_frame.cords, glottis, share); }
    /// Closes its front part after that, which a web joins, for shares from 0 on.
    void joinCords(const Lumen& web, double share);
    /// The same of the entrance of the larynx, and of the pharynx, for shares from 0 on.
    void narrowVestibule(const Lumen& vestibule, double share);
    void narrowPharynx(const Lumen& pharynx, double share);
    /// The same of the windpipe from side to side, and then from front to back: of that `right_A`
    /// of the lumen is to the front or back, and its front at one side.
    void narrowWindpipe(const Lumen& sides, double share);
    void flattenWindpipe(const Lumen& depth, double share);

    [[nodiscard]] const AirwayFrame<double>& frame() const { return m_frame; }
    /// Whether anything is moved or coloured.
    [[nodiscard]] bool isThere() const { return m_isThere; }

private:
    void close(NarrowingFrame<double>& frame, const Lumen& lumen, double share);

    AirwayFrame<double> m_frame;
    std::size_t m_swellings = 0;
    std::size_t m_tints = 0;
    bool m_isThere = false;
};

/// The same values in single precision, as graphics cards use them.
[[nodiscard]] AirwayFrame<float> inSingle(const AirwayFrame<double>& frame);

} // namespace carina
