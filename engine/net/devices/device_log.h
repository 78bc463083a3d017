#pragma once

#include "engine/core/session_time.h"
#include "engine/io/site/devices/tracker_file.h"

#include <QFile>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace carina
{

/// Writes the bytes of a conversation with a device to a file while it goes on, so that it can be
/// replayed (readDeviceLog): first a line that describes the tracker,
///
///     # carina.conversation/1 {"kind": "ndi", "address": ..., "poses": ..., "tools": [...]}
///
/// then a line each time that the port is opened, one for all bytes that were sent or came
/// together, in the form of the recordings of IGSTK (readNdiRecording), and one where the client
/// looked and there were none: the same client, told the same times, does the same again,
///
///     1127242654.213753900 : (INFO) opened
///     1127242654.213753900 : (INFO) 41. command[12] BX:0001C26D\x0D
///     1127242654.213871700 : (INFO) 41. receive[6] \xC4\xA5\x17\x00"\xE3
///     1127242654.463998200 : (INFO) waited
///
/// with seconds since 1970 by the clock of this computer at the beginning. Each line is with the
/// system when a function returns: a program that is killed loses none.
class DeviceLog
{
public:
    /// A file that is there already is replaced.
    /// @returns FileUnwritable
    [[nodiscard]] static Result<std::unique_ptr<DeviceLog>>
    create(const std::filesystem::path& file, const TrackerDescription& description);

    /// The port was opened.
    void opened(LocalTime now);
    /// What came and what is sent after it; either may be empty, or both.
    void exchanged(std::string_view received, std::string_view sent, LocalTime now);

    /// Whether a line could not be written, as on a full disk. Nothing more is written then.
    [[nodiscard]] bool hasFailed() const { return m_hasFailed; }
    [[nodiscard]] std::string file() const { return m_file.fileName().toStdString(); }

private:
    explicit DeviceLog(const std::filesystem::path& file);

    [[nodiscard]] std::string stamp(LocalTime now) const;
    void write(const std::string& lines);

    QFile m_file;
    Duration m_since1970; ///< of the zero of LocalTime
    std::size_t m_commands = 0;
    bool m_hasFailed = false;
};

} // namespace carina
