#include "engine/geometry/deformation/airway_field.h"

#include "engine/core/expects.h"

#include <algorithm>

namespace carina
{
namespace
{

NarrowingFrame<float> narrowingInSingle(const NarrowingFrame<double>& frame)
{
    NarrowingFrame<float> single;
    single.across = frame.across.cast<float>();
    single.along = frame.along.cast<float>();
    single.up = frame.up.cast<float>();
    single.acrossFrom = static_cast<float>(frame.acrossFrom);
    single.alongFrom = static_cast<float>(frame.alongFrom);
    single.upFrom = static_cast<float>(frame.upFrom);
    single.closing = static_cast<float>(frame.closing);
    single.front = static_cast<float>(frame.front);
    single.wider = static_cast<float>(frame.wider);
    single.outer = static_cast<float>(frame.outer);
    return single;
}

SwellingFrame<float> swellingInSingle(const SwellingFrame<double>& frame)
{
    SwellingFrame<float> single;
    single.centre = frame.centre.cast<float>();
    single.axis = frame.axis.cast<float>();
    single.shift = frame.shift.cast<float>();
    single.perAcross2 = static_cast<float>(frame.perAcross2);
    single.perAlong2 = static_cast<float>(frame.perAlong2);
    single.outward = static_cast<float>(frame.outward);
    single.soft2 = static_cast<float>(frame.soft2);
    single.isFlat = static_cast<float>(frame.isFlat);
    single.tissues = static_cast<float>(frame.tissues);
    return single;
}

TintFrame<float> tintInSingle(const TintFrame<double>& frame)
{
    TintFrame<float> single;
    single.centre = frame.centre.cast<float>();
    single.axis = frame.axis.cast<float>();
    single.light = frame.light.cast<float>();
    single.perAcross2 = static_cast<float>(frame.perAcross2);
    single.perAlong2 = static_cast<float>(frame.perAlong2);
    single.share = static_cast<float>(frame.share);
    single.tissues = static_cast<float>(frame.tissues);
    return single;
}

/// Linear, nearly: the square, as the shader has it of the colours of vertices.
Vec3 linearLight(const Rgb& color)
{
    const Vec3 coded = Vec3{double(color[0]), double(color[1]), double(color[2])} / 255.0;
    return coded.cwiseProduct(coded);
}

} // namespace

void AirwayField::swell(const Swelling& swelling)
{
    CARINA_EXPECTS(m_swellings < kMostSwellings);
    const double across = swelling.across.si;
    const double along = swelling.along.si;
    CARINA_EXPECTS(across > 0.0 && along > 0.0 && swelling.depth.si > 0.0);
    CARINA_EXPECTS(swelling.outward.si >= 0.0
                   && swelling.outward.si + swelling.shift_A.norm()
                          <= kMostOfReach * std::min(across, along));
    m_frame.swellings[m_swellings++] = {.centre = swelling.p_A_centre,
                                        .axis = swelling.axis_A,
                                        .shift = swelling.shift_A,
                                        .perAcross2 = 1.0 / (across * across),
                                        .perAlong2 = 1.0 / (along * along),
                                        .outward = swelling.outward.si,
                                        .soft2 = swelling.depth.si * swelling.depth.si,
                                        .isFlat = swelling.isFlat ? 1.0 : 0.0,
                                        .tissues = double(swelling.tissues)};
    m_isThere = true;
}

void AirwayField::tint(const Tint& tint)
{
    CARINA_EXPECTS(m_tints < kMostTints);
    const double across = tint.across.si;
    const double along = tint.along.si;
    CARINA_EXPECTS(across > 0.0 && along > 0.0 && tint.share >= 0.0 && tint.share <= 1.0);
    m_frame.tints[m_tints++] = {.centre = tint.p_A_centre,
                                .axis = tint.axis_A,
                                .light = linearLight(tint.color),
                                .perAcross2 = 1.0 / (across * across),
                                .perAlong2 = 1.0 / (along * along),
                                .share = tint.share,
                                .tissues = double(tint.tissues)};
    m_isThere = true;
}

void AirwayField::joinCords(const Lumen& web, double share)
{
    CARINA_EXPECTS(share >= 0.0);
    close(m_frame.web, web, share);
}

void AirwayField::narrowVestibule(const Lumen& vestibule, double share)
{
    CARINA_EXPECTS(share >= 0.0);
    close(m_frame.vestibule, vestibule, share);
}

void AirwayField::narrowPharynx(const Lumen& pharynx, double share)
{
    CARINA_EXPECTS(share >= 0.0);
    close(m_frame.pharynx, pharynx, share);
}

void AirwayField::narrowWindpipe(const Lumen& sides, double share)
{
    CARINA_EXPECTS(share >= 0.0);
    close(m_frame.windpipeSides, sides, share);
}

void AirwayField::flattenWindpipe(const Lumen& depth, double share)
{
    CARINA_EXPECTS(share >= 0.0);
    close(m_frame.windpipeDepth, depth, share);
}

void AirwayField::close(NarrowingFrame<double>& frame, const Lumen& lumen, double share)
{
    constexpr double kLeastOuterToOpen = 2.0;
    CARINA_EXPECTS(share >= -kMostOpening && share <= kMostClosing);
    CARINA_EXPECTS(lumen.outer > 1.0 && (share >= 0.0 || lumen.outer >= kLeastOuterToOpen));
    CARINA_EXPECTS(lumen.toWidest.si > 0.0 && lumen.halfInFront.si > 0.0
                   && lumen.halfAtWidest.si >= lumen.halfInFront.si);
    const double wider = (lumen.halfAtWidest - lumen.halfInFront).si;
    // Where the lumen begins, upToOne is a little below 0.
    CARINA_EXPECTS(lumen.halfInFront.si > formula::kNarrowBend * formula::kNarrowBend * wider);
    frame.across = lumen.right_A;
    frame.acrossFrom = -frame.across.dot(lumen.p_A_front);
    frame.along = lumen.back_A / lumen.toWidest.si;
    frame.alongFrom = -frame.along.dot(lumen.p_A_front);
    frame.up = lumen.up_A / lumen.toWidest.si;
    frame.upFrom = -frame.up.dot(lumen.p_A_front);
    frame.closing = share;
    frame.front = lumen.halfInFront.si;
    frame.wider = wider;
    frame.outer = lumen.outer;
    m_isThere = m_isThere || share != 0.0;
}

AirwayFrame<float> inSingle(const AirwayFrame<double>& frame)
{
    AirwayFrame<float> single;
    single.cords = narrowingInSingle(frame.cords);
    single.web = narrowingInSingle(frame.web);
    single.vestibule = narrowingInSingle(frame.vestibule);
    single.pharynx = narrowingInSingle(frame.pharynx);
    single.windpipeSides = narrowingInSingle(frame.windpipeSides);
    single.windpipeDepth = narrowingInSingle(frame.windpipeDepth);
    for (std::size_t i = 0; i < kMostSwellings; ++i)
        single.swellings[i] = swellingInSingle(frame.swellings[i]);
    for (std::size_t i = 0; i < kMostTints; ++i)
        single.tints[i] = tintInSingle(frame.tints[i]);
    return single;
}

} // namespace carina
