#pragma once

#include "engine/core/result.h"
#include "engine/tracking/ndi/ndi_frame.h"
#include "engine/tracking/ndi/ndi_recording.h"

namespace carina
{

/// What a reply to TX, BX or BX2 in a recorded conversation tells.
struct RecordedNdiFrame {
    NdiFrame frame;
    std::optional<double> seconds{}; ///< since 1970, when the reply came; not in all recordings
};

/// A reply or a command that is refused, or a pose in a reply.
struct RefusedNdiReply {
    std::size_t line = 0; ///< of the recording
    Error error;
};

/// A recorded conversation, decoded by the same code as that with a device.
struct NdiConversation {
    std::size_t commands = 0;
    std::size_t replies = 0;
    std::size_t checksumErrors = 0; ///< of commands and replies
    std::vector<RecordedNdiFrame> frames{};
    std::vector<RefusedNdiReply> refused{}; ///< those with wrong checksums among them
};

[[nodiscard]] NdiConversation decode(const std::vector<NdiExchange>& recording);

} // namespace carina
