// Any bytes as a message that the host forwards from one participant to another, unread: refused
// with a reason, or taken apart and written back to the very same bytes.

#include "engine/core/expects.h"
#include "engine/sync/strategies/relayed_message.h"

#include <algorithm>

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto bytes = std::as_bytes(std::span{data, size});
    const auto message = carina::decodeRelayed(bytes);
    if (message)
        CARINA_EXPECTS(std::ranges::equal(carina::encodeRelayed(*message), bytes));
    else
        CARINA_EXPECTS(!message.error().detail.empty());
    return 0;
}
