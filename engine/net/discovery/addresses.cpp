#include "engine/net/discovery/addresses.h"

#include <QHostAddress>
#include <QNetworkInterface>

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::size_t kLongestHostName = 253;

} // namespace

bool isAddress(const std::string& text)
{
    // Qt overlooks blanks, so that one address would have many spellings.
    const auto isVisible = [](char c) { return c > ' ' && c <= '~'; };
    return std::all_of(text.begin(), text.end(), isVisible)
           && !QHostAddress{QString::fromStdString(text)}.isNull();
}

bool isHostName(const std::string& text)
{
    const auto belongs = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')
               || c == '-' || c == '.';
    };
    const bool isName = !text.empty() && text.size() <= kLongestHostName
                        && std::all_of(text.begin(), text.end(), belongs);
    return isName || isAddress(text);
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
