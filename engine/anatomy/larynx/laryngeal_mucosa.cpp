#include "engine/anatomy/larynx/laryngeal_mucosa.h"

#include "engine/anatomy/larynx/laryngeal_cavity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr Length kMucosaVoxel = millimetres(1.0);
constexpr Length kFoldVoxel = millimetres(0.65);
constexpr Length kVocalFoldVoxel = millimetres(0.45);
constexpr Length kRimVoxel = millimetres(0.85);
constexpr double kLining = 2.6;     ///< thickness of the mucosa within the cricoid
constexpr double kStandsOut = 0.35; ///< of a fold from the mucosa below it

/// Where the white vocal fold ends behind: a little behind the tip of the vocal process, so that
/// it is as long as measured at surgery (14.8 +- 3.0 mm in men, Jibi Inkoka Keibu 125(6)) or little
/// longer.
constexpr double kBackOfFold = kVocalProcess_mm + 2.6;

/// Where the edge of the entrance runs on one side, from the back to the epiglottis: y, and height.
struct RimPoint {
    double y, z;
};

constexpr RimPoint kCorniculate{11.2, 10.2};
constexpr RimPoint kCuneiform{4.8, 12.6};

/// The height of the aryepiglottic fold's edge at y.
double rimHeight(double y, const Epiglottis& epiglottis)
{
    constexpr double kAttached = 25.0; // of the epiglottis' edge
    const std::array points{
        RimPoint{15.0, 7.5},
        kCorniculate,
        RimPoint{8.0, 10.0},
        kCuneiform,
        RimPoint{1.0, 13.2},
        RimPoint{std::min(epiglottis.middleAt(kAttached) + 2.0, -5.0), kAttached}};
    for (std::size_t i = 1; i < points.size(); ++i)
        if (y > points[i].y || i + 1 == points.size()) {
            const RimPoint& a = points[i - 1];
            const RimPoint& b = points[i];
            return a.z + std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.3) * (b.z - a.z);
        }
    return 0.0;
}

double outerHalfWidth(double y)
{
    constexpr std::array<std::array<double, 2>, 6> kAt{
        {{-14.0, 10.8}, {-6.0, 11.8}, {0.0, 11.9}, {6.0, 10.9}, {11.0, 8.8}, {15.0, 6.3}}};
    if (y <= kAt.front()[0])
        return kAt.front()[1];
    for (std::size_t i = 1; i < kAt.size(); ++i)
        if (y < kAt[i][0]) {
            const double t = (y - kAt[i - 1][0]) / (kAt[i][0] - kAt[i - 1][0]);
            return kAt[i - 1][1] + t * (kAt[i][1] - kAt[i - 1][1]);
        }
    return kAt.back()[1];
}

double ellipsoidAt(const Vec3& p, const Vec3& middle, const Vec3& radii)
{
    return ellipsoidDistance(Vec3{std::abs(p.x()), p.y(), p.z()} - middle, radii);
}

double cuneiform(const Vec3& p, double more)
{
    return ellipsoidAt(p, {9.0, kCuneiform.y, kCuneiform.z - 2.4},
                       Vec3{1.6, 2.0, 3.2} + Vec3::Constant(more));
}

double corniculate(const Vec3& p, double more)
{
    return ellipsoidAt(p, {4.4, kCorniculate.y, kCorniculate.z - 1.4},
                       Vec3{1.7, 1.8, 2.4} + Vec3::Constant(more));
}

/// What covers the front of the arytenoid cartilage: from its vocal process, where the vocal fold
/// ends, up to the corniculate tubercle.
double arytenoidRidge(const Vec3& p)
{
    return rodDistance({std::abs(p.x()), p.y(), p.z()}, {5.8, 2.0, 0.6},
                       {5.2, kCorniculate.y - 1.0, kCorniculate.z - 2.4}, 1.5, 2.4);
}

struct Mucosa {
    LaryngealCavity cavity;
    Epiglottis epiglottis;

    /// Where the vestibule ends in front: just behind the middle of the epiglottis, beside which
    /// its wall (the quadrangular membrane) goes on to the aryepiglottic folds, and below its foot
    /// at the thyroid cartilage.
    [[nodiscard]] double frontOfVestibule(double z) const
    {
        constexpr double kBehindMiddle = 1.0;
        constexpr double kAtThyroid = -16.0;
        const double leaf = epiglottis.middleAt(z) + kBehindMiddle;
        return kAtThyroid + easedStep(2.8, 8.5, z) * (leaf - kAtThyroid);
    }

