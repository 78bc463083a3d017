#include "ui/lesson/lesson_bar.h"

#include "models/text/shown_as_is.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QStyle>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kWidestTarget = 130; ///< pixels, of a name

/// A text in which & is no mark of a key.
QString withoutKey(QString text) { return text.replace(QLatin1Char{'&'}, QStringLiteral("&&")); }

QString nameIn(const std::vector<LessonModel::Target>& targets, ParticipantId target)
{
    const auto found = std::ranges::find(targets, target, &LessonModel::Target::id);
    return found == targets.end() ? QString{} : found->name;
}

/// As wide as it ever gets, so that nothing beside it moves when its word changes.
void reserve(QToolButton& button, const QString& longest)
{
    const QString now = button.text();
    button.setText(longest);
    button.setMinimumWidth(button.sizeHint().width());
    button.setText(now);
}

} // namespace

LessonBar::LessonBar(QWidget* parent)
    : QWidget{parent}, m_switch{new QToolButton{this}}, m_to{new QToolButton{this}}
{
    m_switch->setObjectName(QStringLiteral("showToOthers"));
    m_switch->setCheckable(true);
    m_switch->setFocusPolicy(Qt::StrongFocus);
    m_switch->setToolTip(
        tr("Shows others your sections, highlights, names and view of the patient, and what you "
           "point at: your mouse over the picture is the pointer"));
    m_to->setObjectName(QStringLiteral("showTo"));
    m_to->setFocusPolicy(Qt::StrongFocus);
    m_to->setPopupMode(QToolButton::InstantPopup);
    m_to->setMenu(&m_menu);
    auto* row = new QHBoxLayout{this};
    row->setContentsMargins(style()->pixelMetric(QStyle::PM_LayoutLeftMargin), 0, 0, 0);
    row->addWidget(m_switch);
    row->addWidget(m_to);
    row->addStretch(1);
    reserve(*m_switch, tr("● Shown"));
    setEnabled(false); // until there is a model
}

void LessonBar::setModel(LessonModel& model)
{
    m_model = &model;
    connect(m_switch, &QToolButton::clicked, &model, &LessonModel::setOn);
    connect(&m_menu, &QMenu::aboutToShow, this, &LessonBar::list);
    connect(&model, &LessonModel::changed, this, &LessonBar::refresh);
    refresh();
}

void LessonBar::putBefore(QWidget& after)
{
    setTabOrder(m_switch, m_to);
    setTabOrder(m_to, &after);
}

void LessonBar::refresh()
{
    setEnabled(m_model->canSwitch());
    const bool isOn = m_model->isOn();
    m_switch->setChecked(isOn);
    m_switch->setText(isOn ? tr("● Shown") : tr("○ Show"));
    const QString to = nameIn(m_model->targets(), m_model->target());
    m_switch->setAccessibleName(tr("Show what you see to: %1").arg(to));
    m_switch->setAccessibleDescription(m_model->text());
    m_to->setAccessibleName(tr("To whom it is shown, now: %1").arg(to));
    const QString fitting = m_to->fontMetrics().elidedText(to, Qt::ElideRight, kWidestTarget);
    m_to->setText(withoutKey(tr("To: %1").arg(fitting)));
    m_to->setToolTip(shownAsIs(tr("To whom it is shown: %1").arg(to)));
}

void LessonBar::list()
{
    m_menu.clear();
    auto* group = new QActionGroup{&m_menu};
    for (const LessonModel::Target& target : m_model->targets()) {
        QAction* action = m_menu.addAction(withoutKey(target.name), m_model,
                                           [this, id = target.id] { m_model->setTarget(id); });
        action->setCheckable(true);
        action->setChecked(target.id == m_model->target());
        group->addAction(action);
    }
    m_menu.addSeparator();
    QAction* view = m_menu.addAction(tr("With my &view, on screens without a head tracker"));
    view->setCheckable(true);
    view->setChecked(m_model->showsView());
    connect(view, &QAction::toggled, m_model, &LessonModel::setShowsView);
}

} // namespace carina
