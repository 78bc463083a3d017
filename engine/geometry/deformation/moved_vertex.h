#pragma once

#include "engine/geometry/deformation/chest_formula.h"

#include <cmath>

namespace carina
{

/// The deformed position of a vertex, metres, and its unit normal there; components along x, y, z
/// of A.
template <class T> struct MovedVertex {
    Shares<T> position;
    Shares<T> normal;
};

/// Moves one vertex, as used by deformed(), which has the formula.
/// @param metrePer 1 / frame.perMetre, component by component
/// @param p        the vertex at rest, in A, metres
/// @param n        its normal at rest
template <class T>
[[gnu::always_inline]] inline MovedVertex<T>
movedVertex(const ChestFrame<T>& frame, const ChestCoefficients<T>& terms,
            const Shares<T>& metrePer, const Shares<T>& p, const Shares<T>& n)
{
    const Shares<T> fromOrigin = p - frame.origin;
    const ChestValue<T> there =
        chestValue<true, T>(frame, terms,
                            {fromOrigin.u * frame.perMetre.u, fromOrigin.v * frame.perMetre.v,
                             fromOrigin.h * frame.perMetre.h});
    const Shares<T> a{T(1) + there.slope_u.u, there.slope_u.v, there.slope_u.h};
    const Shares<T> b{there.slope_v.u, T(1) + there.slope_v.v, there.slope_v.h};
    const Shares<T> c{there.slope_h.u, there.slope_h.v, T(1) + there.slope_h.h};
    const Shares<T> m{metrePer.u * n.u, metrePer.v * n.v, metrePer.h * n.h};
    const auto tripleProduct = [&m](const Shares<T>& r, const Shares<T>& s) {
        return (r.v * s.h - r.h * s.v) * m.u + (r.h * s.u - r.u * s.h) * m.v
               + (r.u * s.v - r.v * s.u) * m.h;
    };
    const Shares<T> normal{frame.perMetre.u * tripleProduct(b, c),
                           frame.perMetre.v * tripleProduct(c, a),
                           frame.perMetre.h * tripleProduct(a, b)};
    const T perLength =
        T(1) / std::sqrt(normal.u * normal.u + normal.v * normal.v + normal.h * normal.h);
    return {
        {p.u + metrePer.u * there.f.u, p.v + metrePer.v * there.f.v, p.h + metrePer.h * there.f.h},
        perLength * normal};
}

} // namespace carina
