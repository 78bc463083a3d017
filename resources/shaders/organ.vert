#version 330 core

// The one vertex shader of everything made of organs. What breathes is moved by the field of the
// chest, written out in engine/geometry/deformation/chest_formula.h and worked out on the processor by
// engine/geometry/deformation/moved_vertex.h; what then follows the jaw is moved by that of the throat, written
// out in engine/geometry/deformation/throat_formula.h, and what gives way to a laryngoscope's blade by that of
// engine/geometry/deformation/blade_formula.h. The names here are theirs. Nothing is uploaded meanwhile
// but a matrix for each region, and one for the jaw. widgets/scene/look/organ_shader.h tells when what is
// written between #ifdef and #endif is there. Before the jaw moves it, tissue is changed as engine/geometry/
// deformation/airway_formula.h has it, and then everything is moved with head and neck as
// engine/geometry/deformation/neck_formula.h has it.

in vec3 vertexPosition;
in vec3 vertexNormal;
in vec3 vertexColor;
in vec3 vertexPart; // id, ChestRegion, MaterialGroup

uniform vec3 eyePosition;
uniform mat4 modelMatrix;
uniform mat4 mvp;
uniform mat3 modelNormalMatrix;
uniform mat4 chest;  // columns: origin and frontShare; perMetre; right hilum; left hilum
// Columns: descent, forward, flare, lift; bulkBack, bulkDown, shrink, shift; of the right lung,
// then of the left.
#ifdef MANY_REGIONS
struct Region {
    mat4 motion;
};
uniform Region regions[15];
mat4 motion; // of this vertex's region
#else
uniform mat4 motion;
#endif
#ifdef JAW_MOVES
uniform mat4 throat; // columns: up and upFrom; incisors and perLength; anchor
uniform mat4 jaw;    // columns: turn; shift; all 0 while the mouth is closed
#endif
#ifdef AIRWAY_CHANGES
// Columns: across and acrossFrom; along and alongFrom; up and upFrom; closing, front, wider, outer; all 0 while
// a lumen is as wide as in the surfaces.
uniform mat4 cords;
uniform mat4 web;
uniform mat4 vestibule;
uniform mat4 pharynx;
uniform mat4 windpipeSides;
uniform mat4 windpipeDepth;
// Columns: centre and perAcross2; axis and perAlong2; shift and outward; soft2, isFlat, tissues.
struct Swelling {
    mat4 form;
};
uniform Swelling swellings[19];
// Columns: centre and perAcross2; axis and perAlong2; light and share; tissues.
struct Tint {
    mat4 place;
};
uniform Tint tints[8];
#endif
#ifdef NECK_BENDS
// Columns: hinge and angle; along and from; arch and soft2; of the head against the neck, and of the
// neck. The angle is 0 in the neutral position.
uniform mat4 neckExtension;
uniform mat4 neckFlexion;
uniform mat4 headPose; // X_AU
// From the frame of what is bent to A, and back from where the neck has taken it.
uniform mat4 intoNeck;
uniform mat4 outOfNeck;
#endif
#ifdef BLADE_PUSHES
// Columns: across and acrossFrom; out and outFrom; along and alongFrom; rise, sag, halfWidth.
uniform mat4 blade;
uniform mat4 tilt; // columns: tilt; up and upFrom; back and backFrom; all 0 while nothing is tilted
#endif
#ifdef SPOTLIGHT
uniform vec4 spot; // of a lamp beside the eye: its direction; metres to what has its true colour
#endif
uniform vec4 section;  // what lies where dot(xyz, p) > w, in A, is cut away; xyz 0: nothing is
uniform float cutAway; // 1: the airway stays whole

out vec3 worldPosition;
out vec3 worldNormal;
out vec4 shade; // light, linear, and opacity; MOIST: the albedo in place of light
#ifdef MOIST
out vec3 restPosition; // in the surfaces
#endif
flat out vec3 part;

const vec3 kSky = vec3(0.80, 0.88, 1.00);
const vec3 kGround = vec3(0.42, 0.36, 0.34);
const vec3 kZenith = vec3(0.0, -0.447, 0.894); // where the sky is brightest, in A
const vec3 kLamp = vec3(-0.242, -0.644, 0.725); // what the highlight mirrors, in A

