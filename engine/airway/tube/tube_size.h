#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <cstdint>
#include <vector>

namespace carina
{

/// What is in a tube and makes it stiffer.
enum class TubeCore : std::uint8_t { Nothing, Bougie, Stylet };

/// A tracheal tube by its size: its dimensions and how stiff it is.
struct TubeSize {
    Length inner;
    Length outer;                           ///< outerDiameterOf
    Length length;                          ///< from the connector's end to the tip
    Length restRadius = millimetres(140.0); ///< of its curve at rest: ISO 5361
    Length cuffFromTip = millimetres(15.0); ///< its lower end; as it is drawn (makeTube)
    Length cuffLength = millimetres(32.0);  ///< the same
    Length bevel = millimetres(3.0);        ///< length of the slanted tip; as it is drawn
    double stiffness = 0.0;                 ///< of bending, E I, N m^2
    TubeCore core = TubeCore::Nothing;

    [[nodiscard]] Length outerRadius() const { return 0.5 * outer; }
    [[nodiscard]] Length wall() const { return 0.5 * (outer - inner); }
};

inline constexpr Length kThinnestTube = millimetres(2.5);
inline constexpr Length kThickestTube = millimetres(9.0);
inline constexpr Length kTubeSizeStep = millimetres(0.5);

/// All sizes, from the thinnest: 2.5, 3.0 .. 9.0 mm of inner diameter.
[[nodiscard]] std::vector<Length> tubeSizes();

/// Young's modulus of a tube's plasticised PVC, assumed: textbooks have 2 to 20 MPa for soft PVC.
/// In the airway it is warm and half as stiff, which is assumed too.
inline constexpr double kColdPvc_Pa = 10e6;
inline constexpr double kWarmPvc_Pa = 5e6;

/// How much stiffer a tube of 7.0 mm is with a bougie or stylet in it, assumed: both are stiffer
/// than the tube by an order of magnitude.
inline constexpr double kBougieToTube = 3.0;
inline constexpr double kStyletToTube = 12.0;

/// Stiffness of a round tube against bending, N m^2: E pi (ro^4 - ri^4) / 4.
[[nodiscard]] double bendingStiffness(double modulus_Pa, Length outerRadius, Length innerRadius);

/// The tube of a size. Its length goes linearly from 140 mm at 2.5 to 320 mm at 8.0 mm, as the
/// usual uncut tubes about have it; of ours.
/// @returns OutOfRange outside kThinnestTube to kThickestTube
[[nodiscard]] Result<TubeSize> tubeOfSize(Length inner, TubeCore core = TubeCore::Nothing,
                                          bool isWarm = true);

/// The curve of a tube at rest in the frame E of its connector (engine/anatomy/shapes/tube.h):
/// straight for kStraightOfTube and then an arc of the rest radius. It begins along -z and bends
/// towards -y: in a patient that lies in A as X_AE of makeTube has it, towards the chest.
/// @returns points at equal distances along it, `pieces` + 1
/// @pre pieces above 0
[[nodiscard]] std::vector<Vec3> restCurve(const TubeSize& size, int pieces);

/// The part beside the connector, which is nearly straight: of ours.
inline constexpr Length kStraightOfTube = millimetres(20.0);

} // namespace carina
