#version 330 core

// Light on organs: a headlight, a soft sky that is brighter from above and in front of the patient,
// a small highlight, and a rim that turns towards the silhouette. Both faces are lit.

in vec3 worldPosition;
in vec3 worldNormal;
in vec3 color; // sRGB, as colours are chosen
flat in vec3 part; // id, region, material

uniform vec3 eyePosition;

out vec4 fragment;

const vec3 kSky = vec3(0.80, 0.88, 1.00);
const vec3 kGround = vec3(0.42, 0.36, 0.34);
const vec3 kZenith = vec3(0.0, -0.447, 0.894); // where the sky is brightest, in A
const vec3 kLamp = vec3(-0.242, -0.644, 0.725); // what the highlight mirrors, in A

// By MaterialGroup: strength of the highlight; opacity seen face on; opacity seen edge on; light
// added edge on.
const vec4 kLooks[8] = vec4[8](
    vec4(0.20, 1.00, 1.00, 0.10), // bone
    vec4(0.35, 1.00, 1.00, 0.12), // soft tissue
    vec4(0.80, 1.00, 1.00, 0.35), // tool
    vec4(0.50, 0.40, 0.95, 0.40), // airway
    vec4(0.40, 0.60, 0.95, 0.30), // lung
    vec4(0.10, 0.20, 0.75, 0.20), // veil
    vec4(0.10, 0.06, 0.40, 0.10), // skin
    vec4(0.05, 0.08, 0.55, 0.15)  // ghost
);

void main()
{
    vec4 look = kLooks[int(part.z)];
    vec3 view = normalize(eyePosition - worldPosition);
    vec3 normal = normalize(worldNormal);
    if (dot(normal, view) < 0.0)
        normal = -normal;
    float facing = dot(normal, view);
    float edge = (1.0 - facing) * (1.0 - facing);

    vec3 albedo = color * color; // close to linear light
    vec3 sky = mix(kGround, kSky, 0.5 + 0.5 * dot(normal, kZenith));
    vec3 light = 0.74 * facing * vec3(1.0, 0.98, 0.95) + 0.44 * sky;
    vec3 halfway = view + kLamp; // not of unit length: divided out below
    float aligned = dot(normal, halfway);
    float cosine2 = aligned * aligned / dot(halfway, halfway);
    float cosine8 = cosine2 * cosine2 * cosine2 * cosine2;
    float highlight = look.x * cosine8 * cosine8 * cosine8 * cosine8;
    vec3 shade = albedo * light + vec3(0.5 * highlight) + look.w * edge * mix(albedo, kSky, 0.35);

    fragment = vec4(sqrt(min(shade, 1.0)), mix(look.y, look.z, edge));
}
