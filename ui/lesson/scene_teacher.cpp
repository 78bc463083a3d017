#include "ui/lesson/scene_teacher.h"

#include "ui/lesson/lesson_scene.h"
#include "ui/panels/patient/parts_panel.h"
#include "ui/panels/patient/section_panel.h"

#include <algorithm>
#include <array>

namespace carina
{

SceneTeacher::SceneTeacher(LessonModel& model, const SceneView& scene)
    : m_model{model}, m_scene{scene}
{
    m_timer.callOnTimeout([this] { look(); });
    m_timer.start(kInterval_ms);
}

void SceneTeacher::pointAt(std::optional<std::uint16_t> part)
{
    m_part = part;
    const auto ray = m_scene.rayUnderMouse();
    m_mouse_A = ray ? std::optional{ray->dir_A} : std::nullopt;
}

void SceneTeacher::setElsewhere(bool elsewhere)
{
    m_isElsewhere = elsewhere;
    if (elsewhere)
        m_model.pointWith(std::nullopt); // what would be pointed at is not drawn
}

void SceneTeacher::showAgain(PartsPanel& parts, SectionPanel& section)
{
    const auto before = m_model.brokenOff();
    if (!before || !m_model.canShowAgain())
        return; // nothing is changed
    const SceneSettings settings = settingsOf(before->lesson, m_scene.parts());
    section.put(settings.section);
    parts.put(settings.looks);
    m_model.showAgain();
}

void SceneTeacher::look()
{
    if (m_isElsewhere)
        return;
    m_model.follow(lessonOf(m_scene.settings()));
    if (!m_model.isOn())
        return;
    const CameraPose& camera = m_scene.sight().pose;
    m_model.lookFrom(viewpointOf(camera));
    const auto p_A = target();
    m_model.pointWith(p_A ? std::optional{pointingAt(*p_A, camera)} : std::nullopt);
}

/// Of a list and the mouse whichever chose last.
std::optional<Vec3> SceneTeacher::target()
{
    const auto ray = m_scene.rayUnderMouse();
    if (m_part && ray && (!m_mouse_A || *m_mouse_A != ray->dir_A))
        m_part.reset();
    return m_part ? ofPart(*m_part) : underMouse();
}

std::optional<Vec3> SceneTeacher::underMouse() const
{
    const auto ray = m_scene.rayUnderMouse();
    if (!ray)
        return std::nullopt;
    const auto met =
        partsOnRay(m_scene.shownParts(), m_scene.frame(), m_scene.sight().section, *ray);
    return met.empty() ? std::nullopt
                       : std::optional{Vec3{ray->p_A_eye + met.front().distance * ray->dir_A}};
}

std::optional<Vec3> SceneTeacher::ofPart(std::uint16_t id) const
{
    const auto& parts = m_scene.shownParts();
    const auto part = std::ranges::find(parts, id, &ScenePart::id);
    if (part == parts.end())
        return std::nullopt;
    const std::array wanted{static_cast<std::size_t>(part - parts.begin())};
    const auto place = visiblePlaces(parts, wanted, m_scene.frame(), m_scene.sight()).front();
    return place ? drawnAt(*part, *place, m_scene.frame()) : std::nullopt;
}

} // namespace carina
