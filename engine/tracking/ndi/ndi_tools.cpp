#include "engine/tracking/ndi/ndi_tools.h"

#include "engine/tracking/ndi/ndi_hexadecimal.h"

#include <algorithm>
#include <iterator>
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
const std::string kPlace = "0020"; // of PHINF: device, port and channel
const std::string kUnplugged = "nothing is plugged in for it";
constexpr int kTries = 3; // of a wired tool that is refused: each stops the others for a moment

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

NdiStep afterwards(std::function<void()> then)
{
    return {.patience = Duration{0}, .inVain = std::move(then)};
}

/// One that goes on without an answer.
NdiStep trying(NdiCommand command, std::function<void(const NdiReply&)> then = {})
{
    NdiStep step = asking(std::move(command), std::move(then));
    step.inVain = [] {};
    return step;
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
    m_plugged.clear();
    m_wireless.clear();
    m_placeOf.clear();
    m_found.clear();
    m_refusedAt.clear();
    m_tries.clear();
    m_dialogue.queue(asking({"PHSR", "01"}, [this](const NdiReply& reply) { free(reply); }));
    m_dialogue.queue(asking({"PHSR", "02"}, [this](const NdiReply& reply) { findWired(reply); }));
    m_dialogue.queue(afterwards([this] { m_dialogue.queueFirst(initialisingFound()); }));
    for (std::size_t tool = 0; tool < m_wanted.size(); ++tool)
        if (m_wanted[tool].definition)
            define(tool);
}

/// What was plugged out is freed only when the device is stopped for a tool.
void NdiTools::lookAtPorts(std::function<void(const NdiReply&)> restarted)
{
    m_dialogue.queue(asking({"PHSR", "01"}, [this](const NdiReply& reply) {
        m_toFree = handlesIn(reply);
        forget(m_toFree);
    }));
    m_dialogue.queue(asking({"PHSR", "02"}, [this](const NdiReply& reply) { findWired(reply); }));
    m_dialogue.queue(afterwards([this, then = std::move(restarted)] { useFound(then); }));
}

/// A device that tracks refuses PHF, PINIT and PENA.
void NdiTools::useFound(const std::function<void(const NdiReply&)>& restarted)
{
    for (const auto& [handle, tool] : m_refusedAt)
        if (mayBeTried(tool))
            m_found.emplace_back(tool, handle);
    if (m_found.empty())
        return;
    std::vector<NdiStep> steps;
    steps.push_back(asking({"TSTOP"}));
    for (const std::uint16_t handle : std::exchange(m_toFree, {}))
        steps.push_back(trying({"PHF", inHexadecimal(handle, 2)}));
    std::ranges::move(initialisingFound(), std::back_inserter(steps));
    steps.push_back(asking({"TSTART"}, restarted));
    m_dialogue.queueFirst(std::move(steps));
}

std::vector<NdiStep> NdiTools::initialisingFound()
{
    std::vector<NdiStep> steps;
    for (const auto& [tool, handle] : std::exchange(m_found, {}))
        steps.push_back(initialising(tool, handle));
    return steps;
}

void NdiTools::freeAll()
{
    m_dialogue.queue(trying({"PHSR", "00"}, [this](const NdiReply& reply) { free(reply); }));
}

void NdiTools::free(const NdiReply& ports)
{
    const std::vector<std::uint16_t> handles = handlesIn(ports);
    forget(handles);
    std::vector<NdiStep> freeing;
    for (const std::uint16_t handle : handles)
        freeing.push_back(trying({"PHF", inHexadecimal(handle, 2)}));
    m_dialogue.queueFirst(std::move(freeing));
}

