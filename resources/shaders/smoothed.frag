#version 330 core

// Smooths the steps of edges in a finished picture, as fast approximate anti-aliasing does
// (T. Lottes, FXAA, NVIDIA white paper, 2009): from the picture alone, along its edges. An edge
// runs across the gradient of lightness, which is Sobel's of the pixel and its eight neighbours.
// The pixel becomes the mean light of four places that lie evenly on a short piece of it, within
// what these nine pixels have, so that nothing new appears.

uniform sampler2D picture;

out vec4 fragment;

const float kLeastContrast = 0.04; // of lightness beside, above and below, that is an edge
const float kHalfLength = 2.5; // of the piece of an edge, pixels along a row or column
const float kMostAside = 1.0; // pixels that it leaves that row or column by, to each side

vec3 pixelAt(ivec2 place)
{
    return texelFetch(picture, clamp(place, ivec2(0), textureSize(picture, 0) - 1), 0).rgb;
}

float lightness(vec3 color)
{
    return dot(color, vec3(0.299, 0.587, 0.114));
}

// Colours are coded as the square root of light (organ.frag).
vec3 lightAt(vec2 place)
{
    vec3 color = textureLod(picture, place / vec2(textureSize(picture, 0)), 0.0).rgb;
    return color * color;
}

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    vec3 own = pixelAt(place);
    vec3 left = pixelAt(place + ivec2(-1, 0));
    vec3 right = pixelAt(place + ivec2(1, 0));
    vec3 below = pixelAt(place + ivec2(0, -1));
    vec3 above = pixelAt(place + ivec2(0, 1));
    vec4 beside = vec4(lightness(left), lightness(right), lightness(below), lightness(above));
    float middle = lightness(own);
    float darkest = min(min(min(beside.x, beside.y), min(beside.z, beside.w)), middle);
    float lightest = max(max(max(beside.x, beside.y), max(beside.z, beside.w)), middle);
    fragment = vec4(own, 1.0);
    if (lightest - darkest < kLeastContrast)
        return;

    vec3 belowLeft = pixelAt(place + ivec2(-1, -1));
    vec3 belowRight = pixelAt(place + ivec2(1, -1));
    vec3 aboveLeft = pixelAt(place + ivec2(-1, 1));
    vec3 aboveRight = pixelAt(place + ivec2(1, 1));
    float rising = lightness(aboveRight) - lightness(belowLeft);
    float falling = lightness(belowRight) - lightness(aboveLeft);
    vec2 gradient = vec2(rising + falling + 2.0 * (beside.y - beside.x),
                         rising - falling + 2.0 * (beside.w - beside.z));
    vec2 along = vec2(-gradient.y, gradient.x);
    float most = max(abs(along.x), abs(along.y));
    if (most < 1e-3)
        return; // a line or a dot, which has no side
    along /= most;
    float aside = min(abs(along.x), abs(along.y));
    vec2 end = along * min(kHalfLength, kMostAside / max(aside, 1e-3));
    vec3 light = 0.25 * (lightAt(gl_FragCoord.xy - end) + lightAt(gl_FragCoord.xy - end / 3.0)
                         + lightAt(gl_FragCoord.xy + end / 3.0) + lightAt(gl_FragCoord.xy + end));

    vec3 least = min(min(min(left, right), min(below, above)), own);
    vec3 greatest = max(max(max(left, right), max(below, above)), own);
    least = min(least, min(min(belowLeft, belowRight), min(aboveLeft, aboveRight)));
    greatest = max(greatest, max(max(belowLeft, belowRight), max(aboveLeft, aboveRight)));
    fragment = vec4(clamp(sqrt(light), least, greatest), 1.0);
}
