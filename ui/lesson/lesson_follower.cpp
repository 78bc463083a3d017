#include "ui/lesson/lesson_follower.h"

#include "models/patient/session_patient.h"
#include "ui/lesson/lesson_scene.h"

namespace carina
{

LessonFollower::LessonFollower(StationScene& scene, const SessionNode& node)
    : m_scene{scene}, m_node{node}
{
    m_scene.followView(true);
    m_scene.onFrameDrawn(
        [this](const DrawnFrame&, const StationMoment& moment) { follow(moment); });
}

bool LessonFollower::isFollowing() const { return m_scene.scene().drawnInstead().has_value(); }

void LessonFollower::follow(const StationMoment& moment)
{
    std::optional<SceneSettings> wanted;
    if (moment.lesson) {
        Lesson lesson = moment.lesson->lesson;
        if (!liesAt(*m_node.state(), ownStation(m_node), m_scene.patient()))
            lesson.looks.clear();
        wanted = settingsOf(lesson, m_scene.scene().parts());
    }
    if (m_scene.scene().drawnInstead() != wanted)
        m_scene.scene().drawInstead(wanted);
}

} // namespace carina