void NdiTools::forget(const std::vector<std::uint16_t>& handles)
{
    for (const std::uint16_t handle : handles) {
        m_toolOf.erase(handle);
        m_plugged.erase(handle);
        m_wireless.erase(handle);
        const auto refused = m_refusedAt.find(handle);
        if (refused == m_refusedAt.end())
            continue;
        m_refused.erase(refused->second);
        m_tries.erase(refused->second);
        m_refusedAt.erase(refused);
    }
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
    m_wireless.insert(handle);
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

/// Tools of which nothing is known yet are taken in ascending order of the ports. The port of a
/// wireless tool that was refused is left, and waits to be initialised as that of a wired one does.
void NdiTools::findWired(const NdiReply& ports)
{
    for (std::size_t tool = 0; tool < m_wanted.size(); ++tool)
        if (isWired(tool) && !hasHandle(tool))
            m_refused.try_emplace(tool, kUnplugged); // or is told of again
    std::vector<NdiStep> steps;
    for (const std::uint16_t handle : handlesIn(ports)) {
        if (m_wireless.contains(handle))
            continue;
        m_plugged.insert(handle);
        if (m_refusedAt.contains(handle))
            continue;
        steps.push_back(asking({"PHINF", inHexadecimal(handle, 2) + kPlace},
                               [this, handle](const NdiReply& reply) {
                                   useWired(handle, errorCode(reply) ? std::string{} : reply.bytes);
                               }));
    }
    m_dialogue.queueFirst(std::move(steps));
}

void NdiTools::useWired(std::uint16_t handle, const std::string& place)
{
    const auto tool = wiredAt(place);
    if (!tool)
        return;
    m_refused.erase(*tool);
    if (!place.empty())
        m_placeOf[*tool] = place;
    m_found.emplace_back(*tool, handle);
}

/// The tool that was at this place; else the next one that was at none, or the only one.
std::optional<std::size_t> NdiTools::wiredAt(const std::string& place) const
{
    std::vector<std::size_t> absent;
    for (std::size_t tool = 0; tool < m_wanted.size(); ++tool)
        if (isUnplugged(tool))
            absent.push_back(tool);
    const auto wasHere = [&](std::size_t tool) {
        const auto known = m_placeOf.find(tool);
        return known != m_placeOf.end() && known->second == place;
    };
    if (const auto same = std::ranges::find_if(absent, wasHere); same != absent.end())
        return *same;
    if (absent.size() > 1)
        std::erase_if(absent, [this](std::size_t tool) { return m_placeOf.contains(tool); });
    return absent.empty() ? std::nullopt : std::optional{absent.front()};
}

NdiStep NdiTools::initialising(std::size_t tool, std::uint16_t handle)
{
    return asking({"PINIT", inHexadecimal(handle, 2)}, [this, tool, handle](const NdiReply& reply) {
        isFine(reply) ? enable(tool, handle) : refuseAt(handle, tool, reply);
    });
}

void NdiTools::enable(std::size_t tool, std::uint16_t handle)
{
    std::vector<NdiStep> steps;
    steps.push_back(asking({"PENA", inHexadecimal(handle, 2) + "D"},
                           [this, tool, handle](const NdiReply& reply) {
                               isFine(reply) ? use(handle, tool) : refuseAt(handle, tool, reply);
                           }));
    m_dialogue.queueFirst(std::move(steps));
}

void NdiTools::use(std::uint16_t handle, std::size_t tool)
{
    m_toolOf[handle] = tool;
    m_refused.erase(tool);
    m_refusedAt.erase(handle);
    m_tries.erase(tool);
}

void NdiTools::refuseAt(std::uint16_t handle, std::size_t tool, const NdiReply& reply)
{
    refuse(tool, reply);
    if (!isWired(tool))
        return;
    m_refusedAt[handle] = tool;
    ++m_tries[tool];
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

bool NdiTools::hasHandle(std::size_t tool) const
{
    return std::ranges::any_of(m_toolOf, [tool](const auto& of) { return of.second == tool; });
}

bool NdiTools::isUnplugged(std::size_t tool) const
{
    const auto refused = m_refused.find(tool);
    return refused != m_refused.end() && refused->second == kUnplugged;
}

bool NdiTools::isAnyAwaited() const
{
    return std::ranges::any_of(m_refused, [](const auto& why) { return why.second == kUnplugged; })
           || std::ranges::any_of(m_refusedAt,
                                  [this](const auto& at) { return mayBeTried(at.second); });
}

bool NdiTools::mayBeTried(std::size_t tool) const
{
    const auto tries = m_tries.find(tool);
    return tries == m_tries.end() || tries->second < kTries;
}

std::string NdiTools::refusals() const
{
    std::string text;
    for (const auto& [tool, why] : m_refused)
        text += (text.empty() ? "" : "; ") + m_wanted[tool].name + ": " + why;
    return text;
}

} // namespace carina
