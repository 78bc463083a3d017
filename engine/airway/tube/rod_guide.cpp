#include "engine/airway/tube/rod_guide.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// Between the plane of a section and the slope there: what is less is taken for this. Of ours.
constexpr double kLeastSlope = 0.25;

/// cos and sin of kLumenDirections.
const std::array<std::array<double, 2>, kLumenDirections>& directionsAcross()
{
    static const auto directions = [] {
        std::array<std::array<double, 2>, kLumenDirections> made{};
        const AcrossWay plane{Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()};
        for (std::size_t k = 0; k < kLumenDirections; ++k)
            made[k] = {plane.direction(k).x(), plane.direction(k).y()};
        return made;
    }();
    return directions;
}

Vec3 normalOf(const GuideSection& section) { return section.back.cross(section.side); }

} // namespace

double GuideSection::share(double u, double v) const
{
    const auto& across = directionsAcross();
    double most = 0.0;
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        most = std::max(most, (across[k][0] * u + across[k][1] * v) / sides[k]);
    return most;
}

GuideSection::Walls GuideSection::wallsAt(double u, double v, unsigned alsoSides) const
{
    const auto& across = directionsAcross();
    Walls walls;
    for (std::size_t k = 0; k < kLumenDirections; ++k) {
        const auto& [cosine, sine] = across[k];
        const double depth = cosine * u + sine * v - sides[k];
        if (depth <= 0.0 && (alsoSides >> k & 1U) == 0U)
            continue;
        walls.sides |= 1U << k;
        walls.byU += depth * cosine;
        walls.byV += depth * sine;
        walls.byUU += cosine * cosine;
        walls.byUV += cosine * sine;
        walls.byVV += sine * sine;
    }
    return walls;
}

AcrossGuide acrossGuide(const GuideSection& section, const Vec3& slope)
{
    const Vec3 normal = normalOf(section);
    const Vec3 perSlope = normal / std::max(slope.dot(normal), kLeastSlope);
    return {section.side - slope.dot(section.side) * perSlope,
            section.back - slope.dot(section.back) * perSlope};
}

GuidedPlace moved(const GuideSection& section, const Vec3& slope, const GuidedPlace& place,
                  const Vec3& way)
{
    const Vec3 normal = normalOf(section);
    const double on = way.dot(normal) / std::max(slope.dot(normal), kLeastSlope);
    const Vec3 across = way - on * slope;
    return {place.along + on, place.u + across.dot(section.side),
            place.v + across.dot(section.back)};
}

void RodGuide::clear()
{
    m_sections.clear();
    m_along.clear();
    m_directions.clear();
}

void RodGuide::add(const GuideSection& section)
{
    if (m_sections.empty()) {
        m_along.push_back(0.0);
    } else {
        const Vec3 way = section.p_A_centre - m_sections.back().p_A_centre;
        const double length = way.norm();
        CARINA_EXPECTS(length > 0.0);
        m_along.push_back(m_along.back() + length);
        m_directions.emplace_back(way / length);
    }
    m_sections.push_back(section);
}

void RodGuide::addFree(std::span<const Vec3> line)
{
    for (std::size_t i = 0; i < line.size(); ++i) {
        const AcrossWay across =
            acrossWay(line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0]);
        add({.p_A_centre = line[i], .side = across.side, .back = across.back});
    }
}

GuideSection RodGuide::at(double along, std::size_t& segment) const
{
    segment = std::min(segment, m_directions.size() - 1);
    while (segment > 0 && along < m_along[segment])
        --segment;
    while (segment + 1 < m_directions.size() && along > m_along[segment + 1])
        ++segment;
    const GuideSection& a = m_sections[segment];
    const GuideSection& b = m_sections[segment + 1];
    const double beyond = along - m_along[segment];
    const double share = std::clamp(beyond / (m_along[segment + 1] - m_along[segment]), 0.0, 1.0);
    GuideSection section{.p_A_centre = a.p_A_centre + beyond * m_directions[segment],
                         .side = a.side + share * (b.side - a.side),
                         .back = a.back + share * (b.back - a.back),
                         .isFree = a.isFree || b.isFree};
    if (!section.isFree)
        for (std::size_t k = 0; k < kLumenDirections; ++k)
            section.sides[k] = a.sides[k] + share * (b.sides[k] - a.sides[k]);
    return section;
}

Vec3 RodGuide::slope(std::size_t segment, const GuidedPlace& place) const
{
    const bool isWithin = place.along > m_along[segment] && place.along < m_along[segment + 1];
    if (!isWithin)
        return m_directions[segment];
    const GuideSection& a = m_sections[segment];
    const GuideSection& b = m_sections[segment + 1];
    const double perLength = 1.0 / (m_along[segment + 1] - m_along[segment]);
    return m_directions[segment]
           + perLength * (place.u * (b.side - a.side) + place.v * (b.back - a.back));
}

GuidedPlace RodGuide::placeOf(const Vec3& p_A, double about, std::size_t& segment) const
{
    constexpr int kRounds = 4;
    GuidedPlace place{.along = about};
    for (int i = 0; i < kRounds; ++i) {
        const GuideSection section = at(place.along, segment);
        if (!section.isFree)
            return {.along = about};
        place = moved(section, slope(segment, place), place, p_A - section.at(place.u, place.v));
    }
    return place;
}

} // namespace carina
