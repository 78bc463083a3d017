#include "engine/net/discovery/addresses.h"

#include <QHostAddress>
#include <QNetworkInterface>

namespace carina
{

bool isAddress(const std::string& text)
{
    return !QHostAddress{QString::fromStdString(text)}.isNull();
}

std::vector<std::string> ownAddresses()
{
    std::vector<std::string> addresses;
    for (const QHostAddress& address : QNetworkInterface::allAddresses())
        if (address.protocol() == QAbstractSocket::IPv4Protocol && !address.isLoopback()
            && !address.isLinkLocal())
            addresses.push_back(address.toString().toStdString());
    return addresses;
}

} // namespace carina
