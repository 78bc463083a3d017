#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// The directions across a way in which its walls are looked for: along the first axis of
/// acrossAxesOf and against it, then along the second and against that.
enum class WallSide : std::uint8_t { Left, Right, Front, Back };
inline constexpr std::array kWallSides{WallSide::Left, WallSide::Right, WallSide::Front,
                                       WallSide::Back};

/// The nearest walls around a place of a way in the surfaces, in A.
struct WallsAround {
    double along = 0.0; ///< the way, metres
    std::array<Vec3, kWallSides.size()> p_A_walls;

    [[nodiscard]] const Vec3& at(WallSide side) const
    {
        return p_A_walls[static_cast<std::size_t>(side)];
    }
};

/// The axes (across, front, direction) of a direction: across as nearly to the patient's left (+x)
/// as can be; nothing where there is no direction or it is that of x.
[[nodiscard]] std::optional<Mat3> acrossAxesOf(const Vec3& direction);

/// The walls of mouth, throat, larynx and trachea along a line, every kWallsEach. Where nothing is
/// nearer than `most` a wall is taken to be there. Places that lie inside of something, as where
/// the line crosses palate or epiglottis, are left out.
[[nodiscard]] std::vector<WallsAround> wallsAlong(const Anatomy& anatomy,
                                                  std::span<const Vec3> line, Length from,
                                                  Length until, Length most);
inline constexpr Length kWallsEach = millimetres(4.0);

/// The same of what is round, as something that yields to a tube.
[[nodiscard]] std::vector<WallsAround> roundWalls(std::span<const Vec3> line, Length from,
                                                  Length until, Length radius);

} // namespace carina
