#pragma once

#include "models/console/saved_views.h"
#include "models/session/people_model.h"
#include "ui/scene/station_scene.h"
#include "widgets/scene/view/orbit_camera.h"

#include <QWidget>

#include <optional>

class QToolButton;

namespace carina
{

class EyesMenu;

/// From where the picture is seen: from a side of the patient, as the instructor saved it, or
/// through somebody's eyes.
class ViewControls : public QWidget
{
    Q_OBJECT

public:
    /// @pre all outlive this.
    ViewControls(StationScene& scene, SavedViews& views, const PeopleModel& people);

Q_SIGNALS:
    /// Through whose eyes it is seen may have changed.
    void changed();

private:
    QToolButton* addPreset(const char* name, const QString& text, const QString& toolTip,
                           ViewPreset preset);
    QToolButton* addMenu(const char* name, const QString& text, const QString& toolTip,
                         QMenu& menu);
    QToolButton* add(const char* name, const QString& text, const QString& toolTip);
    void seeThrough(std::optional<ParticipantId> participant);
    [[nodiscard]] SavedView present() const;
    void showSaved(const SavedView& view);

    StationScene& m_scene;
    EyesMenu* m_eyes;
};

} // namespace carina
