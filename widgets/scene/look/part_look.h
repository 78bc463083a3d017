#pragma once

#include "widgets/scene/surfaces/scene_part.h"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace carina
{

/// What a person may want of a part.
enum class PartStyle : std::uint8_t {
    AsUsual, ///< as its material says
    Solid,   ///< opaque
    Ghost,   ///< hardly more than an outline
    Hidden,
};

/// How a part is shown apart from the way its material says.
struct PartLook {
    PartStyle style = PartStyle::AsUsual;
    bool highlighted = false; ///< opaque, in a colour that no part has; shown even where hidden
    bool labelled = false;    ///< its name stands beside it
    bool plain = false;       ///< of the one colour of its kind, whatever colours it came with

    friend bool operator==(const PartLook&, const PartLook&) = default;
};

/// By id; a part that is not in here is shown as usual.
using PartLooks = std::map<std::uint16_t, PartLook>;

inline constexpr QColor kHighlight{255, 221, 0};

/// The parts as they are drawn with these looks: without those hidden.
[[nodiscard]] std::vector<ScenePart> withLooks(std::span<const ScenePart> parts,
                                               const PartLooks& looks);

} // namespace carina
