#include "engine/io/mesh/surface_check.h"
#include "engine/io/mesh/surface_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carina
{
namespace
{

struct PlyType {
    std::string_view name;
    std::size_t bytes;
    bool integer;
};

constexpr std::array kPlyTypes{
    PlyType{"char", 1, true},    PlyType{"int8", 1, true},     PlyType{"uchar", 1, true},
    PlyType{"uint8", 1, true},   PlyType{"short", 2, true},    PlyType{"int16", 2, true},
    PlyType{"ushort", 2, true},  PlyType{"uint16", 2, true},   PlyType{"int", 4, true},
    PlyType{"int32", 4, true},   PlyType{"uint", 4, true},     PlyType{"uint32", 4, true},
    PlyType{"float", 4, false},  PlyType{"float32", 4, false}, PlyType{"double", 8, false},
    PlyType{"float64", 8, false}};

struct PlyProperty {
    std::size_t countBytes = 0; ///< of the count before a list; 0 for a single value
    std::size_t valueBytes = 0;
    bool cornerIndices = false;
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
    std::optional<PlyEncoding> encoding;
    std::vector<PlyElement> elements;

    std::uint64_t vertices() const
    {
        for (const PlyElement& element : elements)
            if (element.name == "vertex")
                return element.count;
        return 0;
    }
};

Result<void> badHeader(const std::string& fault)
{
    return fail(Errc::FileMalformed, "its header " + fault);
}

const PlyType* plyType(std::string_view name)
{
    const auto found = std::find_if(kPlyTypes.begin(), kPlyTypes.end(),
                                    [&](const PlyType& type) { return type.name == name; });
    return found == kPlyTypes.end() ? nullptr : found;
}

Result<void> readProperty(PlyHeader& header, std::string_view line)
{
    if (header.elements.empty())
        return badHeader("has a property before an element");
    std::string_view word = takeWord(line);
    PlyProperty property;
    if (word == "list") {
        const PlyType* count = plyType(takeWord(line));
        if (count == nullptr || !count->integer)
            return badHeader("counts a list in no integer");
        property.countBytes = count->bytes;
        word = takeWord(line);
    }
    const PlyType* value = plyType(word);
    if (value == nullptr)
        return badHeader("has a property of unknown type");
    property.valueBytes = value->bytes;
    const std::string_view name = takeWord(line);
    property.cornerIndices = property.countBytes > 0 && value->integer
                             && (name == "vertex_indices" || name == "vertex_index");
    header.elements.back().properties.push_back(property);
    return {};
}

Result<void> readHeaderLine(PlyHeader& header, std::string_view line)
{
    const std::string_view key = takeWord(line);
    if (key == "property")
        return readProperty(header, line);
    if (key == "format") {
        const std::string_view name = takeWord(line);
        if (name == "ascii")
            header.encoding = PlyEncoding::Ascii;
        else if (name == "binary_little_endian")
            header.encoding = PlyEncoding::LittleEndian;
        else if (name == "binary_big_endian")
            header.encoding = PlyEncoding::BigEndian;
    } else if (key == "element") {
        PlyElement element{std::string{takeWord(line)}, 0, {}};
        const std::string_view count = takeWord(line);
        const auto read = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (read.ec != std::errc{} || read.ptr != count.data() + count.size())
            return badHeader("has an element without a count");
        header.elements.push_back(std::move(element));
    }
    return {};
}

/// Takes the header off the front of `bytes`.
Result<PlyHeader> takeHeader(std::string_view& bytes)
{
    PlyHeader header;
    for (bool first = true; !bytes.empty(); first = false) {
        std::string_view line = takeLine(bytes);
        std::string_view words = line;
        const std::string_view key = takeWord(words);
        if (first && key != "ply")
            return fail(Errc::FileMalformed, "it does not begin with \"ply\"");
        if (key == "end_header") {
            if (!header.encoding)
                return fail(Errc::FileMalformed, "its header names no format");
            return header;
        }
        if (const auto good = readHeaderLine(header, line); !good)
            return tl::unexpected(good.error());
    }
    return fail(Errc::FileMalformed, "truncated: its header does not end");
}

Result<void> endsIn(const PlyElement& element, std::uint64_t index)
{
    return fail(Errc::FileMalformed, "truncated: it ends in " + element.name + " "
                                         + std::to_string(index + 1) + " of "
                                         + std::to_string(element.count));
}

Result<void> namesVertex(std::uint64_t corner, std::uint64_t vertices)
{
    return fail(Errc::FileMalformed, "a face names vertex " + std::to_string(corner) + " of "
                                         + std::to_string(vertices));
}

/// Takes an unsigned integer of 1, 2 or 4 bytes.
std::optional<std::uint64_t> takeInteger(std::string_view& bytes, std::size_t size, bool bigEndian)
{
    if (bytes.size() < size)
        return std::nullopt;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t at = bigEndian ? i : size - 1 - i;
        value = value << 8U | static_cast<unsigned char>(bytes[at]);
    }
    bytes.remove_prefix(size);
    return value;
}

/// Takes one value or list off the front; nothing when it is not there whole.
std::optional<std::vector<std::uint64_t>> takeProperty(std::string_view& bytes,
                                                       const PlyProperty& property, bool bigEndian)
{
    std::uint64_t values = 1;
    if (property.countBytes > 0) {
        const auto count = takeInteger(bytes, property.countBytes, bigEndian);
        if (!count)
            return std::nullopt;
        values = *count;
    }
    if (values > bytes.size() / property.valueBytes)
        return std::nullopt;
    std::vector<std::uint64_t> corners;
    if (property.cornerIndices)
        for (std::uint64_t i = 0; i < values; ++i)
            corners.push_back(*takeInteger(bytes, property.valueBytes, bigEndian));
    else
        bytes.remove_prefix(values * property.valueBytes);
    return corners;
}

Result<void> walkBinary(const PlyHeader& header, std::string_view bytes)
{
    const std::uint64_t vertices = header.vertices();
    for (const PlyElement& element : header.elements) {
        if (!element.properties.empty() && element.count > bytes.size())
            return endsIn(element, bytes.size());
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            for (const PlyProperty& property : element.properties) {
                const auto corners =
                    takeProperty(bytes, property, header.encoding == PlyEncoding::BigEndian);
                if (!corners)
                    return endsIn(element, i);
                for (const std::uint64_t corner : *corners)
                    if (corner >= vertices)
                        return namesVertex(corner, vertices);
            }
        }
    }
    return {};
}

