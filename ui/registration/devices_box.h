#pragma once

#include "models/registration/device_task.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace carina
{

/// The devices that track at the site: which there are, how each tracks and was calibrated; adds,
/// calibrates, replaces and removes one.
class DevicesBox : public QWidget
{
    Q_OBJECT

public:
    /// @pre task outlives this.
    explicit DevicesBox(DeviceTask& task, QWidget* parent = nullptr);

    void refresh();

Q_SIGNALS:
    /// A person wants to track with these devices, in place of the present tracker.
    void trackWanted();

private:
    void connectControls();
    void layOut();
    void refreshButtons();
    [[nodiscard]] std::optional<std::size_t> chosen() const;
    /// Asks for a device; of the site's, for one in place of it.
    void ask(std::optional<std::size_t> replaced);
    void use(const DeviceTask::Wanted& wanted);
    void calibrate(const DeviceTask::Wanted& wanted);
    void calibrateChosen();

    DeviceTask& m_task;
    QLabel* m_none; ///< children of this
    QListWidget* m_list;
    QPushButton* m_add;
    QPushButton* m_calibrate;
    QPushButton* m_replace;
    QPushButton* m_remove;
    QPushButton* m_track;
};

} // namespace carina
