// Any bytes in the place of a stream of OpenIGTLink: passed over, refused, or read as a message
// that encodes to bytes which read the same; however they are cut. Client and server take them as
// well.

#include "engine/core/expects.h"
#include "engine/tracking/igtl/igtl_checksum.h"
#include "engine/tracking/igtl/igtl_client.h"
#include "engine/tracking/igtl/igtl_pose.h"
#include "engine/tracking/igtl/igtl_subscriber.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace carina;

constexpr std::size_t kMostKept = 64 * 1024;

std::vector<IgtlMessage> messagesIn(std::span<const std::byte> bytes, std::size_t piece)
{
    std::vector<IgtlMessage> messages;
    IgtlReader reader{kMostKept};
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(piece, bytes.size()))) {
        reader.take(bytes.first(std::min(piece, bytes.size())));
        while (auto message = reader.next()) {
            if (*message)
                messages.push_back(**std::move(message));
            else
                CARINA_EXPECTS(!message->error().detail.empty());
        }
    }
    return messages;
}

void verifyPose(const Result<RigidTransform>& pose)
{
    if (pose)
        CARINA_EXPECTS(pose->translation().allFinite()
                       && std::abs(pose->rotation().norm() - 1.0) < 1e-9);
}

void verify(const IgtlMessage& message)
{
    if (std::holds_alternative<IgtlSkipped>(message.content))
        return;
    const auto bytes = encodeIgtl(message);
    const auto again = messagesIn(bytes, bytes.size());
    CARINA_EXPECTS(again.size() == 1 && encodeIgtl(again[0]) == bytes);
    if (const auto* transform = std::get_if<IgtlTransform>(&message.content))
        verifyPose(poseOf(transform->matrix));
    if (const auto* position = std::get_if<IgtlPosition>(&message.content))
        verifyPose(poseOf(*position));
}

/// Makes the checksums right, so that the bodies are read.
void mend(std::span<std::byte> bytes)
{
    while (bytes.size() >= IgtlHeader::kBytes) {
        const auto header = IgtlHeader::read(bytes.first(IgtlHeader::kBytes));
        if (!header || header->bodyBytes > bytes.size() - IgtlHeader::kBytes)
            return;
        const auto body = bytes.subspan(IgtlHeader::kBytes, header->bodyBytes);
        const std::uint64_t sum = igtlChecksum(body);
        for (std::size_t i = 0; i < 8; ++i)
            bytes[IgtlHeader::kBytes - 1 - i] = std::byte((sum >> (8 * i)) & 0xFFU);
        bytes = bytes.subspan(IgtlHeader::kBytes + body.size());
    }
}

} // namespace

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size < 2)
        return 0;
    const auto raw = std::as_bytes(std::span{data, size}).subspan(2);
    std::vector<std::byte> bytes{raw.begin(), raw.end()};
    if (data[0] % 4 != 0)
        mend(bytes);
    const auto messages = messagesIn(bytes, std::max<std::size_t>(1, bytes.size()));
    CARINA_EXPECTS(messagesIn(bytes, 1 + data[1]).size() == messages.size());
    for (const IgtlMessage& message : messages)
        verify(message);

    const LocalTime now{std::chrono::seconds{1}};
    IgtlClient client{{{"Tube", "Jaw"}, IgtlPoses::Tdata, 60}};
    client.start(now);
    client.take(bytes, now);
    static_cast<void>(client.advance(now + std::chrono::seconds{3}));
    for (const IgtlSight& sight : client.takeSights())
        verifyPose(sight.X_TO.value_or(RigidTransform{}));
    static_cast<void>(client.trouble());
    IgtlSubscriber subscriber{now};
    subscriber.take(bytes);
    IgtlOffer offer;
    offer.landmarks = std::make_shared<const IgtlPoints>();
    static_cast<void>(subscriber.due(offer, now + std::chrono::seconds{3}));
    return 0;
}
