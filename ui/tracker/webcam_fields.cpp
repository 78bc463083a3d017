#include "ui/tracker/webcam_fields.h"

#include "widgets/plain_label.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

namespace carina
{
namespace
{

QLabel* webcamNote(const QString& text)
{
    auto* label = new PlainLabel{text};
    label->setWordWrap(true);
    return label;
}

QHBoxLayout* inARow(const QList<QWidget*>& widgets)
{
    auto* row = new QHBoxLayout;
    for (QWidget* widget : widgets)
        row->addWidget(widget, row->count() == 0 ? 1 : 0);
    return row;
}

} // namespace

WebcamFields::WebcamFields(const std::vector<OfferedAddress>& offered, QWidget* parent)
    : QWidget{parent},
      m_place{new QComboBox},
      m_calibration{new QLineEdit},
      m_calibrate{new QPushButton{tr("Cali&brate it…")}}
{
    for (const OfferedAddress& each : offered)
        m_place->addItem(each.text, each.address);
    layOut(offered.size());
    connect(m_place, &QComboBox::editTextChanged, this, &WebcamFields::changed);
    connect(m_calibration, &QLineEdit::textChanged, this, &WebcamFields::changed);
    connect(m_calibrate, &QPushButton::clicked, this, &WebcamFields::calibrationWanted);
}

void WebcamFields::layOut(std::size_t offered)
{
    m_place->setObjectName(QStringLiteral("webcam"));
    m_place->setAccessibleName(tr("Number or device of the webcam, or a video"));
    m_place->setEditable(true);
    m_place->setInsertPolicy(QComboBox::NoInsert);
    m_place->lineEdit()->setPlaceholderText(QStringLiteral("0"));
    m_calibration->setObjectName(QStringLiteral("webcamCalibration"));
    m_calibration->setAccessibleName(tr("File of the webcam's calibration"));
    m_calibrate->setObjectName(QStringLiteral("calibrateWebcam"));
    auto* video = new QPushButton{tr("A &video…")};
    video->setObjectName(QStringLiteral("webcamVideo"));
    auto* calibration = new QPushButton{tr("Browse…")};
    calibration->setAccessibleName(tr("Browse: calibration of the webcam"));
    for (QPushButton* button : {video, calibration, m_calibrate})
        button->setAutoDefault(false);
    connect(video, &QPushButton::clicked, this, &WebcamFields::chooseVideo);
    connect(calibration, &QPushButton::clicked, this, &WebcamFields::chooseCalibration);
    auto* form = new QFormLayout{this};
    auto* place = new PlainLabel{tr("&Camera")};
    place->setBuddy(m_place);
    form->addRow(place, inARow({m_place, video}));
    form->addRow(QString{},
                 webcamNote(offered == 0 ? tr("No webcam was found on this computer.")
                                         : tr("Webcams found on this computer: %1").arg(offered)));
    form->addRow(tr("Calibration"), inARow({m_calibration, calibration, m_calibrate}));
    form->addRow(webcamNote(
        tr("It sees chest, chin, tube, stylus and laryngoscope that wear the sheets of carina-lab "
           "print-markers. Without a calibration it is taken for a usual webcam, and distances are "
           "off by as much as it is another one.")));
}

void WebcamFields::fill(const TrackerForm& form)
{
    if (!form.webcam.isEmpty())
        m_place->setEditText(form.webcam);
    m_calibration->setText(form.calibration);
}

void WebcamFields::read(TrackerForm& form) const
{
    const int offered = m_place->findText(m_place->currentText());
    form.webcam = offered < 0 ? m_place->currentText() : m_place->itemData(offered).toString();
    form.calibration = m_calibration->text();
}

void WebcamFields::setCalibration(const QString& file) { m_calibration->setText(file); }

void WebcamFields::setCanCalibrate(bool can) { m_calibrate->setEnabled(can); }

void WebcamFields::chooseVideo()
{
    const QString file =
        QFileDialog::getOpenFileName(this, tr("A video of the printed tools"), {},
                                     tr("Videos (*.mp4 *.avi *.mkv *.mov *.webm);;All files (*)"));
    if (!file.isEmpty())
        m_place->setEditText(file);
}

void WebcamFields::chooseCalibration()
{
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Calibration of the webcam"), m_calibration->text(),
                                     tr("Calibrations (*.json *.yml *.yaml)"));
    if (!file.isEmpty())
        m_calibration->setText(file);
}

} // namespace carina
