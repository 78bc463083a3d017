#version 330 core

// Surfaces in the light of a lamp beside the eye, as on a laryngoscope's blade, pixel by pixel:
// mucosa with a film of moisture that glints, fine relief, and vessels that show through. Relief and
// vessels are made of noise in the place that tissue has in the surfaces, so that they move with
// it. What is finer than a pixel is left out. Amounts are of ours.

in vec3 worldPosition;
in vec3 worldNormal;
in vec3 restPosition;
in vec4 shade; // albedo, linear, and opacity
flat in vec3 part; // id, region, material

uniform vec3 eyePosition;
uniform vec4 spot; // as in organ.vert

out vec4 fragment;

const float kTissue = 1.0; // MaterialGroup
const float kFluid = 8.0;
const float kSpotNear2 = 0.25; // as in organ.vert
const float kSpotStray = 0.02;
const vec3 kLampLight = vec3(1.0, 0.97, 0.92);

// Sizes of what is made of noise, metres.
const float kPatch = 6.0e-3;
const float kFold = 2.1e-3;
const float kGrain = 0.7e-3;
// Slopes of the relief that each has.
const vec3 kSlopes = vec3(0.06, 0.09, 0.07);
// The same of a fluid, which has waves and ripples instead, and nothing so fine as grains.
const float kWave = 8.0e-3;
const float kRipple = 3.0e-3;
const vec3 kFluidSlopes = vec3(0.09, 0.06, 0.0);
const mat3 kTurn = mat3(0.80, -0.36, 0.48, 0.60, 0.48, -0.64, 0.00, 0.80, 0.60);
const mat3 kTurnBack = transpose(kTurn);

const vec2 kBent = vec2(0.45, 0.10); // how folds and grains bend vessels
const float kVesselHalfWidth = 0.12e-3; // metres
const vec3 kBlood = vec3(0.34, 0.03, 0.04); // linear

// Share of light that enters tissue and goes on, of what has blood and of what is pale as cords.
const vec3 kThrough = vec3(0.35, 0.12, 0.08);
const vec3 kThroughPale = vec3(0.50, 0.42, 0.36);
const vec3 kThroughFluid = vec3(0.50, 0.45, 0.45); // as of one with cells or slime in it
const float kGloss = 300.0; // exponent of the film's highlight
const float kFilm = 1.6; // how bright a lamp is in it,
const float kMostInFilm = 1.3; // in so much light at most: a camera sees no more
const float kRim = 0.5; // what it mirrors of the tissue around, edge on
// What a fluid mirrors: the wall beside it, linear, and its share of that where it would mirror
// the depth of the throat, which is dark.
const vec3 kWall = vec3(0.80, 0.34, 0.31);
const float kDepthShare = 0.20;
const float kBeside = 0.3; // how far to the side a ray goes that meets the wall
const float kFaceOn = 0.02; // what water mirrors
const float kShoulder = 0.6; // from which on light is compressed

float hashed(uint n)
{
    n = (n ^ (n >> 15)) * 0x2c1b3c6du;
    n = (n ^ (n >> 12)) * 0x297a2d39u;
    return float(n >> 8) * (2.0 / 16777216.0) - 1.0;
}

// Noise of about -1 to 1, and its gradient in xyz: between whole places it is interpolated by
// polynomials of the fifth degree from random values there.
vec4 noise(vec3 p)
{
    vec3 cell = floor(p);
    vec3 f = p - cell;
    const uvec3 kPrimes = uvec3(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu);
    uvec3 a = uvec3(ivec3(cell)) * kPrimes;
    uvec3 b = a + kPrimes;
    vec4 low = vec4(hashed(a.x ^ a.y ^ a.z), hashed(a.x ^ b.y ^ a.z), hashed(a.x ^ a.y ^ b.z),
                    hashed(a.x ^ b.y ^ b.z));
    vec4 high = vec4(hashed(b.x ^ a.y ^ a.z), hashed(b.x ^ b.y ^ a.z), hashed(b.x ^ a.y ^ b.z),
                     hashed(b.x ^ b.y ^ b.z));
    vec3 u = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    vec3 slope = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    vec4 alongX = mix(low, high, u.x);
    vec4 dx = high - low;
    vec2 dy = alongX.yw - alongX.xz;
    vec2 alongY = alongX.xz + u.y * dy;
    vec2 dxAlongY = mix(dx.xz, dx.yw, u.y);
    float dz = alongY.y - alongY.x;
    return vec4(slope * vec3(mix(dxAlongY.x, dxAlongY.y, u.z), mix(dy.x, dy.y, u.z), dz),
                alongY.x + u.z * dz);
}

// The same along other axes, so that no grid is seen.
vec4 turnedNoise(mat3 turn, vec3 p)
{
    vec4 n = noise(turn * p);
    return vec4(n.xyz * turn, n.w);
}