// By MaterialGroup: strength of the highlight; opacity seen face on; opacity seen edge on; light
// added edge on.
const vec4 kLooks[9] = vec4[9](
    vec4(0.20, 1.00, 1.00, 0.10), // bone
    vec4(0.35, 1.00, 1.00, 0.12), // soft tissue
    vec4(0.80, 1.00, 1.00, 0.35), // tool
    vec4(0.50, 0.40, 0.95, 0.40), // airway
    vec4(0.40, 0.60, 0.95, 0.30), // lung
    vec4(0.10, 0.20, 0.75, 0.20), // veil
    vec4(0.10, 0.06, 0.40, 0.10), // skin
    vec4(0.05, 0.08, 0.55, 0.15), // ghost
    vec4(0.80, 1.00, 1.00, 0.35)  // fluid
);

vec3 albedo; // of this vertex: sRGB, to close to linear light

const float kSpotNear2 = 0.25; // of that distance, squared: the lamp is no point
const float kSpotStray = 0.02; // light from everywhere, of what the mucosa scatters
const float kBladeShade = 0.6; // of light, what a blade keeps from tissue that it touches
const float kPerShade = 1.0 / 6e-3; // per metre from it, falling by e
const float kShoulder = 0.6; // of light, from which on it is compressed

const float kTool = 2.0; // MaterialGroup
const float kAirway = 3.0;
const float kFluid = 8.0;

const float kLooseTooth = 8.0; // ChestRegion: events move it and those after it
const float kMediastinum = 11.0; // it and those after it follow the jaw
const float kThroat = 12.0;
const float kPharynx = 13.0;
const float kLarynx = 14.0;

const vec3 kStiffness = vec3(16.0, 6.25, 16.0);
const float kBeyond = 0.2;
const float kTendon = 0.3;
const float kSpread = 0.28;
const float kAttachment = 0.65;
const float kShiftFrom = -0.3;
const float kShiftOver = 0.6;
const float kRibsFade = 0.3;
const float kRibsEnd = 1.0;

const float kChin = 0.07;
const float kArch = 7.0;
const float kArchEnd = 12.0;
const vec3 kReachOfAirway = vec3(1.40, 0.17, 0.69); // back, roofFrom, roofTo
const vec3 kReachOfPharynx = vec3(1.075, -0.17, 0.08);

const float kPerNarrowFront = 1.0 / 0.15;
const float kNarrowBack = 1.65;
const float kPerNarrowBack = 1.0 / 0.55;
const float kNarrowLevel = 0.18;
const float kPerNarrowAbove = 1.0 / 0.97;
const float kNarrowBelow = 0.8;
const float kPerNarrowBelow = 1.0 / 0.62;
const float kNarrowBend = 0.1;

const float kSoftContact = 3e-3;
const float kBeforeFace = 7.2e-3;
const float kMostSqueezed = 0.8;
const float kPerBesideBlade = 1.0 / 20e-3;
const float kPerUsualHalfWidth = 1.0 / 8e-3;
const float kPerBeforeHeel = 1.0 / 0.15;
const float kPerPastTip = 1.0 / 0.3;
const float kBendOfLarynx = 0.3;
const float kTongueShare = 1.2;
const float kPharynxFrom = 1.0;
const float kPerPharynx = 1.0 / 1.4;
const float kPerTongueHeight = 1.0 / 2.0;
const float kChinFrom = 1.5;
const float kPerChin = 1.0 / 4.5;

// Each gives a value and its slope.
vec2 step3(float x)
{
    float t = clamp(x, 0.0, 1.0);
    return vec2(t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t));
}

vec2 bulge(float x)
{
    float t = clamp(x, 0.0, 1.0);
    float b = 4.0 * t * (1.0 - t);
    return vec2(b * b, 8.0 * b * (1.0 - 2.0 * t));
}

// A product of functions of v and of h: its value, and its slopes along v and h.
vec3 profile(vec2 along_v, vec2 along_h)
{
    return vec3(along_v.x * along_h.x, along_v.y * along_h.x, along_v.x * along_h.y);
}

