#pragma once

#include "models/lesson/lesson_model.h"
#include "widgets/scene/view/scene_view.h"

#include <QTimer>

namespace carina
{

class PartsPanel;
class SectionPanel;

/// Shows what a view of the instructor draws, from where it looks, and points at what is under the
/// mouse, or at the part that was chosen last in a list.
class SceneTeacher
{
public:
    static constexpr int kInterval_ms = 33; ///< of the view and the pointer

    /// @pre both outlive this.
    SceneTeacher(LessonModel& model, const SceneView& scene);

    /// Points at a part from now on, until the mouse moves over the picture; std::nullopt: at none.
    void pointAt(std::optional<std::uint16_t> part);

    /// While the view draws another station than the model's, nothing of it is shown.
    void setElsewhere(bool elsewhere);

    /// Shows again what broke off (LessonModel::brokenOff), by making the picture so in its panels.
    /// @pre the view draws the patient of the model's station.
    void showAgain(PartsPanel& parts, SectionPanel& section);

private:
    void look();
    [[nodiscard]] std::optional<Vec3> target();
    [[nodiscard]] std::optional<Vec3> underMouse() const;
    [[nodiscard]] std::optional<Vec3> ofPart(std::uint16_t id) const;

    LessonModel& m_model;
    const SceneView& m_scene;
    bool m_isElsewhere = false;
    std::optional<std::uint16_t> m_part;
    std::optional<Vec3> m_mouse_A; ///< the direction of the mouse when the part was chosen
    QTimer m_timer;
};

} // namespace carina
