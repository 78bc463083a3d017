#pragma once

#include <QByteArray>

#include <compare>

namespace carina
{

/// The features of resources/shaders/organ.vert that one draw call needs. Others are compiled out:
/// a software renderer evaluates both sides of a branch and reads indexed uniforms for each vertex
/// separately.
struct OrganShader {
    bool hasManyRegions = true; ///< uniform regions[].motion; else one uniform motion
    bool movesJaw = true;       ///< uniforms throat and jaw; else the jaw stays as in the surfaces
    bool pushesTissue = true;   ///< uniforms blade and tilt; else no blade moves anything
    bool changesAirway = true;  ///< uniforms of airwayUniforms; else no events
    bool bendsNeck = true;      ///< uniforms of neckUniforms; else the head is in neutral position
    bool isSpotlit = false;     ///< uniform spot: lit by a lamp beside the eye alone
    bool isMoist = false;       ///< only if spotlit: moist.frag lights each pixel

    friend auto operator<=>(const OrganShader&, const OrganShader&) = default;
};
[[nodiscard]] QByteArray organVertexShader(const OrganShader& needs);

} // namespace carina
