#include "evaluation/intubation/motion_patient.h"

#include "engine/anatomy/airway/airway_path.h"
#include "engine/anatomy/shapes/strand.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr Length kWaySpacing = millimetres(2.0);
constexpr int kPiecesBetween = 8; ///< of a smooth curve, between two of its points

// Shares of the way from the glottis to the carina: of ours, within the main bronchi of a man (25
// and 50 mm to 127).
constexpr double kLeavesTrachea = 0.14; ///< above the carina
constexpr double kFirstShell = 0.12;    ///< distances from the carina
constexpr double kSecondShell = 0.18;
constexpr double kShellHalf = 0.02;
constexpr double kBeyond = 0.15; ///< straight on

// Of an adult's larynx.
constexpr Length kBehindNotch = millimetres(6.0);
constexpr Length kBesideNotch = millimetres(4.0);
constexpr Length kAboveNotch = millimetres(2.0);
constexpr Length kSection = millimetres(6.0); ///< of the oesophagus

// How far walls are from the middle of a way: of ours, from the usual sizes of adults.
constexpr Length kMostInThroat = millimetres(20.0);
constexpr Length kMostInWindpipe = millimetres(12.0);
constexpr Length kMainBronchus = millimetres(6.5);
constexpr Length kOpenedOesophagus = millimetres(8.0); ///< as far as a tube dilates it
constexpr Length kAtCarina = millimetres(12.0); ///< whose ridge a tube passes: nothing is measured

/// The mean of some places, of which at least kLeastPlaces are needed.
class MeanPlace
{
public:
    void add(const Vec3& p)
    {
        m_sum += p;
        ++m_count;
    }
    [[nodiscard]] std::optional<Vec3> mean() const
    {
        constexpr int kLeastPlaces = 8;
        return m_count < kLeastPlaces ? std::nullopt : std::optional{Vec3{m_sum / m_count}};
    }

private:
    Vec3 m_sum = Vec3::Zero();
    int m_count = 0;
};

/// The mean of a main bronchus' surface at a distance from the carina.
std::optional<Vec3> bronchusAt(const Anatomy& anatomy, Side side, double distance, double half)
{
    const PartRole role =
        side == Side::Right ? PartRole::RightMainBronchus : PartRole::LeftMainBronchus;
    MeanPlace mean;
    for (const AnatomyPart& part : anatomy.parts)
        if (part.role == role)
            for (const Vec3f& p : part.levels.front().positions) {
                const Vec3 p_A = p.cast<double>();
                if (std::abs((p_A - anatomy.landmarks.p_A_carina).norm() - distance) < half)
                    mean.add(p_A);
            }
    return mean.mean();
}

/// The means of the oesophagus' sections across z, from its upper end down.
std::vector<Vec3> oesophagusLine(const Anatomy& anatomy)
{
    std::vector<Vec3> all;
    for (const AnatomyPart& part : anatomy.parts)
        if (part.role == PartRole::Oesophagus)
            for (const Vec3f& p : part.levels.front().positions)
                all.push_back(p.cast<double>());
    std::ranges::sort(all, std::ranges::greater{}, [](const Vec3& p) { return p.z(); });
    std::vector<Vec3> line;
    for (std::size_t i = 0; i < all.size();) {
        const double lowest = all[i].z() - kSection.si;
        MeanPlace section;
        for (; i < all.size() && all[i].z() > lowest; ++i)
            section.add(all[i]);
        if (const auto mean = section.mean())
            line.push_back(*mean);
    }
    return line;
}

double alongNearest(std::span<const Vec3> line, const Vec3& p)
{
    const auto nearest =
        std::ranges::min_element(line, {}, [&p](const Vec3& q) { return (q - p).squaredNorm(); });
    return lengthOf(line.first(std::size_t(nearest - line.begin()) + 1)).si;
}

/// Where a line comes through a plane first, above it before.
double alongAtPlane(std::span<const Vec3> line, double from, const Vec3& p, const Vec3& up)
{
    double along = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double step = (line[i] - line[i - 1]).norm();
        const double before = up.dot(line[i - 1] - p);
        const double after = up.dot(line[i] - p);
        if (along >= from && before > 0.0 && after <= 0.0)
            return along + step * before / (before - after);
        along += step;
    }
    return along;
}

