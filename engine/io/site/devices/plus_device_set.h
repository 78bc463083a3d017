#pragma once

#include "engine/io/site/devices/tracker_file.h"

namespace carina
{

/// The tracker that a device set of PLUS describes (its configuration file, XML): of its devices
/// the first of a type that Carina speaks to,
///
///     PolarisTracker, NDITracker    with SerialPort (1: /dev/ttyS0) and BaudRate, or with
///                                   NetworkHostname and NetworkPort (8765)
///     OpenIGTLinkTracker            with ServerAddress and ServerPort (18944), and MessageType
///                                   TRANSFORM, TDATA or QTDATA
///
/// and of its DataSources those of Type "Tool": Id, which is the tool's name and tells its role
/// (toolRoleOfName); RomFile, in or beneath the folder of the device set; PortName of those that
/// are plugged in, in whose order they come. A tool of OpenIGTLinkTracker is sent as
/// IdToREFERENCE, where REFERENCE is ToolReferenceFrame ("Tracker" without it).
///
/// @returns the errors of reading the file and its definitions; FileMalformed where it is not such
///          XML, has a document type, or more than 64 tools; UnknownFormat without a device of
///          these types. The detail names the file, and the line of a fault.
[[nodiscard]] Result<TrackerDescription> readPlusDeviceSet(const std::filesystem::path& file);

} // namespace carina
