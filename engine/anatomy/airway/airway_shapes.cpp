#include "engine/anatomy/airway/airway_shapes.h"

#include "engine/geometry/rotation.h"

#include <cmath>
#include <numbers>

namespace carina
{

namespace
{

constexpr double kMillimetre = 1e-3;
/// Height of a cartilage above the gaps beside it.
constexpr double kRingHeight = 1.1 * kMillimetre;
constexpr double kRingHeightBronchi = 0.7 * kMillimetre;
constexpr double kRingSpacingBronchi = 5.0 * kMillimetre;
/// Below its upper end a grown man's trachea widens over this length: of ours, five rings.
constexpr double kWidens = 30.0 * kMillimetre;
/// From its upper end, which is open, down to here it has one width.
constexpr double kOpenEnd = 6.0 * kMillimetre;

/// -1/2 in the gaps between cartilages to 1/2 on them, flat on both.
double ripple(double along, double spacing)
{
    const double wave = std::cos(2.0 * std::numbers::pi * along / spacing);
    return easedStep(-0.6, 0.6, wave) - 0.5;
}

/// Down the trachea's axis, turned by `fromAxis` to a side (+1 left) and by `back` to the back.
Vec3 downAndAside(Angle fromAxis, double side, Angle back)
{
    const Vec3 flat{side * std::sin(fromAxis.si), 0.0, -std::cos(fromAxis.si)};
    return std::cos(back.si) * flat + std::sin(back.si) * Vec3::UnitY();
}

AirwayRod branch(const Vec3& p_W_from, const Vec3& direction_W, double length, double radius)
{
    return {p_W_from, p_W_from + length * direction_W, radius, 0.85 * radius};
}

} // namespace

RigidTransform windpipeInAnatomy()
{
    return {rotationFromVector(degrees(12.0).si * Vec3::UnitX()), Vec3::Zero()};
}

AirwaySolid::AirwaySolid(const PatientDimensions& dimensions)
    : m_dimensions(dimensions),
      m_X_AW(windpipeInAnatomy()),
      m_X_WA(m_X_AW.inverse()),
      m_scale(dimensions.tracheaLength / dimensionsOf(BuiltinPatient::Adult).tracheaLength),
      m_right(branchesOf(Side::Right)),
      m_left(branchesOf(Side::Left))
{
}

AirwaySolid::Branches AirwaySolid::branchesOf(Side side) const
{
    const bool right = side == Side::Right;
    const MainBronchusDimensions& main =
        right ? m_dimensions.rightBronchus : m_dimensions.leftBronchus;
    const double sign = right ? -1.0 : 1.0;
    const double radius = 0.5 * main.diameter.si;
    const double mm = kMillimetre * m_scale;

    Branches b;
    b.direction_W = downAndAside(main.fromTrachea, sign, {});
    // From the place on the trachea's axis from which the inner wall runs through the carina.
    // Wider ones than the trachea's upper end would have are so in front, as the trachea.
    const double narrower = (m_dimensions.upperTrachea.sagittal + m_dimensions.upperTrachea.coronal)
                            / (m_dimensions.tracheaSagittal + m_dimensions.tracheaCoronal);
    const double forward = (1.0 - narrower) * radius;
    const Vec3 start{0.0, -forward, radius / std::sin(main.fromTrachea.si)};
    const double toCarina = radius / std::tan(main.fromTrachea.si);
    const Vec3 end = start + (toCarina + main.length.si) * b.direction_W;
    b.rods[0] = {start, end, radius, radius};
    const Angle upperLobe = main.fromTrachea + degrees(right ? 62.0 : 50.0);
    b.rods[1] =
        branch(end, downAndAside(upperLobe, sign, degrees(-12.0)), 20.0 * mm, 0.66 * radius);
    if (right) {
        const Vec3 intermedius = downAndAside(degrees(22.0), sign, degrees(8.0));
        b.rods[2] = branch(end, intermedius, 44.0 * mm, 0.80 * radius);
        b.rods[3] =
            branch(end + 22.0 * mm * intermedius, downAndAside(degrees(35.0), sign, degrees(-45.0)),
                   20.0 * mm, 0.55 * radius);
    } else {
        b.rods[2] =
            branch(end, downAndAside(degrees(25.0), sign, degrees(15.0)), 30.0 * mm, 0.76 * radius);
        b.rods[3] =
            branch(end + 9.0 * mm * downAndAside(upperLobe, sign, degrees(-12.0)),
                   downAndAside(degrees(50.0), sign, degrees(-40.0)), 22.0 * mm, 0.50 * radius);
    }
    return b;
}

double AirwaySolid::belowUpperEnd(double z) const
{
    const double narrow = m_dimensions.tracheaLength.si - kOpenEnd * m_scale;
    return easedStep(narrow, narrow - kWidens * m_scale, z);
}

/// Less again above the bronchi, which are not as deep: by how much is of ours.
double AirwaySolid::deeperAt(double z) const
{
    const double aboveCarina = 0.6 + 0.4 * easedStep(0.0, 25.0 * kMillimetre * m_scale, z);
    return aboveCarina * belowUpperEnd(z)
           * (m_dimensions.tracheaSagittal - m_dimensions.upperTrachea.sagittal).si;
}

double AirwaySolid::tracheaDistance(const Vec3& p_WQ) const
{
    const double blend = 2.0 * kMillimetre * m_scale;
    const PatientDimensions& d = m_dimensions;
    const double wider = belowUpperEnd(p_WQ.z()) * (d.tracheaCoronal - d.upperTrachea.coronal).si;
    const double side = 0.5 * (d.upperTrachea.coronal.si + wider);
    // An ellipse cut flat at the back, at three quarters of its half depth; the axis runs midway
    // between front and back of the upper end. Behind lie oesophagus and spine, so it is deeper to
    // the front.
    const double deeper = deeperAt(p_WQ.z());
    const double halfDepth = (d.upperTrachea.sagittal.si + deeper) / 1.75;
    const double back = 0.875 * halfDepth;
    const double y = p_WQ.y() + 0.5 * deeper;
    const double spacing = d.tracheaLength.si / d.tracheaRings;
    // The open ends of a cartilage lie at the edges of the flat wall.
    const double cartilage = 1.0 - easedStep(0.35 * back, 0.95 * back, y);
    const double ring =
        kRingHeight * m_scale * cartilage * ripple(p_WQ.z() - 0.5 * spacing, spacing);
    const double round =
        ellipseDistance({p_WQ.x(), y - 0.125 * halfDepth}, {side, halfDepth}) - ring;
    const double tube = roundedMax(round, y - back, blend);
    const double ends = std::max(p_WQ.z() - d.tracheaLength.si, blend - p_WQ.z());
    return roundedMax(tube, ends, 0.5 * blend);
}

double AirwaySolid::bronchusDistance(Side side, const Vec3& p_WQ) const
{
    const Branches& b = side == Side::Right ? m_right : m_left;
    const double blend = 3.0 * kMillimetre * m_scale;
    const AirwayRod& main = b.rods[0];
    const double along = (p_WQ - main.p_W_from).dot(b.direction_W);
    const double ring = kRingHeightBronchi * m_scale * ripple(along, kRingSpacingBronchi * m_scale);
    double distance =
        rodDistance(p_WQ, main.p_W_from, main.p_W_to, main.radiusFrom, main.radiusTo) - ring;
    for (std::size_t i = 1; i < b.rods.size(); ++i) {
        const AirwayRod& rod = b.rods[i];
        distance = roundedMin(
            distance, rodDistance(p_WQ, rod.p_W_from, rod.p_W_to, rod.radiusFrom, rod.radiusTo),
            blend);
    }
    return distance;
}

double AirwaySolid::wholeDistance(const Vec3& p_WQ) const
{
    const double both =
        std::min(bronchusDistance(Side::Right, p_WQ), bronchusDistance(Side::Left, p_WQ));
    return roundedMin(tracheaDistance(p_WQ), both, 4.0 * kMillimetre * m_scale);
}

double AirwaySolid::lumenDistance(const Vec3& p_WQ) const
{
    // As below its upper end, which is open.
    const double open = m_dimensions.tracheaLength.si - kOpenEnd * m_scale;
    const Vec3 p{p_WQ.x(), p_WQ.y(), std::min(p_WQ.z(), open)};
    return wholeDistance(p) + kMansTracheaWall.si * m_scale;
}

double AirwaySolid::territory(Side side, const Vec3& p_WQ) const
{
    const Branches& own = side == Side::Right ? m_right : m_left;
    const Branches& other = side == Side::Right ? m_left : m_right;
    const Vec3 towardsOther = (other.direction_W - own.direction_W).normalized();
    return std::max(-p_WQ.dot(own.direction_W), p_WQ.dot(towardsOther));
}

Box AirwaySolid::boundsInA(const Box& bounds_W) const
{
    Box bounds;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p_WQ{(corner & 1) != 0 ? bounds_W.max.x() : bounds_W.min.x(),
                        (corner & 2) != 0 ? bounds_W.max.y() : bounds_W.min.y(),
                        (corner & 4) != 0 ? bounds_W.max.z() : bounds_W.min.z()};
        bounds.include(m_X_AW * p_WQ);
    }
    return bounds;
}