/// The beginning of a line up to an arc length.
Centreline beginningOf(std::span<const Vec3> line, double until)
{
    Centreline beginning{line.front()};
    double along = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        along += (line[i] - line[i - 1]).norm();
        if (along > until - 0.5 * kWaySpacing.si)
            break;
        beginning.push_back(line[i]);
    }
    beginning.push_back(pointAlong(line, metres(until)));
    return beginning;
}

/// A line up to an arc length, and from there a smooth curve through further places. The place
/// before the last of the line gives the curve its direction.
Centreline branching(std::span<const Vec3> line, double until, std::span<const Vec3> further)
{
    Centreline whole = beginningOf(line, until);
    constexpr double kBefore = 0.01;
    std::vector<Vec3> knots{pointAlong(line, metres(until - kBefore)), whole.back()};
    knots.insert(knots.end(), further.begin(), further.end());
    const std::vector<Vec3> smooth = smoothThrough(knots, kPiecesBetween);
    whole.insert(whole.end(), smooth.begin() + kPiecesBetween + 1, smooth.end());
    return whole;
}

TipWay wayAlong(Centreline line_A, const TipWay& trachea, double gate)
{
    TipWay way{
        .line_A = std::move(line_A), .teeth = trachea.teeth, .fork = trachea.fork, .gate = gate};
    way.end = lengthOf(way.line_A).si;
    return way;
}

TipWay tracheaWay(const Anatomy& anatomy, const UpperAirway& upper)
{
    const AirwayLandmarks& l = anatomy.landmarks;
    TipWay way{.line_A = l.path_A};
    way.teeth = alongNearest(way.line_A, l.p_A_incisors);
    way.gate = alongNearest(way.line_A, l.p_A_glottis);
    way.end = lengthOf(way.line_A).si;
    way.carina = way.end;
    way.fork = way.gate - upper.larynxSize() * kForkAboveGlottis.si;
    return way;
}

Result<TipWay> bronchusWay(const Anatomy& anatomy, const TipWay& trachea, Side side)
{
    const double size = trachea.carina - trachea.gate;
    const auto first = bronchusAt(anatomy, side, kFirstShell * size, kShellHalf * size);
    const auto second = bronchusAt(anatomy, side, kSecondShell * size, kShellHalf * size);
    if (!first || !second)
        return fail(Errc::NoAirway, "it has no main bronchi");
    const Vec3 beyond = *second + kBeyond * size * (*second - *first).normalized();
    TipWay way = wayAlong(branching(trachea.line_A, trachea.carina - kLeavesTrachea * size,
                                    std::array{*first, *second, beyond}),
                          trachea, trachea.gate);
    const Vec3 up =
        (pointAlong(trachea.line_A, metres(trachea.carina - 0.2 * size)) - trachea.line_A.back())
            .normalized();
    way.carina = alongAtPlane(way.line_A, way.gate, anatomy.landmarks.p_A_carina, up);
    return way;
}

Result<TipWay> oesophagusWay(const Anatomy& anatomy, const UpperAirway& upper,
                             const TipWay& trachea)
{
    const std::vector<Vec3> line = oesophagusLine(anatomy);
    constexpr std::size_t kLeastSections = 4;
    if (line.size() < kLeastSections)
        return fail(Errc::NoAirway, "it has no oesophagus");
    std::vector<Vec3> further{upper.p_A_notch
                              - upper.larynxSize() * kBehindNotch.si * upper.forward_A()};
    further.insert(further.end(), line.begin(), line.end());
    TipWay way = wayAlong(branching(trachea.line_A, trachea.fork, further), trachea, 0.0);
    way.gate = alongAtPlane(way.line_A, way.fork, anatomy.landmarks.p_A_glottis, upper.up_A);
    return way;
}

TipWay arytenoidWay(const UpperAirway& upper, const TipWay& trachea)
{
    const double size = upper.larynxSize();
    const Vec3 right_A = -Vec3::UnitX();
    const Vec3 onIt =
        upper.p_A_notch + size * (kBesideNotch.si * right_A + kAboveNotch.si * upper.up_A);
    TipWay way = wayAlong(branching(trachea.line_A, trachea.fork, std::array{onIt}), trachea, 0.0);
    way.gate = way.end;
    return way;
}

