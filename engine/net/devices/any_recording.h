#pragma once

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/tracking/sequence_file.h"

#include <filesystem>

namespace carina
{

/// Reads the recording of a tracker in whichever form it is:
///
/// - a sequence of Plus or 3D Slicer (.igs.mha, readSequence)
/// - Carina's own record (pose_record)
/// - the bytes of a conversation with a device (replayedConversation)
/// - a trajectory in TUM form (.tum or .txt, readTum), of one tool with the name of the file
///
/// @returns the errors of reading it; UnknownFormat for another file; Cancelled.
[[nodiscard]] Result<TrackerSequence> readAnyRecording(const std::filesystem::path& file,
                                                       const Progress& goesOn = {});

/// Writes a recording in the form that the extension names: .csv, .mha, or .tum; of several tools
/// in TUM form the further ones go to NAME-2.tum and so on, by the names that no file has yet.
/// @returns FileUnwritable; UnknownFormat for another extension; the errors of sequenceText;
///          Cancelled, after which files of some of the tools may be there in TUM form.
[[nodiscard]] Result<void> writeAnyRecording(const std::filesystem::path& file,
                                             const TrackerSequence& sequence,
                                             const Progress& goesOn = {});

/// Whether writeAnyRecording knows the extension.
[[nodiscard]] bool canWriteRecording(const std::filesystem::path& file);

} // namespace carina
