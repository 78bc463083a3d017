#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"

#include <vector>

namespace carina
{

/// A tracheal tube by its size: its dimensions and how stiff it is.
struct TubeSize {
    Length inner;
    Length outer;           ///< outerDiameterOf
    Length length;          ///< from the connector's end to the tip
    double stiffness = 0.0; ///< of bending, E I, N m^2

    [[nodiscard]] Length outerRadius() const { return 0.5 * outer; }
};

inline constexpr Length kThinnestTube = millimetres(2.5);
inline constexpr Length kThickestTube = millimetres(9.0);
inline constexpr Length kTubeSizeStep = millimetres(0.5);

/// All sizes, from the thinnest: 2.5, 3.0 .. 9.0 mm of inner diameter.
[[nodiscard]] std::vector<Length> tubeSizes();

/// Young's modulus of a tube's plasticised PVC, assumed: textbooks have 2 to 20 MPa for soft PVC.
inline constexpr double kPvc_Pa = 5e6;

/// Stiffness of a round tube against bending, N m^2: E pi (ro^4 - ri^4) / 4.
[[nodiscard]] double bendingStiffness(double modulus_Pa, Length outerRadius, Length innerRadius);

/// The tube of a size. Its length goes linearly from 140 mm at 2.5 to 320 mm at 8.0 mm, as the
/// usual uncut tubes about have it; of ours.
/// @returns OutOfRange outside kThinnestTube to kThickestTube
[[nodiscard]] Result<TubeSize> tubeOfSize(Length inner);

} // namespace carina