void measureWalls(const Anatomy& anatomy, const UpperAirway& upper, TipWay& trachea)
{
    const double atCarina = trachea.carina - upper.windpipeSize() * kAtCarina.si;
    trachea.walls = wallsAlong(anatomy, trachea.line_A, metres(trachea.teeth), metres(trachea.fork),
                               upper.size() * kMostInThroat);
    const double below = trachea.fork + kWallsEach.si;
    const auto windpipe = wallsAlong(anatomy, trachea.line_A, metres(below), metres(atCarina),
                                     upper.windpipeSize() * kMostInWindpipe);
    trachea.walls.insert(trachea.walls.end(), windpipe.begin(), windpipe.end());
}

/// The walls of the trachea's way up to where another one leaves it, and round ones from there on.
void takeWalls(TipWay& way, const TipWay& trachea, double leaves, Length radius)
{
    const std::span<const WallsAround> all = trachea.walls;
    const auto last = std::ranges::lower_bound(all, leaves, {}, &WallsAround::along);
    way.walls.assign(all.begin(), last);
    const auto beyond =
        roundWalls(way.line_A, metres(leaves) + kWallsEach, metres(way.end), radius);
    way.walls.insert(way.walls.end(), beyond.begin(), beyond.end());
}

} // namespace

Result<MotionPatient> motionPatient(const Anatomy& anatomy, const RigidTransform& held)
{
    const AirwayLandmarks& l = anatomy.landmarks;
    const auto upper = upperAirwayOf(anatomy.parts, l);
    if (!upper)
        return tl::unexpected(upper.error());
    TipWay trachea = tracheaWay(anatomy, *upper);
    measureWalls(anatomy, *upper, trachea);
    auto right = bronchusWay(anatomy, trachea, Side::Right);
    auto left = bronchusWay(anatomy, trachea, Side::Left);
    auto oesophagus = oesophagusWay(anatomy, *upper, trachea);
    for (const auto* way : {&right, &left, &oesophagus})
        if (!*way)
            return tl::unexpected(way->error());
    TipWay arytenoid = arytenoidWay(*upper, trachea);
    const double size = upper->windpipeSize();
    const double leaves = trachea.carina - kLeavesTrachea * (trachea.carina - trachea.gate);
    for (TipWay* bronchus : {&*right, &*left})
        takeWalls(*bronchus, trachea, leaves, size * kMainBronchus);
    for (TipWay* behind : {&*oesophagus, &arytenoid})
        takeWalls(*behind, trachea, trachea.fork, size * kOpenedOesophagus);
    const ThroatField throat{l.p_A_carina, l.p_A_glottis, l.p_A_incisors};
    return MotionPatient{.airway = l,
                         .upper = *upper,
                         .throat = throat,
                         .held = held,
                         .forBlade = {*upper, throat, held},
                         .ways = {trachea, *right, *left, *oesophagus, arytenoid}};
}

Vec3 placeOnWay(const MotionPatient& patient, const TipWay& way, double along,
                const HeldTissue& tissue)
{
    const Vec3 p_A = tissue.neck.placed(pointAlong(way.line_A, metres(along)));
    const double inside = 2.0 * (along - way.teeth) / (way.fork - way.teeth);
    if (inside <= 0.0)
        return p_A;
    const FollowingThroat throat{patient.throat, tissue.X_AJ * patient.held.inverse(), tissue.neck};
    const double u = std::min(inside, 1.0);
    return p_A + u * u * (3.0 - 2.0 * u) * throatPull(throat, ThroatTissue::Airway, p_A).d;
}

Length lengthOfWay(const MotionPatient& patient, const TipWay& way, double from, double to,
                   const HeldTissue& tissue)
{
    if (to < from)
        return -1.0 * lengthOfWay(patient, way, to, from, tissue);
    const auto steps = std::max(1, static_cast<int>(std::ceil((to - from) / kWaySpacing.si)));
    double length = 0.0;
    Vec3 before = placeOnWay(patient, way, from, tissue);
    for (int i = 1; i <= steps; ++i) {
        const Vec3 p_A = placeOnWay(patient, way, from + (to - from) * i / steps, tissue);
        length += (p_A - before).norm();
        before = p_A;
    }
    return metres(length);
}

} // namespace carina
