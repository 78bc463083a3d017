#include "engine/sync/strategies/relayed_message.h"

#include "engine/sync/wire/cpo_codec.h"
#include "engine/sync/wire/wire_quantities.h"

namespace carina
{
namespace
{

// The order of the variant's alternatives.
enum class RelayedKind : std::uint8_t { Action, Probe, Answer };

struct RelayedWriter {
    ByteWriter& out;

    void operator()(const EventCpo& event) { writeEventCpo(out, event); }
    void operator()(const DelayProbe& probe) { writeWireTime(out, probe.sentAt); }
    void operator()(const DelayAnswer& answer) { writeWireTime(out, answer.sentAt); }
};

} // namespace

std::vector<std::byte> encodeRelayed(const RelayedMessage& message)
{
    std::vector<std::byte> bytes;
    ByteWriter out{bytes};
    out.number(message.from.value);
    out.number(message.to.value);
    out.number(static_cast<std::uint8_t>(message.content.index()));
    std::visit(RelayedWriter{out}, message.content);
    return bytes;
}

Result<RelayedMessage> decodeRelayed(std::span<const std::byte> bytes)
{
    ByteReader in{bytes};
    RelayedMessage message;
    message.from.value = in.number<std::uint16_t>();
    message.to.value = in.number<std::uint16_t>();
    switch (static_cast<RelayedKind>(in.number<std::uint8_t>())) {
    case RelayedKind::Action:
        message.content = readEventCpo(in);
        break;
    case RelayedKind::Probe:
        message.content = DelayProbe{readWireTime(in)};
        break;
    case RelayedKind::Answer:
        message.content = DelayAnswer{readWireTime(in)};
        break;
    default:
        in.require(false, "message kind");
    }
    in.require(in.remaining() == 0, "length");
    if (!in.ok())
        return fail(Errc::PacketMalformed, in.brokenRule());
    return message;
}

} // namespace carina
