#include "engine/tracking/igtl/igtl_content.h"

namespace carina
{
namespace
{

constexpr std::size_t kWord = 4;
constexpr std::size_t kPointBytes = 3 * kWord;
constexpr std::size_t kAttributeBytes = 6; ///< of what precedes names and values

/// How many cells of which size follow.
struct CellSizes {
    std::uint32_t count = 0;
    std::uint32_t bytes = 0;
};

IgtlCells readCells(IgtlBytes& bytes, const CellSizes& sizes, std::size_t points)
{
    IgtlCells cells{sizes.count, {}};
    bytes.require(sizes.bytes % kWord == 0 && sizes.bytes <= bytes.remaining(), "size of cells");
    if (!bytes.ok())
        return {};
    cells.numbers.reserve(sizes.bytes / kWord);
    IgtlBytes part = bytes.part(sizes.bytes);
    for (std::uint32_t cell = 0; cell < sizes.count && part.ok(); ++cell) {
        const auto corners = part.number<std::uint32_t>();
        part.require(corners <= part.remaining() / kWord, "corners of a cell");
        cells.numbers.push_back(corners);
        for (std::uint32_t i = 0; i < corners && part.ok(); ++i) {
            cells.numbers.push_back(part.number<std::uint32_t>());
            part.require(cells.numbers.back() < points, "number of a point");
        }
    }
    bytes.require(part.ok() && part.remaining() == 0, "cells");
    return cells;
}

std::string readName(IgtlBytes& bytes)
{
    std::string name;
    while (bytes.ok()) {
        const auto c = bytes.number<char>();
        if (c == '\0')
            break;
        name += c;
    }
    return name;
}

std::vector<IgtlAttribute> readAttributes(IgtlBytes& bytes, std::uint32_t count)
{
    bytes.require(count <= bytes.remaining() / kAttributeBytes, "number of attributes");
    if (!bytes.ok())
        return {};
    std::vector<IgtlAttribute> attributes(count);
    for (IgtlAttribute& attribute : attributes) {
        attribute.type = bytes.number<std::uint8_t>();
        attribute.components = bytes.number<std::uint8_t>();
        attribute.count = bytes.number<std::uint32_t>();
    }
    std::size_t nameBytes = 0;
    for (IgtlAttribute& attribute : attributes) {
        attribute.name = readName(bytes);
        nameBytes += attribute.name.size() + 1;
    }
    if (nameBytes % 2 == 1)
        bytes.require(bytes.number<std::uint8_t>() == 0, "end of the names");
    for (IgtlAttribute& attribute : attributes) {
        const std::uint64_t values = std::uint64_t{attribute.count} * attribute.components;
        bytes.require(values <= bytes.remaining() / kWord, "values of an attribute");
        if (!bytes.ok())
            return {};
        attribute.values.resize(values);
        for (float& value : attribute.values)
            value = bytes.real();
    }
    return attributes;
}

void writeAttributes(IgtlWriter& out, const std::vector<IgtlAttribute>& attributes)
{
    std::size_t nameBytes = 0;
    for (const IgtlAttribute& attribute : attributes) {
        out.number(attribute.type);
        out.number(attribute.components);
        out.number(attribute.count);
    }
    for (const IgtlAttribute& attribute : attributes) {
        out.field(attribute.name, attribute.name.size() + 1);
        nameBytes += attribute.name.size() + 1;
    }
    if (nameBytes % 2 == 1)
        out.number(std::uint8_t{0});
    for (const IgtlAttribute& attribute : attributes)
        out.reals(attribute.values);
}

} // namespace

IgtlPolyData readPolyData(IgtlBytes& bytes)
{
    IgtlPolyData data;
    const auto points = bytes.number<std::uint32_t>();
    std::array<CellSizes, 4> sizes;
    for (CellSizes& each : sizes) {
        each.count = bytes.number<std::uint32_t>();
        each.bytes = bytes.number<std::uint32_t>();
    }
    const auto attributes = bytes.number<std::uint32_t>();
    bytes.require(points <= bytes.remaining() / kPointBytes, "number of points");
    if (!bytes.ok())
        return {};
    data.points.resize(points);
    for (auto& point : data.points)
        point = bytes.reals<3>();
    for (std::size_t i = 0; i < sizes.size(); ++i)
        data.cells[i] = readCells(bytes, sizes[i], points);
    data.attributes = readAttributes(bytes, attributes);
    return data;
}

void writePolyData(IgtlWriter& out, const IgtlPolyData& data)
{
    out.number(static_cast<std::uint32_t>(data.points.size()));
    for (const IgtlCells& cells : data.cells) {
        out.number(cells.count);
        out.number(static_cast<std::uint32_t>(kWord * cells.numbers.size()));
    }
    out.number(static_cast<std::uint32_t>(data.attributes.size()));
    for (const auto& point : data.points)
        out.reals(point);
    for (const IgtlCells& cells : data.cells)
        for (const std::uint32_t number : cells.numbers)
            out.number(number);
    writeAttributes(out, data.attributes);
}

} // namespace carina
