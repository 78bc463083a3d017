#pragma once

#include "models/patient/patient_source.h"

#include <QLabel>
#include <QWidget>

namespace carina
{

class SceneView;

/// A patient at rest, as a picture that can be turned, with the name beneath.
class PatientPicture : public QWidget
{
    Q_OBJECT

public:
    explicit PatientPicture(QWidget* parent = nullptr);

    void show(const SharedPatientModel& patient);
    using QWidget::show;
    /// Says in place of a name why no other patient is shown, or what is awaited.
    void say(const QString& words);

private:
    SceneView* m_scene;
    QLabel* m_name;
    SharedPatientModel m_patient;
};

} // namespace carina
