#include "ui/tracker/offer_dialog.h"

#include "models/errors/error_text.h"
#include "ui/refusal_line.h"
#include "widgets/checked_spin_box.h"
#include "widgets/dialog_buttons.h"

#include <QCheckBox>
#include <QFormLayout>

namespace carina
{
namespace
{

constexpr int kOfferWidth = 480;
constexpr int kOfferLines = 4; ///< that the warning may take
const std::string kAllAddresses = "0.0.0.0";

} // namespace

OfferDialog::OfferDialog(OfferSwitch& offer, QWidget* parent)
    : QDialog{parent},
      m_offer{offer},
      m_port{new CheckedSpinBox},
      m_isOpen{new QCheckBox{tr("Also to programs on &other computers")}},
      m_warning{new PlainLabel},
      m_problem{new MessageLine}
{
    setWindowTitle(tr("Let other programs read the poses"));
    setMinimumWidth(kOfferWidth);
    layOut();
    connect(m_port, &QSpinBox::valueChanged, this, &OfferDialog::refresh);
    connect(m_isOpen, &QCheckBox::toggled, this, &OfferDialog::refresh);
    refresh();
}

void OfferDialog::layOut()
{
    m_port->setObjectName(QStringLiteral("offerPort"));
    m_port->setAccessibleName(tr("Port at which other programs read"));
    m_port->setRange(1, 0xFFFF);
    m_port->setValue(IgtlPlace{}.port);
    m_isOpen->setObjectName(QStringLiteral("offerOpen"));
    m_warning->setObjectName(QStringLiteral("offerWarning"));
    m_warning->setAccessibleName(tr("Who can read what is given"));
    m_warning->setWordWrap(true);
    m_warning->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_warning->setMinimumHeight(kOfferLines * fontMetrics().lineSpacing());
    m_problem->setObjectName(QStringLiteral("offerProblem"));
    m_problem->setWordWrap(true);
    auto* rows = new QFormLayout{this};
    auto* told = new PlainLabel{
        tr("Programs such as 3D Slicer are given tube, jaw, the tools and names of everybody at "
           "this station, the landmarks of the airway and the breathing lungs, by OpenIGTLink. "
           "They cannot change anything.")};
    told->setWordWrap(true);
    rows->addRow(told);
    rows->addRow(tr("&Port"), m_port);
    auto* refused = new RefusalLine;
    refused->watch(*m_port);
    rows->addRow(refused);
    rows->addRow(m_isOpen);
    rows->addRow(m_warning);
    rows->addRow(m_problem);
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Cancel};
    QPushButton* give = buttons->addButton(tr("&Give them"), QDialogButtonBox::AcceptRole);
    give->setObjectName(QStringLiteral("offerGive"));
    give->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &OfferDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    rows->addRow(buttons);
    leadTabToCancel(*buttons, *give);
}

IgtlPlace OfferDialog::place() const
{
    IgtlPlace place;
    place.port = std::uint16_t(m_port->value());
    if (m_isOpen->isChecked())
        place.address = kAllAddresses;
    return place;
}

void OfferDialog::accept()
{
    m_port->interpretText(); // its key leaves the field as it is
    if (const auto begun = m_offer.begin(place()); !begun)
        return m_problem->warn(errorText(begun.error()));
    QDialog::accept();
}

void OfferDialog::refresh()
{
    m_warning->setText(offerWarning(place()));
    m_problem->warn({});
}

} // namespace carina
