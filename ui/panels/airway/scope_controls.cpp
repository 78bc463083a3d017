#include "ui/panels/airway/scope_controls.h"

#include "models/text/shown_as_is.h"
#include "ui/panels/airway/scope_canvas.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>
#include <functional>

namespace carina
{
namespace
{

constexpr int kAtBlade = 0; ///< rows of the choice
constexpr int kFlown = 1;
constexpr int kBetweenControls = 4; ///< pixels

/// What a button does to an endoscope.
struct FlightButton {
    const char* name; ///< of the object
    QString text;
    QString spoken;
    QString toolTip;
    std::function<void(FlownEndoscope&)> fly;
};

} // namespace

ScopeControls::ScopeControls(FlownEndoscope& endoscope, bool isOnWholeScreen, QWidget* parent)
    : QWidget{parent},
      m_endoscope{endoscope},
      m_camera{new QComboBox},
      m_whole{new QToolButton},
      m_flight{new QWidget}
{
    m_camera->setObjectName(QStringLiteral("scopeCamera"));
    m_camera->setAccessibleName(tr("Camera of the picture"));
    m_camera->addItems({tr("Camera at the blade"), tr("Camera flown by hand")});
    connect(m_camera, &QComboBox::activated, this, [this](int row) {
        m_endoscope.fly(row == kFlown);
        Q_EMIT cameraChosen();
    });
    m_whole->setObjectName(QStringLiteral("scopeWholeScreen"));
    m_whole->setText(isOnWholeScreen ? tr("Leave full screen") : tr("Full screen"));
    m_whole->setToolTip(isOnWholeScreen
                            ? tr("Shows the picture in its panel again (Esc)")
                            : tr("Shows the picture on the whole screen (F11, or a double click on "
                                 "it); Esc ends that"));
    m_whole->setFocusPolicy(Qt::StrongFocus);
    connect(m_whole, &QToolButton::clicked, this, &ScopeControls::wholeScreenToggled);
    auto* rows = new QVBoxLayout{this};
    rows->setContentsMargins({});
    rows->setSpacing(kBetweenControls);
    auto* choices = new QHBoxLayout;
    choices->setSpacing(kBetweenControls);
    choices->addStretch();
    choices->addWidget(m_camera);
    choices->addWidget(m_whole);
    choices->addStretch();
    rows->addLayout(choices);
    addFlight();
    rows->addWidget(m_flight);
    refresh(true);
}

void ScopeControls::addFlight()
{
    const std::array buttons{
        FlightButton{"flyBack", tr("Mouth"), tr("In front of the mouth"),
                     tr("Takes the camera back in front of the mouth (Home)"),
                     [](FlownEndoscope& scope) { scope.goBack(); }},
        FlightButton{"flyWithdraw", tr("−", "withdraw"), tr("Withdraw the camera"),
                     tr("Takes the camera 2 mm back (S, page down, or the wheel)"),
                     [](FlownEndoscope& scope) { scope.advance(-1.0 * kWayEach); }},
        FlightButton{"flyAdvance", tr("+", "advance"), tr("Advance the camera"),
                     tr("Takes the camera 2 mm on, up to a wall (W, page up, or the wheel)"),
                     [](FlownEndoscope& scope) { scope.advance(kWayEach); }},
        FlightButton{"flyLeft", tr("←"), tr("Turn the camera left"),
                     tr("Turns the camera by 5° to the left of the picture (←, or drag)"),
                     [](FlownEndoscope& scope) { scope.turn(-1.0 * kTurnEach, {}); }},
        FlightButton{"flyRight", tr("→"), tr("Turn the camera right"),
                     tr("Turns the camera by 5° to the right of the picture (→, or drag)"),
                     [](FlownEndoscope& scope) { scope.turn(kTurnEach, {}); }},
        FlightButton{"flyUp", tr("↑"), tr("Turn the camera up"),
                     tr("Turns the camera by 5° up in the picture (↑, or drag)"),
                     [](FlownEndoscope& scope) { scope.turn({}, kTurnEach); }},
        FlightButton{"flyDown", tr("↓"), tr("Turn the camera down"),
                     tr("Turns the camera by 5° down in the picture (↓, or drag)"),
                     [](FlownEndoscope& scope) { scope.turn({}, -1.0 * kTurnEach); }},
    };
    auto* row = new QHBoxLayout{m_flight};
    row->setContentsMargins({});
    row->setSpacing(kBetweenControls);
    row->addStretch();
    for (const FlightButton& made : buttons) {
        auto* button = new QToolButton;
        button->setObjectName(QLatin1String{made.name});
        button->setText(made.text);
        button->setAccessibleName(made.spoken);
        button->setToolTip(shownAsIs(made.toolTip));
        button->setFocusPolicy(Qt::StrongFocus);
        button->setAutoRepeat(true);
        connect(button, &QToolButton::clicked, this, [this, fly = made.fly] { fly(m_endoscope); });
        row->addWidget(button);
    }
    row->addStretch();
}

void ScopeControls::refresh(bool canFly)
{
    auto* rows = qobject_cast<QStandardItemModel*>(m_camera->model());
    rows->item(kFlown)->setEnabled(canFly);
    const QString told = canFly ? tr("At the blade of a laryngoscope, or an endoscope that you fly "
                                     "through the airway: only you see it")
                                : tr("An endoscope cannot be flown: this patient has no lining of "
                                     "throat or larynx, or no trachea");
    m_camera->setToolTip(shownAsIs(told));
    m_camera->setAccessibleDescription(told);
    const bool isFlown = canFly && m_endoscope.isFlown();
    m_camera->setCurrentIndex(isFlown ? kFlown : kAtBlade);
    m_flight->setVisible(isFlown);
}

} // namespace carina