// How much of a structure of this size is seen where a pixel is this large.
float seen(float size, float pixel)
{
    return clamp(1.5 - 3.0 * pixel / size, 0.0, 1.0);
}

// Light of more than kShoulder, so that it comes to 1 only in the limit.
vec3 compressed(vec3 light)
{
    vec3 above = max(light - kShoulder, 0.0) / (1.0 - kShoulder);
    return min(light, kShoulder) + (1.0 - kShoulder) * above / (1.0 + above);
}

// What a fluid mirrors there, and how much of it (Schlick's approximation of Fresnel's).
vec4 mirrored(vec3 view, vec3 flatNormal, vec3 normal)
{
    vec3 ray = reflect(-view, normal);
    float aside = abs(dot(ray, normalize(cross(flatNormal, view) + 1e-6)));
    float dim = 1.0 - clamp(dot(normal, view), 0.0, 1.0);
    float share = kFaceOn + (1.0 - kFaceOn) * dim * dim * dim * dim * dim;
    return vec4(kWall * mix(kDepthShare, 1.0, smoothstep(0.0, kBeside, aside)), share);
}

void main()
{
    vec3 way = eyePosition - worldPosition;
    float far2 = dot(way, way);
    vec3 view = way * inversesqrt(far2);
    vec3 normal = normalize(worldNormal);
    if (dot(normal, view) < 0.0)
        normal = -normal;
    vec3 albedo = shade.rgb;
    float pixel = max(max(length(dFdx(restPosition)), length(dFdy(restPosition))), 1e-6);

    // Pale tissue, as cords, has few vessels; teeth and steel have neither vessels nor relief.
    float isTissue = part.z == kTissue ? 1.0 : 0.0;
    float isFluid = part.z == kFluid ? 1.0 : 0.0;
    float large = isFluid == 1.0 ? kWave : kPatch;
    float middling = isFluid == 1.0 ? kRipple : kFold;
    vec3 slopes = isTissue * kSlopes + isFluid * kFluidSlopes;
    float red = clamp(3.0 * (albedo.r - albedo.g) - 0.2, 0.0, 1.0);

    vec4 patches = turnedNoise(kTurn, restPosition / large);
    vec4 folds = turnedNoise(kTurnBack, restPosition / middling);
    vec4 grains = turnedNoise(kTurnBack, restPosition.yzx / kGrain);
    vec3 relief = slopes.x * patches.xyz + slopes.y * seen(middling, pixel) * folds.xyz
                  + slopes.z * seen(kGrain, pixel) * grains.zxy;

    // A vessel lies where noise is 0, here thicker and there thin.
    vec3 steep = patches.xyz / kPatch + kBent.x * folds.xyz / kFold + kBent.y * grains.zxy / kGrain;
    float away = abs(patches.w + kBent.x * folds.w + kBent.y * grains.w)
                 * inversesqrt(dot(steep, steep) + 1.0);
    float halfWidth = kVesselHalfWidth * clamp(0.4 + 1.4 * folds.w, 0.0, 1.0);
    float blurred = halfWidth + 0.5 * pixel;
    float vessel = (1.0 - smoothstep(0.3 * blurred, 1.3 * blurred, away)) * halfWidth / blurred;
    float patched = patches.w + 0.5 * folds.w;
    albedo *= 1.0 + isTissue * red * vec3(0.20, 0.34, 0.30) * patched;
    albedo = mix(albedo, kBlood, 0.45 * isTissue * red * vessel);

    vec3 bumped = normalize(normal - relief + dot(relief, normal) * normal);
    float facing = clamp(dot(bumped, view), 0.0, 1.0);
    float edge = 1.0 - clamp(dot(normal, view), 0.0, 1.0);
    float cone = smoothstep(0.45, 0.95, -dot(view, spot.xyz));
    float strength = cone * (1.0 + kSpotNear2) / (far2 / (spot.w * spot.w) + kSpotNear2);

    vec3 through = isTissue * mix(kThroughPale, kThrough, red) + isFluid * kThroughFluid;
    vec3 lit = albedo * (facing + through) / (1.0 + through);

    // Of a normal that varies within the pixel, the highlight is wider and fainter.
    vec3 turnX = dFdx(bumped);
    vec3 turnY = dFdy(bumped);
    float gloss = kGloss / (1.0 + 0.5 * kGloss * (dot(turnX, turnX) + dot(turnY, turnY)));
    float glint = exp(gloss * (facing - 1.0)) * gloss / kGloss;
    lit += (1.0 - isFluid) * edge * edge * edge * kRim * albedo;
    vec4 mirror = mirrored(view, normal, bumped);
    lit = mix(lit, mirror.rgb, isFluid * mirror.a);
    vec3 light = strength * lit + min(strength, kMostInFilm) * kFilm * glint;
    fragment = vec4(sqrt(compressed(light * kLampLight + kSpotStray * albedo)), shade.a);
}
