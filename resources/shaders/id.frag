#version 330 core

// Writes which part is seen: the id in red and green, low byte first, and full blue where there is
// any part at all. Never blended.

flat in float part;

out vec4 fragment;

void main()
{
    float high = floor(part / 256.0);
    fragment = vec4((part - 256.0 * high) / 255.0, high / 255.0, 1.0, 1.0);
}