// The displacement at q = (u, v, h), and as its rows the slopes of each component.
void chestValue(vec3 q, out vec3 f, out vec3 slope_u, out vec3 slope_v, out vec3 slope_h)
{
    vec3 right = chest[2].xyz;
    vec3 span = chest[3].xyz - right;
    vec2 left = step3((q.x - right.x) / span.x);
    left.y /= span.x;
    vec3 offset = q - (right + left.x * span);
    vec3 curveSlope = left.y * span;
    float beyond = max(q.x - chest[3].x, 0.0) - max(right.x - q.x, 0.0);
    vec3 pull = kStiffness * vec3(beyond, offset.yz);
    float near = 1.0 / (1.0 + dot(pull, vec3(beyond, offset.yz)));
    float away = 1.0 - near * near;
    vec3 awaySlope = 4.0 * near * near * near
                     * vec3(pull.x - pull.y * curveSlope.y - pull.z * curveSlope.z, pull.yz);

    vec4 c0 = motion[0] + left.x * (motion[2] - motion[0]);
    vec4 c1 = motion[1] + left.x * (motion[3] - motion[1]);
    vec4 slope0 = left.y * (motion[2] - motion[0]);
    vec4 slope1 = left.y * (motion[3] - motion[1]);

    float perDepth = 1.0 / (1.0 + 2.0 * kBeyond);
    vec2 back = step3((q.y + kBeyond) * perDepth) * vec2(1.0, perDepth);
    float perFade = 1.0 / (kRibsEnd - kRibsFade);
    vec2 faded = step3((q.y - kRibsFade) * perFade) * vec2(1.0, perFade);
    float frontShare = chest[0].w;
    vec2 fore = vec2(frontShare, 0.0) + (1.0 - frontShare) * back;
    float inside = clamp(1.0 - q.x * q.x, 0.0, 1.0);
    vec2 apart = vec2(1.0 - kTendon * inside * inside, 4.0 * kTendon * q.x * inside);
    vec2 middle = bulge(q.z);
    float perAttachment = 1.0 / kAttachment;
    vec2 below = step3((q.z - 1.0) * perAttachment) * vec2(1.0, perAttachment);
    vec3 base = profile(fore, step3(q.z) - below);
    vec3 spread = profile(fore, kSpread * middle);
    vec2 grown = step3(3.0 * q.z) * vec2(1.0, 3.0);
    vec3 ribs = profile(vec2(1.0, 0.0) - faded, grown);
    vec3 raised = profile(vec2(1.0, 0.0) - faded, grown - below);
    vec3 bulk = profile(bulge(q.y), middle);

    vec3 widening = c0.z * ribs + c0.x * spread;
    vec3 outward = q.x * widening;
    vec3 backward = c0.y * ribs + c1.x * bulk;
    vec3 down = c0.x * apart.x * base + c0.w * raised + c1.y * bulk;
    float outward_u = widening.x + q.x * (slope0.z * ribs.x + slope0.x * spread.x);
    float backward_u = slope0.y * ribs.x + slope1.x * bulk.x;
    float down_u = (c0.x * apart.y + slope0.x * apart.x) * base.x + slope0.w * raised.x
                   + slope1.y * bulk.x;
    f = away * vec3(outward.x, backward.x, down.x);
    slope_u = awaySlope * outward.x + away * vec3(outward_u, outward.yz);
    slope_v = awaySlope * backward.x + away * vec3(backward_u, backward.yz);
    slope_h = awaySlope * down.x + away * vec3(down_u, down.yz);

    float perShift = 1.0 / kShiftOver;
    vec2 upper = step3((q.z - kShiftFrom) * perShift) * vec2(1.0, perShift);
    f.x += c1.w * inside * inside * upper.x;
    slope_u.x += (slope1.w * inside - 4.0 * c1.w * q.x) * inside * upper.x;
    slope_u.z += c1.w * inside * inside * upper.y;

    vec3 along_u = c1.z * curveSlope - slope1.z * offset;
    f -= c1.z * offset;
    slope_u.x += along_u.x - c1.z;
    slope_v.xy += vec2(along_u.y, -c1.z);
    slope_h.xz += vec2(along_u.z, -c1.z);
}

