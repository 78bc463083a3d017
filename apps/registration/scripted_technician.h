#pragma once

#include "models/registration/registration_model.h"

#include <QDir>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QWidget>

#include <set>

namespace carina
{

/// A scripted technician for a measured run: goes through the wizard from its present step with the
/// same buttons as a person, and takes a picture of each page.
class ScriptedTechnician : public QObject
{
    Q_OBJECT

public:
    /// @param folder for the pictures: registration-1-tracker.png and so on
    /// @pre window and registration outlive this.
    ScriptedTechnician(QWidget& window, const RegistrationModel& registration, QDir folder);

Q_SIGNALS:
    /// The anatomy was fitted and verified; the window is still open.
    void done();
    /// The wizard refused something, or a step took too long.
    void stuck(const QString& where);

private:
    void work();
    void workAtStep();
    void swing();
    void touch();
    void fit();
    void verify();
    void tools();
    void overview();
    void photographOnce();
    void press(const char* button);

    QWidget& m_window;
    const RegistrationModel& m_registration;
    QDir m_folder;
    SiteStep m_step;
    std::set<SiteStep> m_photographed;
    QElapsedTimer m_all;
    QElapsedTimer m_inStep;
    QTimer m_timer;
};

} // namespace carina
