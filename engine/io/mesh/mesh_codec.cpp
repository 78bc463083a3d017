#include "engine/io/mesh/mesh_codec.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>

namespace carina
{
namespace
{

static_assert(std::endian::native == std::endian::little,
              "vertices are copied as they lie in memory");
static_assert(sizeof(Vec3f) == 12 && sizeof(Triangle) == 12 && sizeof(Rgb) == 3);

/// Their places here are in files: add at the end.
constexpr std::array kFileErrors{Errc::NotFinite,    Errc::FileNotFound,  Errc::FileUnreadable,
                                 Errc::FileEmpty,    Errc::FileMalformed, Errc::UnknownFormat,
                                 Errc::FileTooLarge, Errc::NotConfined};

template <class Item> void writeItems(ByteWriter& writer, const std::vector<Item>& items)
{
    writer.number(static_cast<std::uint32_t>(items.size()));
    writer.bytes(std::as_bytes(std::span{items}));
}

template <class Item> std::vector<Item> readItems(ByteReader& reader)
{
    const auto count = reader.number<std::uint32_t>();
    const std::span<const std::byte> bytes = reader.bytes(std::size_t{count} * sizeof(Item));
    std::vector<Item> items(bytes.size() / sizeof(Item));
    if (!items.empty())
        std::memcpy(static_cast<void*>(items.data()), bytes.data(), bytes.size());
    return items;
}

} // namespace

void writeText(ByteWriter& writer, std::string_view text)
{
    writer.number(static_cast<std::uint32_t>(text.size()));
    writer.bytes(std::as_bytes(std::span{text}));
}

std::string readText(ByteReader& reader)
{
    const std::span<const std::byte> bytes = reader.bytes(reader.number<std::uint32_t>());
    std::string text(bytes.size(), '\0');
    if (!text.empty())
        std::memcpy(text.data(), bytes.data(), bytes.size());
    return text;
}

void writeMesh(ByteWriter& writer, const TriangleMesh& mesh)
{
    writeItems(writer, mesh.positions);
    writeItems(writer, mesh.normals);
    writeItems(writer, mesh.triangles);
}

TriangleMesh readMesh(ByteReader& reader)
{
    TriangleMesh mesh;
    mesh.positions = readItems<Vec3f>(reader);
    mesh.normals = readItems<Vec3f>(reader);
    mesh.triangles = readItems<Triangle>(reader);
    std::uint32_t highest = 0;
    for (const Triangle& t : mesh.triangles)
        highest = std::max({highest, t[0], t[1], t[2]});
    reader.require(mesh.triangles.empty() || highest < mesh.positions.size(),
                   "a corner is a vertex");
    reader.require(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size(),
                   "a vertex has a normal");
    return mesh;
}

void writeColors(ByteWriter& writer, const std::vector<Rgb>& colors) { writeItems(writer, colors); }

std::vector<Rgb> readColors(ByteReader& reader, std::size_t vertices)
{
    auto colors = readItems<Rgb>(reader);
    reader.require(colors.empty() || colors.size() == vertices, "a vertex has a colour");
    return colors;
}

void writeFileError(ByteWriter& writer, const Error& error)
{
    const auto known = std::find(kFileErrors.begin(), kFileErrors.end(), error.code);
    CARINA_EXPECTS(known != kFileErrors.end());
    writer.number(static_cast<std::uint8_t>(known - kFileErrors.begin()));
    writeText(writer, error.detail);
}

Error readFileError(ByteReader& reader)
{
    const auto place = reader.number<std::uint8_t>();
    reader.require(place < kFileErrors.size(), "a known failure");
    return {reader.ok() ? kFileErrors[place] : Errc::FileMalformed, readText(reader)};
}

} // namespace carina
