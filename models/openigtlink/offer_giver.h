#pragma once

#include "engine/net/devices/igtl_server.h"
#include "models/openigtlink/station_offer.h"

#include <QString>
#include <QTimer>

namespace carina
{

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

    /// That what is given travels in clear text, and to whom; for a person who starts the program.
    [[nodiscard]] QString warning() const;

private:
    void give();

    std::unique_ptr<IgtlServer> m_server;
    IgtlPlace m_place;
    std::function<Shown()> m_shown;
    StationOffer m_offer;
    QTimer m_timer;
};

} // namespace carina
