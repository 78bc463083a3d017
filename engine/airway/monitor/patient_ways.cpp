#include "engine/airway/monitor/patient_ways.h"

#include "engine/anatomy/airway/airway_measure.h"
#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace carina
{
namespace
{

constexpr double kSectionHeight = 5e-3;             // metres, of the oesophagus
constexpr double kFarShare = 0.8;                   // of a bronchus' reach: its end lies beyond
constexpr Length kBelowCricoid = millimetres(30.0); // below an adult's cords the oesophagus is one
constexpr Length kBelowCarina = millimetres(40.0);  // as far as it is followed in an adult

std::vector<Vec3> pointsOf(std::span<const AnatomyPart> parts, PartRole role)
{
    std::vector<Vec3> points;
    for (const AnatomyPart& part : parts)
        if (part.role == role && !part.levels.empty())
            for (const Vec3f& p : part.levels.front().positions)
                points.push_back(p.cast<double>());
    return points;
}

/// The middle of the end of a bronchus that is far from the carina.
std::optional<Vec3> farEnd(const std::vector<Vec3>& bronchus, const Vec3& p_A_carina)
{
    double far = 0.0;
    for (const Vec3& p : bronchus)
        far = std::max(far, (p - p_A_carina).norm());
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const Vec3& p : bronchus)
        if ((p - p_A_carina).norm() >= kFarShare * far) {
            sum += p;
            ++count;
        }
    return far > 0.0 ? std::optional{Vec3{sum / count}} : std::nullopt;
}

/// In the frontal plane.
Vec3 byAngle(const Vec3& p_A_carina, const Vec3& up, Angle toLeft, Length length)
{
    // About +y a positive angle turns what points down to the patient's right.
    const Vec3 direction = rotationFromVector(-toLeft.si * Vec3::UnitY()) * Vec3{-up};
    return p_A_carina + length.si * direction;
}

Vec3 forwardOf(const Vec3& up) { return (-Vec3::UnitY() + up.y() * up).normalized(); }

/// From the top down.
Centreline middlesOfSections(const std::vector<Vec3>& points, double top, double bottom)
{
    struct Section {
        Vec3 sum = Vec3::Zero();
        int count = 0;
    };
    std::map<long, Section> sections;
    for (const Vec3& p : points) {
        if (p.z() > top || p.z() < bottom)
            continue;
        Section& section = sections[std::lround((top - p.z()) / kSectionHeight)];
        section.sum += p;
        ++section.count;
    }
    Centreline line;
    for (const auto& [height, section] : sections)
        line.emplace_back(section.sum / section.count);
    return line;
}

Centreline behindTrachea(std::span<const Vec3> trachea, const Vec3& forward, double size)
{
    const double belowCords = size * kBelowCricoid.si;
    Centreline line;
    for (const Vec3& p : trachea)
        if ((p - trachea.front()).norm() > belowCords)
            line.emplace_back(p - size * kTracheaToOesophagus.si * forward);
    const Vec3 down = (trachea.back() - trachea.front()).normalized();
    line.emplace_back(trachea.back() - size * kTracheaToOesophagus.si * forward
                      + size * kBelowCarina.si * down);
    return line;
}

Centreline oesophagusOf(std::span<const AnatomyPart> parts, std::span<const Vec3> trachea,
                        const Vec3& forward, double size)
{
    constexpr std::size_t kFewestSections = 3;
    Centreline found = middlesOfSections(pointsOf(parts, PartRole::Oesophagus),
                                         trachea.front().z() - size * kBelowCricoid.si,
                                         trachea.back().z() - size * kBelowCarina.si);
    return found.size() < kFewestSections ? behindTrachea(trachea, forward, size) : found;
}

/// The two halves of the path. Where the glottis is at an end of it, which a set that was sent may
/// say, the landmark there is the other end of that half.
void divide(PatientWays& ways, const AirwayLandmarks& landmarks)
{
    const std::span<const Vec3> path = pathFromTeeth(landmarks);
    const auto glottis = std::ranges::min_element(
        path, {}, [&](const Vec3& p) { return (p - landmarks.p_A_glottis).squaredNorm(); });
    ways.overTongue.assign(path.begin(), glottis + 1);
    ways.trachea.assign(glottis, path.end());
    if (ways.overTongue.size() < 2)
        ways.overTongue.insert(ways.overTongue.begin(), landmarks.p_A_incisors);
    if (ways.trachea.size() < 2)
        ways.trachea.push_back(landmarks.p_A_carina);
}

} // namespace

