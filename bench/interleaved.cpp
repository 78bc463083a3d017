#include "bench/interleaved.h"

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace carina
{
namespace
{

/// Keeps the time of every repetition, by name.
class Collector : public benchmark::BenchmarkReporter
{
public:
    bool ReportContext(const Context& /*context*/) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override
    {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration && !run.error_occurred)
                repetitions[run.run_name.function_name].push_back(
                    {run.GetAdjustedRealTime(), double(run.iterations)});
    }

    std::map<std::string, std::vector<Repetition>> repetitions;
};

} // namespace

std::map<std::string, RepeatedTimes>
repeatedTimes(const std::map<std::string, void (*)(benchmark::State&)>& measured)
{
    std::vector<std::string> words{"bench", "--benchmark_enable_random_interleaving=true",
                                   "--benchmark_repetitions=" + std::to_string(kRepetitions),
                                   "--benchmark_min_time=0.2"};
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    for (const auto& [name, function] : measured)
        benchmark::RegisterBenchmark(name.c_str(), function)->Unit(benchmark::kNanosecond);

    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    std::map<std::string, RepeatedTimes> times;
    for (const auto& [name, function] : measured) {
        if (collector.repetitions[name].empty()) {
            std::fprintf(stderr, "%s was not measured.\n", name.c_str());
            std::exit(EXIT_FAILURE);
        }
        times[name] = timesOf(collector.repetitions[name]);
    }
    return times;
}

std::map<std::string, double>
medianTimes_ns(const std::map<std::string, void (*)(benchmark::State&)>& measured)
{
    std::map<std::string, double> medians;
    for (const auto& [name, times] : repeatedTimes(measured))
        medians[name] = times.median_ns;
    return medians;
}

} // namespace carina
