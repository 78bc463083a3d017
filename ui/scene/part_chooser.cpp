#include "ui/scene/part_chooser.h"

#include "ui/panels/patient/parts_panel.h"

namespace carina
{
namespace
{

constexpr double kSamePlace = 0.003; ///< between unit directions: a few pixels

} // namespace

PartChooser::PartChooser(const SceneView& scene, PartsPanel& panel) : m_scene{scene}, m_panel{panel}
{
    connect(&scene, &SceneView::clicked, this, [this](const Vec3& p_A_eye, const Vec3& dir_A) {
        choose({p_A_eye, dir_A});
    });
}

void PartChooser::choose(const SightRay& ray)
{
    const auto& parts = m_scene.shownParts();
    const auto met = partsOnRay(parts, m_scene.frame(), m_scene.sight().section, ray);
    const bool again = (ray.dir_A - m_lastDir_A).norm() < kSamePlace;
    m_depth = again ? m_depth + 1 : 0;
    m_lastDir_A = ray.dir_A;
    if (met.empty()) {
        m_panel.choose(std::nullopt);
        Q_EMIT chosen({});
        return;
    }
    const ScenePart& part = parts[met[m_depth % met.size()].part];
    m_panel.choose(part.id);
    Q_EMIT chosen(QString::fromStdString(part.name));
}

} // namespace carina
