#include "engine/anatomy/mouth/fauces_shape.h"

#include "engine/anatomy/shapes/strand.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace carina
{
namespace
{

/// Written in reference millimetres (BodyPlan) from the edge of the upper incisors.

constexpr Length kPalateVoxel = millimetres(1.6);
constexpr Length kArchVoxel = millimetres(1.3);

/// Where the uvula hangs from the middle of the soft palate.
const Vec3 kUvulaRoot{0.0, 67.5, 11.0};

/// A part stops this far within what it joins.
constexpr double kWithinWall = 2.2;
/// A fillet begins this far below the surface of what a part joins, so that its rim is not seen.
constexpr double kUnderSurface = 0.4;

/// A profile as the throat of a patient is drawn out, with smooth bends.
std::vector<Vec2> profileIn(std::vector<Vec2> profile, double throat)
{
    std::vector<Vec3> points;
    for (const Vec2& p : profile) {
        const double behind = std::max(p.x() - BodyPlan::kBehindPalate_mm, 0.0);
        points.emplace_back(0.0, p.x() + (throat - 1.0) * behind, p.y());
    }
    std::vector<Vec2> line;
    for (const Vec3& p : smoothThrough(points, 4))
        line.emplace_back(p.y(), p.z());
    return line;
}

/// From within the hard palate to below the free edge: a double arch beside the uvula.
Curtain softPalateOf(double throat)
{
    return {profileIn({Vec2{37, 23}, Vec2{44, 22}, Vec2{52, 20.6}, Vec2{59, 18.4}, Vec2{65, 14.5},
                       Vec2{69, 9}},
                      throat),
            cornersCut({Vec2{-9, -60}, Vec2{-9, 7.2}, Vec2{0, 7.2}, Vec2{2.5, 7.8}, Vec2{4.6, 9.6},
                        Vec2{6.8, 10.4}, Vec2{9, 9.8}, Vec2{11, 8.4}, Vec2{14, 7}, Vec2{30, 6},
                        Vec2{30, -60}},
                       2),
            2.0, 2.8};
}

Curtain palatoglossalOf(double throat)
{
    return {
        profileIn({Vec2{59.5, 20}, Vec2{57.5, 16}, Vec2{54.8, 10}, Vec2{51.5, 3}, Vec2{48.3, -4},
                   Vec2{45.4, -10}, Vec2{43.2, -16}, Vec2{42, -22}, Vec2{41.5, -32}},
                  throat),
        cornersCut({Vec2{-9, -60}, Vec2{-9, 16.6}, Vec2{0, 16.6}, Vec2{4, 16}, Vec2{8, 14.4},
                    Vec2{11.4, 11.4}, Vec2{14.2, 7.4}, Vec2{15.7, 3}, Vec2{16, -2}, Vec2{15.4, -7},
                    Vec2{13.6, -11.5}, Vec2{11.6, -14}, Vec2{11.2, -17}, Vec2{12, -21},
                    Vec2{15, -26}, Vec2{21, -32}, Vec2{21, -60}},
                   2),
        1.5, 2.0};
}

Curtain palatopharyngealOf(double throat)
{
    return {
        profileIn({Vec2{61, 17.6}, Vec2{65, 14.5}, Vec2{68.6, 9.5}, Vec2{70, 4}, Vec2{69.8, -3},
                   Vec2{69.3, -12}, Vec2{69.5, -28}},
                  throat),
        cornersCut({Vec2{-9, -60}, Vec2{-9, 11.2}, Vec2{4.5, 11.6}, Vec2{7, 11.4}, Vec2{9.3, 9.6},
                    Vec2{11.4, 5.9}, Vec2{12.9, 1}, Vec2{13.8, -4}, Vec2{14.4, -10}, Vec2{15, -16},
                    Vec2{16.4, -22}, Vec2{19, -28}, Vec2{19, -60}},
                   2),
        1.5, 2.0};
}

/// In its own millimetres, from the edge of the incisors as if it were as large as the face.
double uvulaCone(const Vec3& p)
{
    return std::min(rodDistance(p, kUvulaRoot, {0, 71.2, 3.5}, 4.0, 2.9),
                    rodDistance(p, {0, 71.2, 3.5}, {0, 72.6, -2.8}, 2.9, 1.8));
}

/// The palatine tonsil between both arches, with its crypts left out.
double tonsil(const Vec3& p) { return ellipsoidDistance(p - Vec3{18.6, 60, -4}, {4.2, 6.0, 10.0}); }

/// A solid with a fillet where it meets another one. Of the fillet, and of what lies within the
/// other, it keeps what is `reach` from it or nearer.
double joined(double solid, double other, double fillet, double reach, double rim)
{
    return roundedMax(roundedMin(solid, other, fillet), solid - reach, rim);
}

} // namespace

Fauces::Fauces(const BodyPlan& plan, const LarynxFrame& larynx, const Tongue& tongue)
    : m_plan(plan),
      m_air(plan, larynx),
      m_tongue(tongue),
      m_palate(softPalateOf(plan.throat)),
      m_front(palatoglossalOf(plan.throat)),
      m_back(palatopharyngealOf(plan.throat)),
      m_p_A_uvula(plan.inThroat(kUvulaRoot)),
      m_unitOfUvula(std::min(plan.face, plan.airway))
{
}

/// Not drawn out as BodyPlan::fromThroat is: the curtains are, and keep their thickness so.
Vec3 Fauces::inFront_mm(const Vec3& p_A) const
{
    return (p_A - m_plan.landmarks.p_A_incisors) / m_plan.face;
}

double Fauces::softPalate(const Vec3& p_A) const
{
    // Narrow between the gums, behind them from wall to wall.
    const double half = 16.5 + 9.0 * easedStep(48.0, 62.0, m_plan.fromThroat(p_A).y());
    const Vec3 p = inFront_mm(p_A);
    return m_plan.face * roundedMax(m_palate.distance(p), 0.9 * (std::abs(p.x()) - half), 2.0);
}

/// @param joined_m distance to what it joins beside the wall
/// @param top_mm   level height at which it ends within the palate
double Fauces::archOf(const Curtain& curtain, double joined_m, double top_mm, const Vec3& p_A) const
{
    constexpr double kFillet = 3.0;
    constexpr double kReach = 1.5;
    constexpr double kFromMidline = 3.0; // nearer to it the palate covers it
    constexpr double kWidest = 27.0;     // within the gums and beyond the pharynx' walls
    constexpr double kSinksFrom = 12.0;  // from there to kFromMidline it sinks into the palate
    constexpr double kSinksBy = 1.2;
    const Vec3 p = inFront_mm(p_A);
    const double x = std::abs(p.x());
    const double air = m_air.distance(p_A) / m_plan.face;
    const double other = std::min(-air, joined_m / m_plan.face) + kUnderSurface;
    const double sunk = kSinksBy * (1.0 - easedStep(kFromMidline, kSinksFrom, x));
    const double arch = joined(curtain.distance(p) + sunk, other + sunk, kFillet, kReach, 0.8);
    const double ends = std::max(
        {air - kWithinWall, kFromMidline - x, x - kWidest, Curtain::levelHeight(p) - top_mm});
    return m_plan.face * roundedMax(arch, ends, 1.0);
}

double Fauces::palatoglossalArch(const Vec3& p_A) const
{
    constexpr double kTop = 17.5;
    return archOf(m_front, std::min(softPalate(p_A), m_tongue.distance(p_A)), kTop, p_A);
}

double Fauces::palatopharyngealArch(const Vec3& p_A) const
{
    constexpr double kTop = 13.5;
    return archOf(m_back, softPalate(p_A), kTop, p_A);
}

double Fauces::uvula(const Vec3& p_A) const
{
    constexpr double kFillet = 4.0;
    constexpr double kReach = 1.6;
    const double cone = uvulaCone((p_A - m_p_A_uvula) / m_unitOfUvula + kUvulaRoot);
    const double palate = softPalate(p_A) / m_unitOfUvula + kUnderSurface;
    return m_unitOfUvula * joined(cone, palate, kFillet, kReach, 0.8);
}

PartPlan Fauces::uvulaPart() const
{
    const auto inAnatomy = [this](const Vec3& p) {
        return Vec3{m_p_A_uvula + m_unitOfUvula * (p - kUvulaRoot)};
    };
    return {"Uvula",
            PartRole::Pharynx,
            "",
            {{inAnatomy({-7, 60, -6}), inAnatomy({7, 78, 18})},
             [fauces = *this](const Vec3& p_A) { return fauces.uvula(p_A); }},
            1e3 * m_unitOfUvula * kArchVoxel};
}

std::vector<PartPlan> Fauces::parts() const
{
    const auto within = [this](const Vec3& least, const Vec3& most) {
        return Box{m_plan.inThroat(least), m_plan.inThroat(most)};
    };
    std::vector<PartPlan> parts;
    parts.push_back({"Soft palate",
                     PartRole::Pharynx,
                     "FMA55021",
                     {within({-28, 30, 2}, {28, 74, 30}),
                      [fauces = *this](const Vec3& p_A) { return fauces.softPalate(p_A); }},
                     1e3 * m_plan.face * kPalateVoxel});
    parts.push_back(uvulaPart());
    for (const double sign : {1.0, -1.0}) {
        const std::string side = sign > 0.0 ? "Left " : "Right ";
        const Box box =
            sign > 0.0 ? within({0, 36, -36}, {34, 78, 24}) : within({-34, 36, -36}, {0, 78, 24});
        const auto add = [&](const char* name, double (Fauces::*arch)(const Vec3&) const) {
            const Implicit half = [fauces = *this, arch, sign](const Vec3& p_A) {
                return std::max((fauces.*arch)(p_A), -sign * p_A.x());
            };
            parts.push_back(
                {side + name, PartRole::Pharynx, "", {box, half}, 1e3 * m_plan.face * kArchVoxel});
        };
        add("palatoglossal arch", &Fauces::palatoglossalArch);
        add("palatopharyngeal arch", &Fauces::palatopharyngealArch);
        parts.push_back({side + "palatine tonsil",
                         PartRole::Pharynx,
                         "",
                         {box,
                          [plan = m_plan, sign](const Vec3& p_A) {
                              const Vec3 p = plan.fromThroat(p_A);
                              return plan.face * tonsil({sign * p.x(), p.y(), p.z()});
                          }},
                         1e3 * m_plan.face * kArchVoxel});
    }
    return parts;
}

} // namespace carina
