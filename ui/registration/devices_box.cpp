#include "ui/registration/devices_box.h"

#include "models/text/shown_as_is.h"
#include "ui/tracker/device_calibration_dialog.h"
#include "ui/tracker/tracker_dialog.h"
#include "widgets/plain_label.h"

#include <QGridLayout>
#include <QListWidget>
#include <QPushButton>

namespace carina
{

DevicesBox::DevicesBox(DeviceTask& task, QWidget* parent)
    : QWidget{parent},
      m_task{task},
      m_none{new PlainLabel{
          tr("This site names no devices yet. Those that are added here track together, in the "
             "frame of the first, in all programs that are given the site."),
          this}},
      m_list{new QListWidget{this}},
      m_add{new QPushButton{tr("&Add a device…"), this}},
      m_calibrate{new QPushButton{tr("Ca&librate it…"), this}},
      m_replace{new QPushButton{tr("Re&place it…"), this}},
      m_remove{new QPushButton{tr("&Remove it"), this}},
      m_track{new QPushButton{tr("&Track with these devices"), this}}
{
    m_list->setObjectName(QStringLiteral("devices"));
    m_list->setAccessibleName(tr("Devices of this site"));
    m_list->setWordWrap(true);
    m_list->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    m_none->setObjectName(QStringLiteral("noDevices"));
    m_none->setWordWrap(true);
    m_add->setObjectName(QStringLiteral("addDevice"));
    m_add->setToolTip(tr("Another device that tracks here, together with the first one"));
    m_calibrate->setObjectName(QStringLiteral("calibrateDevice"));
    m_calibrate->setToolTip(
        tr("Measures its position and orientation relative to the first device, with a body "
           "that both see"));
    m_replace->setObjectName(QStringLiteral("replaceDevice"));
    m_remove->setObjectName(QStringLiteral("removeDevice"));
    m_track->setObjectName(QStringLiteral("trackWithDevices"));
    connectControls();
    layOut();
    refresh();
}

void DevicesBox::connectControls()
{
    connect(m_list, &QListWidget::currentRowChanged, this, &DevicesBox::refreshButtons);
    connect(m_add, &QPushButton::clicked, this, [this] { ask(std::nullopt); });
    connect(m_calibrate, &QPushButton::clicked, this, &DevicesBox::calibrateChosen);
    connect(m_replace, &QPushButton::clicked, this, [this] { ask(chosen()); });
    connect(m_remove, &QPushButton::clicked, this, [this] {
        if (const auto device = chosen())
            m_task.remove(*device);
    });
    connect(m_track, &QPushButton::clicked, this, &DevicesBox::trackWanted);
}

void DevicesBox::layOut()
{
    auto* grid = new QGridLayout{this};
    grid->addWidget(m_none, 0, 0, 1, 2, Qt::AlignTop);
    grid->addWidget(m_list, 1, 0, 1, 2);
    grid->addWidget(m_add, 2, 0);
    grid->addWidget(m_calibrate, 2, 1);
    grid->addWidget(m_replace, 3, 0);
    grid->addWidget(m_remove, 3, 1);
    grid->addWidget(m_track, 4, 0, 1, 2);
}

std::optional<std::size_t> DevicesBox::chosen() const
{
    const int row = m_list->currentRow();
    return row >= 0 && std::size_t(row) < m_task.count() ? std::optional{std::size_t(row)}
                                                         : std::nullopt;
}

void DevicesBox::refresh()
{
    const auto rows = m_task.rows();
    while (m_list->count() > int(rows.size()))
        delete m_list->takeItem(m_list->count() - 1);
    for (int i = 0; i < int(rows.size()); ++i) {
        const DeviceTask::Row& row = rows[std::size_t(i)];
        if (i == m_list->count())
            m_list->addItem(QString{});
        m_list->item(i)->setText(
            QStringList{row.name, row.state, row.calibrated}.join(QLatin1Char('\n')));
        m_list->item(i)->setData(
            Qt::AccessibleTextRole,
            QStringList{row.name, row.state, row.calibrated}.join(QStringLiteral(". ")));
    }
    m_list->setVisible(!rows.empty());
    m_none->setVisible(rows.empty());
    refreshButtons();
}

void DevicesBox::refreshButtons()
{
    const auto device = chosen();
    const QString why = device ? m_task.whyKept(*device) : QString{};
    m_calibrate->setEnabled(device && *device > 0);
    for (QPushButton* button : {m_replace, m_remove}) {
        button->setEnabled(device && why.isEmpty());
        button->setToolTip(shownAsIs(why));
        button->setAccessibleDescription(why);
    }
    m_track->setVisible(m_task.count() > 0 && !m_task.isTracked());
}

void DevicesBox::ask(std::optional<std::size_t> replaced)
{
    auto* dialog =
        new TrackerDialog{m_task.offeredForm(), offeredAddresses(), offeredWebcams(), this};
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, replaced] {
        if (const auto file = m_task.kept(dialog->form(), dialog->choice()))
            use({*file, replaced});
    });
    dialog->open();
}

void DevicesBox::use(const DeviceTask::Wanted& wanted)
{
    if (m_task.isFirst(wanted))
        m_task.setFirst(wanted);
    else
        calibrate(wanted);
}

void DevicesBox::calibrateChosen()
{
    if (const auto device = chosen())
        calibrate({m_task.fileOf(*device)});
}

void DevicesBox::calibrate(const DeviceTask::Wanted& wanted)
{
    const auto devices = m_task.toCalibrate(wanted);
    if (!devices || !m_task.lend())
        return;
    auto* dialog = new DeviceCalibrationDialog{*devices, m_task.make(), this};
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::finished, this, [this, dialog, wanted](int result) {
        m_task.takeBack();
        if (result == QDialog::Accepted)
            m_task.store(wanted, dialog->found());
    });
    dialog->open();
}

} // namespace carina
