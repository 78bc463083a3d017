#include "models/openigtlink/offer_switch.h"

#include <utility>

namespace carina
{

OfferSwitch::OfferSwitch(Shown shown, QObject* parent) : QObject{parent}, m_shown{std::move(shown)}
{
}

Result<void> OfferSwitch::begin(const IgtlPlace& place)
{
    auto server = IgtlServer::listen(place);
    if (!server)
        return tl::unexpected(server.error());
    m_giver = std::make_unique<OfferGiver>(*std::move(server), place, m_shown);
    Q_EMIT changed();
    return {};
}

void OfferSwitch::end()
{
    if (std::exchange(m_giver, nullptr))
        Q_EMIT changed();
}

QString OfferSwitch::text() const
{
    if (!isOn())
        return {};
    const QString readers = tr("Programs that read along now: %1.").arg(clients());
    return (isOpen() ? QStringLiteral("▲ ") : QStringLiteral("● ")) + offerWarning(place())
           + QLatin1Char{' '} + readers;
}

} // namespace carina
