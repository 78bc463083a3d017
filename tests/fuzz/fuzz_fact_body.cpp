// Any bytes in place of a fact: refused, or read and written back to the very same bytes.

#include "engine/core/expects.h"
#include "engine/session/facts/fact_codec.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto bytes = std::as_bytes(std::span{data, size});
    if (const auto body = carina::decodeBody(bytes))
        CARINA_EXPECTS(std::ranges::equal(carina::encodeBody(*body), bytes));
    return 0;
}
