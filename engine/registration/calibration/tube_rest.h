#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace carina
{

/// A tracheal tube at rest, in the connector's frame E: origin at the centre of the tube's end at
/// the connector, -z along the tube as it leaves the connector, bent in the plane of y and z
/// towards -y. Each half is a circular arc.
struct TubeRest {
    Length length;                 ///< of the centreline, connector to tip
    std::array<double, 2> bends{}; ///< curvature of the half at the connector and of that at the
                                   ///< tip, 1/m; a standard tube has 1/0.14
    Length outerDiameter;

    friend bool operator==(const TubeRest&, const TubeRest&) = default;
};

/// The connector: its rim, which a breathing circuit is put on, is a circle about z of E.
inline constexpr Length kConnectorRim = millimetres(20.0); ///< outside of the origin of E
inline constexpr Length kConnectorRadius = millimetres(7.5);

/// The point of the centreline at an arc length from the connector; beyond the tip on the arc.
[[nodiscard]] Vec3 centreOfTube(const TubeRest& tube, Length along);

/// The tip: the centre of its opening.
[[nodiscard]] inline Vec3 tipOfTube(const TubeRest& tube)
{
    return centreOfTube(tube, tube.length);
}

/// The centreline, connector to tip, at steps of at most 4 mm.
[[nodiscard]] std::vector<Vec3> centrelineOfTube(const TubeRest& tube);

/// Distance of a point from the centreline between connector and tip.
[[nodiscard]] double distanceFromTube(const TubeRest& tube, const Vec3& p_EQ);

/// Greatest distance of the centreline from the straight line between its ends.
[[nodiscard]] Length sagittaOfTube(const TubeRest& tube);

/// Where a tube is touched.
enum class TubePart : std::uint8_t {
    Rim,  ///< on the rim of the connector
    Wall, ///< anywhere on the wall
    Tip,  ///< in the middle of the opening at the tip
};

/// A place to touch: on the rim at a share of the way round it, on the wall at a share of the way
/// to the tip.
struct TubeTouchPlace {
    TubePart part = TubePart::Tip;
    double share = 0.0;
    bool isBeside = false; ///< on the wall at the side of the bend; otherwise at its outside
};

/// The places by which a tube is calibrated: three on the rim, five on the wall between connector
/// and cuff, the tip. Those at the outside of the bend tell its curvature, those at the side of it
/// the plane that it lies in.
inline constexpr std::array kTubePlaces{
    TubeTouchPlace{TubePart::Rim, 0.0},         TubeTouchPlace{TubePart::Rim, 1.0 / 3.0},
    TubeTouchPlace{TubePart::Rim, 2.0 / 3.0},   TubeTouchPlace{TubePart::Wall, 0.1},
    TubeTouchPlace{TubePart::Wall, 0.28, true}, TubeTouchPlace{TubePart::Wall, 0.46},
    TubeTouchPlace{TubePart::Wall, 0.64, true}, TubeTouchPlace{TubePart::Wall, 0.82},
    TubeTouchPlace{TubePart::Tip, 1.0}};

/// A place of a tube in E; beside the bend it is on the side of +x.
[[nodiscard]] Vec3 placeOnTube(const TubeRest& tube, const TubeTouchPlace& place);

} // namespace carina
