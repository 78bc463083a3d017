#version 330 core

// The light that organ.vert worked out, coded as colours of a screen are.

in vec4 shade;

out vec4 fragment;

void main()
{
    fragment = vec4(sqrt(min(shade.rgb, 1.0)), shade.a);
}
