#pragma once

#include <QByteArray>

namespace carina
{

/// The features of resources/shaders/organ.vert that one draw call needs. Others are compiled out:
/// a software renderer evaluates both sides of a branch and reads indexed uniforms for each vertex
/// separately.
struct OrganShader {
    bool hasManyRegions = true; ///< uniform regions[].motion; else one uniform motion
    bool movesJaw = true;       ///< uniforms throat and jaw; else the jaw stays as in the surfaces
};
[[nodiscard]] QByteArray organVertexShader(const OrganShader& needs);

} // namespace carina
