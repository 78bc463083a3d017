#include "engine/net/entry/token_message.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::array kTokenRequest{std::byte{'C'}, std::byte{'T'}, std::byte{1}, std::byte{1}};
constexpr std::array kTokenAnswer{std::byte{'C'}, std::byte{'T'}, std::byte{1}, std::byte{2}};
constexpr std::size_t kTokenAt = kTokenAnswer.size() + sizeof(ParticipantId::value);
constexpr std::size_t kTokenAnswerSize = kTokenAt + std::tuple_size_v<AccessKey>;

} // namespace

std::vector<std::byte> encodeTokenRequest() { return {kTokenRequest.begin(), kTokenRequest.end()}; }

bool isTokenRequest(std::span<const std::byte> bytes)
{
    return std::ranges::equal(bytes, kTokenRequest);
}

std::vector<std::byte> encodeToken(const TokenFolder::Token& token)
{
    std::vector<std::byte> bytes{kTokenAnswer.begin(), kTokenAnswer.end()};
    bytes.push_back(static_cast<std::byte>(token.participant.value & 0xFF));
    bytes.push_back(static_cast<std::byte>(token.participant.value >> 8));
    bytes.insert(bytes.end(), token.key.begin(), token.key.end());
    return bytes;
}

std::optional<TokenFolder::Token> decodeToken(std::span<const std::byte> bytes)
{
    if (bytes.size() != kTokenAnswerSize
        || !std::ranges::equal(bytes.first(kTokenAnswer.size()), kTokenAnswer))
        return std::nullopt;
    TokenFolder::Token token{};
    token.participant.value = static_cast<std::uint16_t>(
        std::to_integer<unsigned>(bytes[4]) | std::to_integer<unsigned>(bytes[5]) << 8);
    std::ranges::copy(bytes.subspan(kTokenAt), token.key.begin());
    return token;
}

} // namespace carina
