// How long it takes to encode and decode a control packet object: one of ten poses of a stream that
// travel together, and an action. Beside it the least that handing on as many bytes can cost, a
// copy of them. Prints one JSON object.

#include "bench/interleaved.h"
#include "engine/sync/wire/cpo_codec.h"

#include <array>
#include <cstdio>
#include <cstring>

namespace
{

constexpr std::size_t kStreams = 10;
constexpr const char* kStream = "stream";
constexpr const char* kAction = "action";
constexpr const char* kCopyOfStream = "copy of a stream's";
constexpr const char* kCopyOfAction = "copy of an action's";

carina::StreamGroup tenPoses()
{
    carina::StreamGroup group;
    for (std::uint16_t i = 0; i < kStreams; ++i) {
        carina::StreamCpo cpo;
        cpo.object = carina::ObjectId{i};
        cpo.sequence = i;
        cpo.time = carina::SessionTime{std::chrono::hours{400}};
        cpo.X_AO = {carina::Quat{Eigen::AngleAxisd{0.1 * i, carina::Vec3::UnitX()}},
                    carina::Vec3{0.1, -0.2, 0.01 * i}};
        cpo.motion = carina::StreamMotion{carina::Vec3{0.1, 0.0, -0.3}, carina::Vec3::UnitZ()};
        group.streams.push_back(cpo);
    }
    return group;
}

/// One iteration is one pose.
void stream(benchmark::State& state)
{
    const carina::StreamGroup group = tenPoses();
    std::vector<std::byte> bytes;
    while (state.KeepRunningBatch(kStreams)) {
        bytes.clear();
        carina::ByteWriter out{bytes};
        carina::writeStreamGroup(out, group);
        benchmark::DoNotOptimize(bytes.data());
        carina::ByteReader in{bytes};
        benchmark::DoNotOptimize(carina::readStreamGroup(in));
    }
}

void action(benchmark::State& state)
{
    const carina::EventCpo event;
    std::vector<std::byte> bytes;
    for (auto _ : state) {
        bytes.clear();
        carina::ByteWriter out{bytes};
        carina::writeEventCpo(out, event);
        benchmark::DoNotOptimize(bytes.data());
        carina::ByteReader in{bytes};
        benchmark::DoNotOptimize(carina::readEventCpo(in));
    }
}

template <std::size_t Bytes> void copy(benchmark::State& state)
{
    std::array<std::byte, Bytes> from{};
    std::array<std::byte, Bytes> to{};
    for (auto _ : state) {
        benchmark::DoNotOptimize(from.data());
        std::memcpy(to.data(), from.data(), Bytes);
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
    }
}

} // namespace

int main()
{
    const auto times = carina::medianTimes_ns({{kStream, stream},
                                               {kAction, action},
                                               {kCopyOfStream, copy<carina::kStreamCpoBytes>},
                                               {kCopyOfAction, copy<carina::kEventCpoBytes>}});
    std::printf("{\n  \"schema\": \"carina.bench.cpo/1\",\n  \"repetitions\": %d,\n"
                "  \"stream_median_ns\": %.1f,\n  \"stream_copy_median_ns\": %.1f,\n"
                "  \"action_median_ns\": %.1f,\n  \"action_copy_median_ns\": %.1f\n}\n",
                carina::kRepetitions, times.at(kStream), times.at(kCopyOfStream), times.at(kAction),
                times.at(kCopyOfAction));
    return 0;
}
