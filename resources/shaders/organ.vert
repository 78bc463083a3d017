#version 330 core

// The one vertex shader of everything made of organs: breathing parts, and still ones, whose
// displacement and normal terms are zero or absent (which reads as zero).

in vec3 vertexPosition;
in vec3 vertexNormal;
in vec3 displacement;    // d, metres at amplitude 1
in vec3 normalLinear;    // n1
in vec3 normalQuadratic; // n2
in vec3 vertexColor;
in float partId;

uniform mat4 modelMatrix;
uniform mat4 mvp;
uniform mat3 modelNormalMatrix;
uniform float amplitude; // s

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 color;
flat out float part;

// x(s) = x0 + s d, and the normal that belongs to it, n(s) ~ n0 + s n1 + s^2 n2.
// engine/geometry/deformable_mesh.cpp computes the same on the CPU.
void deform(float s, out vec3 position, out vec3 normal)
{
    position = vertexPosition + s * displacement;
    normal = normalize(vertexNormal + s * (normalLinear + s * normalQuadratic));
}

void main()
{
    vec3 position;
    vec3 normal;
    deform(amplitude, position, normal);

    worldPosition = vec3(modelMatrix * vec4(position, 1.0));
    worldNormal = normalize(modelNormalMatrix * normal);
    color = vertexColor;
    part = partId;
    gl_Position = mvp * vec4(position, 1.0);
}
