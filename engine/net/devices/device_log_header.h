#pragma once

#include "engine/io/site/devices/tracker_file.h"

#include <QJsonObject>

#include <string_view>

namespace carina
{

/// The words by which a DeviceLog is recognised, for its port's opening, and for a moment at which
/// the client looked and nothing had come or was to be sent.
inline constexpr std::string_view kDeviceLogBegins = "# carina.conversation/1 ";
inline constexpr const char* kDeviceLogOpened = "opened";
inline constexpr const char* kDeviceLogWaited = "waited";

/// What a DeviceLog says of the tracker: its description, with the bytes of its tools' definitions.
[[nodiscard]] QJsonObject deviceLogHeader(const TrackerDescription& description);

/// The same back. @returns FileMalformed and the errors of NdiToolDefinition::read.
[[nodiscard]] Result<TrackerDescription> readDeviceLogHeader(std::string_view json);

} // namespace carina
