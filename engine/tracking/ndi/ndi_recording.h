#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// One exchange with a tracker of NDI as it was recorded: bytes as they were on the wire. What the
/// device sent by itself, as after a reset, has no command.
struct NdiExchange {
    std::string command{};
    std::string reply{};             ///< empty where none was recorded
    std::optional<double> seconds{}; ///< since 1970, when the reply came; not all forms have it
    std::size_t line = 0;            ///< of the file, where it begins
};

/// Reads a recorded conversation in the two forms of the recordings of IGSTK:
///
///     sent:NNNN = TX:0001031A
///     recv:NNNN = ...                 a reply may go on over several lines; the CR is left out
///
///     1127242654.2137539 : (INFO) 41. command[12] BX:0001C26D\x0D
///     1127242654.2138717 : (INFO) 41. receive[6] \xC4\xA5\x17\x00"\xE3
///
/// where the second form has bytes that do not print as \xHH, and its time may be left out and the
/// bytes be as they were (a .bin file, whose line ends may have become LF). Several receives with
/// one number are one reply.
///
/// @param name of the input in errors
/// @returns FileUnreadable; FileEmpty where there is no exchange; FileMalformed with the line.
[[nodiscard]] Result<std::vector<NdiExchange>> readNdiRecording(std::istream& input,
                                                                const std::string& name);

/// The same from a file. @returns also FileNotFound.
[[nodiscard]] Result<std::vector<NdiExchange>>
readNdiRecordingFile(const std::filesystem::path& path);

} // namespace carina
