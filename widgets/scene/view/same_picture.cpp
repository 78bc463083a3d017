#include "widgets/scene/view/same_picture.h"

#include "widgets/scene/look/chest_uniforms.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

bool areAlike(const RigidTransform& a, const RigidTransform& b)
{
    return a.rotation().coeffs() == b.rotation().coeffs() && a.translation() == b.translation();
}

bool areAlike(const PlacedBody& a, const PlacedBody& b)
{
    return areAlike(a.X_AF, b.X_AF) && a.scale == b.scale;
}

bool areAlike(const EyePicture& a, const EyePicture& b)
{
    return areAlike(a.X_AD, b.X_AD) && a.frustum.left == b.frustum.left
           && a.frustum.right == b.frustum.right && a.frustum.bottom == b.frustum.bottom
           && a.frustum.top == b.frustum.top && a.part.x == b.part.x && a.part.y == b.part.y
           && a.part.width == b.part.width && a.part.height == b.part.height;
}

bool areAlike(const NamedUniform& a, const NamedUniform& b) { return a.value == b.value; }

bool areAlike(const ChestMotion& a, const ChestMotion& b)
{
    return motionUniform(a) == motionUniform(b);
}

bool areAlike(const std::shared_ptr<const LineBend>& a, const std::shared_ptr<const LineBend>& b)
{
    return std::ranges::equal(a->rest(), b->rest()) && std::ranges::equal(a->bent(), b->bent());
}

template <class Value>
bool areAlike(const std::pair<const std::string, Value>& a,
              const std::pair<const std::string, Value>& b)
{
    return a.first == b.first && areAlike(a.second, b.second);
}

template <class Range> bool areAllAlike(const Range& a, const Range& b)
{
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return areAlike(x, y); });
}

template <class Value>
bool areBothAlike(const std::optional<Value>& a, const std::optional<Value>& b)
{
    return a.has_value() == b.has_value() && (!a || areAlike(*a, *b));
}

bool isAirwayAlike(const AirwayField& a, const AirwayField& b)
{
    if (!a.isThere() && !b.isThere())
        return true;
    return areAllAlike(airwayUniforms(a), airwayUniforms(b));
}

bool isNeckAlike(const NeckField& a, const NeckField& b)
{
    if (!a.isBent() && !b.isBent())
        return true;
    return areAllAlike(neckUniforms(a), neckUniforms(b));
}

bool isTissueAlike(const SceneFrame& a, const SceneFrame& b)
{
    return chestUniform(a.chest.field) == chestUniform(b.chest.field)
           && areAllAlike(a.chest.motion, b.chest.motion) && isAirwayAlike(a.airway, b.airway)
           && throatUniform(a.throat.field) == throatUniform(b.throat.field)
           && areAlike(a.throat.X_AJ, b.throat.X_AJ) && isNeckAlike(a.throat.neck, b.throat.neck)
           && bladeUniform(a.blade) == bladeUniform(b.blade)
           && tiltUniform(a.blade) == tiltUniform(b.blade);
}

bool areEyesAlike(const SceneFrame& a, const SceneFrame& b)
{
    return a.eyes.has_value() == b.eyes.has_value() && (!a.eyes || areAllAlike(*a.eyes, *b.eyes))
           && areBothAlike(a.viewpoint, b.viewpoint);
}

} // namespace

bool areDrawnAlike(const SceneFrame& a, const SceneFrame& b)
{
    return areEyesAlike(a, b) && areAllAlike(a.bodies, b.bodies) && areAllAlike(a.lifted, b.lifted)
           && a.bends == b.bends && areAllAlike(a.bentInPlace, b.bentInPlace)
           && areAllAlike(a.bentAlong, b.bentAlong) && isTissueAlike(a, b);
}

} // namespace carina
