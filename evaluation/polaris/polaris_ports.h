#pragma once

#include "evaluation/polaris/polaris_tool.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace carina
{

/// A tool that is plugged into a Polaris, which knows of it what is in its memory.
struct PluggedTool {
    int port = 1;
    std::string information = "01000000Simulated   00000000000"; ///< type, maker, revision, serial
    std::string partNumber{};
    std::string accessories = "00";
    std::string electricalTest = "00000000";
    std::string markers = "00";
    bool warns = false; ///< is initialised with a warning
};

/// A plugged tool in whose memory this is.
[[nodiscard]] PluggedTool pluggedTool(const PolarisTool& tool);

/// The port handles of a Polaris: which tools it has, and what it tells of them.
class PolarisPorts
{
public:
    struct Port {
        std::string tool{};                  ///< its name, once it is initialised
        std::string definition{};            ///< of a wireless tool, as it is loaded
        std::optional<PolarisTool> loaded{}; ///< the same, once it is initialised
        std::optional<PluggedTool> plugged{};
        bool isOccupied = true; ///< else its tool was unplugged
        bool isInitialised = false;
        bool isEnabled = false;

        [[nodiscard]] unsigned status() const;
    };

    /// @param tools wireless ones, by name, which are told by their markers. Without any, each that
    ///        is loaded is named by its part number
    PolarisPorts(std::vector<PluggedTool> plugged, std::string serialNumber,
                 std::map<std::string, PolarisTool> tools);

    /// Forgets all handles. Those of plugged tools are given when ports are asked for.
    void clear() { m_ports.clear(); }
    /// Unplugs a tool of those that are plugged in, the first is 1; or plugs it in again.
    void unplug(std::size_t wired);
    void plugIn(std::size_t wired);
    /// Bits of the system's status: what was plugged in (0040) and out (0080) since ports were
    /// asked for.
    [[nodiscard]] unsigned changes() const { return m_changes; }
    /// The answer to a command on ports, without its checksum; nothing where it is none.
    [[nodiscard]] std::optional<std::string> answer(const std::string& name,
                                                    const std::string& arguments);

    /// By handle.
    [[nodiscard]] const std::map<int, Port>& all() const { return m_ports; }

private:
    [[nodiscard]] int freeHandle() const;
    void findPlugged();
    [[nodiscard]] std::string list(int which);
    [[nodiscard]] std::string request();
    [[nodiscard]] std::string load(const std::string& arguments);
    [[nodiscard]] std::string initialise(Port& port) const;
    [[nodiscard]] std::string nameOf(const PolarisTool& loaded) const;
    [[nodiscard]] std::string information(const Port& port, unsigned options) const;
    [[nodiscard]] std::string location(const Port& port) const;

    std::vector<PluggedTool> m_plugged; ///< ascending in their ports
    std::set<std::size_t> m_out;        ///< those that are not, now
    unsigned m_changes = 0;
    std::string m_serialNumber;
    std::map<std::string, PolarisTool> m_tools;
    std::map<int, Port> m_ports; ///< by handle
};

} // namespace carina