    /// The air of the larynx, which ends at the epiglottis.
    [[nodiscard]] double air(const Vec3& p) const
    {
        const double rise = frontOfVestibule(p.z() + 0.5) - frontOfVestibule(p.z() - 0.5);
        const double front = (frontOfVestibule(p.z()) - p.y()) / std::hypot(1.0, rise);
        return roundedMax(cavity.distance(p), front, 1.0);
    }

    [[nodiscard]] double wall(const Vec3& p) const
    {
        const double body = laryngealBody(p, epiglottis);
        const double within = std::max(cavity.distance(p) - kLining, p.z() + 4.0);
        const double solid = roundedMin(body, within, 2.0);
        const double ends = kTracheaTop_mm - p.z();
        const double hollow = roundedMax(solid, -air(p), 1.4);
        return std::max(roundedMin(hollow, arytenoidRidge(p), 2.0), ends);
    }

    /// White, from the commissure to the vocal process: a band along the cords' edge that is as
    /// wide everywhere, round at that edge and steep on its other side, where it dips into the
    /// floor of the ventricle. In front it goes on a little beyond the midline, into that of the
    /// other side, and around the commissure.
    [[nodiscard]] double vocalFold(const Vec3& p) const
    {
        constexpr double kOuter = 1.65; // of the cavity's distance at the cords' level: 2.7 mm wide
        constexpr double kBelow = -2.2;
        constexpr double kFloor = 0.8; // of the ventricle beside the cords' edge
        constexpr double kRise = 0.33; // of that floor from there, with the cavity's distance
        constexpr double kAboveFloor = 0.5;
        constexpr double kBeyondMidline = 0.8;
        const double aside = cavity.distance({p.x(), p.y(), 0.0});
        const double top = kFloor + kRise * aside + kAboveFloor;
        const double across = std::max(-kStandsOut - aside, aside - kOuter);
        const double along = std::max(kCommissure_mm - 1.7 - p.y(), p.y() - kBackOfFold);
        const double section = roundedMax(across, std::max(p.z() - top, kBelow - p.z()), 1.2);
        return roundedMax(roundedMax(section, along, 1.6), -kBeyondMidline - p.x(), 0.6);
    }

    /// Of the wall above the ventricle, a band to either side.
    [[nodiscard]] double vestibularFold(const Vec3& p) const
    {
        constexpr double kDeep = 2.2;
        const double c = cavity.distance(p);
        const double within = roundedMax(-kStandsOut - c, c - kDeep, 0.8);
        const double band = std::max(3.6 - p.z(), p.z() - 8.2);
        const double along = std::max(-12.4 - p.y(), p.y() - 4.5);
        const double strip = roundedMax(within, roundedMax(band, along, 1.0), 0.8);
        return roundedMax(strip, 0.4 - p.x(), 0.6);
    }

    /// The surface of the wall as far as a solid reaches on one side.
    [[nodiscard]] double capWithin(const Vec3& p, double solid) const
    {
        return roundedMax(std::abs(wall(p) + 0.6) - 0.6 - 1.4 * kStandsOut, std::max(solid, -p.x()),
                          0.6);
    }

    /// The strip along the edge of the entrance. Behind it ends under the corniculate tubercle and
    /// beside it.
    [[nodiscard]] double aryepiglotticFold(const Vec3& p) const
    {
        const double w = wall(p);
        const double rim = rimHeight(p.y(), epiglottis);
        const double strip = std::max(rim - 6.5 - p.z(), p.y() - 13.6);
        const double inner = 1.8 + 2.6 * easedStep(8.5, kCorniculate.y, p.y());
        const double ends = std::max(epiglottis.middleAt(p.z()) - 0.3 - p.y(), inner - p.x());
        return roundedMax(std::abs(w + 0.6) - 0.6 - kStandsOut, std::max(strip, ends), 0.7);
    }
};

