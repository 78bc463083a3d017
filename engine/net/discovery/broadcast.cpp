#include "engine/net/discovery/broadcast.h"

#include "engine/net/discovery/loopback.h"

#include <QNetworkInterface>

namespace carina
{

std::vector<QHostAddress> broadcastAddresses()
{
    std::vector<QHostAddress> addresses{loopbackBroadcast()};
    for (const QNetworkInterface& network : QNetworkInterface::allInterfaces()) {
        if (!network.flags().testFlag(QNetworkInterface::IsRunning))
            continue;
        for (const QNetworkAddressEntry& entry : network.addressEntries())
            if (!entry.broadcast().isNull())
                addresses.push_back(entry.broadcast());
    }
    return addresses;
}

} // namespace carina
