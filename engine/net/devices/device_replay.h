#pragma once

#include "engine/core/result.h"
#include "engine/tracking/sequence_file.h"

#include <filesystem>
#include <iosfwd>

namespace carina
{

/// The poses in a recorded conversation with a device, by the same client that held it: what came
/// is given to the client again, at the times at which it came, and what the client sends goes
/// nowhere. A conversation without Carina's line about the tracker, as recorded by others with a
/// tracker of NDI, has tools named by the handles of their ports; where it has no times either,
/// the device is held to have exposed 60 times a second.
///
/// @param name of the input in errors
/// @returns FileUnreadable; FileEmpty; FileMalformed with the line, also where it has no pose.
[[nodiscard]] Result<TrackerSequence> replayedConversation(std::istream& input,
                                                           const std::string& name);

/// Whether a file is a conversation with a device: one of Carina's, or one that readNdiRecording
/// reads. Only its beginning is looked at.
[[nodiscard]] bool isConversation(const std::filesystem::path& file);

} // namespace carina
