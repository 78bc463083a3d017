#pragma once

#include "engine/display/eye_view.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/rigid_transform.h"

#include <cstdint>

namespace carina
{

/// From where a view looks at the patient, in the anatomy frame A (+x patient's left, +y posterior,
/// +z superior).
enum class ViewPreset : std::uint8_t {
    Front,   ///< in front of the patient, who looks back: the right lung is left in the picture
    Right,   ///< at the patient's right side
    Left,    ///< at the patient's left side
    Back,    ///< behind the patient
    Trainee, ///< standing behind the head of the patient, who lies: the chest is ahead
};

/// Where a camera is, in A, metres.
struct CameraPose {
    Vec3 p_A_eye = Vec3::Zero();
    Vec3 p_A_target = Vec3::Zero();
    Vec3 up_A = Vec3::UnitZ();
    double nearPlane = 0.01;
    double farPlane = 10.0;
};

/// A perspective camera that turns about a point of interest: yaw about the patient's long axis,
/// pitch between straight below and straight above.
class OrbitCamera
{
public:
    static constexpr double kVerticalFieldOfView = 0.5; ///< radians; narrow, for little distortion

    /// What is looked at, and the picture's width over its height.
    void setBounds(const Box& bounds_A) { m_bounds_A = bounds_A; }
    void setAspect(double widthOverHeight);

    /// Looks from a preset, so near that the bounds just fit into the picture with a small margin.
    void showFrom(ViewPreset preset);

    /// Turns by a part of the picture's height: right and down positive, as a mouse drags.
    void orbit(double right, double down);
    /// Moves what is seen by a part of the picture's height.
    void pan(double right, double down);
    /// Comes nearer by a factor (above 1), or goes away (below 1).
    void zoom(double factor);

    [[nodiscard]] CameraPose pose() const;
    [[nodiscard]] Frustum frustum() const;
    /// The way from the eye through a point of the picture, of length 1: right and up of the centre
    /// in parts of the picture's height.
    [[nodiscard]] Vec3 directionThrough(double right, double up) const;
    /// A camera in an eye D instead (+x right, +y up, along -z), with planes for the same bounds.
    [[nodiscard]] CameraPose poseOf(const RigidTransform& X_AD) const;

private:
    [[nodiscard]] Vec3 backward() const; ///< from the target to the eye
    [[nodiscard]] Vec3 up() const;
    [[nodiscard]] double fittingDistance() const;
    [[nodiscard]] CameraPose withPlanes(CameraPose pose) const;

    Box m_bounds_A;
    double m_aspect = 1.6;
    Vec3 m_target_A = Vec3::Zero();
    double m_yaw = 0.0; ///< 0 in front, positive towards the patient's left
    double m_pitch = 0.0;
    double m_level = 0.0; ///< pitch of the horizon: 0, or pi with the feet up in the picture
    double m_distance = 1.0;
    ViewPreset m_preset = ViewPreset::Front;
    bool m_fitted = true; ///< still as the preset framed it
};

} // namespace carina
