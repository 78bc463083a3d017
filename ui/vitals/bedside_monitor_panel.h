#pragma once

#include "models/vitals/sound_output.h"
#include "models/vitals/vitals_model.h"

#include <QWidget>

class QAction;
class QLabel;
class QPushButton;
class QToolButton;

namespace carina
{

class BedsideMonitor;
class SoundControls;

/// The bedside monitor of the patient with what belongs to its sounds: a button that silences the
/// alarms, one that mutes everything, volumes, and in words what the stethoscope hears. Sounds are
/// played while the panel is in sight.
class BedsideMonitorPanel : public QWidget
{
    Q_OBJECT

public:
    explicit BedsideMonitorPanel(QWidget* parent = nullptr);

    /// @pre both outlive the panel.
    void setModel(VitalsModel& model, const SoundOutput& output);

    /// Mutes all sounds of the program. Its key acts wherever the keyboard is, once a window has
    /// it.
    [[nodiscard]] QAction* muteAction() const { return m_mute; }

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    /// A panel behind others is visible to Qt, and its dock is disabled.
    void changeEvent(QEvent* event) override;

private:
    void makeMute();
    void addControls();
    void addSounds();
    void tellSight();
    void draw(const VitalsModel::Sample& sample);
    void refresh();
    void showNumbers();
    void showAlarms();
    void showSound();
    [[nodiscard]] QString soundNote() const;
    [[nodiscard]] bool isNothingPlayed() const;

    VitalsModel* m_model = nullptr;
    const SoundOutput* m_output = nullptr;
    BedsideMonitor* m_monitor;
    QPushButton* m_silence;
    QAction* m_mute;
    QToolButton* m_muteButton;
    QToolButton* m_volumes;
    QLabel* m_heard;
    QWidget* m_sounds; ///< shown by a button: why there are none, and the volumes
    QLabel* m_obstacle;
    SoundControls* m_controls;
};

} // namespace carina
