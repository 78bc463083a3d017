#include "engine/anatomy/laryngoscopy/glottic_view.h"

#include "engine/core/expects.h"

#include <cmath>
#include <optional>

namespace carina
{
namespace
{

std::size_t placeOf(SeenStructure structure) { return static_cast<std::size_t>(structure); }

/// The pixel in which a point is seen; nothing outside the picture and behind the camera.
std::optional<std::size_t> pixelOf(const StructurePicture& picture, const PictureCamera& camera,
                                   const RigidTransform& X_DA, const Vec3& p_A)
{
    const Vec3 p_D = X_DA * p_A;
    if (!(p_D.z() < 0.0))
        return std::nullopt;
    const double x = 0.5 * (1.0 + p_D.x() / -p_D.z() / camera.halfWidth) * picture.width;
    const double y = 0.5 * (1.0 - p_D.y() / -p_D.z() / camera.halfHeight) * picture.height;
    if (!(x >= 0.0 && y >= 0.0 && x < picture.width && y < picture.height))
        return std::nullopt;
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width)
           + static_cast<std::size_t>(x);
}

/// How many of the points of a line are seen, and how many a tube covers.
struct LineInPicture {
    int seen = 0;
    int underTube = 0;
};
LineInPicture findLine(const StructurePicture& picture, const PictureCamera& camera,
                       const GlotticLine& line)
{
    const RigidTransform X_DA = camera.X_AD.inverse();
    LineInPicture found;
    for (int i = 0; i < kLineSamples; ++i) {
        const double share = (i + 0.5) / kLineSamples;
        const Vec3 p_A = line.p_A_commissure + share * (line.p_A_notch - line.p_A_commissure);
        const auto pixel = pixelOf(picture, camera, X_DA, p_A);
        if (!pixel)
            continue;
        const SeenStructure structure = picture.pixels[*pixel];
        if (structure == SeenStructure::Tube)
            ++found.underTube;
        else if (!hidesGlottis(structure))
            ++found.seen;
    }
    return found;
}

CormackLehane gradeOf(const GlotticView& view, std::size_t pixels)
{
    const auto isSeen = [&](SeenStructure structure) {
        return double(view.visiblePixels[placeOf(structure)]) >= kLeastSeen * double(pixels);
    };
    if (view.opening > kMostOfGlottis)
        return CormackLehane::Grade1;
    if (view.opening > kEndOfGlottis)
        return CormackLehane::Grade2a;
    if (view.opening > 0.0 || isSeen(SeenStructure::Arytenoid))
        return CormackLehane::Grade2b;
    return isSeen(SeenStructure::Epiglottis) ? CormackLehane::Grade3 : CormackLehane::Grade4;
}

} // namespace

const char* gradeName(CormackLehane grade)
{
    constexpr std::array kNames{"1", "2a", "2b", "3", "4"};
    return kNames.at(static_cast<std::size_t>(grade));
}

double seenShare(const StructurePicture& picture, const PictureCamera& camera,
                 const GlotticLine& line)
{
    const LineInPicture found = findLine(picture, camera, line);
    const int counted = kLineSamples - found.underTube;
    return counted > 0 ? double(found.seen) / counted : 0.0;
}

GlotticView glotticView(const StructurePicture& picture, const PictureCamera& camera,
                        const GlotticLine& line)
{
    const auto count =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    CARINA_EXPECTS(picture.pixels.size() == count && count > 0);
    GlotticView view;
    for (const SeenStructure structure : picture.pixels)
        ++view.visiblePixels[placeOf(structure)];
    view.opening = seenShare(picture, camera, line);
    view.underTube = double(findLine(picture, camera, line).underTube) / kLineSamples;
    view.empty = double(view.visiblePixels[placeOf(SeenStructure::Nothing)]) / double(count);
    view.grade = gradeOf(view, count);
    return view;
}

} // namespace carina
