// Any bytes from one who wants to come in, or is asked where a session is: refused, or taken apart
// without a fault that a sanitizer sees, and written back to the very same bytes where there is one
// spelling only.

#include "engine/core/expects.h"
#include "engine/net/discovery/session_notice.h"
#include "engine/net/entry/join_link.h"
#include "engine/net/entry/role_proof.h"
#include "engine/net/entry/token_message.h"
#include "engine/net/secure/dtls_record.h"

#include <algorithm>

namespace
{

using namespace carina;

void readMessages(std::span<const std::byte> bytes)
{
    const auto isSame = [&](const auto& encoded) { return std::ranges::equal(encoded, bytes); };
    (void)decodeQuestion(bytes);
    (void)isTokenRequest(bytes);
    if (const auto notice = decodeAnswer(bytes, 0))
        CARINA_EXPECTS(isSame(encodeAnswer(0, *notice)));
    if (const auto token = decodeToken(bytes))
        CARINA_EXPECTS(isSame(encodeToken(*token)));
    if (const auto challenge = decodeChallenge(bytes))
        CARINA_EXPECTS(isSame(encodeChallenge(*challenge)));
    if (const auto proof = decodeProof(bytes))
        CARINA_EXPECTS(isSame(encodeProof(*proof)));
    if (const auto taken = decodeVerdict(bytes))
        CARINA_EXPECTS(isSame(encodeVerdict(*taken)));
}

void readRecords(std::span<const std::uint8_t> octets)
{
    (void)firstRecord(octets);
    (void)isClientHello(octets);
    (void)holdsFinished(octets);
    (void)isNoCipherAlert(octets);
    (void)isWrongKeyAlert(octets);
}

void readTexts(const std::string& text)
{
    if (const auto identity = pskIdentity(text))
        CARINA_EXPECTS(toText(*identity) == text);
    if (const auto code = JoinCode::parse(text))
        CARINA_EXPECTS(JoinCode::parse(code->text()) == *code);
    const auto link = joinLink(text);
    if (!link)
        return;
    // One that was written more briefly may become too long.
    const std::string again = toText(*link);
    CARINA_EXPECTS(again.size() > JoinLink::kLongest || joinLink(again) == *link);
}

} // namespace

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::span octets{data, size};
    readMessages(std::as_bytes(octets));
    readRecords(octets);
    readTexts({octets.begin(), octets.end()});
    return 0;
}
