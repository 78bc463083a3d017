#include "ui/tracker/device_calibration_dialog.h"

#include "widgets/plain_label.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kDeviceDialogWidth = 600;
constexpr int kResultHeight = 80;

QLabel* foldedLabel(const QString& text)
{
    auto* label = new PlainLabel{text};
    label->setWordWrap(true);
    return label;
}

QComboBox* toolBox(const char* name, const QStringList& tools, const QString& label)
{
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String{name});
    box->setAccessibleName(label);
    box->addItems(tools);
    return box;
}

} // namespace

DeviceCalibrationDialog::DeviceCalibrationDialog(const DevicesToCalibrate& devices, MakeDevice make,
                                                 QWidget* parent)
    : QDialog{parent},
      m_calibration{devices, std::move(make), this},
      m_toolOfFirst{toolBox("toolOfFirst", m_calibration.toolsOfFirst(),
                            tr("Tool of the first device on the body"))},
      m_toolOfSecond{toolBox("toolOfSecond", m_calibration.toolsOfSecond(),
                             tr("Tool of the second device on the body"))},
      m_begin{new QPushButton{tr("&Begin")}},
      m_time{new QProgressBar},
      m_text{foldedLabel({})},
      m_store{new QPushButton{tr("&Store the calibration")}}
{
    setWindowTitle(tr("Calibrate a device to the first one"));
    setMinimumWidth(kDeviceDialogWidth);
    layOut(devices);
    connect(&m_calibration, &DeviceCalibration::changed, this, &DeviceCalibrationDialog::refresh);
    connect(m_begin, &QPushButton::clicked, this, &DeviceCalibrationDialog::begin);
    refresh();
}

QLayout* DeviceCalibrationDialog::toolFields(const DevicesToCalibrate& devices)
{
    auto* fields = new QFormLayout;
    const auto add = [&](const QString& letter, const TrackerDescription& device, QComboBox* box) {
        auto* label = new PlainLabel{letter.arg(trackerName({device}))};
        label->setBuddy(box);
        fields->addRow(label);
        fields->addRow(box);
    };
    add(tr("Tool on the body, of the &first device: %1"), devices.first, m_toolOfFirst);
    add(tr("Tool on the body, of the s&econd device: %1"), devices.second, m_toolOfSecond);
    return fields;
}

QLayout* DeviceCalibrationDialog::coverageRows()
{
    auto* grid = new QGridLayout;
    for (int row = 0; row < int(m_coverage.size()); ++row) {
        CoverageRow& each = m_coverage[std::size_t(row)];
        each = {new PlainLabel, new QProgressBar, new PlainLabel};
        each.bar->setObjectName(QStringLiteral("coverage%1").arg(row));
        each.bar->setRange(0, 100);
        each.bar->setTextVisible(false);
        each.amount->setObjectName(QStringLiteral("amount%1").arg(row));
        grid->addWidget(each.name, row, 0);
        grid->addWidget(each.bar, row, 1);
        grid->addWidget(each.amount, row, 2);
    }
    grid->setColumnStretch(1, 1);
    return grid;
}

void DeviceCalibrationDialog::layOut(const DevicesToCalibrate& devices)
{
    m_begin->setObjectName(QStringLiteral("begin"));
    m_time->setObjectName(QStringLiteral("time"));
    m_time->setAccessibleName(tr("For how long both devices saw the body"));
    m_time->setRange(0, int(toSeconds(DeviceCalibration::kWatched)));
    m_time->setFormat(tr("seen by both for %v of %m s"));
    m_text->setObjectName(QStringLiteral("text"));
    m_text->setAccessibleName(tr("What to do, and what was found"));
    m_text->setMinimumHeight(kResultHeight);
    m_text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_store->setObjectName(QStringLiteral("store"));
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Cancel};
    buttons->addButton(m_store, QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout{this};
    column->addWidget(foldedLabel(
        tr("Fix a tool of each device to one body, or take one that both know. Where on the body "
           "they are need not be known. Then turn it to and fro about all axes and move it about, "
           "where both devices see it.")));
    column->addLayout(toolFields(devices));
    column->addWidget(m_begin);
    column->addLayout(coverageRows());
    column->addWidget(m_time);
    column->addWidget(m_text);
    column->addWidget(buttons);
}

void DeviceCalibrationDialog::begin()
{
    m_calibration.begin(m_toolOfFirst->currentIndex(), m_toolOfSecond->currentIndex());
}

void DeviceCalibrationDialog::refresh()
{
    using State = DeviceCalibration::State;
    const State state = m_calibration.state();
    const bool canBegin = m_toolOfFirst->count() > 0 && m_toolOfSecond->count() > 0;
    m_toolOfFirst->setEnabled(state != State::Watching);
    m_toolOfSecond->setEnabled(state != State::Watching);
    m_begin->setEnabled(canBegin);
    m_begin->setText(state == State::Idle ? tr("&Begin") : tr("&Begin again"));
    m_time->setValue(qRound(m_calibration.share() * m_time->maximum()));
    refreshCoverage();
    m_text->setText(canBegin
                        ? m_calibration.text()
                        : tr("▲ A device has no tools: describe the tools that it is to see."));
    m_store->setEnabled(state == State::Accepted);
    m_begin->setDefault(state != State::Accepted);
    m_store->setDefault(state == State::Accepted);
}

void DeviceCalibrationDialog::refreshCoverage()
{
    const auto coverage = m_calibration.coverage();
    for (std::size_t i = 0; i < coverage.size(); ++i) {
        const DeviceCalibration::Coverage& now = coverage[i];
        m_coverage[i].name->setText(now.name);
        m_coverage[i].bar->setAccessibleName(QStringLiteral("%1: %2").arg(now.name, now.amount));
        m_coverage[i].bar->setValue(qRound(100.0 * now.share));
        m_coverage[i].amount->setText(
            (now.isEnough ? tr("✓ %1", "enough of a motion") : tr("○ %1", "too little of a motion"))
                .arg(now.amount));
    }
}

void DeviceCalibrationDialog::accept()
{
    if (m_calibration.state() == DeviceCalibration::State::Accepted)
        QDialog::accept();
}

void DeviceCalibrationDialog::reject()
{
    m_calibration.cancel();
    QDialog::reject();
}

} // namespace carina
