#pragma once

#include "models/tracker/camera_calibration.h"

#include <QDialog>

#include <array>

class QLabel;
class QPushButton;

namespace carina
{

class CheckedDoubleSpinBox;

/// Calibrates a camera with the printed board: shows in which ninths of the picture the board has
/// been, how well its corners fit, and what to do next. The calibration is written when a person
/// says so, which they can as soon as the pictures determine the camera.
class CalibrationDialog : public QDialog
{
    Q_OBJECT

public:
    explicit CalibrationDialog(CameraToCalibrate camera, QWidget* parent = nullptr);

    /// Writes the calibration, if that is possible; else says why not.
    void accept() override;

private:
    void layOut();
    void beginAnew();
    void refresh();

    CameraToCalibrate m_camera;
    CameraCalibration m_calibration;
    QString m_trouble; ///< of saving
    CheckedDoubleSpinBox* m_square;
    std::array<QLabel*, 9> m_ninths{};
    QLabel* m_text;
    QPushButton* m_begin;
    QPushButton* m_save;
};

} // namespace carina
