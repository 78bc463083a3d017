#pragma once

#include "engine/core/units.h"
#include "engine/geometry/deformation/airway_tissue.h"
#include "engine/geometry/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace carina
{

/// The ways in which a tube can lie. The others branch off the trunk and begin within it.
enum class AirwayWay : std::uint8_t {
    Trunk, ///< from in front of the teeth through mouth, glottis and trachea to the carina
    RightMain,
    LeftMain,
    Oesophagus, ///< from behind the arytenoids
};
inline constexpr std::size_t kAirwayWays = 4;
inline constexpr std::array kAllAirwayWays{AirwayWay::Trunk, AirwayWay::RightMain,
                                           AirwayWay::LeftMain, AirwayWay::Oesophagus};

/// Directions across a way, 22.5 degrees apart: 0 to the patient's left, kLumenDirections / 4 to
/// the back, or up to the palate where the way leads backwards.
inline constexpr std::size_t kLumenDirections = 16;

/// Where the wall ends what the centre line of a tube can reach, in one direction.
struct LumenLimit {
    Vec3 p_A_wall = Vec3::Zero(); ///< what the tube touches there
    Vec3 fromWall = Vec3::Zero(); ///< from there to the tube's centre line, metres
    AirwayTissue tissue = AirwayTissue::Pharynx;
};

/// A section across a way.
struct LumenSection {
    Vec3 p_A_centre = Vec3::Zero();
    std::array<LumenLimit, kLumenDirections> limits{};
    /// By which half the width of its tissue yields to a tube that is too thick.
    Length give{};
};

/// The space in which the centre line of a tube of one outer radius can be, as a patient's surfaces
/// have it; A, metres. It is a polygon of kLumenDirections corners for each section of each way,
/// about 4 mm apart, and in between of what lies between two of them. So it is smooth enough for a
/// rod, quickly asked, and can be moved: four of the corners of each section go with the tissue
/// that they touch, and those between with these (MovedLumen).
///
/// A dense signed distance field would need to know where space goes between tissues that move
/// apart, as tongue and palate do when a mouth opens; the corners need not.
struct AirwayLumen {
    Length tubeRadius{};
    std::array<std::vector<LumenSection>, kAirwayWays> ways;
    std::size_t teeth = 0;   ///< sections of the trunk: at the upper incisors' edge
    std::size_t glottis = 0; ///< and between the vocal cords
    /// Behind which section of each way but the trunk a tip is in it alone.
    std::array<std::size_t, kAirwayWays> begins{};
    bool isMeasured = true; ///< by surfaces; false: partly by usual sizes, for want of them

    [[nodiscard]] const std::vector<LumenSection>& way(AirwayWay which) const
    {
        return ways[std::size_t(which)];
    }
};

/// Axes across a way at one of its sections: to the left and to the back.
struct AcrossWay {
    Vec3 along, side, back; ///< unit, perpendicular
    [[nodiscard]] Vec3 direction(std::size_t k) const;
};
/// @param along the way, of any length but 0
[[nodiscard]] AcrossWay acrossWay(const Vec3& along);

} // namespace carina
