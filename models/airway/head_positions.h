#pragma once

#include "engine/geometry/deformation/neck_field.h"

#include <QString>

#include <span>
#include <string_view>

namespace carina
{

/// A usual position of head and neck.
struct UsualHeadPosition {
    std::string_view name; ///< "sniffing"
    const char* text;      ///< to be translated by usualText()
    HeadPosition position;
};

/// All of them, as they are offered; the first is the neutral position.
[[nodiscard]] std::span<const UsualHeadPosition> usualHeadPositions();
/// Nothing where none is called so.
[[nodiscard]] const UsualHeadPosition* headPositionNamed(std::string_view name);
/// The usual one with just these angles; nothing where there is none.
[[nodiscard]] const UsualHeadPosition* usualOf(const HeadPosition& position);

/// Its name as shown: "Sniffing".
[[nodiscard]] QString usualText(const UsualHeadPosition& usual);
/// "neck 35° flexed", "neck 5° extended", "neck 0°".
[[nodiscard]] QString neckText(const HeadPosition& position);
/// "head 24° extended", "head 5° flexed", "head 0°".
[[nodiscard]] QString headText(const HeadPosition& position);
/// Both: "neck 35° flexed, head 24° extended".
[[nodiscard]] QString headFiguresText(const HeadPosition& position);
/// With its name, where it is a usual one: "Sniffing: neck 35° flexed, head 24° extended".
[[nodiscard]] QString headPositionText(const HeadPosition& position);

} // namespace carina
