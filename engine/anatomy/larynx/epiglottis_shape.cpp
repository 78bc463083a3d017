#include "engine/anatomy/larynx/epiglottis_shape.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// One half of the leaf seen from the front.
const std::vector<Vec2>& outline()
{
    static const auto corners = [] {
        std::vector<Vec2> line =
            cornersCut({Vec2{-1.0, 4.9}, Vec2{2.4, 4.9}, Vec2{3.4, 11.0}, Vec2{6.4, 17.5},
                        Vec2{10.3, 21.8}, Vec2{11.5, 25.0}, Vec2{11.2, 28.4}, Vec2{9.4, 31.4},
                        Vec2{6.4, 33.4}, Vec2{3.0, 34.4}, Vec2{-1.0, 34.4}},
                       3);
        line.insert(line.begin(), Vec2{-6.0, 4.9});
        line.emplace_back(-6.0, 34.4);
        return line;
    }();
    return corners;
}

} // namespace

double Epiglottis::middleAt(double z) const
{
    const double up = z - 3.0;
    // Raised by a blade in the vallecula; at rest it leans over the entrance.
    const double middle = m_posture == Posture::Laryngoscopy ? -12.4 - 0.10 * up : -8.0 + 0.36 * up;
    // The free edge curls towards the tongue.
    return middle - 1.6 * easedStep(26.0, 37.0, z);
}

double Epiglottis::distance(const Vec3& p) const
{
    // Infants' leaves are narrow and bent: as wide, once flattened, as they are here.
    const double narrow = 1.0 - 0.32 * m_omega;
    const double x = std::abs(p.x()) / narrow;
    const double bent = 0.022 + 0.05 * m_omega;
    const double leaf = 0.9 * narrow * polygonDistance({x, p.z()}, outline());
    // Thinner towards its rim.
    const double whole = 2.2 - 1.07 * easedStep(10.0, 24.0, p.z());
    const double half = (1.0 - 0.3 * easedStep(-5.0, 0.0, leaf)) * whole;
    const double slope = m_posture == Posture::Laryngoscopy ? 0.10 : 0.36;
    const double slopeAcross = 2.0 * bent * std::min(x, 12.0) / narrow;
    const double across = (p.y() - middleAt(p.z()) - bent * x * x)
                          / std::sqrt(1.0 + slope * slope + slopeAcross * slopeAcross);
    const double blade = roundedMax(leaf, std::abs(across) - half, 1.8);
    const double tubercle =
        ellipsoidDistance(p - Vec3{0.0, middleAt(11.0) + 1.4, 11.0}, {4.0, 2.2, 4.6});
    return roundedMin(blade, tubercle, 1.5);
}

} // namespace carina
