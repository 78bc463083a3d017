#include "ui/start/patient_picture.h"

#include "ui/scene/scene_parts.h"
#include "widgets/plain_label.h"
#include "widgets/scene/view/scene_view.h"

#include <QVBoxLayout>

namespace carina
{

PatientPicture::PatientPicture(QWidget* parent)
    : QWidget{parent}, m_scene{new SceneView{this}}, m_name{new PlainLabel{this}}
{
    m_scene->setAccessibleName(tr("Picture of the patient"));
    m_scene->setBackground(palette().color(QPalette::Base));
    m_scene->nameSides();
    m_name->setObjectName(QStringLiteral("patientName"));
    m_name->setAlignment(Qt::AlignCenter);
    m_name->setWordWrap(true);
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    column->addWidget(m_scene, 1);
    column->addWidget(m_name);
}

void PatientPicture::show(const SharedPatientModel& patient)
{
    if (patient != m_patient) {
        m_patient = patient;
        m_scene->setFrameSource([patient](int, LocalTime) {
            return sceneFrame({}, patient->lungs().field(), patient->throat(RigidTransform{}));
        });
        m_scene->setParts(sceneParts(*patient), patient->reach());
        m_scene->showFrom(ViewPreset::Front);
    }
    say(QString::fromStdString(patient->name()));
}

void PatientPicture::say(const QString& words) { m_name->setText(words); }

} // namespace carina