PartPlan plan(const char* name, PartRole role, const char* concept_, const LarynxFrame& frame,
              const Box& box, Length voxel, Implicit local)
{
    return {name, role, concept_, frame.inAnatomy(box, std::move(local)),
            1e3 * frame.unit() * voxel};
}

/// A part on one side, from a function of the left half.
template <class Half>
PartPlan onSide(const char* name, const char* concept_, PartRole role, const LarynxFrame& frame,
                double sign, Box left, Length voxel, Half half)
{
    if (sign < 0.0)
        left = {Vec3{-left.max.x(), left.min.y(), left.min.z()},
                Vec3{-left.min.x(), left.max.y(), left.max.z()}};
    const std::string whole = std::string{sign > 0.0 ? "Left " : "Right "}.append(name);
    return plan(whole.c_str(), role, concept_, frame, left, voxel, [sign, half](const Vec3& p) {
        return half({sign * p.x(), p.y(), p.z()});
    });
}

} // namespace

double laryngealBody(const Vec3& p, const Epiglottis& epiglottis)
{
    const double x = std::abs(p.x());
    // Behind the epiglottis, whose foot is embedded; below it behind the thyroid cartilage.
    const double front = std::max(-15.5, epiglottis.middleAt(p.z()) - 0.7
                                             - 12.0 * (1.0 - easedStep(4.0, 17.0, p.z())));
    const double sides = x - outerHalfWidth(p.y());
    // Between the tubercles the edge dips into the interarytenoid notch.
    const double notch = 7.0 * (1.0 - easedStep(0.8, 3.6, x)) * easedStep(7.0, 9.5, p.y());
    const double top = 0.8 * (p.z() - rimHeight(p.y(), epiglottis) + notch);
    const double walls = roundedMax(sides, std::max(front - p.y(), p.y() - 14.2), 3.0);
    const double body = roundedMax(walls, std::max(top, -34.0 - p.z()), 2.6);
    return roundedMin(roundedMin(body, cuneiform(p, 0.0), 2.6), corniculate(p, 0.0), 2.6);
}

std::vector<PartPlan> laryngealMucosa(const BodyPlan& plan_, const LarynxFrame& frame,
                                      const Epiglottis& epiglottis)
{
    const PatientDimensions& d = plan_.dimensions;
    const UpperTrachea& upper = d.upperTrachea;
    const Vec2 trachea =
        0.5 * Vec2{upper.coronal.si, upper.sagittal.si} / frame.unit() - Vec2::Constant(1.6);
    const Mucosa mucosa{LaryngealCavity{trachea}, epiglottis};
    std::vector<PartPlan> parts;
    parts.push_back(plan("Laryngeal mucosa", PartRole::LaryngealMucosa, "", frame,
                         {Vec3{-14, -19, -27}, Vec3{14, 17, 30}}, kMucosaVoxel,
                         [mucosa](const Vec3& p) { return mucosa.wall(p); }));
    for (const double sign : {1.0, -1.0}) {
        const Box box{Vec3{-1, -16, -8}, Vec3{14, 16, 30}};
        parts.push_back(onSide("vocal fold", "", PartRole::VocalFold, frame, sign, box,
                               kVocalFoldVoxel,
                               [mucosa](const Vec3& p) { return mucosa.vocalFold(p); }));
        parts.push_back(onSide("vestibular fold", "", PartRole::LaryngealMucosa, frame, sign, box,
                               kFoldVoxel,
                               [mucosa](const Vec3& p) { return mucosa.vestibularFold(p); }));
        parts.push_back(onSide("aryepiglottic fold", "", PartRole::LaryngealMucosa, frame, sign,
                               box, kRimVoxel,
                               [mucosa](const Vec3& p) { return mucosa.aryepiglotticFold(p); }));
        parts.push_back(onSide(
            "cuneiform tubercle", "", PartRole::LaryngealMucosa, frame, sign, box, kFoldVoxel,
            [mucosa](const Vec3& p) { return mucosa.capWithin(p, cuneiform(p, 1.3)); }));
        parts.push_back(onSide(
            "corniculate tubercle", "", PartRole::LaryngealMucosa, frame, sign, box, kFoldVoxel,
            [mucosa](const Vec3& p) { return mucosa.capWithin(p, corniculate(p, 1.3)); }));
    }
    return parts;
}

} // namespace carina
