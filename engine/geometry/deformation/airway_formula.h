#pragma once

#include "engine/geometry/deformation/blade_formula.h"

#include <array>
#include <cmath>

namespace carina
{

/// The closed form behind AirwayField, for double and float. resources/shaders/organ.vert is a
/// second implementation, for the graphics card.

/// Tissue that swells, in A, metres. With all zeros nothing moves.
template <class T> struct SwellingFrame {
    Vector3<T> centre = Vector3<T>::Zero();
    Vector3<T> axis = Vector3<T>::UnitZ(); ///< unit
    Vector3<T> shift = Vector3<T>::Zero();
    T perAcross2{}; ///< 1 / its reach across the axis squared
    T perAlong2{};  ///< the same along it
    T outward{};
    T soft2{};   ///< square of the depth in which it begins
    T isFlat{};  ///< 1: outward along the axis, to both sides; 0: away from the centre
    T tissues{}; ///< AirwayTissues
};

/// A lumen whose walls come together, or part, in A. With all zeros nothing moves.
template <class T> struct NarrowingFrame {
    /// A point lies dot(across, p) + acrossFrom beside the midplane, metres; `along` from 0 in
    /// front to 1 where the lumen is widest, and `up` from its level in the same unit.
    Vector3<T> across = Vector3<T>::Zero();
    Vector3<T> along = Vector3<T>::Zero();
    Vector3<T> up = Vector3<T>::Zero();
    T acrossFrom{};
    T alongFrom{};
    T upFrom{};
    T closing{}; ///< 1: the walls meet
    T front{};   ///< half the lumen's width in front, metres
    T wider{};   ///< by which it is more from `along` 1 on
    T outer{};   ///< in half widths: beyond, nothing moves
};

inline constexpr std::size_t kMostSwellings = 19;

/// Tissue of another colour, in A, metres. With all zeros it keeps its own.
template <class T> struct TintFrame {
    Vector3<T> centre = Vector3<T>::Zero();
    Vector3<T> axis = Vector3<T>::UnitZ(); ///< unit
    Vector3<T> light = Vector3<T>::Zero(); ///< red, green and blue, linear, 0 to 1
    T perAcross2{};                        ///< as of a swelling
    T perAlong2{};
    T share{};   ///< of this colour in the middle, 0 to 1
    T tissues{}; ///< AirwayTissues
};

inline constexpr std::size_t kMostTints = 8;

/// All that changes an airway. A narrowing of the cords, and a web between them, move the larynx,
/// one of the vestibule and one of the pharynx all of kThroatTissues, those of the windpipe, from
/// side to side and from front to back, the windpipe.
template <class T> struct AirwayFrame {
    NarrowingFrame<T> cords;
    NarrowingFrame<T> web;
    NarrowingFrame<T> vestibule;
    NarrowingFrame<T> pharynx;
    NarrowingFrame<T> windpipeSides;
    NarrowingFrame<T> windpipeDepth;
    std::array<SwellingFrame<T>, kMostSwellings> swellings{};
    std::array<TintFrame<T>, kMostTints> tints{}; ///< of tissue where it is in the surfaces
};

namespace formula
{

/// Where a narrowing begins and ends, in units of the way from its front to where it is widest.
inline constexpr double kNarrowFront = 0.15; ///< whole from there on
inline constexpr double kNarrowBack = 1.65;
inline constexpr double kNarrowEnd = 2.2;
inline constexpr double kNarrowLevel = 0.18; ///< whole up to so far above and below its level
inline constexpr double kNarrowAbove = 1.15;
inline constexpr double kNarrowBelow = 0.8;
inline constexpr double kNarrowBend = 0.1; ///< over which the width ceases to grow

/// What grows in proportion, but no more from 1 on.
template <class T> Smooth<T> upToOne(T x)
{
    using std::sqrt;
    constexpr auto kSoft = T(4.0 * kNarrowBend * kNarrowBend);
    const T over = x - T(1);
    const T root = sqrt(over * over + kSoft);
    return {x - T(0.5) * (over + root), T(0.5) * (T(1) - over / root)};
}

/// The share of a narrowing at a place beside its midplane, and the slopes of this share.
template <class T> struct NarrowingShare {
    T value;
    T slopeAlong;
    T slopeUp;
};
template <class T> NarrowingShare<T> narrowingShare(T along, T up)
{
    constexpr auto kPerFront = T(1.0 / kNarrowFront);
    constexpr auto kPerBack = T(1.0 / (kNarrowEnd - kNarrowBack));
    constexpr auto kPerAbove = T(1.0 / (kNarrowAbove - kNarrowLevel));
    constexpr auto kPerBelow = T(1.0 / (kNarrowBelow - kNarrowLevel));
    const Smooth<T> front = step<T>(along * kPerFront);
    const Smooth<T> back = step<T>((along - T(kNarrowBack)) * kPerBack);
    const Smooth<T> above = step<T>((up - T(kNarrowLevel)) * kPerAbove);
    const Smooth<T> below = step<T>((up + T(kNarrowBelow)) * kPerBelow);
    const T byLength = front.value * (T(1) - back.value);
    const T byHeight = (T(1) - above.value) * below.value;
    return {
        byLength * byHeight,
        byHeight
            * (front.slope * kPerFront * (T(1) - back.value) - front.value * back.slope * kPerBack),
        byLength
            * (below.slope * kPerBelow * (T(1) - above.value)
               - below.value * above.slope * kPerAbove)};
}

} // namespace formula

/// The displacement at p of what a swelling moves, and its gradient (AirwayField).
template <class T>
[[nodiscard]] DisplacementAt<T> swellingPull(const SwellingFrame<T>& swelling, const Vector3<T>& p)
{
    using std::sqrt;
    const Vector3<T> from = p - swelling.centre;
    const T along = swelling.axis.dot(from);
    const Vector3<T> aside = from - along * swelling.axis;
    const T rest =
        T(1) - swelling.perAcross2 * aside.squaredNorm() - swelling.perAlong2 * along * along;
    if (rest <= T(0))
        return {Vector3<T>::Zero(), Matrix3<T>::Zero()};
    const T share = rest * rest;
    const Vector3<T> slope =
        T(-4) * rest * (swelling.perAcross2 * aside + swelling.perAlong2 * along * swelling.axis);
    const T round = T(1) - swelling.isFlat;
    const Vector3<T> out = round * aside + along * swelling.axis;
    const T per = T(1) / sqrt(out.squaredNorm() + swelling.soft2);
    const Vector3<T> whole = swelling.outward * per * out + swelling.shift;
    const Matrix3<T> outSlope = round * Matrix3<T>::Identity()
                                + swelling.isFlat * swelling.axis * swelling.axis.transpose()
                                - per * per * out * out.transpose();
    return {share * whole, whole * slope.transpose() + share * swelling.outward * per * outSlope};
}

/// The displacement at p of the walls of a lumen, and its gradient (AirwayField).
template <class T>
[[nodiscard]] DisplacementAt<T> narrowingPull(const NarrowingFrame<T>& lumen, const Vector3<T>& p)
{
    using formula::Smooth;
    const T across = lumen.across.dot(p) + lumen.acrossFrom;
    const T along = lumen.along.dot(p) + lumen.alongFrom;
    const formula::NarrowingShare<T> there =
        formula::narrowingShare<T>(along, lumen.up.dot(p) + lumen.upFrom);
    if (lumen.closing == T(0) || there.value == T(0))
        return {Vector3<T>::Zero(), Matrix3<T>::Zero()};
    const Smooth<T> wider = formula::upToOne<T>(along);
    const T perHalf = T(1) / (lumen.front + lumen.wider * wider.value);
    const T ratio = (across < T(0) ? -across : across) * perHalf;
    const T perOuter = T(1) / (lumen.outer - T(1));
    const Smooth<T> beside = formula::step<T>((ratio - T(1)) * perOuter);
    const T share = (T(1) - beside.value) * there.value;
    // across * d share / d across, and d share / d along by the width that grows.
    const T steep = beside.slope * perOuter * ratio * there.value;
    const T byAlong =
        (T(1) - beside.value) * there.slopeAlong + steep * perHalf * lumen.wider * wider.slope;
    const T byUp = (T(1) - beside.value) * there.slopeUp;
    const Vector3<T> slope =
        (share - steep) * lumen.across + across * (byAlong * lumen.along + byUp * lumen.up);
    return {-lumen.closing * across * share * lumen.across,
            -lumen.closing * lumen.across * slope.transpose()};
}

/// The displacement at p of one of the tissues by all that changes an airway, one after the other,
/// and its gradient.
template <class T>
[[nodiscard]] DisplacementAt<T> airwayPull(const AirwayFrame<T>& airway, AirwayTissue tissue,
                                           const Vector3<T>& p)
{
    DisplacementAt<T> pull{Vector3<T>::Zero(), Matrix3<T>::Zero()};
    const auto narrow = [&](const NarrowingFrame<T>& lumen) {
        if (lumen.closing != T(0))
            pull = followedBy(pull, p,
                              [&lumen](const Vector3<T>& q) { return narrowingPull(lumen, q); });
    };
    if (tissue == AirwayTissue::Larynx) {
        narrow(airway.cords);
        narrow(airway.web);
    }
    if ((kThroatTissues & only(tissue)) != 0) {
        narrow(airway.vestibule);
        narrow(airway.pharynx);
    }
    if (tissue == AirwayTissue::Windpipe) {
        narrow(airway.windpipeSides);
        narrow(airway.windpipeDepth);
    }
    for (const SwellingFrame<T>& swelling : airway.swellings)
        if ((static_cast<AirwayTissues>(swelling.tissues) & only(tissue)) != 0)
            pull = followedBy(
                pull, p, [&swelling](const Vector3<T>& q) { return swellingPull(swelling, q); });
    return pull;
}

/// How much of a tint's colour a place has: its share in the middle, and less from 0.7 of its
/// reach on (AirwayField).
template <class T> [[nodiscard]] T tintShare(const TintFrame<T>& tint, const Vector3<T>& p)
{
    const Vector3<T> from = p - tint.centre;
    const T along = tint.axis.dot(from);
    const Vector3<T> aside = from - along * tint.axis;
    const T rest = T(1) - tint.perAcross2 * aside.squaredNorm() - tint.perAlong2 * along * along;
    return tint.share * formula::step<T>(T(2) * rest).value;
}

/// The colour of one of the tissues at p by all tints, one over the other: red, green and blue,
/// linear.
/// @param own what it has without them
template <class T>
[[nodiscard]] Vector3<T> airwayLight(const AirwayFrame<T>& airway, AirwayTissue tissue,
                                     const Vector3<T>& p, const Vector3<T>& own)
{
    Vector3<T> light = own;
    for (const TintFrame<T>& tint : airway.tints)
        if ((static_cast<AirwayTissues>(tint.tissues) & only(tissue)) != 0)
            light += tintShare(tint, p) * (tint.light - light);
    return light;
}

} // namespace carina
