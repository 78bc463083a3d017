#pragma once

#include "engine/geometry/deformation/chest_formula.h"
#include "engine/geometry/vec.h"

#include <cstdint>

namespace carina
{

/// The closed form behind ThroatField, for double and float. resources/shaders/organ.vert has it a
/// second time, for the graphics card.

/// How a soft part hangs between the lower jaw and what stands still.
enum class ThroatTissue : std::uint8_t {
    Airway,  ///< tongue, epiglottis, larynx, trachea and the muscles around them
    Pharynx, ///< what lies on the spine behind and hangs from the skull above
};

template <class T> using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T> using Matrix3 = Eigen::Matrix<T, 3, 3>;

/// What the formula is told of a throat. With nothing but zeros, nothing follows.
template <class T> struct ThroatFrame {
    Vector3<T> up = Vector3<T>::Zero(); ///< the stretch along the trachea at p: dot(up, p) + upFrom
    T upFrom{};
    Vector3<T> incisors = Vector3<T>::Zero();
    T perLength{};                          ///< 1 / (incisors to glottis)
    Vector3<T> anchor = Vector3<T>::Zero(); ///< what hangs from the jaw goes where this goes
};

/// Where the jaw takes a point that is fixed to it: p + turn p + shift. Zeros: the mouth is closed.
template <class T> struct JawShift {
    Matrix3<T> turn = Matrix3<T>::Zero();
    Vector3<T> shift = Vector3<T>::Zero();
};

/// How far a place follows the jaw, and how that changes from place to place.
template <class T> struct JawShare {
    T value;
    Vector3<T> slope;
};

/// A displacement, and its derivatives along the axes.
template <class T> struct JawPull {
    Vector3<T> d;
    Matrix3<T> gradient;
};

namespace formula
{

/// Where along the trachea's line, 0 at the carina and 1 at the glottis, the stretch begins, and
/// where it ends.
inline constexpr double kStretchFrom = 0.6;
inline constexpr double kStretchTo = 1.4;
/// How far behind the incisors, in lengths from incisors to glottis, all that is high enough goes
/// with the jaw, and the anchor lies.
inline constexpr double kChin = 0.07;
inline constexpr double kAnchor = 0.21;
/// The jaw is an arch: aside, x lengths from the middle, its soft parts go with it as they do
/// kArch x^2 / (1 + kArchEnd x^2) lengths further in front.
inline constexpr double kArch = 7.0;
inline constexpr double kArchEnd = 12.0;

/// Where a tissue begins to follow at the back, and where it ceases to on its way up; lengths
/// behind the incisors and above them.
struct TissueReach {
    double back;
    double roofFrom;
    double roofTo;
};

[[nodiscard]] constexpr TissueReach reachOf(ThroatTissue tissue)
{
    return tissue == ThroatTissue::Airway ? TissueReach{1.40, 0.17, 0.69}
                                          : TissueReach{1.075, -0.17, 0.08};
}

} // namespace formula

/// How far a place follows: how high it lies, times how far in front, times how far below the roof.
template <class T>
[[nodiscard]] JawShare<T> jawShare(const ThroatFrame<T>& frame, ThroatTissue tissue,
                                   const Vector3<T>& p)
{
    using formula::Smooth;
    using formula::step;
    const formula::TissueReach reach = formula::reachOf(tissue);
    const Vector3<T> q = frame.perLength * (p - frame.incisors);
    const T narrow = T(1) / (T(1) + T(formula::kArchEnd) * q.x() * q.x());
    const T arch = T(formula::kArch) * q.x() * q.x() * narrow;
    const T perDepth = T(1.0 / (reach.back - formula::kChin));
    const T perRoof = T(1.0 / (reach.roofTo - reach.roofFrom));
    const Smooth<T> high = step<T>(frame.up.dot(p) + frame.upFrom);
    const Smooth<T> fore = step<T>((T(reach.back) - q.y() + arch) * perDepth);
    const Smooth<T> roof = step<T>((q.z() - T(reach.roofFrom)) * perRoof);
    const T below = T(1) - roof.value;
    const T forward = frame.perLength * high.value * below * perDepth * fore.slope;
    Vector3<T> slope = (high.slope * fore.value * below) * frame.up;
    slope.x() += forward * T(2.0 * formula::kArch) * q.x() * narrow * narrow;
    slope.y() -= forward;
    slope.z() -= frame.perLength * high.value * fore.value * perRoof * roof.slope;
    return {high.value * fore.value * below, slope};
}

/// The displacement at a place.
template <class T>
[[nodiscard]] JawPull<T> jawPull(const ThroatFrame<T>& frame, ThroatTissue tissue,
                                 const JawShift<T>& jaw, const Vector3<T>& p)
{
    const JawShare<T> share = jawShare(frame, tissue, p);
    const T s = share.value;
    const Vector3<T> anchor = jaw.turn * frame.anchor + jaw.shift;
    const Vector3<T> turned = jaw.turn * (p - frame.anchor);
    return {s * (anchor + s * turned),
            s * s * jaw.turn + (anchor + T(2) * s * turned) * share.slope.transpose()};
}

} // namespace carina
