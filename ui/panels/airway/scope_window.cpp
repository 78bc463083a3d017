#include "ui/panels/airway/scope_window.h"

#include "ui/panels/airway/laryngoscope_panel.h"

#include <QKeyEvent>
#include <QScreen>
#include <QVBoxLayout>

#include <utility>

namespace carina
{

ScopeWindow::ScopeWindow(StationScene& station, std::shared_ptr<FlownEndoscope> endoscope,
                         LaryngoscopePanel& opener)
    : QWidget{&opener, Qt::Window},
      m_panel{new LaryngoscopePanel{PanelPlace::WholeScreen, std::move(endoscope)}}
{
    setObjectName(QStringLiteral("scopeWindow"));
    setWindowTitle(tr("Carina: what the laryngoscope shows (Esc: close)"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* whole = new QVBoxLayout{this};
    whole->setContentsMargins({});
    whole->addWidget(m_panel);
    m_panel->setStation(station);
    connect(m_panel, &LaryngoscopePanel::wholeScreenToggled, this, &QWidget::close);
    m_panel->setFocus();
    setGeometry(opener.screen()->geometry());
    setWindowState(Qt::WindowFullScreen);
}

void ScopeWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        close();
    else
        QWidget::keyPressEvent(event);
}

} // namespace carina
