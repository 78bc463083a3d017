#include "engine/tracking/ndi/ndi_conversation.h"

#include "engine/tracking/ndi/ndi_command.h"
#include "engine/tracking/ndi/ndi_reply.h"

#include <charconv>
#include <utility>

namespace carina
{
namespace
{

/// The options of TX and BX; without arguments they are 0001.
std::optional<std::uint16_t> optionsOf(const NdiCommand& command)
{
    if (command.arguments.empty())
        return kNdiPoses;
    std::uint16_t options = 0;
    const char* const end = command.arguments.data() + command.arguments.size();
    const auto [stop, fault] = std::from_chars(command.arguments.data(), end, options, 16);
    return fault == std::errc{} && stop == end ? std::optional{options} : std::nullopt;
}

/// The frame in a reply; nothing in one to a command that does not ask for poses, or in an error.
Result<std::optional<NdiFrame>> frameIn(const NdiCommand& command, const NdiReply& reply)
{
    const bool isText = reply.form == NdiReply::Form::Text;
    const bool asks = command.name == "TX" || command.name == "BX" || command.name == "BX2";
    if (!asks || errorCode(reply))
        return std::nullopt;
    if (isText != (command.name == "TX"))
        return fail(Errc::DeviceReplyDamaged, "a reply to another command");
    const auto body = std::as_bytes(std::span{reply.bytes});
    const auto some = [](NdiFrame frame) { return std::optional{std::move(frame)}; };
    if (command.name == "BX2")
        return decodeBx2(body).map(some);
    const auto options = optionsOf(command);
    if (!options)
        return fail(Errc::DeviceReplyDamaged, "options of " + command.name);
    return (isText ? decodeTx(reply.bytes, *options) : decodeBx(body, *options)).map(some);
}

class Decoder
{
public:
    void take(const NdiExchange& exchange)
    {
        NdiCommand command;
        if (!exchange.command.empty()) {
            ++m_decoded.commands;
            auto read = readNdiCommand(exchange.command);
            if (!read)
                refuse(exchange, read.error(), true);
            else
                command = *std::move(read);
        }
        if (!exchange.reply.empty())
            takeReply(exchange, command);
    }

    NdiConversation finish() { return std::move(m_decoded); }

private:
    void takeReply(const NdiExchange& exchange, const NdiCommand& command)
    {
        ++m_decoded.replies;
        NdiReplyReader reader;
        reader.take(exchange.reply);
        const auto reply = reader.next();
        if (!reply)
            return refuse(exchange, Error{Errc::DeviceReplyDamaged, "its end is missing"}, false);
        if (!*reply)
            return refuse(exchange, reply->error(), true);
        auto frame = frameIn(command, **reply);
        if (!frame)
            return refuse(exchange, frame.error(), false);
        if (!*frame)
            return;
        if ((*frame)->refusedPose)
            refuse(exchange, *(*frame)->refusedPose, false);
        m_decoded.frames.push_back({**std::move(frame), exchange.seconds});
    }

    void refuse(const NdiExchange& exchange, const Error& error, bool byChecksum)
    {
        m_decoded.checksumErrors += byChecksum ? 1 : 0;
        m_decoded.refused.push_back({exchange.line, error});
    }

    NdiConversation m_decoded;
};

} // namespace

NdiConversation decode(const std::vector<NdiExchange>& recording)
{
    Decoder decoder;
    for (const NdiExchange& exchange : recording)
        decoder.take(exchange);
    return decoder.finish();
}

} // namespace carina
