#include "ui/panels/session/station_dialog.h"

#include "widgets/dialog_buttons.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace carina
{
namespace
{

constexpr int kStationDialogWidth = 420;

} // namespace

StationDialog::StationDialog(const StationsModel& stations, StationId station, QWidget* parent)
    : QDialog{parent},
      m_stations{stations},
      m_station{station},
      m_name{new QLineEdit{stations.nameOf(station)}},
      m_patient{new QComboBox},
      m_fault{new PlainLabel},
      m_accept{new QPushButton{station == kNoStation ? tr("&Add") : tr("&Rename")}}
{
    setWindowTitle(isNew() ? tr("Add a station") : tr("Rename a station"));
    setMinimumWidth(kStationDialogWidth);
    m_name->setObjectName(QStringLiteral("name"));
    m_name->setAccessibleName(tr("Name of the station"));
    m_name->selectAll();
    m_patient->setObjectName(QStringLiteral("patient"));
    m_patient->setAccessibleName(tr("Patient of the station"));
    m_patient->setEditable(true);
    // Words that patientFromWords reads, in English whatever the language.
    m_patient->addItems({QStringLiteral("adult"), QStringLiteral("child"),
                         QStringLiteral("child, girl"), QStringLiteral("1 year, 75 cm, boy"),
                         QStringLiteral("45 years, 182 cm, man")});
    m_patient->setToolTip(
        tr("adult, child, or figures: age in years, or of a small child as “newborn” or “3 "
           "months”, height in cm, man, woman, boy or girl, and slim or obese"));
    m_fault->setObjectName(QStringLiteral("fault"));
    m_fault->setWordWrap(true);
    m_accept->setObjectName(QStringLiteral("accept"));
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Cancel};
    buttons->addButton(m_accept, QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_name, &QLineEdit::textChanged, this, &StationDialog::refresh);
    connect(m_patient, &QComboBox::editTextChanged, this, &StationDialog::refresh);
    auto* rows = new QFormLayout{this};
    rows->addRow(tr("&Name"), m_name);
    rows->addRow(tr("&Patient"), m_patient);
    rows->setRowVisible(m_patient, isNew());
    rows->addRow(m_fault);
    rows->addRow(buttons);
    leadTabToCancel(*buttons, *m_accept);
    m_accept->setDefault(true);
    refresh();
}

QString StationDialog::name() const { return m_name->text().trimmed(); }

QString StationDialog::patient() const { return m_patient->currentText().trimmed(); }

void StationDialog::refresh()
{
    QString fault = m_stations.faultOfName(name(), m_station);
    if (fault.isEmpty() && isNew())
        fault = StationsModel::faultOfPatient(patient());
    m_fault->setText(fault);
    m_accept->setEnabled(fault.isEmpty());
}

} // namespace carina
