#pragma once

#include "engine/airway/lumen/airway_lumen.h"
#include "engine/airway/tube/tube_size.h"
#include "engine/geometry/rigid_transform.h"

#include <vector>

namespace carina::test
{

/// An airway of a few numbers: a funnel, a straight mouth along +y, a quarter of a circle down, and
/// straight down along -z. Metres; the teeth are at the origin.
struct BentLumen {
    double mouth = 0.07;
    double bend = 0.05; ///< radius; 0: it goes straight on along +y
    double below = 0.14;
    double radius = 0.009;

    static constexpr double kFunnel = 0.028;
    static constexpr double kStep = 0.004;

    /// Distance of a place from the middle line.
    [[nodiscard]] double fromMiddle(const Vec3& p_A) const;
    /// The lumen for a tube.
    [[nodiscard]] AirwayLumen lumenFor(Length tubeRadius) const;
    /// Length from the teeth along the middle line to its end.
    [[nodiscard]] double length() const;
};

/// The curve of a tube at rest in the frame E of its connector (engine/anatomy/shapes/tube.h):
/// straight for 20 mm and then an arc of 140 mm radius, as ISO 5361 has it. It begins along -z and
/// bends towards -y: points at equal distances.
[[nodiscard]] std::vector<Vec3> restCurve(const TubeSize& size);

/// Where the connector is while a hand feeds a curved tube into the mouth, so much of it is inside:
/// the curve at rest passes the teeth, and rises a little there.
[[nodiscard]] RigidTransform fed(const TubeSize& size, double inside);

} // namespace carina::test
