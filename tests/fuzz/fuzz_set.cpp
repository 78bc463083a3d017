// Any bytes in an anatomy set that a host sends, its checksum right: refused, or read without a
// fault that a sanitizer sees and written back to the very same bytes. What checkSet then lets
// through has what those who draw it count on.

#include "engine/core/expects.h"
#include "engine/io/anatomy_set/set_check.h"
#include "tests/fuzz/set_under_seal.h"

#include <algorithm>

namespace
{

using namespace carina;

bool isDrawable(const TriangleMesh& mesh)
{
    const auto isCorner = [&mesh](std::uint32_t corner) { return corner < mesh.positions.size(); };
    return !mesh.positions.empty() && mesh.normals.size() == mesh.positions.size()
           && std::ranges::all_of(mesh.triangles, [&](const Triangle& t) {
                  return std::all_of(t.begin(), t.end(), isCorner);
              });
}

} // namespace

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto bytes = fuzz::setUnderSeal(std::as_bytes(std::span{data, size}));
    const auto set = decodeSet(bytes);
    if (!set)
        return 0;
    CARINA_EXPECTS(std::ranges::equal(encodeSet(*set), bytes));
    if (!checkSet(*set))
        return 0;
    for (const AnatomyPart& part : set->anatomy.parts)
        CARINA_EXPECTS(std::ranges::all_of(part.levels, isDrawable));
    return 0;
}
