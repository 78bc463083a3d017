#pragma once

#include "engine/net/devices/igtl_server.h"
#include "models/openigtlink/station_offer.h"

#include <QString>
#include <QTimer>

namespace carina
{

/// That what is given at a place travels in clear text, and to whom, as a sentence.
[[nodiscard]] QString offerWarning(const IgtlPlace& place);

/// Gives what a program shows to the clients of its server of OpenIGTLink, thirty times a second,
/// while there are any.
class OfferGiver
{
public:
    /// A view, and the patient that it is of.
    struct Shown {
        const StationView& view;
        const PatientModel& patient;
    };

    OfferGiver(std::unique_ptr<IgtlServer> server, IgtlPlace place, std::function<Shown()> shown);

    /// With the port that was found where any was asked for.
    [[nodiscard]] const IgtlPlace& place() const { return m_place; }
    [[nodiscard]] int clients() const { return m_server->clients(); }

private:
    void give();

    std::unique_ptr<IgtlServer> m_server;
    IgtlPlace m_place;
    std::function<Shown()> m_shown;
    StationOffer m_offer;
    QTimer m_timer;
};

} // namespace carina