Vec3 PatientWays::inward_A() const
{
    constexpr Length kAhead = millimetres(10.0);
    return (pointAlong(overTongue, kAhead) - p_A_incisors()).normalized();
}

PatientWays patientWays(const AirwayLandmarks& landmarks, const std::optional<UpperAirway>& upper,
                        std::span<const AnatomyPart> parts)
{
    PatientWays ways;
    divide(ways, landmarks);
    const Vec3 middle = ways.p_A_glottis();
    const Vec3 along = middle - ways.p_A_carina();
    const Vec3 up = upper ? upper->up_A : along.normalized();
    const Vec3 forward = forwardOf(up);
    const double windpipe = along.norm() / kReferenceWindpipe.si;
    ways.size = (middle - ways.p_A_incisors()).norm() / kReferenceWay.si;
    const double larynx = upper ? upper->larynxSize() : ways.size;
    ways.p_A_notch =
        upper ? upper->p_A_notch : Vec3{middle - 0.5 * larynx * kReferenceGlottis.si * forward};
    ways.p_A_frontOfCords = middle + kBesideCords.si * forward;
    ways.p_A_backOfCords = middle - kBesideCords.si * forward;
    ways.p_A_leftOfCords = middle + kBesideCords.si * up.cross(forward);

    ways.p_A_rightEnd =
        farEnd(pointsOf(parts, PartRole::RightMainBronchus), ways.p_A_carina())
            .value_or(byAngle(ways.p_A_carina(), up, radians(-kRightBronchusAngle.si),
                              windpipe * kRightBronchus));
    ways.p_A_leftEnd =
        farEnd(pointsOf(parts, PartRole::LeftMainBronchus), ways.p_A_carina())
            .value_or(byAngle(ways.p_A_carina(), up, kLeftBronchusAngle, windpipe * kLeftBronchus));

    ways.oesophagus = oesophagusOf(parts, ways.trachea, forward, windpipe);
    ways.oesophagus.insert(ways.oesophagus.begin(),
                           ways.p_A_notch - larynx * kNotchToHypopharynx.si * forward);
    return ways;
}

double shareOfJaw(const PatientWays& ways, const Vec3& p_A)
{
    const double whole = (ways.p_A_glottis() - ways.p_A_incisors()).norm();
    const double inside = ways.inward_A().dot(p_A - ways.p_A_incisors());
    return std::clamp(inside / (kAlongPalate * whole), 0.0, 1.0);
}

PatientWays moved(PatientWays ways, const std::function<Vec3(const Vec3&)>& drawn)
{
    for (Centreline* line : {&ways.overTongue, &ways.trachea, &ways.oesophagus})
        for (Vec3& p : *line)
            p = drawn(p);
    for (Vec3* p : {&ways.p_A_rightEnd, &ways.p_A_leftEnd, &ways.p_A_notch, &ways.p_A_frontOfCords,
                    &ways.p_A_backOfCords, &ways.p_A_leftOfCords})
        *p = drawn(*p);
    return ways;
}

PlaceOnWay nearestOnWay(std::span<const Vec3> line, const Vec3& p_A)
{
    CARINA_EXPECTS(line.size() >= 2);
    PlaceOnWay best;
    double least = -1.0;
    double before = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 piece = line[i] - line[i - 1];
        const double length = piece.norm();
        if (length > 0.0) {
            const bool isLast = i + 1 == line.size();
            const double share = std::max(piece.dot(p_A - line[i - 1]) / (length * length), 0.0);
            const double there = isLast ? share : std::min(share, 1.0);
            const Vec3 place = line[i - 1] + there * piece;
            const double off = (p_A - place).norm();
            if (least < 0.0 || off < least) {
                least = off;
                best = {place, metres(before + there * length), metres(off)};
            }
        }
        before += length;
    }
    return best;
}

} // namespace carina
