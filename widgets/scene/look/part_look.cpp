#include "widgets/scene/look/part_look.h"

namespace carina
{

std::vector<ScenePart> withLooks(std::span<const ScenePart> parts, const PartLooks& looks)
{
    std::vector<ScenePart> shown;
    for (const ScenePart& part : parts) {
        const auto found = looks.find(part.id);
        const PartLook look = found == looks.end() ? PartLook{} : found->second;
        if (look.style == PartStyle::Hidden && !look.highlighted)
            continue;
        ScenePart& drawn = shown.emplace_back(part);
        if (look.highlighted)
            drawn.color = kHighlight;
        if (look.highlighted || look.plain)
            drawn.colors.clear();
        const bool isOpaque = drawLayerOf(part.group) != DrawLayer::Blended;
        if ((look.highlighted || look.style == PartStyle::Solid) && !isOpaque)
            drawn.group = MaterialGroup::SoftTissue;
        else if (look.style == PartStyle::Ghost && !look.highlighted)
            drawn.group = MaterialGroup::Ghost;
    }
    return shown;
}

} // namespace carina