void deform(out vec3 position, out vec3 normal)
{
    position = vertexPosition;
    normal = vertexNormal;
    if (motion == mat4(0.0))
        return;
    vec3 perMetre = chest[1].xyz;
    vec3 f;
    vec3 a;
    vec3 b;
    vec3 c;
    chestValue((position - chest[0].xyz) * perMetre, f, a, b, c);
    position += f / perMetre;
    a.x += 1.0;
    b.y += 1.0;
    c.z += 1.0;
    vec3 n = normal / perMetre;
    normal = normalize(perMetre * vec3(dot(cross(b, c), n), dot(cross(c, a), n), dot(cross(a, b), n)));
}

#ifdef JAW_MOVES
// How far a place follows the jaw, and how that changes from place to place.
float jawShare(vec3 reach, vec3 p, out vec3 slope)
{
    float perLength = throat[1].w;
    vec3 q = perLength * (p - throat[1].xyz);
    float narrow = 1.0 / (1.0 + kArchEnd * q.x * q.x);
    float arch = kArch * q.x * q.x * narrow;
    float perDepth = 1.0 / (reach.x - kChin);
    float perRoof = 1.0 / (reach.z - reach.y);
    vec2 high = step3(dot(throat[0].xyz, p) + throat[0].w);
    vec2 fore = step3((reach.x - q.y + arch) * perDepth);
    vec2 roof = step3((q.z - reach.y) * perRoof);
    float below = 1.0 - roof.x;
    float forward = perLength * high.x * below * perDepth * fore.y;
    slope = (high.y * fore.x * below) * throat[0].xyz;
    slope.x += forward * 2.0 * kArch * q.x * narrow * narrow;
    slope.y -= forward;
    slope.z -= perLength * high.x * fore.x * perRoof * roof.y;
    return high.x * fore.x * below;
}

void followJaw(inout vec3 position, inout vec3 normal)
{
    if (vertexPart.y < kMediastinum || jaw == mat4(0.0))
        return;
#ifdef NECK_BENDS
    // In the frame of the head: v * m is transpose(m) * v.
    mat3 head = mat3(headPose);
    position = (position - headPose[3].xyz) * head;
    normal = normal * head;
#endif
    vec3 slope;
    float s = jawShare(vertexPart.y == kPharynx ? kReachOfPharynx : kReachOfAirway, position, slope);
    vec3 anchor = mat3(jaw) * throat[2].xyz + jaw[3].xyz;
    vec3 turned = mat3(jaw) * (position - throat[2].xyz);
    position += s * (anchor + s * turned);
    vec3 along = anchor + 2.0 * s * turned;
    mat3 j = mat3(1.0) + s * s * mat3(jaw) + outerProduct(along, slope);
    normal = normalize(normal.x * cross(j[1], j[2]) + normal.y * cross(j[2], j[0])
                       + normal.z * cross(j[0], j[1]));
#ifdef NECK_BENDS
    position = head * position + headPose[3].xyz;
    normal = head * normal;
#endif
}
#endif

#if defined(AIRWAY_CHANGES) || defined(BLADE_PUSHES) || defined(NECK_BENDS)
// The normal that a surface has after a displacement with this gradient.
vec3 turnedNormal(mat3 gradient, vec3 n)
{
    mat3 j = mat3(1.0) + gradient;
    return normalize(n.x * cross(j[1], j[2]) + n.y * cross(j[2], j[0]) + n.z * cross(j[0], j[1]));
}

#endif

