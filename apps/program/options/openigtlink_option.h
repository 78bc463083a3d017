#pragma once

#include "models/openigtlink/offer_switch.h"

#include <QCommandLineParser>
#include <QWidget>

namespace carina::program
{

/// `--openigtlink [ADDRESS:]PORT`: gives what the program shows to programs of other makers.
void addOpenIgtLinkOption(QCommandLineParser& parser);

/// Switches on what `--openigtlink` asks for; that it sends in clear text is written to stderr.
/// Whether or not it is asked for, the window's title says from now on while other computers can
/// read what the switch gives.
/// @returns WrongOption for a place that is none; the errors of OfferSwitch::begin.
/// @pre the switch outlives the window.
[[nodiscard]] Result<void> openIgtLinkOption(const QCommandLineParser& parser, QWidget& window,
                                             OfferSwitch& offer);

} // namespace carina::program
