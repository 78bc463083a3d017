#pragma once

#include "models/tracker/background_work.h"
#include "models/tracker/tracker_form.h"
#include "models/tracker/tracker_trial.h"

#include <QDialog>

#include <array>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace carina
{

class ServerFields;
class SimulatedFields;
class TrackerTools;
class WebcamFields;

/// Asks a person which tracker to use: the simulated one with what it has to cope with, a Polaris
/// at a serial port or on the network, a server of OpenIGTLink, a webcam before the printed tools,
/// a recording of poses or of the bytes of a device, or what a file describes. A Polaris can be
/// tried before; what answered is told, or that nothing does. Use is enabled once nothing is
/// missing, also for a Polaris that does not answer yet: it is tried again by itself. The window
/// takes the height that the chosen source needs; where the screen is too low its fields scroll,
/// and its buttons stay in sight.
class TrackerDialog : public QDialog
{
    Q_OBJECT

public:
    /// @param begin shown first
    /// @param offered serial ports
    /// @param webcams of this computer
    TrackerDialog(const TrackerForm& begin, const std::vector<OfferedAddress>& offered,
                  const std::vector<OfferedAddress>& webcams = {}, QWidget* parent = nullptr);

    /// Offers to record the bytes of a device, too.
    void offerToRecord();

    [[nodiscard]] TrackerForm form() const;
    /// What was chosen. @pre the dialog was accepted.
    [[nodiscard]] const TrackerChoice& choice() const { return *m_choice; }

    /// Takes the choice, if its files can be read; else it says why not. Meanwhile it tells how far
    /// it is, and reading ends where a field is changed or the window closed.
    void accept() override;
    void done(int result) override;

Q_SIGNALS:
    /// A device is tried or calibrated from now on, or no more: who uses one lets go of it
    /// meanwhile, because it may be the same.
    void devicesWanted(bool areWanted);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void want(bool wants);
    void addSource(TrackerSource source, const QString& text, QWidget* details);
    [[nodiscard]] QWidget* polarisFields(const std::vector<OfferedAddress>& offered);
    [[nodiscard]] QWidget* fileFields(QLineEdit& file, const QString& title, const QString& kinds,
                                      QCheckBox* choice = nullptr);
    void addRecordRow();
    void chooseConversation();
    void offerPoses();
    void layOut();
    void fit();
    void connectFields();
    void fill(const TrackerForm& form);
    [[nodiscard]] QWidget* descriptionFields();
    void tryIt();
    void calibrate();
    void edited();
    void refresh();
    void takeRead();

    TrackerTrial m_trial;
    std::optional<TrackerChoice> m_choice;
    QScrollArea* m_area; ///< of the sources
    QVBoxLayout* m_rows; ///< in it
    QButtonGroup* m_sources;
    std::array<QWidget*, 6> m_details{}; ///< of each source
    SimulatedFields* m_simulated;
    QComboBox* m_address;
    QComboBox* m_poses;
    QComboBox* m_rate;
    TrackerTools* m_tools;
    ServerFields* m_server;
    WebcamFields* m_webcam;
    QPushButton* m_try;
    QLabel* m_found;
    QLineEdit* m_recording;
    QCheckBox* m_isLooped;
    QLineEdit* m_description;
    QPushButton* m_calibrate;
    QLineEdit* m_conversation;
    QWidget* m_recordRow;
    bool m_offersToRecord = false;
    QLabel* m_missing;
    QPushButton* m_use;
    bool m_wants = false;                        ///< a device
    TrackerForm m_asked;                         ///< whose files are read
    std::optional<Result<TrackerChoice>> m_read; ///< set by the thread that reads
    BackgroundWork m_reading;                    ///< last: ends before what it uses
};

} // namespace carina
