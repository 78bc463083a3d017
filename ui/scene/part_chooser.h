#pragma once

#include "widgets/scene/view/scene_view.h"

#include <QObject>

namespace carina
{

class PartsPanel;

/// Chooses the part that is clicked in a picture in the list of parts; a further click at the same
/// place chooses what is behind it.
class PartChooser : public QObject
{
    Q_OBJECT

public:
    /// @pre both outlive this.
    PartChooser(const SceneView& scene, PartsPanel& panel);

Q_SIGNALS:
    /// The name of the part that was clicked; empty where there is none.
    void chosen(const QString& name);

private:
    void choose(const SightRay& ray);

    const SceneView& m_scene;
    PartsPanel& m_panel;
    Vec3 m_lastDir_A = Vec3::Zero();
    std::size_t m_depth = 0; ///< how many parts before the chosen one the ray meets
};

} // namespace carina