#ifdef AIRWAY_CHANGES
void narrow(mat4 lumen, inout vec3 position, inout vec3 normal)
{
    if (lumen[3].x == 0.0)
        return;
    float across = dot(lumen[0].xyz, position) + lumen[0].w;
    float along = dot(lumen[1].xyz, position) + lumen[1].w;
    float up = dot(lumen[2].xyz, position) + lumen[2].w;
    vec2 front = step3(along * kPerNarrowFront);
    vec2 back = step3((along - kNarrowBack) * kPerNarrowBack);
    vec2 above = step3((up - kNarrowLevel) * kPerNarrowAbove);
    vec2 below = step3((up + kNarrowBelow) * kPerNarrowBelow);
    float byLength = front.x * (1.0 - back.x);
    float byHeight = (1.0 - above.x) * below.x;
    float there = byLength * byHeight;
    if (there == 0.0)
        return;
    float thereAlong =
        byHeight * (front.y * kPerNarrowFront * (1.0 - back.x) - front.x * back.y * kPerNarrowBack);
    float thereUp =
        byLength * (below.y * kPerNarrowBelow * (1.0 - above.x) - below.x * above.y * kPerNarrowAbove);
    float over = along - 1.0;
    float root = sqrt(over * over + 4.0 * kNarrowBend * kNarrowBend);
    vec2 wider = vec2(along - 0.5 * (over + root), 0.5 * (1.0 - over / root));
    float perHalf = 1.0 / (lumen[3].y + lumen[3].z * wider.x);
    float ratio = abs(across) * perHalf;
    float perOuter = 1.0 / (lumen[3].w - 1.0);
    vec2 beside = step3((ratio - 1.0) * perOuter);
    float share = (1.0 - beside.x) * there;
    float steep = beside.y * perOuter * ratio * there;
    float byAlong = (1.0 - beside.x) * thereAlong + steep * perHalf * lumen[3].z * wider.y;
    float byUp = (1.0 - beside.x) * thereUp;
    vec3 slope = (share - steep) * lumen[0].xyz + across * (byAlong * lumen[1].xyz + byUp * lumen[2].xyz);
    position -= lumen[3].x * across * share * lumen[0].xyz;
    normal = turnedNormal(outerProduct(-lumen[3].x * lumen[0].xyz, slope), normal);
}

void swell(mat4 swelling, inout vec3 position, inout vec3 normal)
{
    vec3 axis = swelling[1].xyz;
    vec3 from = position - swelling[0].xyz;
    float along = dot(axis, from);
    vec3 aside = from - along * axis;
    float rest = 1.0 - swelling[0].w * dot(aside, aside) - swelling[1].w * along * along;
    if (rest <= 0.0)
        return;
    float share = rest * rest;
    vec3 slope = -4.0 * rest * (swelling[0].w * aside + swelling[1].w * along * axis);
    float isFlat = swelling[3].y;
    float ball = 1.0 - isFlat;
    vec3 outward = ball * aside + along * axis;
    float per = 1.0 / sqrt(dot(outward, outward) + swelling[3].x);
    vec3 whole = swelling[2].w * per * outward + swelling[2].xyz;
    mat3 outSlope = mat3(ball) + isFlat * outerProduct(axis, axis)
                    - per * per * outerProduct(outward, outward);
    position += share * whole;
    normal = turnedNormal(outerProduct(whole, slope) + share * swelling[2].w * per * outSlope, normal);
}

void changeAirway(inout vec3 position, inout vec3 normal)
{
    if (vertexPart.y < kLooseTooth)
        return;
    if (vertexPart.y == kLarynx) {
        narrow(cords, position, normal);
        narrow(web, position, normal);
    }
    if (vertexPart.y >= kThroat) {
        narrow(vestibule, position, normal);
        narrow(pharynx, position, normal);
    }
    if (vertexPart.y == kMediastinum) {
        narrow(windpipeSides, position, normal);
        narrow(windpipeDepth, position, normal);
    }
    int tissue = 1 << int(vertexPart.y - kLooseTooth);
    for (int i = 0; i < 19; ++i)
        if ((int(swellings[i].form[3].z) & tissue) != 0)
            swell(swellings[i].form, position, normal);
}

// By the place in the surfaces.
void tintAirway(vec3 position)
{
    if (vertexPart.y < kLooseTooth)
        return;
    int tissue = 1 << int(vertexPart.y - kLooseTooth);
    for (int i = 0; i < 8; ++i) {
        mat4 place = tints[i].place;
        if ((int(place[3].x) & tissue) == 0)
            continue;
        vec3 from = position - place[0].xyz;
        float along = dot(place[1].xyz, from);
        vec3 aside = from - along * place[1].xyz;
        float rest = 1.0 - place[0].w * dot(aside, aside) - place[1].w * along * along;
        albedo = mix(albedo, place[2].xyz, place[2].w * step3(2.0 * rest).x);
    }
}
#endif

