#pragma once

#include "engine/tracking/ndi/ndi_dialogue.h"
#include "engine/tracking/ndi/tool_definition.h"

#include <map>
#include <set>
#include <utility>

namespace carina
{

/// A tool that a tracker of NDI is to track.
struct NdiWantedTool {
    std::string name;
    /// Of a wireless tool, which is told to the device; nothing for one that is plugged in. The
    /// wired tools of the list are those of the device's ports, in ascending order.
    std::optional<NdiToolDefinition> definition{};
};

/// Gives a device the tools that it is to track: ports that others left are freed, each wireless
/// tool is defined and enabled, wired tools are initialised and enabled. A tool that the device
/// refuses is left out; a wired one is tried again, three times in all until it is plugged in anew.
/// The port of a wireless one that was refused is never taken for that of a wired one.
/// A wired tool that is plugged in again at the place where it was, which the device tells, is the
/// same tool.
class NdiTools
{
public:
    /// @pre the dialogue outlives this.
    NdiTools(std::vector<NdiWantedTool> wanted, NdiDialogue& dialogue);

    /// Queues the commands, behind what is queued. What was known before is forgotten.
    void setUp();
    /// Looks, behind what is queued, what was plugged in and out of a device that tracks. Only for
    /// a tool that is to be set up it is stopped and started again: `restarted` is told the answer.
    void lookAtPorts(std::function<void(const NdiReply&)> restarted);
    /// Frees all ports of the device, also those that others left, behind what is queued. A command
    /// that it refuses, or does not answer, is passed over.
    void freeAll();

    [[nodiscard]] std::size_t count() const { return m_wanted.size(); }
    /// Which of the wanted tools has a handle of the device.
    [[nodiscard]] std::optional<std::size_t> toolOf(std::uint16_t handle) const;
    /// Each tool that is left out, and why: "Tube: PINIT failed; Chin: …"; empty if none is.
    [[nodiscard]] std::string refusals() const;
    /// How many tools are plugged into the device.
    [[nodiscard]] std::size_t pluggedIn() const { return m_plugged.size(); }
    /// Whether a tool is one that is plugged in.
    [[nodiscard]] bool isWired(std::size_t tool) const { return !m_wanted[tool].definition; }
    /// Whether nothing was plugged in for a tool when the ports were looked at last.
    [[nodiscard]] bool isUnplugged(std::size_t tool) const;
    /// Whether the ports are to be looked at for one that is not plugged in, or was refused and is
    /// tried again.
    [[nodiscard]] bool isAnyAwaited() const;

private:
    void free(const NdiReply& ports);
    void forget(const std::vector<std::uint16_t>& handles);
    void define(std::size_t tool);
    void load(std::size_t tool, std::uint16_t handle);
    void findWired(const NdiReply& ports);
    void useWired(std::uint16_t handle, const std::string& place);
    [[nodiscard]] std::optional<std::size_t> wiredAt(const std::string& place) const;
    void useFound(const std::function<void(const NdiReply&)>& restarted);
    [[nodiscard]] std::vector<NdiStep> initialisingFound();
    [[nodiscard]] NdiStep initialising(std::size_t tool, std::uint16_t handle);
    void enable(std::size_t tool, std::uint16_t handle);
    void use(std::uint16_t handle, std::size_t tool);
    void refuse(std::size_t tool, const NdiReply& reply);
    void refuseAt(std::uint16_t handle, std::size_t tool, const NdiReply& reply);
    [[nodiscard]] bool mayBeTried(std::size_t tool) const;
    [[nodiscard]] bool hasHandle(std::size_t tool) const;

    std::vector<NdiWantedTool> m_wanted;
    NdiDialogue& m_dialogue;
    std::map<std::uint16_t, std::size_t> m_toolOf; ///< by handle
    std::map<std::size_t, std::string> m_refused;  ///< tools, and why
    std::set<std::uint16_t> m_plugged;             ///< handles
    std::set<std::uint16_t> m_wireless;            ///< handles that were asked for
    std::map<std::size_t, std::string> m_placeOf;  ///< of wired tools, as the device tells it
    std::vector<std::pair<std::size_t, std::uint16_t>>
        m_found;                                      ///< wired tools to be set up, handles
    std::vector<std::uint16_t> m_toFree;              ///< handles
    std::map<std::uint16_t, std::size_t> m_refusedAt; ///< wired tools, by handle
    std::map<std::size_t, int> m_tries;               ///< of those in vain
};

} // namespace carina
