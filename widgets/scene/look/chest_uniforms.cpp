#include "widgets/scene/look/chest_uniforms.h"

#include <QVector4D>

namespace carina
{
namespace
{

QVector4D column(const Shares<float>& s, float last = 0.0F) { return {s.u, s.v, s.h, last}; }
QVector4D column(const Vec3f& v, float last = 0.0F) { return {v.x(), v.y(), v.z(), last}; }

QMatrix4x4 narrowingUniform(const NarrowingFrame<float>& frame)
{
    QMatrix4x4 uniform;
    uniform.setColumn(0, column(frame.across, frame.acrossFrom));
    uniform.setColumn(1, column(frame.along, frame.alongFrom));
    uniform.setColumn(2, column(frame.up, frame.upFrom));
    uniform.setColumn(3, {frame.closing, frame.front, frame.wider, frame.outer});
    return uniform;
}

QMatrix4x4 swellingUniform(const SwellingFrame<float>& frame)
{
    QMatrix4x4 uniform;
    uniform.setColumn(0, column(frame.centre, frame.perAcross2));
    uniform.setColumn(1, column(frame.axis, frame.perAlong2));
    uniform.setColumn(2, column(frame.shift, frame.outward));
    uniform.setColumn(3, {frame.soft2, frame.isFlat, frame.tissues, 0.0F});
    return uniform;
}

QMatrix4x4 tintUniform(const TintFrame<float>& frame)
{
    QMatrix4x4 uniform;
    uniform.setColumn(0, column(frame.centre, frame.perAcross2));
    uniform.setColumn(1, column(frame.axis, frame.perAlong2));
    uniform.setColumn(2, column(frame.light, frame.share));
    uniform.setColumn(3, {frame.tissues, 0.0F, 0.0F, 0.0F});
    return uniform;
}

QMatrix4x4 bendUniform(const NeckBend<float>& bend)
{
    QMatrix4x4 uniform;
    uniform.setColumn(0, column(bend.hinge, bend.angle));
    uniform.setColumn(1, column(bend.along, bend.from));
    uniform.setColumn(2, {bend.arch, bend.soft2, 0.0F, 0.0F});
    return uniform;
}

QMatrix4x4 poseUniform(const RigidTransform& X)
{
    const Eigen::Matrix3f turn = X.rotation().toRotationMatrix().cast<float>();
    QMatrix4x4 uniform;
    for (int axis = 0; axis < 3; ++axis)
        uniform.setColumn(axis, column(Vec3f{turn.col(axis)}));
    uniform.setColumn(3, column(Vec3f{X.translation().cast<float>()}, 1.0F));
    return uniform;
}

} // namespace

QMatrix4x4 chestUniform(const ChestField& field)
{
    const ChestFrame<float> frame = inSingle(field.frame());
    QMatrix4x4 uniform;
    uniform.setColumn(0, column(frame.origin, frame.frontShare));
    uniform.setColumn(1, column(frame.perMetre));
    uniform.setColumn(2, column(frame.rightHilum));
    uniform.setColumn(3, column(frame.leftHilum));
    return uniform;
}

QMatrix4x4 motionUniform(const ChestMotion& motion)
{
    const ChestCoefficients<float> c = inSingle(motion);
    QMatrix4x4 uniform;
    int next = 0;
    for (const ChestTerms<float>& side : {c.right, c.left}) {
        uniform.setColumn(next++, {side.descent, side.forward, side.flare, side.lift});
        uniform.setColumn(next++, {side.bulkBack, side.bulkDown, side.shrink, side.shift});
    }
    return uniform;
}

QMatrix4x4 throatUniform(const ThroatField& field)
{
    const ThroatFrame<float> frame = inSingle(field.frame());
    QMatrix4x4 uniform;
    uniform.setColumn(0, column(frame.up, frame.upFrom));
    uniform.setColumn(1, column(frame.incisors, frame.perLength));
    uniform.setColumn(2, column(frame.anchor));
    return uniform;
}

QMatrix4x4 jawUniform(const RigidTransform& X_AJ)
{
    const JawShift<float> jaw = inSingle(jawShift(X_AJ));
    QMatrix4x4 uniform;
    for (int axis = 0; axis < 3; ++axis)
        uniform.setColumn(axis, column(Vec3f{jaw.turn.col(axis)}));
    uniform.setColumn(3, column(jaw.shift));
    return uniform;
}

QMatrix4x4 bladeUniform(const BladeField& field)
{
    const BladeFrame<float> frame = inSingle(field.frame());
    QMatrix4x4 uniform;
    uniform.setColumn(0, column(frame.across, frame.acrossFrom));
    uniform.setColumn(1, column(frame.out, frame.outFrom));
    uniform.setColumn(2, column(frame.along, frame.alongFrom));
    uniform.setColumn(3, {frame.rise, frame.sag, frame.halfWidth, 0.0F});
    return uniform;
}

QMatrix4x4 tiltUniform(const BladeField& field)
{
    const BladeFrame<float> frame = inSingle(field.frame());
    QMatrix4x4 uniform;
    uniform.setColumn(0, column(frame.tilt));
    uniform.setColumn(1, column(frame.up, frame.upFrom));
    uniform.setColumn(2, column(frame.back, frame.backFrom));
    return uniform;
}

std::array<NamedUniform, kAirwayUniforms> airwayUniforms(const AirwayField& field)
{
    constexpr std::array kSwellings{
        "swellings[0].form",  "swellings[1].form",  "swellings[2].form",  "swellings[3].form",
        "swellings[4].form",  "swellings[5].form",  "swellings[6].form",  "swellings[7].form",
        "swellings[8].form",  "swellings[9].form",  "swellings[10].form", "swellings[11].form",
        "swellings[12].form", "swellings[13].form", "swellings[14].form", "swellings[15].form",
        "swellings[16].form", "swellings[17].form", "swellings[18].form"};
    static_assert(kSwellings.size() == kMostSwellings);
    constexpr std::array kTints{"tints[0].place", "tints[1].place", "tints[2].place",
                                "tints[3].place", "tints[4].place", "tints[5].place",
                                "tints[6].place", "tints[7].place"};
    static_assert(kTints.size() == kMostTints);
    const AirwayFrame<float> frame = inSingle(field.frame());
    std::array<NamedUniform, kAirwayUniforms> all;
    all[0] = {"cords", narrowingUniform(frame.cords)};
    all[1] = {"web", narrowingUniform(frame.web)};
    all[2] = {"vestibule", narrowingUniform(frame.vestibule)};
    all[3] = {"pharynx", narrowingUniform(frame.pharynx)};
    all[4] = {"windpipeSides", narrowingUniform(frame.windpipeSides)};
    all[5] = {"windpipeDepth", narrowingUniform(frame.windpipeDepth)};
    for (std::size_t n = 0; n < kMostSwellings; ++n)
        all[6 + n] = {kSwellings[n], swellingUniform(frame.swellings[n])};
    for (std::size_t n = 0; n < kMostTints; ++n)
        all[6 + kMostSwellings + n] = {kTints[n], tintUniform(frame.tints[n])};
    return all;
}

std::array<NamedUniform, kNeckUniforms> neckUniforms(const NeckField& field,
                                                     const std::optional<RigidTransform>& X_AF)
{
    const NeckFrame<float> frame = inSingle(field.frame());
    const RigidTransform X_FA_bent = X_AF ? outOfNeck(field, *X_AF) : RigidTransform{};
    return {NamedUniform{"neckExtension", bendUniform(frame.extension)},
            NamedUniform{"neckFlexion", bendUniform(frame.flexion)},
            NamedUniform{"headPose", poseUniform(field.X_AU())},
            NamedUniform{"intoNeck", poseUniform(X_AF.value_or(RigidTransform{}))},
            NamedUniform{"outOfNeck", poseUniform(X_FA_bent)}};
}

bool isJawMoved(const RigidTransform& X_AJ)
{
    const JawShift<float> jaw = inSingle(jawShift(X_AJ));
    return !jaw.turn.isZero(0.0F) || !jaw.shift.isZero(0.0F);
}

} // namespace carina
