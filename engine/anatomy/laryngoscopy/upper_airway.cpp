#include "engine/anatomy/laryngoscopy/upper_airway.h"

#include "engine/anatomy/airway/airway_measure.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

namespace carina
{
namespace
{

constexpr double kNearMidplane = 4e-3; ///< metres to either side
constexpr double kSameHeight = 1.5e-3; ///< metres up and down

constexpr std::string_view kUpperLipWords = "upper lip";
constexpr std::string_view kLowerLipWords = "lower lip";

bool isCalled(const AnatomyPart& part, std::string_view words)
{
    std::string name = part.name;
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name.find(words) != std::string::npos;
}

bool isCord(const AnatomyPart& part)
{
    return isCalled(part, "vocal") && !isCalled(part, "vestibular");
}

/// All vertices of the finest levels of the parts for which `is` holds.
std::vector<Vec3> verticesOf(std::span<const AnatomyPart> parts,
                             const std::function<bool(const AnatomyPart&)>& is)
{
    std::vector<Vec3> vertices;
    for (const AnatomyPart& part : parts)
        if (is(part) && !part.levels.empty())
            for (const Vec3f& p : part.levels.front().positions)
                vertices.push_back(p.cast<double>());
    return vertices;
}

/// The mean of those that reach farthest along a direction, within kSameHeight.
std::optional<Vec3> farthest(const std::vector<Vec3>& vertices, const Vec3& dir_A)
{
    if (vertices.empty())
        return std::nullopt;
    double most = dir_A.dot(vertices.front());
    for (const Vec3& p : vertices)
        most = std::max(most, dir_A.dot(p));
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const Vec3& p : vertices)
        if (dir_A.dot(p) > most - kSameHeight) {
            sum += p;
            ++count;
        }
    return sum / count;
}

/// Those within kNearMidplane of the plane through the glottis.
std::vector<Vec3> nearMidplane(std::vector<Vec3> vertices, double x)
{
    std::erase_if(vertices, [x](const Vec3& p) { return std::abs(p.x() - x) > kNearMidplane; });
    return vertices;
}

/// The foremost of those at a height.
std::optional<Vec3> foremostAt(std::vector<Vec3> vertices, const UpperAirway& airway, double height)
{
    std::erase_if(vertices, [&](const Vec3& p) {
        return std::abs(airway.up_A.dot(p - airway.p_A_epiglottisBase) - height) > kSameHeight;
    });
    return farthest(vertices, airway.forward_A());
}

/// All of its places are changed.
template <class Change> void changePlaces(UpperAirway& airway, Change change)
{
    for (Vec3* p_A : {&airway.p_A_incisors, &airway.p_A_uvula, &airway.p_A_epiglottisBase,
                      &airway.p_A_epiglottisTip, &airway.p_A_vallecula, &airway.p_A_commissure,
                      &airway.p_A_notch})
        change(*p_A);
    for (Vec3& p_A : airway.path_A)
        change(p_A);
    for (auto* p_A :
         {&airway.p_A_tongue, &airway.p_A_upperLip, &airway.p_A_lowerLip, &airway.p_A_neck})
        if (*p_A)
            change(**p_A);
    if (airway.windpipe)
        change(airway.windpipe->p_A_middle);
}

Vec3 inPlane(Vec3 p, double x)
{
    p.x() = x;
    return p;
}

/// Base, tip and vallecula.
bool findEpiglottis(UpperAirway& airway, std::span<const AnatomyPart> parts, double x)
{
    const std::vector<Vec3> vertices = nearMidplane(
        verticesOf(parts, [](const AnatomyPart& p) { return p.role == PartRole::Epiglottis; }), x);
    const auto tip = farthest(vertices, airway.up_A);
    const auto base = farthest(vertices, -airway.up_A);
    if (!tip || !base)
        return false;
    airway.p_A_epiglottisTip = inPlane(*tip, x);
    airway.p_A_epiglottisBase = inPlane(*base, x);
    const double height = kValleculaHeight * airway.up_A.dot(*tip - *base);
    const auto floor = foremostAt(vertices, airway, height);
    if (!floor)
        return false;
    airway.p_A_vallecula = inPlane(*floor, x);
    return true;
}

/// Their ends, at the height of the landmark between them.
bool findGlottis(UpperAirway& airway, std::span<const AnatomyPart> parts, const Vec3& p_A_glottis)
{
    const std::vector<Vec3> cords = verticesOf(parts, isCord);
    const auto front = farthest(cords, airway.forward_A());
    const auto back = farthest(cords, -airway.forward_A());
    if (!front || !back)
        return false;
    const auto atGlottis = [&](const Vec3& p) {
        return Vec3{p_A_glottis + airway.forward_A().dot(p - p_A_glottis) * airway.forward_A()};
    };
    airway.p_A_commissure = atGlottis(*front);
    airway.p_A_notch = atGlottis(*back);
    return true;
}

bool findUvula(UpperAirway& airway, std::span<const AnatomyPart> parts, double x)
{
    for (const char* words : {"uvula", "soft palate"}) {
        const auto isIt = [words](const AnatomyPart& part) { return isCalled(part, words); };
        if (const auto tip = farthest(verticesOf(parts, isIt), -Vec3::UnitZ())) {
            airway.p_A_uvula = inPlane(*tip, x);
            return true;
        }
    }
    return false;
}

/// The mean, in the midplane.
std::optional<Vec3> meanInPlane(const std::vector<Vec3>& vertices, double x)
{
    if (vertices.empty())
        return std::nullopt;
    const Vec3 sum = std::accumulate(vertices.begin(), vertices.end(), Vec3{Vec3::Zero()});
    return inPlane(sum / double(vertices.size()), x);
}

void findTongue(UpperAirway& airway, std::span<const AnatomyPart> parts, double x)
{
    const auto isOfTongue = [](const AnatomyPart& p) { return p.role == PartRole::Tongue; };
    // Without the muscles that it comes from: genioglossus, hyoglossus, styloglossus.
    const auto isTongue = [&](const AnatomyPart& p) {
        return isOfTongue(p) && !isCalled(p, "glossus");
    };
    const std::vector<Vec3> tongue = verticesOf(parts, isTongue);
    airway.p_A_tongue = meanInPlane(tongue.empty() ? verticesOf(parts, isOfTongue) : tongue, x);
}

void findLips(UpperAirway& airway, std::span<const AnatomyPart> parts, double x)
{
    const auto middle = [&](std::string_view words) {
        const auto isIt = [words](const AnatomyPart& part) { return isCalled(part, words); };
        return meanInPlane(nearMidplane(verticesOf(parts, isIt), x), x);
    };
    airway.p_A_upperLip = middle(kUpperLipWords);
    airway.p_A_lowerLip = middle(kLowerLipWords);
}

void findWindpipe(UpperAirway& airway, std::span<const AnatomyPart> parts, const Vec3& p_A_level)
{
    constexpr double kRingsHeight = 2.5e-3; // metres to either side of the level
    const auto isTrachea = [](const AnatomyPart& p) { return p.role == PartRole::Trachea; };
    const Vec3 across = airway.up_A.cross(airway.forward_A());
    Box reach; // across, to the front, and up from the level
    for (const Vec3& p : verticesOf(parts, isTrachea)) {
        const Vec3 from = p - p_A_level;
        if (std::abs(from.dot(airway.up_A)) < kRingsHeight)
            reach.include({from.dot(across), from.dot(airway.forward_A()), 0.0});
    }
    if (reach.empty())
        return;
    const Vec3 centre = reach.centre();
    const Vec3 half = reach.max - centre;
    if (half.x() > 0.0 && half.y() > 0.0)
        airway.windpipe =
            WindpipePlace{p_A_level + centre.x() * across + centre.y() * airway.forward_A(),
                          metres(half.x()), metres(half.y())};
}

void findNeck(UpperAirway& airway, std::span<const AnatomyPart> parts, const Vec3& p_A_level)
{
    constexpr double kSkinNear = 8e-3; // metres; vertices of skin are some 7 mm apart
    const auto isSkin = [](const AnatomyPart& p) { return p.role == PartRole::Skin; };
    std::vector<Vec3> vertices = verticesOf(parts, isSkin);
    std::erase_if(vertices, [&](const Vec3& p) {
        return std::abs(p.x() - p_A_level.x()) > kSkinNear
               || std::abs(airway.up_A.dot(p - p_A_level)) > kSkinNear;
    });
    if (const auto front = farthest(vertices, airway.forward_A()))
        airway.p_A_neck = inPlane(*front, p_A_level.x());
}

bool hasTeethAt(std::span<const AnatomyPart> parts, const Vec3& p_A_edge)
{
    constexpr double kNearEdge = 6e-3; // metres
    const auto isTooth = [](const AnatomyPart& p) { return p.role == PartRole::Tooth; };
    return std::ranges::any_of(verticesOf(parts, isTooth),
                               [&](const Vec3& p) { return (p - p_A_edge).norm() < kNearEdge; });
}

} // namespace