#ifdef NECK_BENDS
void bend(mat4 neck, inout vec3 position, inout vec3 normal)
{
    if (neck[0].w == 0.0)
        return;
    vec3 from = position - neck[0].xyz;
    float root = sqrt(from.y * from.y + neck[2].y);
    vec2 share = step3(dot(neck[1].xyz, position) + neck[1].w + neck[2].x * root);
    if (share.x == 0.0)
        return;
    vec3 slope = neck[0].w * share.y * (neck[1].xyz + vec3(0.0, neck[2].x * from.y / root, 0.0));
    float angle = neck[0].w * share.x;
    float sine = sin(angle);
    float halfSine = sin(0.5 * angle);
    float less = 2.0 * halfSine * halfSine; // 1 - cosine
    vec3 shift = vec3(0.0, -less * from.y - sine * from.z, sine * from.y - less * from.z);
    vec3 turned = from + shift;
    mat3 turn = mat3(0.0, 0.0, 0.0, 0.0, -less, sine, 0.0, -sine, -less); // column by column
    position += shift;
    normal = turnedNormal(turn + outerProduct(vec3(0.0, -turned.z, turned.y), slope), normal);
}
#endif

#ifdef BLADE_PUSHES
void pushByBlade(inout vec3 position, inout vec3 normal)
{
    float across = dot(blade[0].xyz, position) + blade[0].w;
    float along = dot(blade[2].xyz, position) + blade[2].w;
    float onBlade = clamp(along, 0.0, 1.0);
    float faceSlope = blade[3].x - 4.0 * blade[3].y * (1.0 - 2.0 * onBlade);
    float face = blade[3].x * onBlade - 4.0 * blade[3].y * onBlade * (1.0 - onBlade)
                 + faceSlope * (along - onBlade);
    float inside = face - dot(blade[1].xyz, position) - blade[1].w;
    float narrow = min(blade[3].z * kPerUsualHalfWidth, 1.0);
    float soft = 2.0 * kSoftContact * narrow;
    float perBeside = kPerBesideBlade / narrow;
    float depth = inside + kBeforeFace * narrow;
    float root = sqrt(depth * depth + soft * soft);
    vec2 push = 0.5 * kMostSqueezed * vec2(depth + root, 1.0 + depth / root);
    vec2 heel = step3(along * kPerBeforeHeel + 1.0);
    vec2 tip = step3((along - 1.0) * kPerPastTip);
    vec2 side = step3((abs(across) - blade[3].z) * perBeside);
    float byLength = heel.x * (1.0 - tip.x);
    float byWidth = 1.0 - side.x;
    float byLengthSlope =
        heel.y * kPerBeforeHeel * (1.0 - tip.x) - heel.x * tip.y * kPerPastTip;
    float byWidthSlope = (across < 0.0 ? side.y : -side.y) * perBeside;
    float share = byLength * byWidth;
    vec3 slope = (byLengthSlope * byWidth * push.x + share * push.y * faceSlope) * blade[2].xyz
                 + byLength * byWidthSlope * push.x * blade[0].xyz
                 - share * push.y * blade[1].xyz;
    position += share * push.x * blade[1].xyz;
    normal = turnedNormal(outerProduct(blade[1].xyz, slope), normal);
}

vec2 leaning(float height)
{
    float perHeight = 1.0 / (1.0 - 0.5 * kBendOfLarynx);
    float h = max(height, 0.0);
    float low = min(h, kBendOfLarynx);
    return perHeight * vec2(0.5 * low * low / kBendOfLarynx + h - low, low / kBendOfLarynx);
}

vec2 leaningOfPharynx(float height)
{
    vec2 lean = leaning(height);
    vec2 above = step3((height - kPharynxFrom) * kPerPharynx);
    return vec2(lean.x * (1.0 - above.x),
                lean.y * (1.0 - above.x) - lean.x * above.y * kPerPharynx);
}

