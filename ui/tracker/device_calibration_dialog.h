#pragma once

#include "models/tracker/device_calibration.h"

#include <QDialog>

#include <array>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace carina
{

/// Calibrates a device to the first one of a site: asks which tools are on the body, shows how far
/// it was turned and moved and what is missing, and then what was found. It ends accepted where a
/// person stores a frame that can be used.
class DeviceCalibrationDialog : public QDialog
{
    Q_OBJECT

public:
    DeviceCalibrationDialog(const DevicesToCalibrate& devices, MakeDevice make,
                            QWidget* parent = nullptr);

    /// @pre the dialog was accepted.
    [[nodiscard]] const FrameCalibration& found() const { return m_calibration.found(); }

    void accept() override;
    /// Gives the devices free.
    void reject() override;

private:
    /// How far the body was turned about an axis, or moved.
    struct CoverageRow {
        QLabel* name = nullptr;
        QProgressBar* bar = nullptr;
        QLabel* amount = nullptr;
    };

    void layOut(const DevicesToCalibrate& devices);
    [[nodiscard]] QLayout* toolFields(const DevicesToCalibrate& devices);
    [[nodiscard]] QLayout* coverageRows();
    void begin();
    void refresh();
    void refreshCoverage();

    DeviceCalibration m_calibration;
    QComboBox* m_toolOfFirst;
    QComboBox* m_toolOfSecond;
    QPushButton* m_begin;
    std::array<CoverageRow, 4> m_coverage{};
    QProgressBar* m_time;
    QLabel* m_text;
    QPushButton* m_store;
};

} // namespace carina
