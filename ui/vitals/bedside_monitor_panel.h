#pragma once

#include "models/vitals/sound_output.h"
#include "models/vitals/vitals_model.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QToolButton;

namespace carina
{

class BedsideMonitor;
class SoundControls;

/// The bedside monitor of the patient with what belongs to its sounds: a button that silences the
/// alarms, one that mutes everything, volumes, and in words what the stethoscope hears.
class BedsideMonitorPanel : public QWidget
{
    Q_OBJECT

public:
    explicit BedsideMonitorPanel(QWidget* parent = nullptr);

    /// @pre both outlive the panel.
    void setModel(VitalsModel& model, const SoundOutput& output);

private:
    void addControls();
    void draw(const VitalsModel::Sample& sample);
    void refresh();
    void showNumbers();
    void showAlarms();
    void showSound();
    [[nodiscard]] QString soundNote() const;
    [[nodiscard]] bool isAllMuted() const;
    void muteAll(bool mute);

    VitalsModel* m_model = nullptr;
    const SoundOutput* m_output = nullptr;
    BedsideMonitor* m_monitor;
    QPushButton* m_silence;
    QToolButton* m_mute;
    QToolButton* m_volumes;
    QLabel* m_heard;
    QLabel* m_obstacle;
    SoundControls* m_sounds;
};

} // namespace carina
