#include "ui/tracker/calibration_dialog.h"

#include "models/errors/error_text.h"
#include "ui/refusal_line.h"
#include "widgets/checked_spin_box.h"
#include "widgets/plain_label.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kCalibrationWidth = 560;
constexpr int kTextHeight = 60;
constexpr double kPrintedSquare_mm = 28.0; ///< of carina-lab print-markers

QLabel* boardLabel(const QString& text)
{
    auto* label = new PlainLabel{text};
    label->setWordWrap(true);
    return label;
}

} // namespace

CalibrationDialog::CalibrationDialog(CameraToCalibrate camera, QWidget* parent)
    : QDialog{parent},
      m_camera{std::move(camera)},
      m_square{new CheckedDoubleSpinBox},
      m_text{boardLabel({})},
      m_begin{new QPushButton{tr("&Begin anew")}},
      m_save{new QPushButton{tr("&Save the calibration")}}
{
    setWindowTitle(tr("Calibrate a camera"));
    setMinimumWidth(kCalibrationWidth);
    layOut();
    connect(&m_calibration, &CameraCalibration::changed, this, &CalibrationDialog::refresh);
    connect(m_begin, &QPushButton::clicked, this, &CalibrationDialog::beginAnew);
    beginAnew();
}

void CalibrationDialog::layOut()
{
    m_square->setObjectName(QStringLiteral("square"));
    m_square->setAccessibleName(tr("Side of a square of the board"));
    m_square->setRange(5.0, 200.0);
    m_square->setDecimals(1);
    m_square->setSuffix(tr(" mm"));
    m_square->setValue(kPrintedSquare_mm);
    m_text->setObjectName(QStringLiteral("text"));
    m_text->setAccessibleName(tr("How far the calibration is"));
    m_text->setMinimumHeight(kTextHeight);
    m_begin->setObjectName(QStringLiteral("begin"));
    m_begin->setAutoDefault(false);
    m_save->setObjectName(QStringLiteral("save"));
    auto* ninths = new QGridLayout;
    for (int i = 0; i < int(m_ninths.size()); ++i) {
        QLabel*& ninth = m_ninths[std::size_t(i)];
        ninth = new PlainLabel;
        ninth->setObjectName(QStringLiteral("ninth%1").arg(i));
        ninth->setAccessibleName(
            tr("Row %1, column %2 of the picture").arg(i / 3 + 1).arg(i % 3 + 1));
        ninth->setAlignment(Qt::AlignCenter);
        ninth->setFrameShape(QFrame::StyledPanel);
        ninths->addWidget(ninth, i / 3, i % 3);
    }
    auto* fields = new QFormLayout;
    fields->addRow(tr("S&quare of the board"), m_square);
    auto* refused = new RefusalLine;
    refused->watch(*m_square);
    fields->addRow(refused);
    fields->addRow(QString{}, m_begin);
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Cancel};
    buttons->addButton(m_save, QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout{this};
    column->addWidget(boardLabel(
        tr("Hold the printed board before the camera so that it fills a third of the picture or "
           "more. Corners of the board that were seen in each part of the picture:")));
    column->addLayout(ninths);
    column->addWidget(m_text);
    column->addLayout(fields);
    column->addWidget(buttons);
}

void CalibrationDialog::beginAnew()
{
    m_trouble.clear();
    m_square->interpretText(); // its key leaves the field as it is
    m_calibration.begin(m_camera, m_square->value());
    refresh();
}

void CalibrationDialog::refresh()
{
    const auto coverage = m_calibration.coverage();
    for (std::size_t i = 0; i < m_ninths.size(); ++i)
        m_ninths[i]->setText(coverage[i] > 0 ? tr("✓ %1").arg(coverage[i]) : tr("○ none yet"));
    m_text->setText(m_trouble.isEmpty() ? m_calibration.text() : m_trouble);
    m_save->setEnabled(m_calibration.isFitted());
}

void CalibrationDialog::accept()
{
    if (!m_calibration.isFitted())
        return;
    m_calibration.end();
    const auto saved = m_calibration.save(m_camera.file);
    if (saved)
        return QDialog::accept();
    m_trouble = errorText(saved.error());
    refresh();
}

} // namespace carina
