#include "engine/tracking/simulated/simulated_options.h"

#include "engine/tracking/sequence_fields.h"
#include "engine/tracking/tool_role.h"

#include <array>
#include <charconv>

namespace carina
{
namespace
{

constexpr double kPartlyHidden = 0.5;

tl::unexpected<Error> noSuchOption(std::string_view option)
{
    std::string tools;
    for (const char* word : kToolRoleWords)
        if (std::string_view{word} != toolRoleWord(ToolRole::Other))
            tools += (tools.empty() ? "" : ", ") + std::string{word};
    return fail(Errc::WrongOption,
                "simulated: \"" + std::string{option}
                    + "\" is not among rate=HZ (1 to 1000), hidden=TOOL, partly=TOOL, "
                      "dropouts=PERCENT (0 to 90) and with=laryngoscope, where TOOL is one of "
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

bool take(std::string_view name, std::string_view value, SimulatedOptions& options)
{
    if (name == "rate" || name == "dropouts") {
        const bool isRate = name == "rate";
        const auto number =
            isRate
                ? numberWithin(value, SimulatedOptions::kSlowest_Hz, SimulatedOptions::kFastest_Hz)
                : numberWithin(value, 0.0, SimulatedOptions::kMostDropouts_percent);
        if (number)
            (isRate ? options.rate_Hz : options.dropouts_percent) = *number;
        return number.has_value();
    }
    const auto tool = toolRoleOfWord(value);
    if (name == "with") {
        options.laryngoscope = tool == ToolRole::Laryngoscope;
        return options.laryngoscope;
    }
    if (name != "hidden" && name != "partly")
        return false;
    if (!tool || *tool == ToolRole::Other)
        return false;
    (name == "hidden" ? options.hidden : options.partly).push_back(*tool);
    return true;
}

SimulatedTrackerSettings simulatedSettings(const SimulatedOptions& options)
{
    SimulatedTrackerSettings settings;
    settings.rate = hertz(options.rate_Hz);
    settings.dropouts = options.dropouts_percent / 100.0;
    settings.laryngoscope = options.laryngoscope;
    for (const ToolRole tool : options.hidden)
        settings.occlusions.push_back(hidden(tool, 1.0));
    for (const ToolRole tool : options.partly)
        settings.occlusions.push_back(hidden(tool, kPartlyHidden));
    return settings;
}

/// As short as it can be read again exactly.
std::string numberText(double number)
{
    std::array<char, 32> text{};
    const auto written = std::to_chars(text.data(), text.data() + text.size(), number);
    return {text.data(), written.ptr};
}

} // namespace

Result<SimulatedOptions> simulatedOptions(std::string_view words)
{
    SimulatedOptions options;
    for (;;) {
        const std::size_t comma = words.find(',');
        const std::string_view option = words.substr(0, comma);
        const std::size_t equals = option.find('=');
        if (equals == std::string_view::npos
            || !take(option.substr(0, equals), option.substr(equals + 1), options))
            return noSuchOption(option);
        if (comma == std::string_view::npos)
            return options;
        words.remove_prefix(comma + 1);
    }
}

std::string simulatedWords(const SimulatedOptions& options)
{
    const SimulatedOptions unsaid;
    std::string words;
    const auto say = [&words](const char* name, const std::string& value) {
        words += (words.empty() ? "" : ",") + std::string{name} + '=' + value;
    };
    if (options.rate_Hz != unsaid.rate_Hz)
        say("rate", numberText(options.rate_Hz));
    for (const ToolRole tool : options.hidden)
        say("hidden", toolRoleWord(tool));
    for (const ToolRole tool : options.partly)
        say("partly", toolRoleWord(tool));
    if (options.dropouts_percent != unsaid.dropouts_percent)
        say("dropouts", numberText(options.dropouts_percent));
    if (options.laryngoscope)
        say("with", toolRoleWord(ToolRole::Laryngoscope));
    return words;
}

Result<SimulatedTrackerSettings> readSimulatedOptions(std::string_view words)
{
    return simulatedOptions(words).map(&simulatedSettings);
}

} // namespace carina
