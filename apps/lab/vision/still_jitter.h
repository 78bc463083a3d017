#pragma once

#include "engine/geometry/rigid_transform.h"

#include <optional>
#include <vector>

namespace carina::lab
{

/// How much the poses of a thing scatter while it is still: in stretches of ten successive pictures
/// with a pose, between whose halves the means differ by less than 0.5 mm and 0.5 degrees.
class StillJitter
{
public:
    /// The next picture; nothing where there is no pose.
    void add(const std::optional<RigidTransform>& X_TO);

    /// Poses in such stretches.
    [[nodiscard]] int samples() const { return m_samples; }
    /// RMS about the mean of each stretch, three-dimensional; nothing where there is none.
    [[nodiscard]] std::optional<double> position_mm() const;
    [[nodiscard]] std::optional<double> rotation_deg() const;

private:
    void judge();

    std::vector<RigidTransform> m_stretch;
    int m_samples = 0;
    double m_positionSquares = 0.0; ///< metres
    double m_rotationSquares = 0.0; ///< radians
};

} // namespace carina::lab
