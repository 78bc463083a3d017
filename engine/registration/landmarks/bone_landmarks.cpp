#include "engine/registration/landmarks/bone_landmarks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace carina
{
namespace
{

constexpr float kHalfSlice = 3e-3F; // metres

using Points = std::span<const Vec3f>;

bool has(const std::string& name, std::string_view word)
{
    const auto alike = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == b;
    };
    return std::search(name.begin(), name.end(), word.begin(), word.end(), alike) != name.end()
           || word.empty();
}

/// The points of the first bone whose name has both; none where there is no such bone.
Points pointsOf(std::span<const Bone> bones, std::string_view word, std::string_view side = {})
{
    const auto found = std::ranges::find_if(
        bones, [&](const Bone& bone) { return has(bone.name, word) && has(bone.name, side); });
    return found == bones.end() ? Points{} : found->positions_A;
}

/// x of the plane halfway between the leftmost and the rightmost point.
float middleOf(Points points)
{
    const auto [least, most] =
        std::ranges::minmax(points, {}, [](const Vec3f& p) { return p.x(); });
    return 0.5F * (least.x() + most.x());
}

std::vector<Vec3f> sliceOf(Points points, float x)
{
    std::vector<Vec3f> slice;
    std::ranges::copy_if(points, std::back_inserter(slice),
                         [x](const Vec3f& p) { return std::abs(p.x() - x) <= kHalfSlice; });
    return slice;
}

Vec3 foremostOf(Points points)
{
    return std::ranges::min(points, {}, [](const Vec3f& p) { return p.y(); }).cast<double>();
}

Vec3 lowestOf(Points points)
{
    return std::ranges::min(points, {}, [](const Vec3f& p) { return p.z(); }).cast<double>();
}

Vec3 highestOf(Points points)
{
    return std::ranges::max(points, {}, [](const Vec3f& p) { return p.z(); }).cast<double>();
}

Vec3 ribBelow(Points clavicle, Points rib)
{
    const std::vector<Vec3f> slice = sliceOf(rib, middleOf(clavicle));
    return foremostOf(slice.empty() ? rib : Points{slice});
}

/// Of the points on one side, the furthest down and back.
std::optional<Vec3> jawAngle(Points mandible, float side)
{
    const auto downAndBack = [side](const Vec3f& p) {
        return side * p.x() > 0.0F ? p.y() - p.z() : -std::numeric_limits<float>::infinity();
    };
    if (mandible.empty())
        return std::nullopt;
    const Vec3f& angle = std::ranges::max(mandible, {}, downAndBack);
    return side * angle.x() > 0.0F ? std::optional{Vec3{angle.cast<double>()}} : std::nullopt;
}

} // namespace

std::optional<LandmarkCatalogue> boneLandmarks(std::span<const Bone> bones, std::string anatomy)
{
    const Points manubrium = pointsOf(bones, "manubrium");
    const Points xiphoid = pointsOf(bones, "xiphoid");
    const Points leftRib = pointsOf(bones, "fifth rib", "left");
    const Points rightRib = pointsOf(bones, "fifth rib", "right");
    const Points leftClavicle = pointsOf(bones, "clavicle", "left");
    const Points rightClavicle = pointsOf(bones, "clavicle", "right");
    for (const Points bone : {manubrium, xiphoid, leftRib, rightRib, leftClavicle, rightClavicle})
        if (bone.empty())
            return std::nullopt;
    const std::vector<Vec3f> midline = sliceOf(manubrium, middleOf(manubrium));
    LandmarkCatalogue catalogue = ribCageCatalogue({}, std::move(anatomy));
    catalogue.landmarks[0].p_AQ = highestOf(midline.empty() ? manubrium : Points{midline});
    catalogue.landmarks[1].p_AQ = lowestOf(xiphoid);
    catalogue.landmarks[2].p_AQ = ribBelow(leftClavicle, leftRib);
    catalogue.landmarks[3].p_AQ = ribBelow(rightClavicle, rightRib);
    return catalogue;
}

FurtherPlaces onBones(FurtherPlaces places, std::span<const Bone> bones)
{
    const Points mandible = pointsOf(bones, "mandible");
    places.p_A_leftJawAngle = jawAngle(mandible, 1.0F).value_or(places.p_A_leftJawAngle);
    places.p_A_rightJawAngle = jawAngle(mandible, -1.0F).value_or(places.p_A_rightJawAngle);
    if (const Points rib = pointsOf(bones, "tenth rib", "left"); !rib.empty())
        places.p_A_leftTenthRib = foremostOf(rib);
    if (const Points rib = pointsOf(bones, "tenth rib", "right"); !rib.empty())
        places.p_A_rightTenthRib = foremostOf(rib);
    return places;
}

std::vector<Landmark> boneCheckPlaces(std::span<const Bone> bones)
{
    std::vector<Landmark> places;
    if (const Points thyroid = pointsOf(bones, "thyroid cartilage"); !thyroid.empty())
        places.push_back({"Prominence of the larynx", foremostOf(thyroid)});
    else if (const Points mandible = pointsOf(bones, "mandible"); !mandible.empty())
        places.push_back({"Tip of the chin", foremostOf(mandible)});
    const Points manubrium = pointsOf(bones, "manubrium");
    const Points left = pointsOf(bones, "clavicle", "left");
    const Points right = pointsOf(bones, "clavicle", "right");
    if (manubrium.empty() || left.empty() || right.empty())
        return places;
    const float middle = middleOf(manubrium);
    const auto inner = [middle](Points clavicle) {
        return Vec3{std::ranges::min(clavicle, {}, [middle](const Vec3f& p) {
                        return std::abs(p.x() - middle);
                    }).cast<double>()};
    };
    places.push_back({"Inner end of the left clavicle", inner(left)});
    places.push_back({"Inner end of the right clavicle", inner(right)});
    return places;
}

} // namespace carina