void tiltLarynx(inout vec3 position, inout vec3 normal)
{
    vec2 lean = leaning(dot(tilt[1].xyz, position) + tilt[1].w);
    vec2 behind = step3(dot(tilt[2].xyz, position) + tilt[2].w);
    vec3 slope = lean.y * (1.0 - behind.x) * tilt[1].xyz - lean.x * behind.y * tilt[2].xyz;
    position += lean.x * (1.0 - behind.x) * tilt[0].xyz;
    normal = turnedNormal(outerProduct(tilt[0].xyz, slope), normal);
}

// By a share of the tilt, and its slope, at the height of the position; less to the back by a linear
// function of the place (BladeDepth).
void shiftForward(vec2 share, vec4 depth, inout vec3 position, inout vec3 normal)
{
    vec2 behind = step3(dot(depth.xyz, position) + depth.w);
    vec2 chin = step3((-dot(tilt[2].xyz, position) - tilt[2].w - kChinFrom) * kPerChin);
    float place = (1.0 - behind.x) * (1.0 - chin.x);
    vec3 placeSlope = chin.y * kPerChin * (1.0 - behind.x) * tilt[2].xyz
                      - behind.y * (1.0 - chin.x) * depth.xyz;
    vec3 slope = share.y * place * tilt[1].xyz + share.x * placeSlope;
    position += share.x * place * tilt[0].xyz;
    normal = turnedNormal(outerProduct(tilt[0].xyz, slope), normal);
}

vec4 depthBehindHinge()
{
    float lean = -dot(tilt[2].xyz, tilt[1].xyz) / max(dot(tilt[1].xyz, tilt[1].xyz), 1e-6);
    return tilt[2] + lean * tilt[1];
}

void giveWayToBlade(inout vec3 position, inout vec3 normal)
{
    if (blade == mat4(0.0))
        return;
    float height = dot(tilt[1].xyz, position) + tilt[1].w;
    if (vertexPart.y == kThroat) {
        vec2 high = step3(height * kPerTongueHeight) * vec2(1.0, kPerTongueHeight);
        shiftForward(kTongueShare * high, tilt[2], position, normal);
        pushByBlade(position, normal);
    } else if (vertexPart.y == kLarynx) {
        tiltLarynx(position, normal);
    } else if (vertexPart.y == kPharynx) {
        vec4 depth = depthBehindHinge() + vec4(0.0, 0.0, 0.0, 1.0);
        shiftForward(leaningOfPharynx(height), depth, position, normal);
    }
}
#endif

#if defined(BLADE_PUSHES) && defined(SPOTLIGHT)
// The share of light that comes to a place near a blade, which shades it: least where both touch.
float pastBlade(vec3 position)
{
    if (blade == mat4(0.0))
        return 1.0;
    float along = dot(blade[2].xyz, position) + blade[2].w;
    float onBlade = clamp(along, 0.0, 1.0);
    float face = blade[3].x * onBlade - 4.0 * blade[3].y * onBlade * (1.0 - onBlade);
    vec3 off = vec3(dot(blade[1].xyz, position) + blade[1].w - face,
                    max(abs(dot(blade[0].xyz, position) + blade[0].w) - blade[3].z, 0.0),
                    (along - onBlade) * inversesqrt(dot(blade[2].xyz, blade[2].xyz)));
    return 1.0 - kBladeShade * exp(-length(off) * kPerShade);
}
#endif

#ifdef SPOTLIGHT
#ifdef MOIST
// moist.frag lights it.
vec4 shadeAt(vec3 position, vec3 normal)
{
    vec4 look = kLooks[int(vertexPart.z)];
    float edge = 1.0 - abs(dot(normal, normalize(eyePosition - position)));
    return vec4(albedo, mix(look.y, look.z, edge * edge));
}
#else
// Light of more than kShoulder, so that it comes to 1 only in the limit.
vec3 compressed(vec3 light)
{
    vec3 above = max(light - kShoulder, 0.0) / (1.0 - kShoulder);
    return min(light, kShoulder) + (1.0 - kShoulder) * above / (1.0 + above);
}

