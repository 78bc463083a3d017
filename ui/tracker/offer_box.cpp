#include "ui/tracker/offer_box.h"

#include "ui/tracker/offer_dialog.h"
#include "widgets/plain_label.h"

#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

namespace carina
{

OfferBox::OfferBox(OfferSwitch& offer, QWidget* parent)
    : QWidget{parent}, m_offer{offer}, m_button{new QPushButton}, m_text{new PlainLabel}
{
    m_button->setObjectName(QStringLiteral("offer"));
    m_button->setAutoDefault(false);
    m_text->setObjectName(QStringLiteral("offered"));
    m_text->setAccessibleName(tr("What is given to other programs"));
    m_text->setWordWrap(true);
    setFocusProxy(m_button);
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    column->addWidget(m_button);
    column->addWidget(m_text);
    connect(m_button, &QPushButton::clicked, this, &OfferBox::press);
    connect(&m_offer, &OfferSwitch::changed, this, &OfferBox::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &OfferBox::refresh);
    timer->start(kInterval_ms);
    refresh();
}

void OfferBox::press()
{
    if (m_offer.isOn())
        return m_offer.end();
    auto* dialog = new OfferDialog{m_offer, this};
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void OfferBox::refresh()
{
    m_button->setText(m_offer.isOn() ? tr("No &longer for other programs")
                                     : tr("&Let other programs read the poses…"));
    m_text->setText(m_offer.text());
    m_text->setVisible(m_offer.isOn());
}

} // namespace carina
