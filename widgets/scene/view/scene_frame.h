#pragma once

#include "engine/anatomy/chest/chest_region.h"
#include "engine/core/session_time.h"
#include "engine/display/eye_picture.h"
#include "engine/geometry/deformation/chest_field.h"
#include "engine/geometry/deformation/throat_field.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

inline constexpr std::size_t kMostEyes = 2; ///< that see one frame

/// Where a body F is drawn, and how large: a point p_F of it at X_AF * (scale p_F).
struct PlacedBody {
    RigidTransform X_AF;
    double scale = 1.0;

    PlacedBody() = default;
    PlacedBody(const RigidTransform& place, double size = 1.0) // NOLINT: most have their own size
        : X_AF{place}, scale{size}
    {
    }
};

/// The chest in one pose: what moves each of its regions, for the level of detail that was asked
/// for. Nothing moves by default.
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
    SessionTime time{}; ///< for which this holds

    BreathingChest chest;
    FollowingThroat throat;

    /// Each moving body's place, by name. A body that is not in here is not drawn: lost
    /// is never an identity.
    std::map<std::string, PlacedBody> bodies;

    /// The eyes it is seen by, at most kMostEyes, in parts of the window that do not overlap; none
    /// at all, as while a headset is lost, leave the background. Without a list the view's own
    /// camera sees it.
    std::optional<std::vector<EyePicture>> eyes;
};

/// One frame that was drawn.
struct DrawnFrame {
    SceneFrame frame;          ///< what was drawn
    int level = 0;             ///< in which level of detail, of those parts that share theirs
    std::size_t triangles = 0; ///< of all parts in their levels
    LocalTime asked{};         ///< when the frame source was asked
    LocalTime lit{};           ///< when it was expected to be lit, as the frame source was told
    LocalTime swapped{};       ///< when the buffers had been swapped
};

} // namespace carina
