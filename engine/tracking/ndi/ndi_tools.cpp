#include "engine/tracking/ndi/ndi_tools.h"

#include "engine/tracking/ndi/ndi_hexadecimal.h"

#include <utility>

namespace carina
{
namespace
{

using ndi::fromHexadecimal;
using ndi::inHexadecimal;

constexpr Duration kToolPatience = std::chrono::seconds{2};
constexpr std::size_t kBlockBytes = 64; // of a definition, in PVWR
constexpr std::size_t kDefinitionBytes = 1024;

/// The handles in a reply to PHSR: a count, and for each two digits and three of its status.
std::vector<std::uint16_t> handlesIn(const NdiReply& reply)
{
    constexpr std::size_t kEntry = 5;
    std::vector<std::uint16_t> handles;
    const std::string_view text{reply.bytes};
    const std::size_t count = fromHexadecimal(text.substr(0, 2)).value_or(0);
    for (std::size_t i = 0; i < count && text.size() >= 2 + (i + 1) * kEntry; ++i)
        if (const auto handle = fromHexadecimal(text.substr(2 + i * kEntry, 2)))
            handles.push_back(*handle);
    return handles;
}

NdiStep asking(NdiCommand command, std::function<void(const NdiReply&)> then = {})
{
    return {.command = std::move(command), .patience = kToolPatience, .then = std::move(then)};
}

} // namespace

NdiTools::NdiTools(std::vector<NdiWantedTool> wanted, NdiDialogue& dialogue)
    : m_wanted{std::move(wanted)}, m_dialogue{dialogue}
{
}

void NdiTools::setUp()
{
    m_toolOf.clear();
    m_refused.clear();
    m_pluggedIn = 0;
    m_dialogue.queue(asking({"PHSR", "01"}, [this](const NdiReply& reply) { free(reply); }));
    // First the wired ones: of a wireless tool that is refused the port is left.
    m_dialogue.queue(asking({"PHSR", "02"}, [this](const NdiReply& reply) { useWired(reply); }));
    for (std::size_t tool = 0; tool < m_wanted.size(); ++tool)
        if (m_wanted[tool].definition)
            define(tool);
}

void NdiTools::free(const NdiReply& ports)
{
    std::vector<NdiStep> freeing;
    for (const std::uint16_t handle : handlesIn(ports))
        freeing.push_back(asking({"PHF", inHexadecimal(handle, 2)}));
    m_dialogue.queueFirst(std::move(freeing));
}

void NdiTools::define(std::size_t tool)
{
    m_dialogue.queue(asking({"PHRQ", "*********1****"}, [this, tool](const NdiReply& reply) {
        const auto handle = fromHexadecimal(reply.bytes);
        if (!handle || reply.bytes.size() != 2)
            refuse(tool, reply);
        else
            load(tool, *handle);
    }));
}

void NdiTools::load(std::size_t tool, std::uint16_t handle)
{
    std::vector<NdiStep> steps;
    const auto& bytes = m_wanted[tool].definition->bytes();
    for (std::size_t at = 0; at < kDefinitionBytes; at += kBlockBytes) {
        std::string block = inHexadecimal(handle, 2) + inHexadecimal(at, 4);
        for (std::size_t i = at; i < at + kBlockBytes; ++i)
            block +=
                inHexadecimal(i < bytes.size() ? std::to_integer<std::size_t>(bytes[i]) : 0, 2);
        steps.push_back(asking({"PVWR", block}));
    }
    steps.push_back(initialising(tool, handle));
    m_dialogue.queueFirst(std::move(steps));
}

void NdiTools::useWired(const NdiReply& ports)
{
    const std::vector<std::uint16_t> handles = handlesIn(ports);
    m_pluggedIn = handles.size();
    std::vector<NdiStep> steps;
    std::size_t used = 0;
    for (std::size_t tool = 0; tool < m_wanted.size(); ++tool) {
        if (m_wanted[tool].definition)
            continue;
        if (used < handles.size())
            steps.push_back(initialising(tool, handles[used++]));
        else
            m_refused[tool] = "nothing is plugged in for it";
    }
    m_dialogue.queueFirst(std::move(steps));
}

NdiStep NdiTools::initialising(std::size_t tool, std::uint16_t handle)
{
    return asking({"PINIT", inHexadecimal(handle, 2)}, [this, tool, handle](const NdiReply& reply) {
        isFine(reply) ? enable(tool, handle) : refuse(tool, reply);
    });
}

void NdiTools::enable(std::size_t tool, std::uint16_t handle)
{
    std::vector<NdiStep> steps;
    steps.push_back(asking({"PENA", inHexadecimal(handle, 2) + "D"},
                           [this, tool, handle](const NdiReply& reply) {
                               if (isFine(reply))
                                   m_toolOf[handle] = tool;
                               else
                                   refuse(tool, reply);
                           }));
    m_dialogue.queueFirst(std::move(steps));
}

void NdiTools::refuse(std::size_t tool, const NdiReply& reply)
{
    m_refused[tool] = whyRefused(reply);
}

std::optional<std::size_t> NdiTools::toolOf(std::uint16_t handle) const
{
    const auto tool = m_toolOf.find(handle);
    return tool == m_toolOf.end() ? std::nullopt : std::optional{tool->second};
}

std::string NdiTools::refusals() const
{
    std::string text;
    for (const auto& [tool, why] : m_refused)
        text += (text.empty() ? "" : "; ") + m_wanted[tool].name + ": " + why;
    return text;
}

} // namespace carina
