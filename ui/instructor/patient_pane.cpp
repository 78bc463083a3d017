#include "ui/instructor/patient_pane.h"

#include "models/station/people_words.h"
#include "ui/lesson/lesson_bar.h"
#include "ui/panels/people_menus.h"
#include "ui_patient_pane.h"

namespace carina
{

PatientPane::PatientPane(QWidget* parent)
    : QWidget{parent}, m_ui{std::make_unique<Ui::PatientPane>()}
{
    m_ui->setupUi(this);
    m_ui->scene->setBackground(palette().color(QPalette::Base));
}

PatientPane::~PatientPane() = default;

void PatientPane::setModels(SessionModel& session, const RespirationModel& respiration,
                            StationsModel& stations, PeopleModel& people, LessonModel& lesson)
{
    m_session = &session;
    m_respiration = &respiration;
    m_stations = &stations;
    m_people = &people;
    m_lesson = &lesson;
    m_ui->stations->setModel(stations);
    auto* bar = new LessonBar;
    bar->setModel(lesson);
    m_ui->views->addWidget(bar);
    bar->putBetween(*m_ui->exaggeration, *m_ui->scene);
    connect(&lesson, &LessonModel::changed, this, [this] {
        if (m_stationScene)
            refreshPeople();
    });
}

void PatientPane::show(const PatientModel& patient, StationView& view)
{
    m_view = &view;
    if (m_stationScene) {
        view.exaggerate(m_ui->exaggeration->value());
        m_stationScene->show(patient, view);
        m_part.clear();
        return;
    }
    m_stationScene = std::make_unique<StationScene>(*m_ui->scene, patient, view);
    connectViews();
    addEyes();
}

SceneView& PatientPane::scene() { return *m_ui->scene; }

void PatientPane::connectViews()
{
    const auto shows = [this](ViewPreset preset) {
        return [this, preset] { m_ui->scene->showFrom(preset); };
    };
    connect(m_ui->front, &QToolButton::clicked, this, shows(ViewPreset::Front));
    connect(m_ui->side, &QToolButton::clicked, this, shows(ViewPreset::Right));
    connect(m_ui->head, &QToolButton::clicked, this, shows(ViewPreset::Trainee));
    connect(m_ui->exaggeration, &QDoubleSpinBox::valueChanged, this,
            [this](double factor) { m_view->exaggerate(factor); });
}

void PatientPane::addEyes()
{
    auto* menu = new EyesMenu{*m_people, tr("Through the eyes of"), this};
    m_ui->eyes->setMenu(menu);
    connect(menu, &EyesMenu::chosen, this, [this](std::optional<ParticipantId> participant) {
        m_stationScene->seeThrough(participant);
        refreshPeople();
    });
    // A view of the own camera is also chosen by where it stands.
    for (QToolButton* preset : {m_ui->front, m_ui->side, m_ui->head})
        connect(preset, &QToolButton::clicked, menu, [this, menu] {
            menu->setChosen(std::nullopt);
            m_stationScene->seeThrough(std::nullopt);
            refreshPeople();
        });
}

void PatientPane::refresh()
{
    m_ui->patientState->setText(patientText());
    refreshPeople();
}

void PatientPane::refreshPeople()
{
    QStringList told{m_people->workText()};
    if (const auto& eyes = m_stationScene->throughEyesOf())
        told += throughEyesText(*m_session->node().state(), m_stationScene->moment(), *eyes);
    if (const QString shown = m_lesson->text(); !shown.isEmpty())
        told.prepend(shown);
    if (!m_part.isEmpty())
        told += tr("Part: %1").arg(m_part);
    m_ui->peopleState->setText(told.join(QStringLiteral("      ")));
}

void PatientPane::tellPart(const QString& name)
{
    m_part = name;
    refreshPeople();
}

QString PatientPane::patientText() const
{
    QString text = tr("● Condition: %1").arg(m_respiration->inForceText());
    if (m_stations->isForAll())
        text = tr("▲ Changes of breathing and condition are for all %1 stations.   %2")
                   .arg(QString::number(m_stations->open().size()), text);
    return text;
}

} // namespace carina
