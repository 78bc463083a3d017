#include "apps/program/openigtlink_option.h"

#include <QCoreApplication>

#include <cstdio>

namespace carina::program
{
namespace
{

const QString kOpenIgtLink = QStringLiteral("openigtlink");

QString openIgtLinkWords(const char* text)
{
    return QCoreApplication::translate("OpenIgtLinkOption", text);
}

} // namespace

void addOpenIgtLinkOption(QCommandLineParser& parser)
{
    parser.addOption(
        {kOpenIgtLink,
         openIgtLinkWords("Give poses, landmarks and the breathing lungs to programs such as 3D "
                          "Slicer, by OpenIGTLink, which is clear text and asks for no code. "
                          "With a port alone only to programs on this computer."),
         QStringLiteral("[ADDRESS:]PORT")});
}

Result<std::unique_ptr<OfferGiver>> openIgtLinkOption(const QCommandLineParser& parser,
                                                      QWidget& window,
                                                      std::function<OfferGiver::Shown()> shown)
{
    if (!parser.isSet(kOpenIgtLink))
        return nullptr;
    const auto place = IgtlPlace::read(parser.value(kOpenIgtLink).toStdString());
    if (!place)
        return fail(Errc::WrongOption, "--openigtlink takes a port, or address:port, not '"
                                           + place.error().detail + "'");
    auto server = IgtlServer::listen(*place);
    if (!server)
        return tl::unexpected(server.error());
    auto giver = std::make_unique<OfferGiver>(*std::move(server), *place, std::move(shown));
    std::fprintf(stderr, "%s\n", qPrintable(giver->warning()));
    if (!place->isLoopback())
        window.setWindowTitle(
            openIgtLinkWords("%1 - OpenIGTLink is open to other computers, in clear text")
                .arg(window.windowTitle().isEmpty() ? QCoreApplication::applicationName()
                                                    : window.windowTitle()));
    return giver;
}

} // namespace carina::program
