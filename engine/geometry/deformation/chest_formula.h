#pragma once

#include <algorithm>

namespace carina
{

/// The closed form behind ChestField, for any number type: double for computing amplitudes, float
/// for moving vertices, intervals for proofs. resources/shaders/organ.vert is a second
/// implementation, for the graphics card.

/// A position or a displacement in shares of the chest's size, or a derivative along these axes.
template <class T> struct Shares {
    T u; ///< -1 at the right wall, 0 in the middle, 1 at the left wall
    T v; ///< 0 in front, 1 at the back
    T h; ///< 0 at the apex of the lungs, 1 at their base

    friend Shares operator+(const Shares& a, const Shares& b)
    {
        return {a.u + b.u, a.v + b.v, a.h + b.h};
    }
    friend Shares operator-(const Shares& a, const Shares& b)
    {
        return {a.u - b.u, a.v - b.v, a.h - b.h};
    }
    friend Shares operator*(const T& k, const Shares& a) { return {k * a.u, k * a.v, k * a.h}; }
};

/// The parameters of one chest.
template <class T> struct ChestFrame {
    Shares<T> origin{};     ///< u = v = h = 0, in A along x, y and z, metres
    Shares<T> perMetre{};   ///< shares per metre along x, y and z of A; the last is negative
    Shares<T> rightHilum{}; ///< u below 0
    Shares<T> leftHilum{};  ///< u above 0
    T frontShare{};         ///< descent of the diaphragm in front, relative to the back
};

/// The coefficient of each term of the field, and the axes along which the term moves.
template <class T> struct ChestTerms {
    T descent{};  ///< h: the base moves down, most at the back; and u: outward with it; fades below
                  ///< the lungs, where the diaphragm is attached
    T forward{};  ///< v: the ribs move forward (negative)
    T flare{};    ///< u: the ribs move away from the middle
    T lift{};     ///< h: the ribs move up (negative); fades below the lungs
    T bulkBack{}; ///< v: the interior moves backward
    T bulkDown{}; ///< h: the interior moves down
    T shrink{};   ///< u, v and h: everything moves towards the hilum
    T shift{};    ///< u: the mediastinum moves to the left

    friend bool operator==(const ChestTerms&, const ChestTerms&) = default;
};

/// The coefficients of the right and of the left side, with a smooth transition between the hila.
template <class T> struct ChestCoefficients {
    ChestTerms<T> right;
    ChestTerms<T> left;
};

/// A displacement, and the gradient of each of its components.
template <class T> struct ChestValue {
    Shares<T> f;
    Shares<T> slope_u; ///< of f.u along u, v and h
    Shares<T> slope_v;
    Shares<T> slope_h;
};

namespace formula
{

/// 1 / radius^2 of the region around a hilum that hardly moves, in shares.
inline constexpr Shares<double> kStiffness{16.0, 6.25, 16.0};
/// How far the front-to-back ramp of the descent extends beyond front and back, in shares.
inline constexpr double kBeyond = 0.2;
/// Reduction of the descent in the middle, where the heart lies on the diaphragm.
inline constexpr double kTendon = 0.3;
/// Outward motion per descent, as the chest is wider below.
inline constexpr double kSpread = 0.28;
/// How far below the base of the lungs at rest descent and lift fade to 0, in shares: the diaphragm
/// slides along the wall there and keeps its attachment, and the belly's skin is not lifted.
inline constexpr double kAttachment = 0.65;
/// The h at which the shift of the mediastinum begins, above the lungs, and over what it grows:
/// from the larynx, which stays, to below the carina.
inline constexpr double kShiftFrom = -0.3;
inline constexpr double kShiftOver = 0.6;
/// The v at which the ribs' motion begins to decrease towards the back, and that at which it is 0.
inline constexpr double kRibsFade = 0.3;
inline constexpr double kRibsEnd = 1.0;

/// The value of a function of one variable, and its derivative.
template <class T> struct Smooth {
    T value;
    T slope;
};

template <class T> T clamped(const T& x)
{
    using std::max;
    using std::min;
    return min(max(x, T(0)), T(1));
}

/// t^2 (3 - 2 t) with t = x clamped to 0 .. 1.
template <class T> Smooth<T> step(const T& x)
{
    const T t = clamped(x);
    return {t * t * (T(3) - T(2) * t), T(6) * t * (T(1) - t)};
}

/// (4 t (1 - t))^2 within 0 .. 1, and 0 outside.
template <class T> Smooth<T> bulge(const T& x)
{
    const T t = clamped(x);
    const T b = T(4) * t * (T(1) - t);
    return {b * b, T(8) * b * (T(1) - T(2) * t)};
}

/// A function of h that fades to 0 below the lungs.
template <class T> Smooth<T> fadingBelow(const Smooth<T>& along_h, const T& h)
{
    constexpr double kPerAttachment = 1.0 / kAttachment;
    const Smooth<T> fade = step<T>((h - T(1)) * T(kPerAttachment));
    return {along_h.value - fade.value, along_h.slope - T(kPerAttachment) * fade.slope};
}

/// The factor of the descent along u: 1 - kTendon max(1 - u^2, 0)^2.
template <class T> Smooth<T> besideTheTendon(const T& u)
{
    const T inside = clamped<T>(T(1) - u * u);
    return {T(1) - T(kTendon) * inside * inside, T(4.0 * kTendon) * u * inside};
}

/// The value of a function of v and h, and its derivatives along both.
template <class T> struct Profile {
    T value;
    T v;
    T h;

    friend Profile operator+(const Profile& a, const Profile& b)
    {
        return {a.value + b.value, a.v + b.v, a.h + b.h};
    }
    friend Profile operator*(const T& k, const Profile& a)
    {
        return {k * a.value, k * a.v, k * a.h};
    }
};

template <class T> Profile<T> product(const Smooth<T>& along_v, const Smooth<T>& along_h)
{
    return {along_v.value * along_h.value, along_v.slope * along_h.value,
            along_v.value * along_h.slope};
}

/// A point relative to the curve that joins the hila.
template <class T> struct Anchor {
    Smooth<T> left;       ///< 0 at the right hilum and beyond, 1 at the left one; slope along u
    Shares<T> offset;     ///< from the curve
    Shares<T> curveSlope; ///< slope of the curve along u
    T away;               ///< 1 - 1 / (1 + rho)^2: 0 on the curve, 1 far from it
    Shares<T> slope;      ///< of away
};

template <class T, class S>
[[gnu::always_inline]] inline Anchor<T> anchor(const ChestFrame<S>& frame, const Shares<T>& q)
{
    using std::max;
    const Shares<T> right{T(frame.rightHilum.u), T(frame.rightHilum.v), T(frame.rightHilum.h)};
    const Shares<T> left{T(frame.leftHilum.u), T(frame.leftHilum.v), T(frame.leftHilum.h)};
    const Shares<T> span = left - right;
    const T perSpan = T(1) / span.u;
    Anchor<T> a;
    a.left = step<T>((q.u - right.u) * perSpan);
    a.left.slope = a.left.slope * perSpan;
    a.offset = q - (right + a.left.value * span);
    a.curveSlope = a.left.slope * span;
    const T beyond = max(q.u - left.u, T(0)) - max(right.u - q.u, T(0));
    const T pull_u = T(kStiffness.u) * beyond;
    const T pull_v = T(kStiffness.v) * a.offset.v;
    const T pull_h = T(kStiffness.h) * a.offset.h;
    const T near = T(1) / (T(1) + pull_u * beyond + pull_v * a.offset.v + pull_h * a.offset.h);
    const T near2 = near * near;
    a.away = T(1) - near2;
    a.slope =
        (T(4) * near2 * near)
        * Shares<T>{pull_u - pull_v * a.curveSlope.v - pull_h * a.curveSlope.h, pull_v, pull_h};
    return a;
}

/// The coefficients at a point between the lungs, and their slopes along u.
template <bool kBothSides, class T, class S>
[[gnu::always_inline]] inline void mix(const ChestCoefficients<S>& terms, const Smooth<T>& left,
                                       ChestTerms<T>& c, ChestTerms<T>& slope)
{
    const auto one = [&](S ChestTerms<S>::*from, T ChestTerms<T>::*to) {
        c.*to = T(terms.right.*from);
        slope.*to = T(0);
        if constexpr (kBothSides) {
            c.*to = c.*to + left.value * T(terms.left.*from - terms.right.*from);
            slope.*to = left.slope * T(terms.left.*from - terms.right.*from);
        }
    };
    one(&ChestTerms<S>::descent, &ChestTerms<T>::descent);
    one(&ChestTerms<S>::forward, &ChestTerms<T>::forward);
    one(&ChestTerms<S>::flare, &ChestTerms<T>::flare);
    one(&ChestTerms<S>::lift, &ChestTerms<T>::lift);
    one(&ChestTerms<S>::bulkBack, &ChestTerms<T>::bulkBack);
    one(&ChestTerms<S>::bulkDown, &ChestTerms<T>::bulkDown);
    one(&ChestTerms<S>::shrink, &ChestTerms<T>::shrink);
    one(&ChestTerms<S>::shift, &ChestTerms<T>::shift);
}

/// The gradient of the product away * f, where f_u is the slope of f along u.
template <class T>
[[gnu::always_inline]] inline Shares<T> slopeOfProduct(const Anchor<T>& a, const Profile<T>& f,
                                                       const T& f_u)
{
    return {a.slope.u * f.value + a.away * f_u, a.slope.v * f.value + a.away * f.v,
            a.slope.h * f.value + a.away * f.h};
}

/// The terms that are 0 on the curve between the hila.
template <bool kBothSides, class T>
[[gnu::always_inline]] inline ChestValue<T> anchored(const Anchor<T>& a, const T& frontShare,
                                                     const ChestTerms<T>& c,
                                                     const ChestTerms<T>& slope, const Shares<T>& q)
{
    constexpr double kPerDepth = 1.0 / (1.0 + 2.0 * kBeyond);
    constexpr double kPerFade = 1.0 / (kRibsEnd - kRibsFade);
    const Smooth<T> back = step<T>((q.v + T(kBeyond)) * T(kPerDepth));
    const Smooth<T> faded = step<T>((q.v - T(kRibsFade)) * T(kPerFade));
    const Smooth<T> upper = step<T>(T(3) * q.h);
    const T behind = T(1) - frontShare;
    const Smooth<T> fore{frontShare + behind * back.value, behind * back.slope * T(kPerDepth)};
    const Smooth<T> apart = besideTheTendon<T>(q.u);
    const Smooth<T> middle = bulge<T>(q.h);
    const Profile<T> base = product<T>(fore, fadingBelow<T>(step<T>(q.h), q.h));
    const Profile<T> spread =
        product<T>(fore, {T(kSpread) * middle.value, T(kSpread) * middle.slope});
    const Smooth<T> inFront{T(1) - faded.value, -faded.slope * T(kPerFade)};
    const Smooth<T> grown{upper.value, T(3) * upper.slope};
    const Profile<T> ribs = product<T>(inFront, grown);
    const Profile<T> raised = product<T>(inFront, fadingBelow<T>(grown, q.h));
    const Profile<T> bulk = product<T>(bulge<T>(q.v), middle);
    const Profile<T> widening = c.flare * ribs + c.descent * spread;
    const Profile<T> out = q.u * widening;
    const Profile<T> backward = c.forward * ribs + c.bulkBack * bulk;
    const Profile<T> down = (c.descent * apart.value) * base + c.lift * raised + c.bulkDown * bulk;
    T out_u = widening.value;
    T backward_u = T(0);
    T down_u = c.descent * apart.slope * base.value;
    if constexpr (kBothSides) {
        out_u = out_u + q.u * (slope.flare * ribs.value + slope.descent * spread.value);
        backward_u = slope.forward * ribs.value + slope.bulkBack * bulk.value;
        down_u = down_u + slope.descent * apart.value * base.value + slope.lift * raised.value
                 + slope.bulkDown * bulk.value;
    }
    return {{a.away * out.value, a.away * backward.value, a.away * down.value},
            slopeOfProduct(a, out, out_u),
            slopeOfProduct(a, backward, backward_u),
            slopeOfProduct(a, down, down_u)};
}

/// Adds the shift of the mediastinum, which decreases to 0 towards the larynx.
template <class T>
[[gnu::always_inline]] inline void addShift(const T& c, const T& slope, const Shares<T>& q,
                                            ChestValue<T>& sum)
{
    const T inside = clamped<T>(T(1) - q.u * q.u);
    const T inside2 = inside * inside;
    constexpr double kPerShift = 1.0 / kShiftOver;
    const Smooth<T> upper = step<T>((q.h - T(kShiftFrom)) * T(kPerShift));
    sum.f.u = sum.f.u + c * inside2 * upper.value;
    sum.slope_u.u = sum.slope_u.u + (slope * inside2 - T(4) * c * q.u * inside) * upper.value;
    sum.slope_u.h = sum.slope_u.h + T(kPerShift) * c * inside2 * upper.slope;
}

/// Adds the contraction towards the curve between the hila.
template <class T>
[[gnu::always_inline]] inline void addShrink(const T& c, const T& slope, const Anchor<T>& a,
                                             ChestValue<T>& sum)
{
    const Shares<T> along_u = c * a.curveSlope - slope * a.offset;
    sum.f = sum.f - c * a.offset;
    sum.slope_u.u = sum.slope_u.u + along_u.u - c;
    sum.slope_v.u = sum.slope_v.u + along_u.v;
    sum.slope_h.u = sum.slope_h.u + along_u.h;
    sum.slope_v.v = sum.slope_v.v - c;
    sum.slope_h.h = sum.slope_h.h - c;
}

} // namespace formula

/// The displacement at a point q and its gradient, in shares.
/// @tparam kBothSides false where `right` and `left` are equal: fewer operations, same result
template <bool kBothSides = true, class T, class S>
[[gnu::always_inline]] inline ChestValue<T>
chestValue(const ChestFrame<S>& frame, const ChestCoefficients<S>& terms, const Shares<T>& q)
{
    const formula::Anchor<T> a = formula::anchor<T>(frame, q);
    ChestTerms<T> c;
    ChestTerms<T> slope;
    formula::mix<kBothSides, T>(terms, a.left, c, slope);
    ChestValue<T> sum = formula::anchored<kBothSides, T>(a, T(frame.frontShare), c, slope, q);
    formula::addShift<T>(c.shift, slope.shift, q, sum);
    formula::addShrink<T>(c.shrink, slope.shrink, a, sum);
    return sum;
}

} // namespace carina
