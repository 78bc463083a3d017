#include "ui/instructor/view_controls.h"

#include "models/text/shown_as_is.h"
#include "ui/instructor/saved_views_menu.h"
#include "ui/panels/people/people_menus.h"
#include "widgets/scene/view/scene_view.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace carina
{

ViewControls::ViewControls(StationScene& scene, SavedViews& views, const PeopleModel& people)
    : m_scene{scene}, m_eyes{new EyesMenu{people, tr("Through the eyes of"), this}}
{
    auto* row = new QHBoxLayout{this};
    row->setContentsMargins({});
    row->setSpacing(0);
    addPreset("front", tr("&Front"),
              tr("Seen from the patient's front; drag or arrow keys turn, wheel or + and - zoom"),
              ViewPreset::Front);
    addPreset("rightSide", tr("Si&de"), tr("Seen from the patient's right side"),
              ViewPreset::Right);
    addPreset("head", tr("&Head end"),
              tr("Seen from behind the patient's head, as a trainee stands"), ViewPreset::Trainee);
    auto* saved = new SavedViewsMenu{views, [this] { return present(); }, this};
    connect(saved, &SavedViewsMenu::chosen, this, &ViewControls::showSaved);
    addMenu("savedViews", tr("Vie&ws"), tr("Choose, save or delete a view"), *saved);
    connect(m_eyes, &EyesMenu::chosen, this, &ViewControls::seeThrough);
    addMenu("eyes", tr("E&yes of"),
            tr("Seen through the eyes of a participant whose head is tracked, or in the own view"),
            *m_eyes)
        ->setAccessibleName(tr("Through the eyes of a participant"));
}

QToolButton* ViewControls::add(const char* name, const QString& text, const QString& toolTip)
{
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String{name});
    button->setText(text);
    button->setToolTip(shownAsIs(toolTip));
    button->setFocusPolicy(Qt::TabFocus);
    layout()->addWidget(button);
    return button;
}

/// A view of the own camera is chosen by where it stands.
QToolButton* ViewControls::addPreset(const char* name, const QString& text, const QString& toolTip,
                                     ViewPreset preset)
{
    QToolButton* button = add(name, text, toolTip);
    connect(button, &QToolButton::clicked, this, [this, preset] {
        m_scene.scene().showFrom(preset);
        seeThrough(std::nullopt);
    });
    return button;
}

QToolButton* ViewControls::addMenu(const char* name, const QString& text, const QString& toolTip,
                                   QMenu& menu)
{
    QToolButton* button = add(name, text, toolTip);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(&menu);
    return button;
}

void ViewControls::seeThrough(std::optional<ParticipantId> participant)
{
    m_eyes->setChosen(participant);
    m_scene.seeThrough(participant);
    Q_EMIT changed();
}

SavedView ViewControls::present() const
{
    const CameraPose pose = m_scene.scene().camera().pose();
    return {{}, pose.p_A_eye, pose.p_A_target, pose.up_A};
}

void ViewControls::showSaved(const SavedView& view)
{
    CameraPose pose;
    pose.p_A_eye = view.p_A_eye;
    pose.p_A_target = view.p_A_target;
    pose.up_A = view.up_A;
    m_scene.scene().showFrom(pose);
    seeThrough(std::nullopt);
}

} // namespace carina
