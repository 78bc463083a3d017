#include "ui/instructor/patient_pane.h"

#include "ui_patient_pane.h"

namespace carina
{

PatientPane::PatientPane(QWidget* parent)
    : QWidget{parent}, m_ui{std::make_unique<Ui::PatientPane>()}
{
    m_ui->setupUi(this);
    m_ui->scene->setBackground(palette().color(QPalette::Base));
    connect(m_ui->exaggeration, &QDoubleSpinBox::valueChanged, this,
            [this](double factor) { m_view->exaggerate(factor); });
    connect(m_ui->exaggeration, &CheckedDoubleSpinBox::refused, this, &PatientPane::refused);
}

PatientPane::~PatientPane() = default;

void PatientPane::setModels(StationsModel& stations, AttentionModel& attention)
{
    m_ui->stations->setModel(stations);
    m_ui->attentionBar->setModel(attention);
}

void PatientPane::show(const PatientModel& patient, StationView& view)
{
    m_view = &view;
    view.exaggerate(m_ui->exaggeration->value());
    if (m_stationScene)
        m_stationScene->show(patient, view);
    else
        m_stationScene = std::make_unique<StationScene>(*m_ui->scene, patient, view);
}

SceneView& PatientPane::scene() { return *m_ui->scene; }

} // namespace carina
