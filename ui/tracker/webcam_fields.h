#pragma once

#include "models/tracker/tracker_form.h"

#include <QWidget>

class QComboBox;
class QLineEdit;
class QPushButton;

namespace carina
{

/// The fields for a webcam, or a video, that sees the printed tools, without a file that describes
/// it: which one, and its calibration where there is one.
class WebcamFields : public QWidget
{
    Q_OBJECT

public:
    /// @param offered the webcams of this computer
    explicit WebcamFields(const std::vector<OfferedAddress>& offered, QWidget* parent = nullptr);

    void fill(const TrackerForm& form);
    /// Puts what is in the fields into a form.
    void read(TrackerForm& form) const;
    void setCalibration(const QString& file);
    void setCanCalibrate(bool can);

Q_SIGNALS:
    void changed();
    /// A person wants the camera calibrated.
    void calibrationWanted();

private:
    void layOut(std::size_t offered);
    void chooseVideo();
    void chooseCalibration();

    QComboBox* m_place;
    QLineEdit* m_calibration;
    QPushButton* m_calibrate;
};

} // namespace carina
