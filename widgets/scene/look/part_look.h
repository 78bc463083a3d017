#pragma once

#include "widgets/scene/surfaces/scene_part.h"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace carina
{

/// How a person wants a part to be drawn.
enum class PartStyle : std::uint8_t {
    AsUsual, ///< as its material group
    Solid,   ///< opaque
    Ghost,   ///< nearly only an outline
    Hidden,
};

/// How a part is drawn differently from its material group.
struct PartLook {
    PartStyle style = PartStyle::AsUsual;
    bool highlighted = false; ///< opaque, in a colour that no part has; shown even if hidden
    bool labelled = false;    ///< its name is shown beside it
    bool plain = false;       ///< in the one colour of its kind, without its vertex colours

    friend bool operator==(const PartLook&, const PartLook&) = default;
};

/// Looks by part id; a part that is not listed is drawn as usual.
using PartLooks = std::map<std::uint16_t, PartLook>;

inline constexpr QColor kHighlight{255, 221, 0};

/// The parts as drawn with these looks, without the hidden ones.
[[nodiscard]] std::vector<ScenePart> withLooks(std::span<const ScenePart> parts,
                                               const PartLooks& looks);

} // namespace carina
