#include "ui/instructor/projector_window.h"

#include "widgets/scene/view/scene_view.h"

#include <QCloseEvent>
#include <QGuiApplication>
#include <QScreen>
#include <QShortcut>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kFollowing_ms = 100;
constexpr QSize kWindowed{960, 540};

/// A screen on which the console is not; null where there is none.
QScreen* otherScreen(const QWidget& console)
{
    const QScreen* taken = console.screen();
    for (QScreen* screen : QGuiApplication::screens())
        if (screen != taken && !screen->geometry().intersects(taken->geometry())) // no mirror
            return screen;
    return nullptr;
}

} // namespace

ProjectorWindow::ProjectorWindow(const StationScene& shown, const PatientModel& patient,
                                 const StationView& view, QWidget& console)
    : m_shown{shown},
      m_console{console},
      m_scene{new SceneView},
      m_stationScene{*m_scene, patient, view}
{
    setObjectName(QStringLiteral("projector"));
    setWindowTitle(tr("Carina: the picture (F11: full screen, Esc: close)"));
    m_scene->setAccessibleName(tr("Patient, three-dimensional view, as on the console"));
    m_scene->setBackground(palette().color(QPalette::Base));
    m_scene->follow(shown.scene());
    auto* whole = new QVBoxLayout{this};
    whole->setContentsMargins({});
    whole->addWidget(m_scene);
    connect(new QShortcut{QKeySequence{Qt::Key_Escape}, this}, &QShortcut::activated, this,
            &QWidget::close);
    connect(new QShortcut{QKeySequence{Qt::Key_F11}, this}, &QShortcut::activated, this,
            &ProjectorWindow::toggleFullScreen);
    m_following.callOnTimeout(this, &ProjectorWindow::follow);
    m_following.start(kFollowing_ms);
    follow();
    // Qt moves the window first.
    connect(qApp, &QGuiApplication::screenRemoved, this, &ProjectorWindow::keepOffConsole,
            Qt::QueuedConnection);
    resize(kWindowed);
    place();
}

void ProjectorWindow::follow()
{
    m_stationScene.seeThrough(m_shown.throughEyesOf());
    m_stationScene.showBlade(m_shown.laryngoscope().ownBlade());
}

void ProjectorWindow::place()
{
    if (QScreen* screen = otherScreen(m_console)) {
        setGeometry(screen->geometry());
        setWindowState(Qt::WindowFullScreen);
    }
}

void ProjectorWindow::show(const PatientModel& patient, const StationView& view)
{
    m_stationScene.show(patient, view);
}

void ProjectorWindow::toggleFullScreen()
{
    if (isFullScreen())
        showNormal();
    else
        showFullScreen();
}

void ProjectorWindow::keepOffConsole()
{
    if (!isFullScreen() || screen() != m_console.screen())
        return;
    showNormal();
    resize(kWindowed);
    m_console.raise();
}

void ProjectorWindow::closeEvent(QCloseEvent* event)
{
    QWidget::closeEvent(event);
    Q_EMIT closed();
}

} // namespace carina
