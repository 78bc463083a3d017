#include "ui/trainee_window.h"

#include "models/station_notice.h"
#include "widgets/scene/scene_view.h"

#include <QAction>
#include <QTimer>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kNoticeInterval_ms = 200;

} // namespace

TraineeWindow::TraineeWindow(const SessionNode& node, StationId station,
                             const PatientModel& patient, const StationView& view)
    : m_node{node},
      m_station{station},
      m_scene{new SceneView{this}},
      m_notice{new QLabel{this}},
      m_stationScene{*m_scene, patient, view}
{
    setWindowTitle(tr("Carina trainee"));
    setPalette(QPalette{Qt::white, Qt::black});
    setAutoFillBackground(true);
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_scene, 1);
    column->addWidget(m_notice);
    m_notice->setAlignment(Qt::AlignCenter);
    m_notice->setMargin(4);

    m_scene->setAccessibleName(tr("Patient, three-dimensional view"));
    m_scene->setBackground(Qt::black);
    makeMenu();
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &TraineeWindow::refreshNotice);
    timer->start(kNoticeInterval_ms);
    refreshNotice();
}

void TraineeWindow::makeMenu()
{
    m_menu.addAction(tr("From the &front"), this, [this] { m_scene->showFrom(ViewPreset::Front); });
    m_menu.addAction(tr("From the &right side"), this,
                     [this] { m_scene->showFrom(ViewPreset::Right); });
    m_menu.addAction(tr("From the &head end"), this,
                     [this] { m_scene->showFrom(ViewPreset::Trainee); });
    m_menu.addSeparator();
    m_menu.addAction(tr("F&ull screen on or off"), this,
                     [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    m_menu.addAction(tr("&Leave"), this, &QWidget::close);

    auto* open = new QAction{tr("Menu"), this};
    open->setShortcut(Qt::Key_Escape);
    open->setShortcutContext(Qt::ApplicationShortcut); // also while the scene has the keyboard
    connect(open, &QAction::triggered, this,
            [this] { m_menu.popup(mapToGlobal(rect().center())); });
    addAction(open);
}

void TraineeWindow::refreshNotice()
{
    const QString notice = stationNotice(m_node, m_station, m_stationScene.patient().contentHash(),
                                         m_stationScene.moment());
    m_notice->setText(notice);
    m_notice->setVisible(!notice.isEmpty());
}

} // namespace carina