// A lamp beside the eye, as on a laryngoscope's blade: less light away from its axis, by the square
// of the distance as of any small lamp, and a highlight of the film of moisture on what faces it.
vec4 shadeAt(vec3 position, vec3 normal)
{
    vec4 look = kLooks[int(vertexPart.z)];
    vec3 way = eyePosition - position;
    float far2 = dot(way, way);
    vec3 view = way * inversesqrt(far2);
    if (dot(normal, view) < 0.0)
        normal = -normal;
    float facing = dot(normal, view);
    float edge = (1.0 - facing) * (1.0 - facing);
    float cone = smoothstep(0.45, 0.95, -dot(view, spot.xyz));
    float strength = cone * (1.0 + kSpotNear2) / (far2 / (spot.w * spot.w) + kSpotNear2);
    float facing4 = facing * facing * facing * facing;
    float facing16 = facing4 * facing4 * facing4 * facing4;
    vec3 lit = strength
                   * (albedo * (0.2 + 0.8 * facing) * vec3(1.0, 0.97, 0.92)
                      + vec3(0.6 * look.x * facing16 * facing16))
               + kSpotStray * albedo;
    return vec4(compressed(lit), mix(look.y, look.z, edge));
}
#endif
#else
// A headlight, a soft sky that is brighter from above and in front of the patient, a small
// highlight, and a rim that turns towards the silhouette. Both faces are lit. Worked out here and
// not for each pixel: of a whole patient there are fewer vertices than pixels to shade.
vec4 shadeAt(vec3 position, vec3 normal)
{
    vec4 look = kLooks[int(vertexPart.z)];
    vec3 view = normalize(eyePosition - position);
    if (dot(normal, view) < 0.0)
        normal = -normal;
    float facing = dot(normal, view);
    float edge = (1.0 - facing) * (1.0 - facing);

    vec3 sky = mix(kGround, kSky, 0.5 + 0.5 * dot(normal, kZenith));
    vec3 light = 0.74 * facing * vec3(1.0, 0.98, 0.95) + 0.44 * sky;
    vec3 halfway = view + kLamp; // not of unit length: divided out below
    float aligned = dot(normal, halfway);
    float cosine2 = aligned * aligned / dot(halfway, halfway);
    float cosine8 = cosine2 * cosine2 * cosine2 * cosine2;
    float highlight = look.x * cosine8 * cosine8 * cosine8 * cosine8;
    vec3 lit = albedo * light + vec3(0.5 * highlight) + look.w * edge * mix(albedo, kSky, 0.35);
    return vec4(lit, mix(look.y, look.z, edge));
}
#endif

void main()
{
#ifdef MANY_REGIONS
    motion = regions[int(vertexPart.y)].motion;
#endif
    vec3 position;
    vec3 normal;
    deform(position, normal);
    albedo = vertexColor * vertexColor;
#ifdef AIRWAY_CHANGES
    tintAirway(position);
    changeAirway(position, normal);
#endif
#ifdef NECK_BENDS
    position = vec3(intoNeck * vec4(position, 1.0));
    normal = mat3(intoNeck) * normal;
    bend(neckExtension, position, normal);
    bend(neckFlexion, position, normal);
    position = vec3(outOfNeck * vec4(position, 1.0));
    normal = mat3(outOfNeck) * normal;
#endif
#ifdef JAW_MOVES
    followJaw(position, normal);
#endif
#ifdef BLADE_PUSHES
    giveWayToBlade(position, normal);
#ifdef SPOTLIGHT
    albedo *= pastBlade(position);
#endif
#endif

    worldPosition = vec3(modelMatrix * vec4(position, 1.0));
    worldNormal = normalize(modelNormalMatrix * normal);
    shade = shadeAt(worldPosition, worldNormal);
    part = vertexPart;
#ifdef MOIST
    restPosition = vertexPosition;
#endif
    bool whole = vertexPart.z == kTool || vertexPart.z == kFluid || (cutAway == 1.0 && vertexPart.z == kAirway);
    gl_ClipDistance[0] = whole ? 1.0 : section.w - dot(section.xyz, worldPosition);
    gl_Position = mvp * vec4(position, 1.0);
}
