#pragma once

#include "widgets/scene/look/scope_colors.h"

#include <map>
#include <string>
#include <vector>

namespace carina
{

/// The colours of what a laryngoscope shows of a patient (colorTissue), worked out once: they
/// follow from the surfaces alone, whichever blade lies before them, and take long enough to hold
/// up the picture.
class TissueColors
{
public:
    /// Colours all parts; those of the patient of the last call as they were.
    /// @param contentHash of the patient, from which ids and meshes of the tissue follow; empty
    ///                    where it is not known
    /// @param structures  by the id of a part
    void color(std::span<ScenePart> parts, std::span<const SeenStructure> structures,
               const AirwayLandmarks& landmarks, const std::string& contentHash);

private:
    struct Colored {
        QColor color;
        std::vector<std::vector<Rgb>> vertices; ///< of each level
    };

    std::string m_contentHash;
    std::map<std::uint16_t, Colored> m_parts; ///< of tissue, by their id; none before the first
};

} // namespace carina
