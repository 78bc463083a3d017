#include "engine/net/discovery/session_notice.h"

#include "engine/core/byte_buffer.h"
#include "engine/core/expects.h"
#include "engine/session/facts/fact_rules.h"
#include "engine/session/facts/utf8.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::array kMagic{std::byte{'C'}, std::byte{'D'}, std::byte{1}};
constexpr std::uint8_t kQuestion = 1;
constexpr std::uint8_t kAnswer = 2;
constexpr std::size_t kQuestionSize = 128;

std::vector<std::byte> beginNotice(std::uint8_t kind, std::uint32_t nonce)
{
    std::vector<std::byte> bytes{kMagic.begin(), kMagic.end()};
    ByteWriter out{bytes};
    out.number(kind);
    out.number(nonce);
    return bytes;
}

/// The nonce of a message of this kind.
std::uint32_t readNoticeHead(ByteReader& in, std::uint8_t kind)
{
    in.require(std::ranges::equal(in.bytes(kMagic.size()), kMagic), "magic");
    in.require(in.number<std::uint8_t>() == kind, "kind");
    return in.number<std::uint32_t>();
}

} // namespace

std::vector<std::byte> encodeQuestion(const SessionQuestion& question)
{
    auto bytes = beginNotice(kQuestion, question.nonce);
    ByteWriter out{bytes};
    out.bytes(question.session);
    bytes.resize(kQuestionSize);
    return bytes;
}

std::optional<SessionQuestion> decodeQuestion(std::span<const std::byte> bytes)
{
    ByteReader in{bytes};
    SessionQuestion question{.nonce = readNoticeHead(in, kQuestion)};
    std::ranges::copy(in.bytes(question.session.size()), question.session.begin());
    return in.ok() && bytes.size() == kQuestionSize ? std::optional{question} : std::nullopt;
}

std::vector<std::byte> encodeAnswer(std::uint32_t nonce, const SessionNotice& notice)
{
    CARINA_EXPECTS(!notice.name.empty() && notice.name.size() <= kLongestText && notice.port != 0);
    auto bytes = beginNotice(kAnswer, nonce);
    ByteWriter out{bytes};
    out.bytes(notice.session);
    out.number(notice.port);
    out.number(static_cast<std::uint8_t>(notice.name.size()));
    out.bytes(std::as_bytes(std::span{notice.name}));
    return bytes;
}

std::optional<SessionNotice> decodeAnswer(std::span<const std::byte> bytes, std::uint32_t nonce)
{
    ByteReader in{bytes};
    in.require(readNoticeHead(in, kAnswer) == nonce, "nonce");
    SessionNotice notice;
    std::ranges::copy(in.bytes(notice.session.size()), notice.session.begin());
    notice.port = in.number<std::uint16_t>();
    const std::size_t length = in.number<std::uint8_t>();
    for (const std::byte b : in.bytes(length))
        notice.name.push_back(static_cast<char>(b));
    in.require(length > 0 && length <= kLongestText && isUtf8(notice.name), "name");
    in.require(notice.port != 0 && in.remaining() == 0, "port and end");
    return in.ok() ? std::optional{notice} : std::nullopt;
}

} // namespace carina
