#pragma once

#include "models/tracker/tracker_choice.h"

#include <QString>

#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// Where poses are to come from.
enum class TrackerSource : std::uint8_t {
    Simulated,
    Polaris,
    Recording,
    Description,
    OpenIgtLink,
    Webcam, ///< before the tools that are printed; no file describes it
};

/// A tool of a Polaris, as a person names it.
struct FormTool {
    ToolRole role = ToolRole::Stylus;
    QString definition{}; ///< the .rom file of a wireless tool; empty for one that is plugged in

    friend bool operator==(const FormTool&, const FormTool&) = default;
};

/// A tool of a server of OpenIGTLink, as a person names it.
struct ServedTool {
    QString device{}; ///< by which the server sends it
    ToolRole role = ToolRole::Stylus;

    friend bool operator==(const ServedTool&, const ServedTool&) = default;
};

/// The fields that a person fills in to connect a tracker. Those of other sources are kept.
struct TrackerForm {
    TrackerSource source = TrackerSource::Simulated;
    QString address{}; ///< of a Polaris: a serial port, or host and port
    std::vector<FormTool> tools{{}};
    NdiPoseReply poses = NdiPoseReply::Bx; ///< how a Polaris is asked for them
    int fastestRate = 921600;              ///< of its serial port, bits a second
    QString recording{};                   ///< a file, of poses or of the bytes of a device
    bool isLooped = false;                 ///< whether it is played again and again
    QString description{};                 ///< a file
    QString server{};                      ///< of OpenIGTLink: host and port
    IgtlPoses asked = IgtlPoses::Transform;
    std::vector<ServedTool> served{};
    SimulatedOptions simulated{};
    QString webcam{};       ///< its number or device, or a video or folder of pictures
    QString calibration{};  ///< of the webcam, a file; empty: it is taken for a usual one
    QString conversation{}; ///< the file for the bytes of the device; empty: they are not recorded

    friend bool operator==(const TrackerForm&, const TrackerForm&) = default;
};

/// An address at which a tracker may be.
struct OfferedAddress {
    QString address{};
    QString text{}; ///< as shown: "/dev/ttyUSB0 (FT232R USB UART)"
};

/// The serial ports of this computer.
[[nodiscard]] std::vector<OfferedAddress> offeredAddresses();

/// The webcams of this computer.
[[nodiscard]] std::vector<OfferedAddress> offeredWebcams();

/// The device of a webcam that a person names by its number, "0", or as it is, "/dev/video0"; of
/// anything else, such as a video, the text without blanks around it.
[[nodiscard]] QString webcamPlace(const QString& text);

/// Whether the bytes of a tracker of this source can be recorded.
[[nodiscard]] bool canHaveConversation(TrackerSource source);

/// Whether what is filled in may be a camera, which can be calibrated: a webcam, or a description
/// that is no device set of PLUS; nothing is missing.
[[nodiscard]] bool canCalibrateCamera(const TrackerForm& form);

/// The rates of a serial port that are offered as the fastest, in bits a second, best first.
[[nodiscard]] std::span<const int> offeredRates();

/// The roles of a tool, in the order in which they are offered.
[[nodiscard]] std::span<const ToolRole> offeredRoles();

/// The roles of tools that the simulated tracker can hide.
[[nodiscard]] std::span<const ToolRole> simulatedRoles();

/// The role for a tool that a server sends: the one that its name tells, with or without
/// "ToTracker", else Other; Other also where a tool has this role already.
[[nodiscard]] ToolRole freeRoleOf(const QString& device, const std::vector<ServedTool>& taken);

/// Whether a text is the address of a server: host and port.
[[nodiscard]] bool isServerAddress(const QString& text);

/// The server that a form names, with what is there of its tools.
[[nodiscard]] TrackerDescription describedServer(const TrackerForm& form);

/// What a person has to correct, as a sentence; std::nullopt if nothing is missing.
[[nodiscard]] std::optional<QString> whatIsMissing(const TrackerForm& form);

/// The tracker that a form names. A recording takes long.
/// @pre nothing is missing.
/// @returns the errors of reading its files; Cancelled.
[[nodiscard]] Result<TrackerChoice> choiceOf(const TrackerForm& form, const Progress& goesOn = {});

} // namespace carina
