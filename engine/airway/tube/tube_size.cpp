#include "engine/airway/tube/tube_size.h"

#include "engine/anatomy/shapes/tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace carina
{
namespace
{

constexpr Length kShortest = millimetres(140.0); ///< of the thinnest
constexpr Length kLongest = millimetres(320.0);  ///< from an inner diameter of 8 mm on
constexpr Length kInnerOfLongest = millimetres(8.0);

} // namespace

std::vector<Length> tubeSizes()
{
    std::vector<Length> sizes;
    const int steps = int(std::lround((kThickestTube - kThinnestTube) / kTubeSizeStep));
    for (int i = 0; i <= steps; ++i)
        sizes.push_back(kThinnestTube + double(i) * kTubeSizeStep);
    return sizes;
}

double bendingStiffness(double modulus_Pa, Length outerRadius, Length innerRadius)
{
    return modulus_Pa * 0.25 * std::numbers::pi
           * (std::pow(outerRadius.si, 4) - std::pow(innerRadius.si, 4));
}

Result<TubeSize> tubeOfSize(Length inner)
{
    constexpr Length kRounding = millimetres(1e-6);
    if (!(inner >= kThinnestTube - kRounding && inner <= kThickestTube + kRounding))
        return fail(Errc::OutOfRange, "a tube of " + std::to_string(inMillimetres(inner)) + " mm");
    TubeSize size{.inner = inner, .outer = outerDiameterOf(inner), .length = {}};
    const double share = std::min((inner - kThinnestTube) / (kInnerOfLongest - kThinnestTube), 1.0);
    size.length = kShortest + share * (kLongest - kShortest);
    size.stiffness = bendingStiffness(kPvc_Pa, size.outerRadius(), 0.5 * inner);
    return size;
}

} // namespace carina
