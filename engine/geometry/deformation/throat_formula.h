#pragma once

#include "engine/geometry/deformation/chest_formula.h"
#include "engine/geometry/vec.h"

#include <cstdint>

namespace carina
{

/// The closed form behind ThroatField, for double and float. resources/shaders/organ.vert is a
/// second implementation, for the graphics card.

/// Kinds of soft tissue, by how they are attached to the lower jaw and to parts that do not move.
enum class ThroatTissue : std::uint8_t {
    Airway,  ///< tongue, epiglottis, larynx, trachea and the muscles around them
    Pharynx, ///< attached to the spine behind and to the skull above
};

template <class T> using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T> using Matrix3 = Eigen::Matrix<T, 3, 3>;

/// The parameters of one throat, in A, metres. With all zeros nothing follows the jaw.
template <class T> struct ThroatFrame {
    Vector3<T> up = Vector3<T>::Zero(); ///< the step along the trachea is of dot(up, p) + upFrom
    T upFrom{};
    Vector3<T> incisors = Vector3<T>::Zero();
    T perLength{};                          ///< 1 / (incisors to glottis)
    Vector3<T> anchor = Vector3<T>::Zero(); ///< the point a of ThroatField
};

/// The motion of a point that is fixed to the jaw: p + turn p + shift. All zeros: the jaw is in its
/// pose in the surfaces.
template <class T> struct JawShift {
    Matrix3<T> turn = Matrix3<T>::Zero();
    Vector3<T> shift = Vector3<T>::Zero();
};

/// The share S by which a point follows the jaw, and its gradient.
template <class T> struct JawShare {
    T value;
    Vector3<T> slope;
};

/// A displacement, metres, and its gradient.
template <class T> struct DisplacementAt {
    Vector3<T> d;
    Matrix3<T> gradient;
};

namespace formula
{

/// Where the step along the trachea begins and ends; 0 is at the carina and 1 at the glottis.
inline constexpr double kStretchFrom = 0.6;
inline constexpr double kStretchTo = 1.4;
/// Distances behind the incisors, in units of incisors to glottis: up to kChin tissue moves fully
/// with the jaw (if high enough); at kAnchor is the anchor point.
inline constexpr double kChin = 0.07;
inline constexpr double kAnchor = 0.21;
/// The jaw is an arch: tissue at x units beside the midplane follows like tissue in the midplane
/// that lies kArch x^2 / (1 + kArchEnd x^2) units further in front.
inline constexpr double kArch = 7.0;
inline constexpr double kArchEnd = 12.0;

/// Where S of a tissue begins at the back (units behind the incisors), and the heights above the
/// incisors between which it decreases to 0; in units of incisors to glottis.
struct TissueReach {
    double back;
    double roofFrom;
    double roofTo;
};

/// The reach of a tissue.
[[nodiscard]] constexpr TissueReach reachOf(ThroatTissue tissue)
{
    return tissue == ThroatTissue::Airway ? TissueReach{1.40, 0.17, 0.69}
                                          : TissueReach{1.075, -0.17, 0.08};
}

} // namespace formula

/// S at p: the product of the steps along the trachea, towards the front and below the roof.
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

/// The unit normal of a surface after a displacement with this gradient: n ~ cof(I + grad d) n0.
template <class T>
[[nodiscard]] Vector3<T> turnedNormal(const Matrix3<T>& gradient, const Vector3<T>& n)
{
    const Matrix3<T> j = Matrix3<T>::Identity() + gradient;
    return (n.x() * j.col(1).cross(j.col(2)) + n.y() * j.col(2).cross(j.col(0))
            + n.z() * j.col(0).cross(j.col(1)))
        .normalized();
}

/// One displacement after another, and the gradient of both.
template <class T, class Second>
[[nodiscard]] DisplacementAt<T> followedBy(const DisplacementAt<T>& first, const Vector3<T>& p,
                                           Second second)
{
    const DisplacementAt<T> then = second(Vector3<T>{p + first.d});
    return {first.d + then.d, first.gradient + then.gradient + then.gradient * first.gradient};
}

/// The displacement at p and its gradient (see ThroatField).
template <class T>
[[nodiscard]] DisplacementAt<T> jawPull(const ThroatFrame<T>& frame, ThroatTissue tissue,
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
