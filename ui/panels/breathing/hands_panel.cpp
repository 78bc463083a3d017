#include "ui/panels/breathing/hands_panel.h"

#include "models/physiology/hands_model.h"
#include "widgets/plain_label.h"

#include <QAction>
#include <QToolButton>
#include <QVBoxLayout>

namespace carina
{
namespace
{

QAction* keyedAction(Qt::Key key, const char* name, QWidget* parent)
{
    auto* action = new QAction{parent};
    action->setObjectName(QLatin1String{name});
    action->setShortcut(key);
    action->setShortcutContext(Qt::ApplicationShortcut); // also while a scene has the keyboard
    action->setAutoRepeat(false);
    action->setEnabled(false);
    return action;
}

} // namespace

HandsPanel::HandsPanel(QWidget* parent)
    : QWidget{parent},
      m_cuff{keyedAction(Qt::Key_F7, "handsCuff", this)},
      m_stylet{keyedAction(Qt::Key_F8, "handsStylet", this)},
      m_bag{keyedAction(Qt::Key_F9, "handsBag", this)},
      m_obstacle{new PlainLabel},
      m_travelling{new PlainLabel}
{
    m_cuff->setText(tr("&Inflate the cuff"));
    m_stylet->setText(tr("Stylet out"));
    m_bag->setText(tr("S&queeze the bag"));
    m_bag->setCheckable(true);
    m_cuff->setToolTip(tr("Without it a quarter of each breath escapes beside the tube (F7)"));
    m_stylet->setToolTip(
        tr("Once a tube is followed; it is back in the tube for the next try (F8)"));
    m_bag->setToolTip(tr("As often as the patient would breathe quietly, in place of a ventilator, "
                         "until you let it go (F9)"));
    layOut();
}

void HandsPanel::layOut()
{
    auto* column = new QVBoxLayout{this};
    for (QAction* action : handActions()) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        column->addWidget(button);
        if (action == m_cuff)
            setFocusProxy(button);
    }
    m_obstacle->setObjectName(QStringLiteral("handsObstacle"));
    m_obstacle->setWordWrap(true);
    m_travelling->setObjectName(QStringLiteral("handsTravelling"));
    m_travelling->setAccessibleName(tr("What is under way"));
    m_travelling->setMinimumHeight(2 * m_travelling->fontMetrics().lineSpacing());
    m_travelling->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    column->addWidget(m_obstacle);
    column->addWidget(m_travelling);
    column->addStretch(1);
}

void HandsPanel::setModel(HandsModel& model)
{
    m_model = &model;
    connect(m_cuff, &QAction::triggered, &model,
            [&model] { model.setCuff(!model.isCuffInflated()); });
    connect(m_stylet, &QAction::triggered, &model, &HandsModel::drawStylet);
    connect(m_bag, &QAction::triggered, &model, &HandsModel::squeezeBag);
    connect(&model, &HandsModel::changed, this, &HandsPanel::refresh);
    refresh();
}

QString HandsPanel::obstacle() const { return m_model ? m_model->obstacleToBag() : QString{}; }

void HandsPanel::refresh()
{
    const bool handlesTube = m_model->obstacle().isEmpty();
    m_cuff->setText(m_model->isCuffInflated() ? tr("Deflate the cuff") : tr("&Inflate the cuff"));
    m_cuff->setEnabled(handlesTube);
    m_stylet->setEnabled(handlesTube && m_model->hasStylet());
    m_bag->setChecked(m_model->isBagSqueezed());
    m_bag->setEnabled(obstacle().isEmpty());
    m_obstacle->setText(obstacle());
    m_obstacle->setVisible(!obstacle().isEmpty());
    m_travelling->setText(m_model->travellingText());
}

} // namespace carina
