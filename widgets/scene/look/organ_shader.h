#pragma once

#include <QByteArray>

namespace carina
{

/// What one draw needs of resources/shaders/organ.vert. A processor that draws works out both sides
/// of a condition and fetches what has an index for each vertex alone; so what a draw does not need
/// is left out.
struct OrganShader {
    bool hasManyRegions = true; ///< uniform motions[] by region; else one uniform motion for all
    bool movesJaw = true; ///< uniforms throat and jaw; else the jaw stays where surfaces have it
};
[[nodiscard]] QByteArray organVertexShader(const OrganShader& needs);

} // namespace carina
