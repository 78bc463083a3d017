#pragma once

#include "models/tracker/tracker_choice.h"

#include <QString>

#include <optional>
#include <vector>

namespace carina
{

/// Where poses are to come from.
enum class TrackerSource : std::uint8_t { Simulated, Polaris, Recording, Description };

/// A tool of a Polaris, as a person names it.
struct FormTool {
    ToolRole role = ToolRole::Stylus;
    QString definition{}; ///< the .rom file of a wireless tool; empty for one that is plugged in

    friend bool operator==(const FormTool&, const FormTool&) = default;
};

/// The fields that a person fills in to connect a tracker. Those of other sources are kept.
struct TrackerForm {
    TrackerSource source = TrackerSource::Simulated;
    QString address{}; ///< of a Polaris: a serial port, or host and port
    std::vector<FormTool> tools{{}};
    QString recording{};   ///< a file
    bool isLooped = false; ///< whether it is played again and again
    QString description{}; ///< a file

    friend bool operator==(const TrackerForm&, const TrackerForm&) = default;
};

/// An address at which a tracker may be.
struct OfferedAddress {
    QString address{};
    QString text{}; ///< as shown: "/dev/ttyUSB0 (FT232R USB UART)"
};

/// The serial ports of this computer.
[[nodiscard]] std::vector<OfferedAddress> offeredAddresses();

/// What a person has to correct, as a sentence; std::nullopt if nothing is missing.
[[nodiscard]] std::optional<QString> whatIsMissing(const TrackerForm& form);

/// The tracker that a form names.
/// @pre nothing is missing.
/// @returns the errors of reading its files.
[[nodiscard]] Result<TrackerChoice> choiceOf(const TrackerForm& form);

} // namespace carina
