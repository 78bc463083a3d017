// Any bytes from the network: refused, or taken apart without a fault that a sanitizer sees.

#include "engine/sync/wire/datagram_codec.h"

#include <cstddef>
#include <cstdint>
#include <span>

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    (void)carina::decodeDatagram(std::as_bytes(std::span{data, size}));
    return 0;
}
