#pragma once

#include "engine/airway/scope/scope_walls.h"
#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// The camera of an endoscope that a person flies by hand: a ball that goes the way it looks, or
/// back, slides along walls and passes none. A function of what was asked of it and of where the
/// walls were; time has no part in it.
///
/// A way is gone in pieces. From a place p whose distance to all walls is at least r, the ball goes
/// on by at most r / 4, then off the nearest wall until its middle is at least r from that, and
/// stays within 3/4 r of p. As no wall is within r of p, none is passed, however thin it is and
/// however long the way. Where no such place is found, or only one that leads back, it is stopped.
/// r is its radius, or where tissue has come nearer than that, the distance it has left.
class FlownScope
{
public:
    explicit FlownScope(Length radius) : m_radius{radius.si} {}

    /// X_AD: +x to the right of the picture, +y up, looking along -z.
    [[nodiscard]] const RigidTransform& pose() const { return m_X_AD; }
    [[nodiscard]] Length radius() const { return metres(m_radius); }

    /// Puts it into this pose. @pre the walls are not nearer than its radius there
    void place(const RigidTransform& X_AD) { m_X_AD = X_AD; }
    /// Turns it where it is: what it looks at is farther to the right and up.
    void turn(Angle right, Angle up);
    /// Turns it about the line of sight, clockwise as it looks.
    void roll(Angle clockwise);
    /// So far the way it looks; below 0 the way back. It goes no farther than kLeash from all
    /// walls.
    void advance(Length way, ScopeWalls& walls);
    /// After the walls have moved: goes along with the tissue around it, then off the walls as far
    /// as there is room.
    void follow(ScopeWalls& walls);
    /// Whether a wall touches it.
    [[nodiscard]] bool isAtWall(ScopeWalls& walls) const;

    static constexpr Length kLeash = millimetres(40.0);   ///< of ours, as those that follow
    static constexpr Length kTouching = millimetres(0.1); ///< beyond its radius

private:
    [[nodiscard]] std::optional<Vec3> slid(const Vec3& from, const Vec3& to, double room,
                                           ScopeWalls& walls) const;
    void makeRoom(ScopeWalls& walls);
    void goTo(const Vec3& p_A) { m_X_AD = {m_X_AD.rotation(), p_A}; }

    double m_radius;
    RigidTransform m_X_AD;
};

} // namespace carina
