#pragma once

#include "engine/tracking/igtl/igtl_codec.h"
#include "engine/tracking/igtl/igtl_reader.h"

#include <string>
#include <vector>

namespace carina::test
{

/// The 12 numbers of a quarter turn about z and a position of (10, -20, 30) mm.
inline constexpr IgtlMatrix kQuarterTurn{0, 1, 0, -1, 0, 0, 0, 0, 1, 10, -20, 30};

inline IgtlMessage messageOf(IgtlContent content, std::string device = "Tube")
{
    IgtlMessage message;
    message.device = std::move(device);
    message.content = std::move(content);
    return message;
}

/// One of each kind.
inline std::vector<IgtlMessage> igtlSamples()
{
    IgtlPolyData surface;
    surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    surface.cells[0] = {1, {1, 3}};
    surface.cells[kIgtlPolygons] = {2, {3, 0, 1, 2, 3, 0, 2, 3}};
    surface.attributes = {{1, 3, 1, "flow", {1, 2, 3}}, {0, 1, 2, "age", {4, 5}}};
    std::vector<IgtlMessage> all{
        messageOf(IgtlTransform{kQuarterTurn}),
        messageOf(IgtlPosition{{1, 2, 3}, {0, 0, 0, 1}, 4}),
        messageOf(IgtlPosition{{1, 2, 3}, {0, 0, 1, 0}, 3}),
        messageOf(IgtlPosition{{1, 2, 3}, {}, 0}),
        messageOf(IgtlTrackingData{{{"Tube", 2, kQuarterTurn}, {"Jaw", 1, kQuarterTurn}}}),
        messageOf(IgtlQuaternionTrackingData{{{"Tube", 2, {1, 2, 3}, {0, 0, 0, 1}}}}),
        messageOf(IgtlStart{false, 20, "Patient"}),
        messageOf(IgtlStart{true, 50, ""}),
        messageOf(IgtlStatus{13, -7, "NOT_READY", "Not yet."}),
        messageOf(IgtlString{3, "a text"}),
        messageOf(IgtlPoints{{{"Carina", "Landmark", {1, 2, 3, 4}, {5, 6, 7}, 2, "CT"}}}),
        messageOf(surface),
        messageOf(IgtlQuery{"GET_POLYDATA"}),
        messageOf(IgtlQuery{"STP_TDATA"}),
        messageOf(IgtlReply{"RTS_TDATA", -1}),
    };
    const std::size_t count = all.size();
    for (std::size_t i = 0; i < count; ++i) {
        IgtlMessage message = all[i];
        message.version = 2;
        message.stamp = (std::uint64_t{1'234'567'890} << 32U) + 0x8000'0000U;
        message.id = 7;
        message.metadata = {{"TransformStatus", 3, "OK"}, {"Empty", 106, ""}};
        all.push_back(message);
    }
    return all;
}

/// The messages in a stream, and how many were refused.
struct IgtlStream {
    std::vector<IgtlMessage> messages;
    int refused = 0;
    bool isLost = false;
    bool isWithin = false;
};
inline IgtlStream streamOf(std::span<const std::byte> bytes, std::size_t piece = 1U << 30U)
{
    IgtlStream stream;
    IgtlReader reader{1U << 20U};
    while (!bytes.empty()) {
        const auto taken = bytes.first(std::min(piece, bytes.size()));
        bytes = bytes.subspan(taken.size());
        reader.take(taken);
        while (auto message = reader.next()) {
            if (*message)
                stream.messages.push_back(**std::move(message));
            else
                ++stream.refused;
        }
    }
    stream.isLost = reader.isLost();
    stream.isWithin = reader.isWithin();
    return stream;
}

} // namespace carina::test
