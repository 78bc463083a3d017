#pragma once

#include "engine/airway/lumen/moved_lumen.h"

#include <array>
#include <span>
#include <vector>

namespace carina
{

/// A section across the guide of a rod: its centre, its axes, and how far a node may be from there.
struct GuideSection {
    Vec3 p_A_centre = Vec3::Zero();
    Vec3 side = Vec3::UnitX(); ///< as AcrossWay; unit, or nearly so between two sections
    Vec3 back = Vec3::UnitY();
    /// From the centre to the sides of a convex polygon, across kLumenDirections, metres.
    std::array<double, kLumenDirections> sides{};
    bool isFree = true; ///< nothing limits a node there

    /// The sides that a place (u, v) is beyond: their number is the number of terms of the sums.
    struct Walls {
        unsigned sides = 0;                        ///< a bit for each
        double byU = 0.0, byV = 0.0;               ///< half the gradient of the depths' squares
        double byUU = 0.0, byUV = 0.0, byVV = 0.0; ///< half the second derivatives
    };
    /// @param alsoSides that count also where it is not beyond them: a bit for each
    /// @pre not isFree
    [[nodiscard]] Walls wallsAt(double u, double v, unsigned alsoSides = 0) const;
    /// Of the way from the centre to the sides; above 1 beyond. @pre not isFree
    [[nodiscard]] double share(double u, double v) const;

    [[nodiscard]] Vec3 at(double u, double v) const { return p_A_centre + u * side + v * back; }
};

/// Where a node of a rod is: so far along its guide, and so far from that across it. Metres.
struct GuidedPlace {
    double along = 0.0;
    double u = 0.0, v = 0.0;
};

/// What u and v change by with a way in A, where the section stays.
struct AcrossGuide {
    Vec3 byU = Vec3::Zero(), byV = Vec3::Zero();
};
/// @param slope of the guide at the place (RodGuide::slope)
[[nodiscard]] AcrossGuide acrossGuide(const GuideSection& section, const Vec3& slope);
/// Where a place is once it has gone a way, to first order.
[[nodiscard]] GuidedPlace moved(const GuideSection& section, const Vec3& slope,
                                const GuidedPlace& place, const Vec3& way);

/// The line along which a rod lies, and how far it can be from it: sections across it, as a lumen
/// has them, and where it is free space around them. Before the first and beyond the last it goes
/// straight on. A, metres.
///
/// With a length along it and two across it a place in A is told (GuidedPlace) as long as planes of
/// neighbouring sections do not meet there.
class RodGuide
{
public:
    void clear();
    /// @pre elsewhere than the section before
    void add(const GuideSection& section);
    /// Free space around points of a line. @pre no two neighbours equal
    void addFree(std::span<const Vec3> line);

    [[nodiscard]] std::size_t size() const { return m_sections.size(); }
    /// From the first section to the last.
    [[nodiscard]] double length() const { return m_along.back(); }

    /// Of a length along it. @param segment with which the search begins; it becomes that one
    /// @pre two sections at least
    [[nodiscard]] GuideSection at(double along, std::size_t& segment) const;
    /// By how much a place in a segment goes on in A with its length along the guide.
    [[nodiscard]] Vec3 slope(std::size_t segment, const GuidedPlace& place) const;
    /// Where a place of free space is that is so far along it, or nearly so; in its middle where it
    /// is not free.
    [[nodiscard]] GuidedPlace placeOf(const Vec3& p_A, double about, std::size_t& segment) const;

private:
    std::vector<GuideSection> m_sections;
    std::vector<double> m_along;
    std::vector<Vec3> m_directions; ///< of the segments
};

} // namespace carina
