// How long the processor takes to deform a mesh of 500,000 vertices, beside copying as many bytes
// as the deformed mesh holds into fresh memory: the least that any way of handing out a deformed
// mesh can cost. Prints one JSON object.

#include "bench/interleaved.h"
#include "engine/geometry/deformable_mesh.h"

#include <cstdio>
#include <cstring>
#include <memory>
#include <random>
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

} // namespace

int main()
{
    const auto times_ns = carina::medianTimes_ns({{kOurs, deform}, {kPeer, copy}});
    const double ours_ms = 1e-6 * times_ns.at(kOurs);
    const double peer_ms = 1e-6 * times_ns.at(kPeer);
    std::printf("{\n  \"schema\": \"carina.bench.deformation/1\",\n  \"vertices\": %zu,\n"
                "  \"repetitions\": %d,\n  \"deformed_median_ms\": %.3f,\n"
                "  \"memcpy_median_ms\": %.3f,\n  \"ratio_to_memcpy\": %.2f\n}\n",
                kVertices, carina::kRepetitions, ours_ms, peer_ms, ours_ms / peer_ms);
    return 0;
}
