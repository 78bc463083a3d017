#include "engine/io/mesh/surface_check.h"
#include "engine/io/mesh/surface_text.h"

#include <cstdint>
#include <cstring>

namespace carina
{
namespace
{

constexpr std::size_t kStlHeaderBytes = 84;
constexpr std::size_t kStlTriangleBytes = 50;

Result<void> checkAsciiStl(std::string_view bytes)
{
    long open = 0;
    bool solidEnded = false;
    while (!bytes.empty()) {
        std::string_view line = takeLine(bytes);
        const std::string_view key = takeWord(line);
        open += key == "facet" ? 1 : 0;
        open -= key == "endfacet" ? 1 : 0;
        solidEnded = key == "endsolid" || (solidEnded && key.empty());
    }
    if (open != 0 || !solidEnded)
        return fail(Errc::FileMalformed, "truncated: a solid that does not end");
    return {};
}

} // namespace

Result<void> checkStl(std::string_view bytes)
{
    std::uint32_t declared = 0;
    if (bytes.size() >= kStlHeaderBytes)
        std::memcpy(&declared, bytes.data() + 80, sizeof declared);
    const std::size_t needed = kStlHeaderBytes + std::size_t{declared} * kStlTriangleBytes;
    if (bytes.starts_with("solid") && bytes.size() != needed)
        return checkAsciiStl(bytes);
    if (bytes.size() < needed)
        return fail(
            Errc::FileMalformed,
            "truncated: " + std::to_string(declared) + " triangles declared, bytes for "
                + std::to_string(bytes.size() < kStlHeaderBytes
                                     ? 0
                                     : (bytes.size() - kStlHeaderBytes) / kStlTriangleBytes));
    return {};
}

} // namespace carina
