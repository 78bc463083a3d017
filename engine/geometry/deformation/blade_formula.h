#pragma once

#include "engine/geometry/deformation/airway_tissue.h"
#include "engine/geometry/deformation/throat_formula.h"

#include <cmath>

namespace carina
{

/// The closed form behind BladeField, for double and float. resources/shaders/organ.vert is a
/// second implementation, for the graphics card.

/// The parameters of one blade in a patient, in A, metres. With all zeros nothing moves.
template <class T> struct BladeFrame {
    /// The blade's frame L: a point lies dot(axis, p) + from across it and above its heel towards
    /// the handle; `along` in shares of the way from heel to tip.
    Vector3<T> across = Vector3<T>::Zero();
    Vector3<T> out = Vector3<T>::Zero();
    Vector3<T> along = Vector3<T>::Zero();
    T acrossFrom{};
    T outFrom{};
    T alongFrom{};
    T rise{}; ///< of the tip above the heel
    T sag{};  ///< of the middle below the line from heel to tip
    T halfWidth{};
    /// The displacement of what lies at height 1 of the larynx, dot(up, p) + upFrom, and in front
    /// of where dot(back, p) + backFrom is 0; from where that is 1 on nothing moves.
    Vector3<T> tilt = Vector3<T>::Zero();
    Vector3<T> up = Vector3<T>::Zero();
    T upFrom{};
    Vector3<T> back = Vector3<T>::Zero();
    T backFrom{};
};

namespace formula
{

inline constexpr double kSoftContact = 3e-3; ///< metres over which tissue begins to give way
/// Tissue gives way so far before the blade's face, metres, by at most this share of what it lies
/// deeper: no sheet becomes thinner than a fifth of what it was.
inline constexpr double kBeforeFace = 7.2e-3;
inline constexpr double kMostSqueezed = 0.8;
inline constexpr double kBesideBlade = 20e-3; ///< metres beside its edge where its effect ends
/// These lengths are those of a blade as wide as a grown person's, or wider; of a narrower one they
/// are less in proportion, or an infant's blade would take the cheeks along.
inline constexpr double kUsualHalfWidth = 8e-3;
inline constexpr double kBeforeHeel = 0.15; ///< likewise, in shares of its length
inline constexpr double kPastTip = 0.3;
inline constexpr double kBendOfLarynx = 0.3; ///< height over which its tilt begins

/// The base of the tongue goes forward with the larynx: by this share of what lies at height 1,
/// from this height on; less from kChinFrom to kChinEnd in front of the larynx, in units in which
/// tilting fades behind it.
inline constexpr double kTongueShare = 1.2;
inline constexpr double kTongueHeight = 2.0;
inline constexpr double kChinFrom = 1.5;
inline constexpr double kChinEnd = 6.0;
/// Heights between which the pharynx ceases to lean with the larynx beside it: above are the palate
/// and what hangs from it, which no blade takes along. In between it leans by less than
/// kTongueShare.
inline constexpr double kPharynxFrom = 1.0;
inline constexpr double kPharynxTo = 2.4;

/// How far the face of a blade lies above its heel, at a share of its length: the parabola that
/// rises by `rise` and sags by `sag` below that half way; straight on beyond its ends.
template <class T> Smooth<T> bladeFace(T rise, T sag, T along)
{
    const T s = clamped(along);
    const T slope = rise - T(4) * sag * (T(1) - T(2) * s);
    return {rise * s - T(4) * sag * s * (T(1) - s) + slope * (along - s), slope};
}

/// How far something is pushed that would lie `inside` the face of a blade: nearly 0 far outside.
/// Its slope is between 0 and kMostSqueezed. It is more than `inside`, so that nothing stays inside
/// the blade, up to kMostSqueezed kBeforeFace narrow / (1 - kMostSqueezed): 28.8 mm where `narrow`
/// is 1.
/// @param narrow what the lengths of contact are multiplied by (narrowness); above 0
template <class T> Smooth<T> contactPush(T inside, T narrow)
{
    using std::sqrt;
    constexpr auto kHalf = T(0.5 * kMostSqueezed);
    const T depth = inside + T(kBeforeFace) * narrow;
    const T soft = T(2.0 * kSoftContact) * narrow;
    const T root = sqrt(depth * depth + soft * soft);
    return {kHalf * (depth + root), kHalf * (T(1) + depth / root)};
}

/// What lengths of contact and kBesideBlade are multiplied by for a blade of this half width: at
/// most 1.
template <class T> T narrowness(T halfWidth)
{
    using std::min;
    return min(halfWidth * T(1.0 / kUsualHalfWidth), T(1));
}

/// How far what lies at a height of the larynx leans over: not at all below 0, from kBendOfLarynx
/// on in proportion, and by 1 at height 1.
template <class T> Smooth<T> leaning(T height)
{
    using std::max;
    using std::min;
    constexpr auto kBend = T(kBendOfLarynx);
    constexpr auto kPerHeight = T(1.0 / (1.0 - 0.5 * kBendOfLarynx));
    const T h = max(height, T(0));
    const T low = min(h, kBend);
    return {kPerHeight * (T(0.5) * low * low / kBend + h - low), kPerHeight * low / kBend};
}

/// The same of the pharynx: as the larynx up to kPharynxFrom, and not at all from kPharynxTo on.
template <class T> Smooth<T> leaningOfPharynx(T height)
{
    constexpr auto kPer = T(1.0 / (kPharynxTo - kPharynxFrom));
    const Smooth<T> lean = leaning<T>(height);
    const Smooth<T> above = step<T>((height - T(kPharynxFrom)) * kPer);
    return {lean.value * (T(1) - above.value),
            lean.slope * (T(1) - above.value) - lean.value * above.slope * kPer};
}

} // namespace formula

/// The displacement at p of what the face of a blade pushes away, and its gradient (BladeField).
template <class T>
[[nodiscard]] DisplacementAt<T> bladePush(const BladeFrame<T>& blade, const Vector3<T>& p)
{
    using formula::Smooth;
    using formula::step;
    if (blade.halfWidth == T(0))
        return {Vector3<T>::Zero(), Matrix3<T>::Zero()};
    const T across = blade.across.dot(p) + blade.acrossFrom;
    const T along = blade.along.dot(p) + blade.alongFrom;
    const Smooth<T> face = formula::bladeFace(blade.rise, blade.sag, along);
    const T narrow = formula::narrowness(blade.halfWidth);
    const T perBeside = T(1.0 / formula::kBesideBlade) / narrow;
    const Smooth<T> push =
        formula::contactPush<T>(face.value - blade.out.dot(p) - blade.outFrom, narrow);
    const Smooth<T> heel = step<T>(along * T(1.0 / formula::kBeforeHeel) + T(1));
    const Smooth<T> tip = step<T>((along - T(1)) * T(1.0 / formula::kPastTip));
    const T aside = across < T(0) ? -across : across;
    const Smooth<T> side = step<T>((aside - blade.halfWidth) * perBeside);
    const T byLength = heel.value * (T(1) - tip.value);
    const T byWidth = T(1) - side.value;
    const T byLengthSlope = heel.slope * T(1.0 / formula::kBeforeHeel) * (T(1) - tip.value)
                            - heel.value * tip.slope * T(1.0 / formula::kPastTip);
    const T byWidthSlope = (across < T(0) ? side.slope : -side.slope) * perBeside;
    const T share = byLength * byWidth;
    const Vector3<T> slope =
        (byLengthSlope * byWidth * push.value + share * push.slope * face.slope) * blade.along
        + byLength * byWidthSlope * push.value * blade.across - share * push.slope * blade.out;
    return {share * push.value * blade.out, blade.out * slope.transpose()};
}

/// The displacement at p of the larynx, which the blade tilts with its epiglottis, and its
/// gradient.
template <class T>
[[nodiscard]] DisplacementAt<T> larynxTilt(const BladeFrame<T>& blade, const Vector3<T>& p)
{
    const formula::Smooth<T> lean = formula::leaning<T>(blade.up.dot(p) + blade.upFrom);
    const formula::Smooth<T> behind = formula::step<T>(blade.back.dot(p) + blade.backFrom);
    const T front = T(1) - behind.value;
    const Vector3<T> slope = lean.slope * front * blade.up - lean.value * behind.slope * blade.back;
    return {lean.value * front * blade.tilt, blade.tilt * slope.transpose()};
}

/// A linear function of the place: what is moved is so wholly up to 0, and not from 1 on.
template <class T> struct BladeDepth {
    Vector3<T> slope;
    T from{};

    [[nodiscard]] T at(const Vector3<T>& p) const { return slope.dot(p) + from; }
};

/// How far a place is behind the hinge of the larynx, across the trachea, in units in which tilting
/// fades there.
template <class T> [[nodiscard]] BladeDepth<T> depthBehindHinge(const BladeFrame<T>& blade)
{
    using std::max;
    constexpr auto kNoTilt = T(1e-6); // per square metre: `up` is 0 then
    const T lean = -blade.back.dot(blade.up) / max(blade.up.squaredNorm(), kNoTilt);
    return {blade.back + lean * blade.up, blade.backFrom + lean * blade.upFrom};
}

/// The displacement at p of what goes forward with the larynx by a share of the tilt, and its
/// gradient: less and less to the back and towards the chin.
/// @param share at the height of p
template <class T>
[[nodiscard]] DisplacementAt<T> forwardShift(const BladeFrame<T>& blade, const Vector3<T>& p,
                                             const formula::Smooth<T>& share,
                                             const BladeDepth<T>& depth)
{
    using formula::Smooth;
    using formula::step;
    constexpr auto kPerChin = T(1.0 / (formula::kChinEnd - formula::kChinFrom));
    const Smooth<T> behind = step<T>(depth.at(p));
    const Smooth<T> chin =
        step<T>((-blade.back.dot(p) - blade.backFrom - T(formula::kChinFrom)) * kPerChin);
    const T place = (T(1) - behind.value) * (T(1) - chin.value);
    const Vector3<T> placeSlope = chin.slope * kPerChin * (T(1) - behind.value) * blade.back
                                  - behind.slope * (T(1) - chin.value) * depth.slope;
    const Vector3<T> slope = share.slope * place * blade.up + share.value * placeSlope;
    return {share.value * place * blade.tilt, blade.tilt * slope.transpose()};
}

/// The displacement at p of the tongue's base, and its gradient: more and more up to height
/// kTongueHeight, by kTongueShare of the tilt from there on.
template <class T>
[[nodiscard]] DisplacementAt<T> tongueBaseShift(const BladeFrame<T>& blade, const Vector3<T>& p)
{
    constexpr auto kPerHeight = T(1.0 / formula::kTongueHeight);
    constexpr auto kShare = T(formula::kTongueShare);
    const auto high = formula::step<T>((blade.up.dot(p) + blade.upFrom) * kPerHeight);
    return forwardShift<T>(blade, p, {kShare * high.value, kShare * high.slope * kPerHeight},
                           {blade.back, blade.backFrom});
}

/// The displacement at p of the lining of the pharynx, and its gradient. What lies behind the hinge
/// stays, as high as it may be: the wall in front of the spine.
template <class T>
[[nodiscard]] DisplacementAt<T> pharynxShift(const BladeFrame<T>& blade, const Vector3<T>& p)
{
    BladeDepth<T> depth = depthBehindHinge(blade);
    depth.from += T(1);
    const T height = blade.up.dot(p) + blade.upFrom;
    return forwardShift<T>(blade, p, formula::leaningOfPharynx<T>(height), depth);
}

/// The displacement at p of one of the tissues, and its gradient.
template <class T>
[[nodiscard]] DisplacementAt<T> bladePull(const BladeFrame<T>& blade, AirwayTissue tissue,
                                          const Vector3<T>& p)
{
    if (tissue == AirwayTissue::Larynx)
        return larynxTilt(blade, p);
    if (tissue == AirwayTissue::Pharynx)
        return pharynxShift(blade, p);
    if (tissue != AirwayTissue::Throat)
        return {Vector3<T>::Zero(), Matrix3<T>::Zero()};
    return followedBy(tongueBaseShift(blade, p), p,
                      [&blade](const Vector3<T>& moved) { return bladePush(blade, moved); });
}

} // namespace carina
