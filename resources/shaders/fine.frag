#version 330 core

// The mean of a pixel's samples, as light: colours are coded as its square root (organ.frag).

uniform sampler2DMS picture;

out vec4 fragment;

const int kSamples = 4; // kSamplesPerPixel

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 light = vec3(0.0);
    for (int i = 0; i < kSamples; ++i) {
        vec3 color = texelFetch(picture, pixel, i).rgb;
        light += color * color;
    }
    fragment = vec4(sqrt(light / float(kSamples)), 1.0);
}
