#pragma once

#include "engine/airway/lumen/airway_lumen.h"
#include "engine/geometry/deformation/airway_field.h"
#include "engine/geometry/deformation/blade_field.h"
#include "engine/geometry/deformation/throat_field.h"

#include <functional>
#include <optional>

namespace carina
{

/// Where tissue goes that lies at a place of the surfaces, in A.
using TissueMotion = std::function<Vec3(const Vec3& p_A, AirwayTissue tissue)>;

/// As it is drawn without a blade: changed by events and breath, then taken by the neck, then by
/// the jaw. The arguments must outlive the motion.
[[nodiscard]] TissueMotion tissueMotion(const AirwayField& changes, const FollowingThroat& throat);
/// Where a blade pushes what lies at a place of that; nothing without a blade, which must outlive
/// the motion.
[[nodiscard]] TissueMotion bladePushing(const BladeField& blade);

/// A section of a moved lumen, for the centre line of a tube.
struct MovedSection {
    Vec3 p_A_centre = Vec3::Zero();
    Vec3 side = Vec3::UnitX(); ///< unit, as AcrossWay
    Vec3 back = Vec3::UnitY();
    /// From the centre to the sides across these directions (evenOut), metres.
    std::array<double, kLumenDirections> reach{};
    /// Half the least width, metres; below 0 by so much the tube is too thick.
    double spare = 0.0;
    double give = 0.0; ///< metres

    static constexpr double kLeastReach = 1e-5;
};

/// A way of a moved lumen. No sections: the patient has none such.
struct MovedWay {
    std::vector<MovedSection> sections;
    std::vector<double> along; ///< to each, from the first, along the centres; metres
    std::vector<Vec3> middles; ///< of the sections, between their walls

    [[nodiscard]] bool isThere() const { return sections.size() >= 2; }
    /// From the first section to the nearest place of the centre line.
    /// @param segment with which the search begins; it becomes the one that was found
    [[nodiscard]] double alongAt(const Vec3& p_A, std::size_t& segment) const;
    /// How far a place is from the line of the middles, metres.
    [[nodiscard]] double fromMiddles(const Vec3& p_A) const;
    /// The segment of the centre line that is nearest to a place.
    [[nodiscard]] std::size_t nearestSegment(const Vec3& p_A) const;
    /// Where a tube that comes from `from` is stopped: the first place that is narrower than tube
    /// and tissue allow; the end where there is none.
    [[nodiscard]] double stopBehind(double from) const;
};

/// A lumen where the tissue around it is at a moment. A, metres.
struct MovedLumen {
    std::array<MovedWay, kAirwayWays> ways;
    Length tubeRadius{};
    double teeth = 0.0; ///< along the trunk
    double glottis = 0.0;
    std::array<double, kAirwayWays> begins{}; ///< along each way but the trunk

    [[nodiscard]] const MovedWay& way(AirwayWay which) const { return ways[std::size_t(which)]; }

    /// The section at a length along a way.
    [[nodiscard]] MovedSection sectionAt(AirwayWay which, double along) const;
};

/// Moves a lumen with the tissue around it. Four corners of each section are moved with what they
/// touch, those between by the share of these; centres go to the middle between them.
/// @param push what makes room beside that: a wall goes away from the way with it, and not into the
///             way, as the palate would that is drawn with the tongue before a blade
[[nodiscard]] MovedLumen moved(const AirwayLumen& lumen, const TissueMotion& motion,
                               const TissueMotion& push = {});

} // namespace carina