Result<void> walkAsciiLine(const PlyElement& element, std::string_view line, std::uint64_t index,
                           std::uint64_t vertices)
{
    for (const PlyProperty& property : element.properties) {
        std::uint64_t values = 1;
        if (property.countBytes > 0) {
            const std::string_view word = takeWord(line);
            const auto read = std::from_chars(word.data(), word.data() + word.size(), values);
            if (read.ec != std::errc{})
                return endsIn(element, index);
        }
        for (std::uint64_t i = 0; i < values; ++i) {
            const std::string_view word = takeWord(line);
            std::uint64_t corner = 0;
            const auto read = std::from_chars(word.data(), word.data() + word.size(), corner);
            if (word.empty() || (property.cornerIndices && read.ec != std::errc{}))
                return endsIn(element, index);
            if (property.cornerIndices && corner >= vertices)
                return namesVertex(corner, vertices);
        }
    }
    return {};
}

Result<void> walkAscii(const PlyHeader& header, std::string_view bytes)
{
    for (const PlyElement& element : header.elements) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (bytes.empty())
                return endsIn(element, i);
            if (auto good = walkAsciiLine(element, takeLine(bytes), i, header.vertices()); !good)
                return good;
        }
    }
    return {};
}

} // namespace

Result<void> checkPly(std::string_view bytes)
{
    const Result<PlyHeader> header = takeHeader(bytes);
    if (!header)
        return tl::unexpected(header.error());
    return header->encoding == PlyEncoding::Ascii ? walkAscii(*header, bytes)
                                                  : walkBinary(*header, bytes);
}

} // namespace carina
