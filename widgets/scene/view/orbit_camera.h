#pragma once

#include "engine/display/eye_view.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/rigid_transform.h"

#include <cstdint>

namespace carina
{

/// Viewpoints on the patient, in the anatomy frame A (+x patient's left, +y posterior, +z
/// superior).
enum class ViewPreset : std::uint8_t {
    Front,   ///< in front of the patient: the right lung is at the left of the picture
    Right,   ///< at the patient's right side
    Left,    ///< at the patient's left side
    Back,    ///< behind the patient
    Trainee, ///< standing behind the head of the lying patient: the chest is ahead
};

/// How the patient lies or sits, which says what is up in the room.
enum class Lie : std::uint8_t {
    Upright, ///< head up
    OnBack,
    OnFront,
    OnRightSide,
    OnLeftSide,
};

/// The pose and clipping planes of a camera, in A, metres.
struct CameraPose {
    Vec3 p_A_eye = Vec3::Zero();
    Vec3 p_A_target = Vec3::Zero();
    Vec3 up_A = Vec3::UnitZ();
    double nearPlane = 0.01;
    double farPlane = 10.0;
};

/// A perspective camera that orbits a point: yaw about the room's vertical, pitch from straight
/// below to straight above. A preset shows the patient from the same side of the body however the
/// patient lies; what is up in the room is up in the picture, or the head where the camera looks
/// straight up or down.
class OrbitCamera
{
public:
    static constexpr double kVerticalFieldOfView = 0.5; ///< radians; narrow, for little distortion

    /// The box to look at, and the picture's width over its height.
    void setBounds(const Box& bounds_A) { m_bounds_A = bounds_A; }
    void setAspect(double widthOverHeight);
    /// How the patient lies. Where that changes, the camera looks from its preset again.
    void setLie(Lie lie);

    /// Looks from a preset, at the distance where the bounds fit into the picture with a small
    /// margin.
    void showFrom(ViewPreset preset);
    /// Looks as a pose does, with the room's vertical up or down in the picture.
    /// @pre the eye is not in the target, and up not along the line to it
    void look(const CameraPose& pose);

    /// Rotates by a mouse drag, in fractions of the picture's height: right and down positive.
    void orbit(double right, double down);
    /// Shifts the scene by a mouse drag, in fractions of the picture's height.
    void pan(double right, double down);
    /// Moves nearer by a factor above 1, or away by a factor below 1.
    void zoom(double factor);

    [[nodiscard]] CameraPose pose() const;
    [[nodiscard]] Frustum frustum() const;
    /// The camera pose of an eye D (+x right, +y up, looking along -z), with clipping planes for
    /// the same bounds.
    [[nodiscard]] CameraPose poseOf(const RigidTransform& X_AD) const;

private:
    [[nodiscard]] Vec3 backward() const; ///< from the target to the eye
    [[nodiscard]] Vec3 up() const;
    [[nodiscard]] double fittingDistance() const;
    void lookFrom(ViewPreset preset);
    [[nodiscard]] CameraPose withPlanes(CameraPose pose) const;

    Box m_bounds_A;
    double m_aspect = 1.6;
    Vec3 m_target_A = Vec3::Zero();
    Lie m_lie = Lie::Upright;
    /// The room W: z up and, while the patient lies, y towards the head; that of A upright.
    Mat3 m_R_AW = Mat3::Identity();
    double m_yaw = 0.0; ///< about z of W, 0 at its -y; upright 0 in front, then to the left
    double m_pitch = 0.0;
    double m_level = 0.0; ///< pitch of the horizon: 0, or pi with the feet up in the picture
    double m_distance = 1.0;
    ViewPreset m_preset = ViewPreset::Front;
    bool m_fitted = true; ///< unchanged since showFrom()
};

} // namespace carina
