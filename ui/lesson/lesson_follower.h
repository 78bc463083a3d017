#pragma once

#include "ui/scene/station_scene.h"

namespace carina
{

/// Draws what an instructor shows to this program's participant in place of the own settings of a
/// scene, which are drawn again afterwards. The parts of another patient than that of the session
/// stay as usual.
class LessonFollower
{
public:
    /// @pre both outlive this.
    LessonFollower(StationScene& scene, const SessionNode& node);

    /// Whether something is drawn in place of the own settings.
    [[nodiscard]] bool isFollowing() const;

private:
    void follow(const StationMoment& moment);

    StationScene& m_scene;
    const SessionNode& m_node;
};

} // namespace carina
