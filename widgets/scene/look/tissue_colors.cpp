#include "widgets/scene/look/tissue_colors.h"

namespace carina
{

void TissueColors::color(std::span<ScenePart> parts, std::span<const SeenStructure> structures,
                         const AirwayLandmarks& landmarks, const std::string& contentHash)
{
    if (contentHash.empty() || m_contentHash != contentHash) {
        colorTissue(parts, structures, landmarks);
        m_contentHash = contentHash;
        m_parts.clear();
        for (const ScenePart& part : parts)
            if (isColored(structures[part.id]))
                m_parts.emplace(part.id, Colored{part.color, part.colors});
        return;
    }
    for (ScenePart& part : parts)
        if (const auto known = m_parts.find(part.id); known != m_parts.end()) {
            part.color = known->second.color;
            part.colors = known->second.vertices;
        }
}

} // namespace carina
