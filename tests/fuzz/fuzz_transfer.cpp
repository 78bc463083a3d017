// Any bytes over the connection by which an anatomy set travels: refused, waited for, or taken
// apart without a fault that a sanitizer sees, and written back to the very same bytes.

#include "engine/core/expects.h"
#include "engine/net/anatomy_transfer/transfer_frame.h"

#include <algorithm>

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carina;
    auto rest = std::as_bytes(std::span{data, size});
    while (true) {
        const auto before = rest;
        const auto frame = transfer::takeFrame(rest);
        if (!frame || !*frame)
            return 0;
        const auto* want = std::get_if<transfer::Want>(&**frame);
        if (want && want->version != transfer::kVersion)
            continue; // what another version says is not kept
        CARINA_EXPECTS(std::ranges::equal(transfer::encode(**frame),
                                          before.first(before.size() - rest.size())));
    }
}
