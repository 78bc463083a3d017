#pragma once

#include "engine/anatomy/shapes/implicit_shape.h"

#include <vector>

namespace carina
{

/// A sheet of mucosa across the throat with a free edge towards the midline: the soft palate, or an
/// arch of the fauces. Symmetric; millimetres, signed distances.
class Curtain
{
public:
    /// @param profile_mm y and z of the middle of the sheet in the midplane; to both sides it sinks
    ///                   by 0.014 x^2 (of ours), and beyond the last point it goes on straight
    /// @param opening_mm x and z of what it leaves open, seen from the front: a polygon whose part
    ///                   with x > 0 counts, and whose outline there is the free edge
    /// @param edge_mm    half its thickness at the free edge
    /// @param root_mm    the same from 8 mm off the edge on
    /// @pre the profile has two points, no two neighbours equal; the opening has three.
    Curtain(std::vector<Vec2> profile_mm, std::vector<Vec2> opening_mm, double edge_mm,
            double root_mm);

    [[nodiscard]] double distance(const Vec3& p_mm) const;

    /// The height at which a place would lie in the midplane, if the sheet did not sink.
    [[nodiscard]] static double levelHeight(const Vec3& p_mm);

private:
    std::vector<Vec2> m_profile;
    std::vector<Vec2> m_opening;
    double m_edge;
    double m_root;
};

} // namespace carina
