#pragma once

#include "engine/geometry/deformation/throat_formula.h"

#include <cmath>

namespace carina
{

/// The closed form behind NeckField, for double and float. resources/shaders/organ.vert is a
/// second implementation, for the graphics card.

/// One bend of a neck, in A, metres: a rotation about an axis along +x through `hinge`, by a share
/// of `angle` that grows with the height of a place. With all zeros nothing moves.
template <class T> struct NeckBend {
    Vector3<T> hinge = Vector3<T>::Zero();
    T angle{}; ///< radians, of what turns wholly; +: the face goes down
    /// The height is dot(along, p) + from + arch sqrt(y^2 + soft2), y being how far p lies behind
    /// the hinge: 0 where nothing turns yet, 1 from where all turns wholly.
    Vector3<T> along = Vector3<T>::Zero();
    T from{};
    T arch{};
    T soft2{T(1)}; ///< above 0
};

/// A neck in one position.
template <class T> struct NeckFrame {
    NeckBend<T> extension; ///< of the head against the neck, first
    NeckBend<T> flexion;   ///< of the neck with the head
};

/// The pose X_AU of a head: what turns wholly goes from p to turn p + shift.
template <class T> struct HeadPose {
    Matrix3<T> turn = Matrix3<T>::Identity();
    Vector3<T> shift = Vector3<T>::Zero();
};

/// The share of the angle by which a place turns, and its gradient.
template <class T> [[nodiscard]] JawShare<T> bendShare(const NeckBend<T>& bend, const Vector3<T>& p)
{
    using std::sqrt;
    const T behind = p.y() - bend.hinge.y();
    const T root = sqrt(behind * behind + bend.soft2);
    const formula::Smooth<T> share =
        formula::step<T>(bend.along.dot(p) + bend.from + bend.arch * root);
    Vector3<T> slope = bend.along;
    slope.y() += bend.arch * behind / root;
    return {share.value, share.slope * slope};
}

/// The displacement at p of one bend, and its gradient:
///
///     x = c + R(a S) (p - c),   grad x = R + (e_x x (x - c)) a (grad S)^T
///
/// with c the hinge, a the angle and S the share.
template <class T>
[[nodiscard]] DisplacementAt<T> bendPull(const NeckBend<T>& bend, const Vector3<T>& p)
{
    using std::sin;
    if (bend.angle == T(0))
        return {Vector3<T>::Zero(), Matrix3<T>::Zero()};
    const JawShare<T> share = bendShare(bend, p);
    const T angle = bend.angle * share.value;
    const T sine = sin(angle);
    const T half = sin(T(0.5) * angle);
    const T less = T(2) * half * half; // 1 - cosine
    const Vector3<T> q = p - bend.hinge;
    const Vector3<T> d{T(0), -less * q.y() - sine * q.z(), sine * q.y() - less * q.z()};
    const Vector3<T> turned = q + d;
    Matrix3<T> gradient = Matrix3<T>::Zero();
    gradient(1, 1) = -less;
    gradient(1, 2) = -sine;
    gradient(2, 1) = sine;
    gradient(2, 2) = -less;
    gradient += Vector3<T>{T(0), -turned.z(), turned.y()} * (bend.angle * share.slope).transpose();
    return {d, gradient};
}

/// The displacement at p of a neck, and its gradient.
template <class T>
[[nodiscard]] DisplacementAt<T> neckPull(const NeckFrame<T>& neck, const Vector3<T>& p)
{
    return followedBy(bendPull(neck.extension, p), p,
                      [&neck](const Vector3<T>& moved) { return bendPull(neck.flexion, moved); });
}

/// What pullAt displaces in the frame of the head, displaced there: the displacement at p, which
/// has moved with the head, and its gradient, both in A.
template <class T, class PullAt>
[[nodiscard]] DisplacementAt<T> pullInHead(const HeadPose<T>& head, const Vector3<T>& p,
                                           PullAt pullAt)
{
    const Matrix3<T> back = head.turn.transpose();
    const DisplacementAt<T> pull = pullAt(Vector3<T>{back * (p - head.shift)});
    return {head.turn * pull.d, head.turn * pull.gradient * back};
}

} // namespace carina
