#include "engine/tracking/ndi/ndi_command.h"

#include "engine/tracking/ndi/ndi_reply.h"

#include <algorithm>

namespace carina
{

std::string encoded(const NdiCommand& command)
{
    const std::string text = command.name + ":" + command.arguments;
    return text + ndiChecksumText(text) + "\r";
}

Result<NdiCommand> readNdiCommand(std::string_view bytes)
{
    if (bytes.ends_with('\r'))
        bytes.remove_suffix(1);
    const std::size_t end = bytes.find_first_of(": ");
    const std::string_view name = bytes.substr(0, end);
    const auto isName = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
    if (name.empty() || end == std::string_view::npos || !std::ranges::all_of(name, isName))
        return fail(Errc::DeviceReplyDamaged, "not a command");
    if (bytes[end] == ' ')
        return NdiCommand{std::string{name}, std::string{bytes.substr(end + 1)}};
    return checkedText(bytes).map([&](std::string_view text) {
        return NdiCommand{std::string{name}, std::string{text.substr(end + 1)}};
    });
}

} // namespace carina