Vec3 UpperAirway::forward_A() const { return (-Vec3::UnitY() + up_A.y() * up_A).normalized(); }

Length UpperAirway::glottis() const { return metres((p_A_commissure - p_A_notch).norm()); }

double UpperAirway::size() const
{
    const double way = (0.5 * (p_A_commissure + p_A_notch) - p_A_incisors).norm();
    return way / kReferenceWay.si / drawnOut;
}

double UpperAirway::larynxSize() const
{
    constexpr double kLeastShare = 0.25; // of surfaces whose cords are not found well
    return std::clamp(glottis() / kReferenceGlottis, kLeastShare * size(), size());
}

Result<UpperAirway> upperAirwayOf(std::span<const AnatomyPart> parts,
                                  const AirwayLandmarks& landmarks)
{
    UpperAirway airway;
    airway.p_A_incisors = landmarks.p_A_incisors;
    const Vec3 trachea = landmarks.p_A_glottis - landmarks.p_A_carina;
    if (!(trachea.norm() > ThroatField::kLeast))
        return fail(Errc::NoAirway, "the trachea is too short");
    airway.up_A = trachea.normalized();
    const double x = landmarks.p_A_glottis.x();
    if (!findEpiglottis(airway, parts, x))
        return fail(Errc::NoAirway, "no epiglottis");
    if (!findGlottis(airway, parts, landmarks.p_A_glottis))
        return fail(Errc::NoAirway, "no vocal cords");
    if (!findUvula(airway, parts, x))
        return fail(Errc::NoAirway, "no soft palate");
    findTongue(airway, parts, x);
    findLips(airway, parts, x);
    airway.toCarina = metres(trachea.norm());
    const Vec3 p_A_level =
        landmarks.p_A_glottis - airway.windpipeSize() * kNarrowingOfWindpipe.si * airway.up_A;
    findWindpipe(airway, parts, p_A_level);
    findNeck(airway, parts, p_A_level);
    airway.hasIncisors = hasTeethAt(parts, landmarks.p_A_incisors);
    const std::span<const Vec3> path = pathFromTeeth(landmarks);
    const auto glottis = std::ranges::min_element(
        path, {}, [&](const Vec3& p) { return (p - landmarks.p_A_glottis).squaredNorm(); });
    airway.path_A.assign(path.begin(), glottis + 1);
    return airway;
}

