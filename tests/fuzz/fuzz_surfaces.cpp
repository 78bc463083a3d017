// Any bytes as the answer of carina-surface-reader: refused, or read without a fault that a
// sanitizer sees and written back to the very same bytes.

#include "engine/core/expects.h"
#include "engine/io/mesh/mesh_file_codec.h"

#include <algorithm>
#include <cstdint>

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carina;
    const auto bytes = std::as_bytes(std::span{data, size});
    const auto answer = decodeMeshFile(bytes);
    if (!answer) {
        CARINA_EXPECTS(answer.error().code == Errc::FileMalformed);
        return 0;
    }
    CARINA_EXPECTS(std::ranges::equal(encodeMeshFile(*answer), bytes));
    return 0;
}
