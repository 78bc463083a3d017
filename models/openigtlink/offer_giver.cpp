#include "models/openigtlink/offer_giver.h"

#include "engine/core/monotonic_clock.h"

#include <QCoreApplication>

#include <chrono>

namespace carina
{
namespace
{

constexpr int kGiveInterval_ms = 33;

QString giverWords(const char* text) { return QCoreApplication::translate("OfferGiver", text); }

} // namespace

QString offerWarning(const IgtlPlace& place)
{
    const QString where =
        QStringLiteral("%1:%2").arg(QString::fromStdString(place.address)).arg(place.port);
    return (place.isLoopback()
                ? giverWords(QT_TRANSLATE_NOOP(
                    "OfferGiver", "OpenIGTLink at %1: all programs on this computer can read "
                                  "poses, landmarks and lungs, in clear text and without a code."))
                : giverWords(QT_TRANSLATE_NOOP(
                    "OfferGiver", "Warning: OpenIGTLink at %1 is open to other computers. Whoever "
                                  "reaches it can read poses and names, landmarks and lungs, in "
                                  "clear text and without a code.")))
        .arg(where);
}

OfferGiver::OfferGiver(std::unique_ptr<IgtlServer> server, IgtlPlace place,
                       std::function<Shown()> shown)
    : m_server{std::move(server)}, m_place{std::move(place)}, m_shown{std::move(shown)}
{
    m_place.port = m_server->port();
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.callOnTimeout([this] { give(); });
    m_timer.start(kGiveInterval_ms);
}

void OfferGiver::give()
{
    if (m_server->clients() == 0)
        return;
    const auto [view, patient] = m_shown();
    const Duration since1970 = std::chrono::system_clock::now().time_since_epoch();
    const StationMoment moment = view.litAt(monotonicNow(), StationOffer::levelOf(patient));
    m_server->give(m_offer.at(patient, moment, since1970));
}

} // namespace carina
