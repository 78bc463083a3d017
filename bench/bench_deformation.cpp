// How long the processor takes to deform a mesh of 500,000 vertices, beside copying as many bytes
// as the deformed mesh holds into fresh memory: the least that any way of handing out a deformed
// mesh can cost. Prints one JSON object.

#include "engine/geometry/deformable_mesh.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace
{

constexpr std::size_t kVertices = 500'000;
constexpr std::size_t kTriangles = 2 * kVertices; // as many as a closed surface has
constexpr const char* kOurs = "deformed";
constexpr const char* kPeer = "memcpy";

std::vector<carina::Vec3f> randomVectors(std::mt19937& random, float scale)
{
    std::uniform_real_distribution<float> number{-scale, scale};
    std::vector<carina::Vec3f> vectors(kVertices);
    for (carina::Vec3f& vector : vectors)
        vector = {number(random), number(random), number(random)};
    return vectors;
}

const carina::DeformableMesh& lung()
{
    static const carina::DeformableMesh mesh = [] {
        std::mt19937 random{7};
        carina::DeformableMesh made;
        made.rest.positions = randomVectors(random, 0.15F);
        made.rest.normals = randomVectors(random, 1.0F);
        made.rest.triangles.resize(kTriangles);
        made.displacement = randomVectors(random, 0.02F);
        made.normalLinear = randomVectors(random, 0.1F);
        made.normalQuadratic = randomVectors(random, 0.01F);
        return made;
    }();
    return mesh;
}

std::size_t bytesOfDeformed()
{
    return 2 * kVertices * sizeof(carina::Vec3f) + kTriangles * sizeof(carina::Triangle);
}

void deform(benchmark::State& state)
{
    const carina::DeformableMesh& mesh = lung();
    float s = 0.0F;
    for (auto _ : state) {
        s = s < 1.0F ? s + 0.01F : 0.0F;
        benchmark::DoNotOptimize(carina::deformed(mesh, s));
    }
}

void copy(benchmark::State& state)
{
    const std::vector<std::byte> source(bytesOfDeformed(), std::byte{1});
    for (auto _ : state) {
        const auto target = std::make_unique_for_overwrite<std::byte[]>(source.size());
        std::memcpy(target.get(), source.data(), source.size());
        benchmark::DoNotOptimize(target.get());
        benchmark::ClobberMemory();
    }
}

/// Keeps the time of every repetition, by benchmark.
class Collector : public benchmark::BenchmarkReporter
{
public:
    bool ReportContext(const Context& /*context*/) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override
    {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration || run.error_occurred)
                continue;
            const bool ours = run.run_name.function_name == kOurs;
            (ours ? m_ours : m_peer).push_back(run.GetAdjustedRealTime());
        }
    }

    [[nodiscard]] std::span<const double> ours() const { return m_ours; }
    [[nodiscard]] std::span<const double> peer() const { return m_peer; }

private:
    std::vector<double> m_ours;
    std::vector<double> m_peer;
};

double median(std::span<const double> values)
{
    std::vector<double> sorted{values.begin(), values.end()};
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
}

} // namespace

int main()
{
    // The repetitions of both alternate at random, so that a busy moment strikes both.
    std::vector<std::string> words{"bench", "--benchmark_enable_random_interleaving=true",
                                   "--benchmark_repetitions=15", "--benchmark_min_time=0.2"};
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    benchmark::RegisterBenchmark(kOurs, deform)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(kPeer, copy)->Unit(benchmark::kMillisecond);

    Collector times;
    benchmark::RunSpecifiedBenchmarks(&times);
    if (times.ours().empty() || times.peer().empty()) {
        std::fputs("The deformation or its peer was not measured.\n", stderr);
        return 1;
    }
    const double ours_ms = median(times.ours());
    const double peer_ms = median(times.peer());
    std::printf("{\n  \"schema\": \"carina.bench.deformation/1\",\n  \"vertices\": %zu,\n"
                "  \"repetitions\": %zu,\n  \"deformed_median_ms\": %.3f,\n"
                "  \"memcpy_median_ms\": %.3f,\n  \"ratio_to_memcpy\": %.2f\n}\n",
                kVertices, times.ours().size(), ours_ms, peer_ms, ours_ms / peer_ms);
    return 0;
}
