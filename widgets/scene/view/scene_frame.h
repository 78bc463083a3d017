#pragma once

#include "engine/anatomy/chest/chest_region.h"
#include "engine/anatomy/shapes/line_bend.h"
#include "engine/core/session_time.h"
#include "engine/display/eye_picture.h"
#include "engine/geometry/deformation/airway_field.h"
#include "engine/geometry/deformation/blade_field.h"
#include "engine/geometry/deformation/chest_field.h"
#include "engine/geometry/deformation/throat_field.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

inline constexpr std::size_t kMostEyes = 2; ///< eyes per frame

/// Pose and scale of a body F: its point p_F is drawn at X_AF * (scale p_F). Also a motion in A,
/// which takes what is at p_A to X_AF * (scale p_A).
struct PlacedBody {
    RigidTransform X_AF;
    double scale = 1.0;

    PlacedBody() = default;
    PlacedBody(const RigidTransform& place, double size = 1.0) // NOLINT: most have their own size
        : X_AF{place}, scale{size}
    {
    }

    [[nodiscard]] Vec3 at(const Vec3& p_F) const { return X_AF * Vec3{scale * p_F}; }
    /// The motion of what is placed: first `placed`, then `motion`.
    friend PlacedBody operator*(const PlacedBody& motion, const PlacedBody& placed)
    {
        return {RigidTransform{motion.X_AF.rotation() * placed.X_AF.rotation(),
                               motion.at(placed.X_AF.translation())},
                motion.scale * placed.scale};
    }
};

/// The deformation of the chest in one pose: the motion of each region, for the requested level of
/// detail. By default nothing moves.
struct BreathingChest {
    ChestField field;
    std::array<ChestMotion, kChestRegions> motion{}; ///< by ChestRegion

    [[nodiscard]] const ChestMotion& of(ChestRegion region) const
    {
        return motion[static_cast<std::size_t>(region)];
    }
};

/// Everything that moves in a scene, at one time.
struct SceneFrame {
    SessionTime time{}; ///< the time of this state

    BreathingChest chest;
    AirwayField airway; ///< what events change of the throat's tissue before it follows the jaw
    FollowingThroat throat;
    /// The body that the neck of `throat` bends, and whose tissue follows the jaw.
    std::string bends;
    /// What is bent as it lies in that body, though it has a pose of its own, as a tube: by name,
    /// X_AF of each such body where it lies in neutral position. In another one its form is that
    /// which the neck gives it there, seen from F, which goes with the head. Others keep their
    /// forms.
    std::map<std::string, RigidTransform> bentInPlace;
    /// What is bent along a line instead, in its own frame: by the name of its body.
    std::map<std::string, std::shared_ptr<const LineBend>> bentAlong;
    BladeField blade; ///< which pushes tissue of that body that has followed the jaw

    /// The pose of each moving body, by name. A body that is not listed is not drawn: a lost pose
    /// is never an identity.
    std::map<std::string, PlacedBody> bodies;

    /// The groups of parts that are lifted out, by ScenePart::liftedWith: the motion in A of each
    /// from where its bodies have it. Deformations take place before.
    std::map<std::string, PlacedBody> lifted;

    /// The pictures of at most kMostEyes eyes, in areas of the window that do not overlap. An empty
    /// list, as while a headset is lost, draws the background only; std::nullopt uses the view's
    /// own camera.
    std::optional<std::vector<EyePicture>> eyes;
    /// Mouse and keys turn the head that these eyes are in (SceneView::headTurned), and not the
    /// view's own camera.
    bool isHeadSteered = false;

    /// X_AD of an eye (+x right, +y up, looking along -z) in whose place the view's own camera is
    /// drawn. That stays where it is meanwhile, and nobody moves it.
    std::optional<RigidTransform> viewpoint{};
};

/// The place of a body in a frame, or of its parts that are lifted out with a group, while they
/// are; std::nullopt where the body is not drawn.
/// @param body       empty: what is fixed in A
/// @param liftedWith empty: what is in its place
[[nodiscard]] inline std::optional<PlacedBody>
placeOf(const SceneFrame& frame, const std::string& body, const std::string& liftedWith)
{
    PlacedBody place;
    if (!body.empty()) {
        const auto found = frame.bodies.find(body);
        if (found == frame.bodies.end())
            return std::nullopt;
        place = found->second;
    }
    const auto motion = frame.lifted.find(liftedWith);
    return motion == frame.lifted.end() ? place : motion->second * place;
}

/// One frame that was drawn.
struct DrawnFrame {
    SceneFrame frame;          ///< what was drawn
    int level = 0;             ///< common level of detail of the parts that share theirs
    std::size_t triangles = 0; ///< of all parts in their levels
    LocalTime asked{};         ///< when the frame source was called
    LocalTime lit{};           ///< the expected time of light passed to the frame source
    LocalTime swapped{};       ///< when the buffers had been swapped
};

} // namespace carina
