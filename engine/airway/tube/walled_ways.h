#pragma once

#include "engine/airway/tube/banded_system.h"
#include "engine/airway/tube/rod_guide.h"

#include <span>
#include <vector>

namespace carina
{

/// The ways of nodes for which a sum of squares and of walls is least,
///
///     1/2 d . A d - b . d + sum k / 2 depth^2
///
/// where A and b are those of a BandedSystem, and the depths those of a node beyond each side of
/// its section, which stays as it is. The sum is convex. Newton's method: from the walls that held
/// the nodes the last time, which are mostly those that hold them now; then along each way that it
/// finds to where the sum is about least. In hundreds of segments nearly always two solutions are
/// enough, and it is exact once the same walls hold.
class WalledWays
{
public:
    explicit WalledWays(std::size_t nodes, double wall);

    /// A node as it is now.
    struct Node {
        GuideSection section;
        Vec3 slope = Vec3::UnitZ(); ///< RodGuide::slope
        AcrossGuide across{};
        GuidedPlace place{};
    };
    std::vector<Node> nodes;
    BandedSystem system; ///< A and b

    /// @param first node that is not held; those before do not move
    /// @param nearEnough a change of the ways after which no solution follows, metres
    /// @returns false where A is not positive definite
    [[nodiscard]] bool find(std::size_t first, double nearEnough);

    [[nodiscard]] std::span<const Vec3> ways() const { return m_ways; }
    /// Whether the sum is least with them, and not only less.
    [[nodiscard]] bool isLeast() const { return m_isLeast; }

    static constexpr int kMostSolutions = 5; ///< of ours

private:
    void touch(std::size_t first, std::span<const Vec3> ways, bool areKept);
    void addWalls(std::size_t first);
    [[nodiscard]] double wallsAlong(std::size_t first) const;
    struct AlongWays {
        double slope = 0.0, curve = 0.0;
    };
    [[nodiscard]] AlongWays squaresAlong(std::size_t first) const;
    void search(std::size_t first);

    double m_wall;
    std::vector<BandedSystem::Row> m_squares; ///< the rows without walls
    std::vector<GuideSection::Walls> m_touches;
    std::vector<Vec3> m_ways;
    std::vector<Vec3> m_found; ///< from m_ways to the solution
    std::vector<Vec3> m_tried;
    bool m_isLeast = false;
};

} // namespace carina
