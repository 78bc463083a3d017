#version 330 core

// How far off what is drawn may be, as bands of colour with lines where they meet, in place of the
// parts' own colours. What faces the eye has the very colour of its band; what turns away is a
// little darker, so that shapes are seen. Airway and lungs are opaque, so that nothing behind them
// changes their bands.

in vec3 worldPosition;
in vec3 worldNormal;
in vec4 shade;
flat in vec3 part; // id, region, material

uniform vec3 eyePosition;
uniform mat4 errorQuadric; // [p 1] Q [p 1]^T is the squared error at p, in widths of a band
uniform float firstBand;   // where it begins, in widths of a band
uniform float bandCount;
struct Band {
    vec3 color;
    vec3 line; // the colour of the line where it begins
};
uniform Band bands[10];

out vec4 fragment;

const float kTool = 2.0;      // MaterialGroup
const float kVeil = 5.0;
const float kHalfLine = 0.75; // pixels
const float kDense = 0.25;    // lines for a pixel, from which on they fade
const float kEdgeTone = 0.72;

int bandAt(float error)
{
    return int(clamp(error - firstBand, 0.0, bandCount - 1.0));
}

void main()
{
    vec4 p = vec4(worldPosition, 1.0);
    float error = sqrt(max(dot(p, errorQuadric * p), 0.0));
    float perPixel = length(vec2(dFdx(error), dFdy(error)));
    if (part.z == kTool) {
        fragment = vec4(sqrt(min(shade.rgb, 1.0)), shade.a);
        return;
    }
    float line = floor(error + 0.5);
    float away = abs(error - line) / max(perPixel, 1e-9);
    float ink = (1.0 - smoothstep(kHalfLine - 0.5, kHalfLine + 0.5, away))
                * (1.0 - smoothstep(kDense, 2.0 * kDense, perPixel));
    vec3 color = mix(bands[bandAt(error)].color, bands[bandAt(line + 0.5)].line, ink);
    float facing = abs(dot(normalize(worldNormal), normalize(eyePosition - worldPosition)));
    float tone = mix(kEdgeTone, 1.0, smoothstep(0.0, 0.6, facing));
    fragment = vec4(color * tone, part.z < kVeil ? 1.0 : shade.a);
}
