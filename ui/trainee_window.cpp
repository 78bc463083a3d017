#include "ui/trainee_window.h"

#include "models/station_notice.h"
#include "widgets/scene/scene_view.h"

#include <QActionGroup>
#include <QTimer>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kNoticeInterval_ms = 200;
constexpr int kNoticeMargin = 4; // pixels

} // namespace

TraineeWindow::TraineeWindow(const SessionNode& node, StationId station,
                             const PatientModel& patient, const StationView& view,
                             const HeadsetView& headset, ViewOutput output,
                             ChinProbeModel chinProbe)
    : m_node{node},
      m_station{station},
      m_scene{new SceneView{this}},
      m_notices{new QLabel{this}, new QLabel{this}},
      m_headset{headset},
      m_chinProbe{chinProbe},
      m_stationScene{*m_scene, patient, view}
{
    setWindowTitle(tr("Carina trainee"));
    setPalette(QPalette{Qt::white, Qt::black});
    setAutoFillBackground(true);
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_scene);
    for (QLabel* notice : m_notices) {
        notice->setAttribute(Qt::WA_NativeWindow); // else the scene's own window would cover it
        notice->setAlignment(Qt::AlignCenter);
        notice->setAutoFillBackground(true);
        notice->setMargin(kNoticeMargin);
        notice->setWordWrap(true);
    }

    m_scene->setAccessibleName(tr("Patient, three-dimensional view"));
    m_scene->setBackground(Qt::black);
    showTo(output);
    makeMenu();
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &TraineeWindow::refreshNotice);
    timer->start(kNoticeInterval_ms);
}

void TraineeWindow::makeMenu()
{
    addOutputs();
    m_menu.addSeparator();
    addPresets();
    m_menu.addSeparator();
    if (m_chinProbe.isThere())
        addChinProbe();
    m_menu.addAction(tr("F&ull screen on or off"), this,
                     [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    m_menu.addAction(tr("&Leave"), this, &QWidget::close);

    auto* open = new QAction{tr("Menu"), this};
    open->setShortcut(Qt::Key_Escape);
    open->setShortcutContext(Qt::ApplicationShortcut); // also while the scene has the keyboard
    connect(open, &QAction::triggered, this, [this] { m_menu.popup(mapToGlobal(menuPlace())); });
    addAction(open);
}

void TraineeWindow::addOutputs()
{
    auto* outputs = new QActionGroup{this};
    const auto add = [this, outputs](ViewOutput output, const QString& text) {
        QAction* action = m_menu.addAction(text, this, [this, output] { showTo(output); });
        action->setCheckable(true);
        action->setChecked(output == m_stationScene.output());
        outputs->addAction(action);
    };
    add(ViewOutput::Screen, tr("On a &screen"));
    add(ViewOutput::Mono, tr("In a headset, &one picture"));
    add(ViewOutput::SideBySide, tr("In a headset, &two pictures side by side"));
}

void TraineeWindow::addPresets()
{
    const auto add = [this](ViewPreset preset, const QString& text) {
        m_presets.push_back(
            m_menu.addAction(text, this, [this, preset] { m_scene->showFrom(preset); }));
        m_presets.back()->setEnabled(m_stationScene.output() == ViewOutput::Screen);
    };
    add(ViewPreset::Front, tr("From the &front"));
    add(ViewPreset::Right, tr("From the &right side"));
    add(ViewPreset::Trainee, tr("From the &head end"));
}

void TraineeWindow::addChinProbe()
{
    auto* choices = new QActionGroup{this};
    const auto add = [this, choices](bool movesManikin, const QString& text) {
        QAction* action = m_menu.addAction(
            text, this, [this, movesManikin] { m_chinProbe.setMovesManikin(movesManikin); });
        action->setCheckable(true);
        action->setChecked(movesManikin == m_chinProbe.movesManikin());
        choices->addAction(action);
    };
    add(false, tr("Manikin lies still, chin probe moves the &jaw"));
    add(true, tr("&Manikin is moved with its mouth closed"));
    m_menu.addSeparator();
}

void TraineeWindow::showTo(ViewOutput output)
{
    m_stationScene.showTo(m_headset, output);
    for (QAction* preset : m_presets)
        preset->setEnabled(output == ViewOutput::Screen);
    refreshNotice();
}

void TraineeWindow::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    refreshNotice();
}

/// Where one eye sees it whole.
QPoint TraineeWindow::menuPlace() const
{
    const bool twice = m_stationScene.output() == ViewOutput::SideBySide;
    const QSize size = m_menu.sizeHint();
    const QRect eye{0, 0, twice ? width() / 2 : width(), height()};
    return eye.center() - QPoint{size.width() / 2, size.height() / 2};
}

QString TraineeWindow::notice() const
{
    const QString notice = stationNotice(m_node, m_station, m_stationScene.patient().contentHash(),
                                         m_stationScene.moment(), m_stationScene.output());
    return notice.isEmpty() && m_chinProbe.movesManikin()
               ? tr("The patient follows the chin probe: keep the manikin's mouth closed")
               : notice;
}

void TraineeWindow::refreshNotice()
{
    const ViewOutput output = m_stationScene.output();
    const QString notice = this->notice();
    const bool twice = output == ViewOutput::SideBySide;
    const int width = twice ? this->width() / 2 : this->width();
    placeNotice(0, notice, {0, 0, width, height()});
    placeNotice(1, twice ? notice : QString{}, {width, 0, width, height()});
}

void TraineeWindow::placeNotice(std::size_t place, const QString& notice, const QRect& within)
{
    QLabel& label = *m_notices[place];
    label.setVisible(!notice.isEmpty());
    if (notice.isEmpty())
        return;
    const QMargins margins{kNoticeMargin, kNoticeMargin, kNoticeMargin, kNoticeMargin};
    QRect needed = label.fontMetrics().boundingRect(within - margins,
                                                    Qt::AlignCenter | Qt::TextWordWrap, notice)
                   + margins;
    needed.moveBottom(within.bottom());
    label.setText(notice);
    label.setGeometry(needed);
    label.raise();
}

} // namespace carina