bool isLip(const AnatomyPart& part)
{
    return isCalled(part, kUpperLipWords) || isCalled(part, kLowerLipWords);
}

UpperAirway changed(UpperAirway airway, const AirwayField& changes)
{
    const auto change = [&](Vec3& p_A, AirwayTissue tissue) {
        p_A += airwayPull<double>(changes.frame(), tissue, p_A).d;
    };
    for (Vec3* p_A : {&airway.p_A_epiglottisBase, &airway.p_A_epiglottisTip, &airway.p_A_vallecula,
                      &airway.p_A_commissure, &airway.p_A_notch})
        change(*p_A, AirwayTissue::Larynx);
    change(airway.p_A_uvula, AirwayTissue::Pharynx);
    airway.d_A_incisors +=
        airwayPull<double>(changes.frame(), AirwayTissue::Teeth, airway.p_A_incisors).d;
    for (auto* p_A : {&airway.p_A_tongue, &airway.p_A_upperLip, &airway.p_A_lowerLip})
        if (*p_A)
            change(**p_A, AirwayTissue::Throat);
    return airway;
}

UpperAirway bent(UpperAirway airway, const NeckField& neck)
{
    if (!neck.isBent())
        return airway;
    const double size = airway.size();
    const Angle turn = neck.turnAt(0.5 * (airway.p_A_commissure + airway.p_A_notch));
    airway.up_A = rotationFromVector(turn.si * Vec3::UnitX()) * airway.up_A;
    airway.d_A_incisors = neck.X_AU().rotation() * airway.d_A_incisors;
    changePlaces(airway, [&neck](Vec3& p_A) { p_A = neck.placed(p_A); });
    airway.drawnOut *= airway.size() / size;
    return airway;
}

UpperAirway followed(UpperAirway airway, const FollowingThroat& throat)
{
    airway = bent(std::move(airway), throat.neck);
    const auto follow = [&](Vec3& p_A) { p_A += throatPull(throat, ThroatTissue::Airway, p_A).d; };
    for (Vec3* p_A : {&airway.p_A_epiglottisBase, &airway.p_A_epiglottisTip, &airway.p_A_vallecula,
                      &airway.p_A_commissure, &airway.p_A_notch})
        follow(*p_A);
    for (Vec3& p_A : airway.path_A)
        follow(p_A);
    return airway;
}

AirwayAxes airwayAxes(const UpperAirway& airway, const NeckField& neck)
{
    const auto between = [](const Vec3& a, const Vec3& b) {
        return radians(std::atan2(a.cross(b).norm(), a.dot(b)));
    };
    const Vec3 sight = 0.5 * (airway.p_A_commissure + airway.p_A_notch) - airway.p_A_incisors;
    return {between(neck.X_AU().rotation() * Vec3::UnitY(), sight), between(sight, -airway.up_A)};
}

UpperAirway seenFrom(const RigidTransform& X_FA, UpperAirway airway)
{
    changePlaces(airway, [&X_FA](Vec3& p) { p = X_FA * p; });
    airway.up_A = X_FA.rotation() * airway.up_A;
    airway.d_A_incisors = X_FA.rotation() * airway.d_A_incisors;
    return airway;
}

} // namespace carina
