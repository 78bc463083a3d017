// Any bytes from one who wants to come in, or is asked where a session is: refused, or taken apart
// without a fault that a sanitizer sees.

#include "engine/net/discovery/session_notice.h"
#include "engine/net/join_link.h"
#include "engine/net/secure/dtls_record.h"
#include "engine/net/secure/join_code.h"
#include "engine/net/secure/psk_identity.h"
#include "engine/net/secure/role_proof.h"
#include "engine/net/secure/token_message.h"

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::span octets{data, size};
    const std::string text{octets.begin(), octets.end()};
    (void)carina::decodeQuestion(std::as_bytes(octets));
    (void)carina::decodeAnswer(std::as_bytes(octets), 0);
    (void)carina::decodeToken(std::as_bytes(octets));
    (void)carina::decodeChallenge(std::as_bytes(octets));
    (void)carina::decodeProof(std::as_bytes(octets));
    (void)carina::decodeVerdict(std::as_bytes(octets));
    (void)carina::firstRecord(octets);
    (void)carina::isClientHello(octets);
    (void)carina::holdsFinished(octets);
    (void)carina::pskIdentity(text);
    (void)carina::JoinCode::parse(text);
    (void)carina::joinLink(text);
    return 0;
}
