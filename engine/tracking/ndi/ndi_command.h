#pragma once

#include "engine/core/result.h"

#include <string>
#include <string_view>

namespace carina
{

/// A command to a tracker of NDI: "TX" with the arguments "0001".
struct NdiCommand {
    std::string name;
    std::string arguments{};

    friend bool operator==(const NdiCommand&, const NdiCommand&) = default;
};

/// The bytes of a command: name, colon, arguments, checksum and CR.
[[nodiscard]] std::string encoded(const NdiCommand& command);

/// Reads a command, with or without its CR: one with a colon has a checksum, one with a blank in
/// its place has none.
/// @returns DeviceReplyDamaged where it is neither, or the checksum is wrong.
[[nodiscard]] Result<NdiCommand> readNdiCommand(std::string_view bytes);

} // namespace carina
