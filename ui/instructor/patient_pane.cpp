#include "ui/instructor/patient_pane.h"

#include "ui_patient_pane.h"

#include <QEvent>
#include <QWindow>

namespace carina
{

PatientPane::PatientPane(QWidget* parent)
    : QWidget{parent}, m_ui{std::make_unique<Ui::PatientPane>()}
{
    m_ui->setupUi(this);
    m_ui->scene->setBackground(palette().color(QPalette::Base));
    m_ui->centreLayout->removeWidget(m_ui->attentionBar);
    m_ui->attentionBar->setAttribute(Qt::WA_NativeWindow); // else the scene's own would cover it
    m_ui->attentionBar->setAutoFillBackground(true);
    m_ui->attentionBar->installEventFilter(this);
    m_ui->scene->installEventFilter(this);
    connect(m_ui->exaggeration, &QDoubleSpinBox::valueChanged, this,
            [this](double factor) { m_view->exaggerate(factor); });
    connect(m_ui->exaggeration, &CheckedDoubleSpinBox::refused, this, &PatientPane::refused);
}

PatientPane::~PatientPane() = default;

void PatientPane::setModels(StationsModel& stations, AttentionModel& attention,
                            IntubationTimeline& intubation)
{
    m_ui->stations->setModel(stations);
    m_ui->attentionBar->setModel(attention);
    m_ui->intubation->setTimeline(intubation);
}

void PatientPane::chooseStep(SessionTime moment) { m_ui->intubation->choose(moment); }

void PatientPane::show(const PatientModel& patient, StationView& view)
{
    m_view = &view;
    view.exaggerate(m_ui->exaggeration->value());
    if (m_stationScene)
        m_stationScene->show(patient, view);
    else
        m_stationScene = std::make_unique<StationScene>(*m_ui->scene, patient, view);
}

bool PatientPane::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Move:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::LayoutRequest: // it says something else
        layAttention();
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

/// Over the upper edge of the picture, of which it takes no more than its sentence needs.
void PatientPane::layAttention()
{
    const QRect picture = m_ui->scene->geometry();
    const QSize size = m_ui->attentionBar->sizeIn(picture.width());
    m_ui->attentionBar->lie({picture.topLeft(), size});
    m_ui->scene->keepNamesBelow(m_ui->attentionBar->isHidden() ? 0 : size.height());
    if (QWindow* window = m_ui->attentionBar->windowHandle())
        window->raise();
}

SceneView& PatientPane::scene() { return *m_ui->scene; }

} // namespace carina
