#include "engine/anatomy/larynx/hyoid_shape.h"

#include "engine/anatomy/airway/pharynx_place.h"
#include "engine/anatomy/shapes/strand.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

/// Written in the millimetres of LarynxFrame.
constexpr Length kHyoidVoxel = millimetres(1.0);
constexpr double kBeforeEpiglottis = 13.6; ///< of the middle of the body
constexpr double kHalfBody = 6.0;          ///< of its middle line; its ends are round
constexpr double kHornRoot = 9.0;
constexpr double kBodyHigh = 4.8;
constexpr double kBodyThick = 2.7;
constexpr double kHornRadius = 2.1;
constexpr double kTipRadius = 2.4;

/// Half the thickness of the pharynx' wall, and the room beside it.
constexpr double kHalfPharynxWall = 1.7;
constexpr double kBesidePharynx = 0.5;
/// Higher up the pharynx is wider than the horns reach; reference millimetres above the cords.
constexpr double kHighestHorn = 42.0;
/// The palatopharyngeal arches: their foot, and how far aside they reach; reference millimetres of
/// the face. In children they lead down past the horns.
constexpr double kFootOfArches = -24.5;
constexpr double kBesideArches = 22.2;

/// How high the body lies above the cords: at rest as in the man of BodyParts3D; lower with the
/// mouth held open, below its floor (Muto and Kanazawa 1994: down and back).
double hyoidLevel(Posture posture) { return posture == Posture::Rest ? 28.0 : 21.5; }

/// Lengthens the way from the midline so that a rod of this radius keeps clear of the pharynx and
/// the arches of the palate, and keeps it below where the pharynx widens. Metres.
Vec3 besidePharynx(const BodyPlan& plan, Vec3 p_A, double radius)
{
    const PharynxPlace place{plan};
    p_A.z() = std::min(p_A.z(), place.inAnatomy({0.0, 0.0, kHighestHorn}).z());
    const double z = place.inHis(p_A).z();
    const double half = pharynxSectionAt(z).halfWidth + kHalfPharynxWall + kBesidePharynx;
    double beside = place.inAnatomy({half, 0.0, z}).x();
    if (p_A.z() > plan.inFace({0.0, 0.0, kFootOfArches}).z())
        beside = std::max(beside, plan.face * kBesideArches);
    p_A.x() = std::max(p_A.x(), beside + radius);
    return p_A;
}

/// Both halves are one half mirrored; frame A, metres.
struct Hyoid {
    Strand body;
    std::vector<Vec3> horn;
    std::vector<double> hornRadii;
    std::array<Vec3, 2> lesserHorn;
    double unit;

    Hyoid(const BodyPlan& plan, const LarynxFrame& frame, const Epiglottis& epiglottis)
        : Hyoid(plan, frame, epiglottis.middleAt(hyoidLevel(plan.posture)) - kBeforeEpiglottis,
                hyoidLevel(plan.posture))
    {
    }

    [[nodiscard]] double distance(const Vec3& p_A) const
    {
        const Vec3 p{std::abs(p_A.x()), p_A.y(), p_A.z()};
        const double horns =
            std::min(tubeDistance(p, horn, hornRadii),
                     rodDistance(p, lesserHorn[0], lesserHorn[1], 2.0 * unit, 1.4 * unit));
        return roundedMin(body.distance(p), horns, 1.5 * unit);
    }

    [[nodiscard]] Box bounds() const
    {
        Box box = body.bounds();
        for (const Vec3& p : horn) {
            const Vec3 reach = Vec3::Constant(kTipRadius * unit);
            for (const Vec3& at : {p, Vec3{-p.x(), p.y(), p.z()}}) {
                box.include(at - reach);
                box.include(at + reach);
            }
        }
        box.max.z() = std::max(box.max.z(), lesserHorn[1].z() + kTipRadius * unit);
        return box;
    }

private:
    Hyoid(const BodyPlan& plan, const LarynxFrame& frame, double front, double level)
        : body(bodyOf(frame, front, level)),
          lesserHorn{frame.inAnatomy(Vec3{kHornRoot + 1.0, front + 2.4, level + 3.0}),
                     frame.inAnatomy(Vec3{kHornRoot + 2.5, front + 4.0, level + 7.0})},
          unit(frame.unit())
    {
        const double radius = kHornRadius * unit;
        const auto at = [&](double x, double back, double up) {
            return frame.inAnatomy(Vec3{x, front + back, level + up});
        };
        const Vec3 root = at(kHornRoot, 1.4, 0.4);
        // The arches of a throat that is drawn out reach farther forward.
        const Vec3 side = besidePharynx(plan, at(15.0, 9.0 / plan.throat, 0.3), radius);
        const Vec3 bend = 0.5 * (root + side) + 1.5 * unit * Vec3{1.0, -1.0, 0.0};
        const Vec3 tip = besidePharynx(plan, at(16.5, 31.0, 0.5), kTipRadius * unit);
        horn = smoothThrough(
            std::array{root, bend, side, besidePharynx(plan, at(16.0, 22.0, 0.2), radius), tip}, 4);
        hornRadii.assign(horn.size(), radius);
        hornRadii.back() = kTipRadius * unit;
    }

    static Strand bodyOf(const LarynxFrame& frame, double front, double level)
    {
        std::vector<StrandPoint> points;
        const double u = frame.unit();
        for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            const Vec3 p{kHalfBody * x, front + 1.4 * x * x, level + 0.4 * x * x};
            const Vec3 ahead = frame.inAnatomy(p - Vec3::UnitY()) - frame.inAnatomy(p);
            points.push_back(
                {frame.inAnatomy(p), kBodyHigh * u, kBodyThick * u, ahead.normalized()});
        }
        return Strand{std::move(points)};
    }
};

} // namespace

PartPlan hyoid(const BodyPlan& plan, const LarynxFrame& frame, const Epiglottis& epiglottis)
{
    const Hyoid bone{plan, frame, epiglottis};
    return {"Hyoid bone",
            PartRole::Hyoid,
            "FMA52749",
            {bone.bounds(), [bone](const Vec3& p_A) { return bone.distance(p_A); }},
            1e3 * frame.unit() * kHyoidVoxel};
}

} // namespace carina
