#pragma once

#include "apps/lab/command/words.h"
#include "engine/io/site/devices/tracker_file.h"
#include "engine/tracking/sequence_file.h"
#include "evaluation/polaris/polaris_tool.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace carina::lab
{

using NamedTool = std::pair<std::string, ToolRole>;

/// How the simulated device names the only tool that is plugged into it.
inline const std::string kWiredTool = "wired 1";

/// The tools before a simulated Polaris.
struct PolarisTools {
    std::vector<DescribedTool> described;     ///< as its client is told of them, each with its .rom
    std::map<std::string, PolarisTool> known; ///< by name: what the device reads in the same bytes
};

/// The tools of a recording as a device can have them: no role twice.
/// @returns WrongOption where they are not one to nine, or one has no name of its own of at most 20
///          plain characters.
[[nodiscard]] Result<std::vector<NamedTool>> toolsOf(const Words& words,
                                                     const TrackerSequence& sequence);

/// The tools with these names and roles. Those that `files` names have the markers of a .rom file,
/// "NAME=FILE", several of them separated by commas; the others those of simulatedTools().
/// @returns WrongOption for other words, for a file whose markers are on one line, and for two
///          tools with the same markers; the errors of reading a .rom file, which name it.
[[nodiscard]] Result<PolarisTools>
polarisTools(const Words& words, const std::vector<NamedTool>& named, const QString& files);

} // namespace carina::lab
