// How long the processor takes to deform a lung of 500,000 vertices with their exact normals
// (deformed), beside copying as many bytes as it writes: the least that any way of handing out a
// deformed lung can cost. Programs do so once for a patient, and for lungs that they give to others
// over OpenIGTLink; each frame is deformed by the vertex shader, which bench_drawing measures.
// Prints one JSON object.

#include "bench/interleaved.h"
#include "engine/lungs/drawing/chest_pose.h"

#include <cstdio>
#include <cstring>
#include <random>
#include <vector>

namespace
{

constexpr std::size_t kVertices = 500'000;
constexpr const char* kOneLung = "deform_one_lung";
constexpr const char* kBothLungs = "deform_both_lungs";
constexpr const char* kPeer = "memcpy";

const carina::TriangleMesh& vertices()
{
    static const carina::TriangleMesh mesh = [] {
        std::mt19937 random{7};
        std::uniform_real_distribution<float> number{-0.12F, 0.12F};
        carina::TriangleMesh made;
        for (auto* vectors : {&made.positions, &made.normals})
            for (std::size_t i = 0; i < kVertices; ++i)
                vectors->emplace_back(number(random), number(random), number(random));
        return made;
    }();
    return mesh;
}

carina::ChestField chest()
{
    carina::Box lungs_A;
    lungs_A.include(carina::Vec3{-0.13, -0.1, -0.15});
    lungs_A.include(carina::Vec3{0.13, 0.1, 0.1});
    return {lungs_A, {-0.03, 0.01, -0.01}, {0.03, 0.01, 0.0}};
}

void deform(benchmark::State& state, carina::ChestRegion region)
{
    const carina::ChestField field = chest();
    carina::ChestPose pose;
    for (auto _ : state) {
        const double s = pose.lungs[0].diaphragm < 1.0 ? pose.lungs[0].diaphragm + 0.01 : 0.0;
        pose.lungs = {s * carina::kQuietBreath, 0.9 * s * carina::kQuietBreath};
        benchmark::DoNotOptimize(
            carina::deformed(vertices(), field, carina::motionOf(region, pose, field)));
    }
}

void deformOneLung(benchmark::State& state) { deform(state, carina::ChestRegion::RightLowerLung); }

/// What lies in both lungs goes over from one's motion into the other's.
void deformBothLungs(benchmark::State& state) { deform(state, carina::ChestRegion::Bronchi); }

void copy(benchmark::State& state)
{
    const std::vector<float> source(6 * kVertices, 1.0F);
    std::vector<float> target(source.size());
    for (auto _ : state) {
        std::memcpy(target.data(), source.data(), source.size() * sizeof(float));
        benchmark::DoNotOptimize(target.data());
        benchmark::ClobberMemory();
    }
}

} // namespace

int main()
{
    const auto times_ns = carina::medianTimes_ns(
        {{kOneLung, deformOneLung}, {kBothLungs, deformBothLungs}, {kPeer, copy}});
    const double one_ms = 1e-6 * times_ns.at(kOneLung);
    const double both_ms = 1e-6 * times_ns.at(kBothLungs);
    const double peer_ms = 1e-6 * times_ns.at(kPeer);
    std::printf("{\n  \"schema\": \"carina.bench.deformation/4\",\n  \"vertices\": %zu,\n"
                "  \"repetitions\": %d,\n  \"one_lung_median_ms\": %.3f,\n"
                "  \"both_lungs_median_ms\": %.3f,\n  \"memcpy_median_ms\": %.3f,\n"
                "  \"ratio_to_memcpy\": %.2f,\n  \"both_lungs_ratio_to_memcpy\": %.2f\n}\n",
                kVertices, carina::kRepetitions, one_ms, both_ms, peer_ms, one_ms / peer_ms,
                both_ms / peer_ms);
    return 0;
}
