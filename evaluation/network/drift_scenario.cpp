#include "evaluation/network/drift_scenario.h"

#include "engine/io/files/file_limit.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

namespace carina
{
namespace
{

using namespace std::chrono_literals;

PathProfile steady(Duration delay) { return {.delay = delay}; }

PathProfile exponential(Duration delay, Duration mean, double loss = 0.0)
{
    return {.delay = delay,
            .jitter = PathProfile::Jitter::Exponential,
            .jitterScale = mean,
            .loss = loss};
}

PathProfile cellular(Duration delay)
{
    return {
        .delay = delay, .jitter = PathProfile::Jitter::Pareto, .jitterScale = 8ms, .loss = 0.02};
}

/// The path on which one thing at a time goes wrong.
PathProfile metro() { return exponential(8ms, 500us); }

DriftScenario both(std::string name, const PathProfile& path)
{
    return {.name = std::move(name), .forward = path, .backward = path};
}

template <class Change> DriftScenario faulty(std::string name, Change change)
{
    PathProfile path = metro();
    change(path);
    return both(std::move(name), path);
}

DriftScenario clockScenario()
{
    DriftScenario scenario = both("clock", metro());
    scenario.clockOffset = 250ms;
    scenario.areClocksAtLimits = true;
    return scenario;
}

/// The conditions of Hamza-Lup et al. 2004, as far as their figures tell: 11 degrees of event
/// updates at 100 deg/s are 110 ms, of which their LAN has 0.2. The rest is the software, here 95
/// ms from a button to the other program, and frames, half of one on average. A message waits for
/// the frame in which it is handled, so that its delay is even over one.
DriftScenario paperScenario()
{
    constexpr double kFramesPerSecond = 35.0;
    DriftScenario scenario = both("paper", {.delay = 95ms,
                                            .jitter = PathProfile::Jitter::Uniform,
                                            .jitterScale = fromSeconds(0.5 / kFramesPerSecond)});
    scenario.frames = {.rate = kFramesPerSecond, .rateError = 0.01};
    return scenario;
}

std::vector<DriftScenario> builtIn()
{
    return {
        both("lan", steady(200us)),
        both("wifi", exponential(2ms, 3ms, 0.005)),
        both("metro", metro()),
        both("wan", exponential(40ms, 2ms, 0.005)),
        {.name = "asymmetric",
         .forward = exponential(25ms, 2ms),
         .backward = exponential(55ms, 2ms)},
        {.name = "cellular", .forward = cellular(35ms), .backward = cellular(20ms)},
        // Exponential tails through the medians and 99th percentiles that were measured.
        {.name = "5g",
         .forward = exponential(5600us, 1150us),
         .backward = exponential(4310us, 1431us)},
        both("starlink", exponential(15620us, 9200us)),
        faulty("step", [](PathProfile& path) { path.stepAt = 30s, path.stepBy = 20ms; }),
        faulty("partition", [](PathProfile& path) { path.cutFrom = 30s, path.cutFor = 2s; }),
        faulty("burst",
               [](PathProfile& path) {
                   path.burst = {0.01, 0.25};
               }),
        faulty("bottleneck", [](PathProfile& path) { path.bitsPerSecond = 1e6; }),
        faulty("duplication", [](PathProfile& path) { path.duplication = 0.1; }),
        faulty("reordering", [](PathProfile& path) { path.reordering = 0.05, path.heldUp = 20ms; }),
        clockScenario(),
        paperScenario(),
    };
}

std::optional<TracePoint> tracePoint(const std::string& line)
{
    std::istringstream words{line};
    double at_ms = 0.0;
    std::string delay;
    std::string rest;
    if (!(words >> at_ms >> delay) || words >> rest || !std::isfinite(at_ms)
        || std::abs(at_ms) > 1e9)
        return std::nullopt;
    TracePoint point{fromSeconds(at_ms * 1e-3), std::nullopt};
    if (delay == "x")
        return point;
    char* end = nullptr;
    const double delay_ms = std::strtod(delay.c_str(), &end);
    if (*end != '\0' || !(delay_ms >= 0.0 && delay_ms <= 1e6))
        return std::nullopt;
    point.delay = fromSeconds(delay_ms * 1e-3);
    return point;
}

std::string allNames()
{
    std::string all;
    for (const std::string_view name : scenarioNames())
        all += (all.empty() ? "" : ", ") + std::string{name};
    return all;
}

Result<DriftScenario> readTrace(const std::string& file)
{
    if (const auto size = readableSize(file, kMeasurementLimit); !size)
        return size.error().code != Errc::FileNotFound
                   ? tl::unexpected(size.error())
                   : fail(Errc::FileNotFound, file
                                                  + " is neither a trace file nor one of the "
                                                    "scenarios "
                                                  + allNames());
    std::ifstream in{file};
    std::vector<TracePoint> points;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        line.resize(std::min(line.find('#'), line.size()));
        if (line.find_first_not_of(" \t\r") == std::string::npos)
            continue;
        const auto point = tracePoint(line);
        if (!point || (!points.empty() && point->at <= points.back().at))
            return fail(Errc::FileMalformed,
                        file + ", line " + std::to_string(number)
                            + ": expected a time in ms above the last and a delay in ms or x.");
        points.push_back(*point);
    }
    if (points.empty())
        return fail(Errc::FileEmpty, file + " holds no delays.");
    PathProfile path;
    path.trace = std::make_shared<const std::vector<TracePoint>>(std::move(points));
    return both(file, path);
}

} // namespace

std::vector<DisplayFrames> displaysOf(const ViewFrames& frames, std::size_t displays,
                                      std::uint32_t seed)
{
    std::vector<DisplayFrames> all(displays);
    if (frames.rate <= 0.0)
        return all;
    std::mt19937 random{seed};
    const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (DisplayFrames& display : all) {
        const double rate = frames.rate * (1.0 + frames.rateError * (2.0 * share() - 1.0));
        display = {fromSeconds(1.0 / rate), fromSeconds(-share() / rate)};
    }
    return all;
}

std::vector<std::string_view> scenarioNames()
{
    static const std::vector<DriftScenario> all = builtIn();
    std::vector<std::string_view> names;
    for (const DriftScenario& scenario : all)
        names.push_back(scenario.name);
    return names;
}

Result<DriftScenario> findScenario(const std::string& nameOrFile)
{
    for (DriftScenario& scenario : builtIn())
        if (scenario.name == nameOrFile)
            return std::move(scenario);
    return readTrace(nameOrFile);
}

} // namespace carina
