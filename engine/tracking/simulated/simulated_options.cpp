#include "engine/tracking/simulated/simulated_options.h"

#include "engine/tracking/sequence_fields.h"
#include "engine/tracking/tool_role.h"

#include <cmath>

namespace carina
{
namespace
{

constexpr double kSlowest_Hz = 1.0;
constexpr double kFastest_Hz = 1000.0;
constexpr double kMostDropouts = 90.0;
constexpr double kPartlyHidden = 0.5;

tl::unexpected<Error> noSuchOption(std::string_view option)
{
    std::string tools;
    for (const char* word : kToolRoleWords)
        if (std::string_view{word} != toolRoleWord(ToolRole::Other))
            tools += (tools.empty() ? "" : ", ") + std::string{word};
    return fail(Errc::WrongOption,
                "simulated: \"" + std::string{option}
                    + "\" is not among rate=HZ (1 to 1000), hidden=TOOL, partly=TOOL and "
                      "dropouts=PERCENT (0 to 90), where TOOL is one of "
                    + tools);
}

std::optional<double> numberWithin(std::string_view text, double least, double most)
{
    const auto number = field::numberOf<double>(text);
    return number && *number >= least && *number <= most ? number : std::nullopt;
}

Occlusion hidden(ToolRole tool, double share)
{
    const SessionTime from{kHiddenFrom};
    return {.tool = tool,
            .from = from,
            .until = from + kHiddenFor,
            .share = share,
            .every = kHiddenEvery};
}

bool take(std::string_view name, std::string_view value, SimulatedTrackerSettings& settings)
{
    if (name == "rate" || name == "dropouts") {
        const bool isRate = name == "rate";
        const auto number = isRate ? numberWithin(value, kSlowest_Hz, kFastest_Hz)
                                   : numberWithin(value, 0.0, kMostDropouts);
        if (number && isRate)
            settings.rate = hertz(*number);
        else if (number)
            settings.dropouts = *number / 100.0;
        return number.has_value();
    }
    if (name != "hidden" && name != "partly")
        return false;
    const auto tool = toolRoleOfWord(value);
    if (!tool || *tool == ToolRole::Other)
        return false;
    settings.occlusions.push_back(hidden(*tool, name == "hidden" ? 1.0 : kPartlyHidden));
    return true;
}

} // namespace

Result<SimulatedTrackerSettings> readSimulatedOptions(std::string_view words)
{
    SimulatedTrackerSettings settings;
    for (;;) {
        const std::size_t comma = words.find(',');
        const std::string_view option = words.substr(0, comma);
        const std::size_t equals = option.find('=');
        if (equals == std::string_view::npos
            || !take(option.substr(0, equals), option.substr(equals + 1), settings))
            return noSuchOption(option);
        if (comma == std::string_view::npos)
            return settings;
        words.remove_prefix(comma + 1);
    }
}

} // namespace carina
