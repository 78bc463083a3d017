#include "apps/program/options/openigtlink_option.h"

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

void showWhileOpen(QWidget& window, const OfferSwitch& offer)
{
    const QString title = window.windowTitle();
    const QString named = title.isEmpty() ? QCoreApplication::applicationName() : title;
    QObject::connect(&offer, &OfferSwitch::changed, &window, [&window, &offer, title, named] {
        window.setWindowTitle(
            offer.isOpen()
                ? openIgtLinkWords("%1 - OpenIGTLink is open to other computers, in clear text")
                      .arg(named)
                : title);
    });
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

Result<void> openIgtLinkOption(const QCommandLineParser& parser, QWidget& window,
                               OfferSwitch& offer)
{
    showWhileOpen(window, offer);
    if (!parser.isSet(kOpenIgtLink))
        return {};
    const auto place = IgtlPlace::read(parser.value(kOpenIgtLink).toStdString());
    if (!place)
        return fail(Errc::WrongOption, "--openigtlink takes a port, or address:port, not '"
                                           + place.error().detail + "'");
    const auto begun = offer.begin(*place);
    if (begun)
        std::fprintf(stderr, "%s\n", qPrintable(offerWarning(offer.place())));
    return begun;
}

} // namespace carina::program
