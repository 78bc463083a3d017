#version 330 core

// Writes which part is seen: the id in red and green, low byte first, and full blue where there is
// any part at all. Never blended. Draws the parts of one layer and no others.

flat in vec3 part; // id, region, material

uniform float layer; // as layerOf(MaterialGroup)

out vec4 fragment;

const float kLastOpaque = 2.0; // the tools; fluids are opaque, too
const float kFluid = 8.0;

void main()
{
    if ((part.z == kFluid ? 0.0 : max(part.z - kLastOpaque, 0.0)) != layer)
        discard;
    float high = floor(part.x / 256.0);
    fragment = vec4((part.x - 256.0 * high) / 255.0, high / 255.0, 1.0, 1.0);
}