ImplicitShape AirwaySolid::trachea() const
{
    const double side = 1.5 * m_dimensions.tracheaCoronal.si;
    const double depth = m_dimensions.tracheaSagittal.si;
    Box bounds_W;
    bounds_W.include(Vec3{-side, -depth, -5.0 * kMillimetre});
    bounds_W.include(Vec3{side, depth, m_dimensions.tracheaLength.si});
    const auto distance = [solid = *this](const Vec3& p_A) {
        const Vec3 p_WQ = solid.m_X_WA * p_A;
        return std::max({solid.wholeDistance(p_WQ), -solid.territory(Side::Right, p_WQ),
                         -solid.territory(Side::Left, p_WQ), -solid.lumenDistance(p_WQ)});
    };
    return {boundsInA(bounds_W), distance};
}

ImplicitShape AirwaySolid::bronchus(Side side) const
{
    Box bounds_W;
    for (const AirwayRod& rod : (side == Side::Right ? m_right : m_left).rods) {
        const Vec3 reach = Vec3::Constant(rod.radiusFrom + 2.0 * kMillimetre);
        for (const Vec3& p_W : {rod.p_W_from, rod.p_W_to}) {
            bounds_W.include(p_W - reach);
            bounds_W.include(p_W + reach);
        }
    }
    const auto distance = [solid = *this, side](const Vec3& p_A) {
        const Vec3 p_WQ = solid.m_X_WA * p_A;
        return std::max(solid.wholeDistance(p_WQ), solid.territory(side, p_WQ));
    };
    return {boundsInA(bounds_W), distance};
}

double AirwaySolid::outsideLungs(const Vec3& p_A) const
{
    const Vec3 p_WQ = m_X_WA * p_A;
    double distance = tracheaDistance(p_WQ);
    for (const Branches* b : {&m_right, &m_left}) {
        const AirwayRod& main = b->rods[0];
        distance = std::min(distance, rodDistance(p_WQ, main.p_W_from, main.p_W_to, main.radiusFrom,
                                                  main.radiusTo));
    }
    return distance;
}

} // namespace carina
