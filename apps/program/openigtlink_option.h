#pragma once

#include "models/openigtlink/offer_giver.h"

#include <QCommandLineParser>
#include <QWidget>

namespace carina::program
{

/// `--openigtlink [ADDRESS:]PORT`: gives what the program shows to programs of other makers.
void addOpenIgtLinkOption(QCommandLineParser& parser);

/// The server that `--openigtlink` asks for, running; null without it. That it sends in clear text
/// is written to stderr, and where other computers can reach it, also to the window's title.
/// @returns WrongOption for a place that is none; the errors of IgtlServer::listen.
/// @pre what `shown` uses outlives the result.
[[nodiscard]] Result<std::unique_ptr<OfferGiver>>
openIgtLinkOption(const QCommandLineParser& parser, QWidget& window,
                  std::function<OfferGiver::Shown()> shown);

} // namespace carina::program
