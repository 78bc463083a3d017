#include "engine/io/mesh/mesh_file_codec.h"

#include "engine/io/mesh/mesh_codec.h"

#include <utility>

namespace carina
{
namespace
{

enum class Answer : std::uint8_t { Surfaces, Failure };

bool isTooMuch(const MeshFile& file)
{
    return file.surfaces.size() > kMostParts || file.attributions.size() > kMostParts
           || file.textureFaults.size() > kMostParts;
}

std::uint32_t readCount(ByteReader& reader)
{
    const auto count = reader.number<std::uint32_t>();
    reader.require(count <= kMostParts, "not too many parts");
    return count;
}

MeshFile readSurfaces(ByteReader& reader)
{
    MeshFile file;
    for (auto left = readCount(reader); left > 0 && reader.ok(); --left) {
        NamedSurface surface;
        surface.name = readText(reader);
        surface.conceptId = readText(reader);
        surface.mesh = readMesh(reader);
        surface.colors = readColors(reader, surface.mesh.positions.size());
        file.surfaces.push_back(std::move(surface));
    }
    for (auto left = readCount(reader); left > 0 && reader.ok(); --left)
        file.attributions.push_back(readText(reader));
    for (auto left = readCount(reader); left > 0 && reader.ok(); --left)
        file.textureFaults.push_back(readFileError(reader));
    return file;
}

} // namespace

std::vector<std::byte> encodeMeshFile(const Result<MeshFile>& file)
{
    if (file && isTooMuch(*file))
        return encodeMeshFile(fail(Errc::FileTooLarge, "it has too many parts"));
    std::vector<std::byte> bytes;
    ByteWriter writer{bytes};
    if (!file) {
        writer.number(static_cast<std::uint8_t>(Answer::Failure));
        writeFileError(writer, file.error());
        return bytes;
    }
    writer.number(static_cast<std::uint8_t>(Answer::Surfaces));
    writer.number(static_cast<std::uint32_t>(file->surfaces.size()));
    for (const NamedSurface& surface : file->surfaces) {
        writeText(writer, surface.name);
        writeText(writer, surface.conceptId);
        writeMesh(writer, surface.mesh);
        writeColors(writer, surface.colors);
    }
    writer.number(static_cast<std::uint32_t>(file->attributions.size()));
    for (const std::string& line : file->attributions)
        writeText(writer, line);
    writer.number(static_cast<std::uint32_t>(file->textureFaults.size()));
    for (const Error& fault : file->textureFaults)
        writeFileError(writer, fault);
    return bytes;
}

Result<Result<MeshFile>> decodeMeshFile(std::span<const std::byte> bytes)
{
    ByteReader reader{bytes};
    const auto answer = static_cast<Answer>(reader.number<std::uint8_t>());
    reader.require(answer == Answer::Surfaces || answer == Answer::Failure, "a known answer");
    if (answer == Answer::Failure) {
        Error error = readFileError(reader);
        reader.require(reader.remaining() == 0, "nothing follows");
        if (reader.ok())
            return Result<MeshFile>{tl::unexpected(std::move(error))};
    }
    MeshFile file = readSurfaces(reader);
    reader.require(reader.remaining() == 0, "nothing follows");
    if (!reader.ok())
        return fail(Errc::FileMalformed,
                    std::string{"its reader broke a rule: "} + reader.brokenRule());
    return Result<MeshFile>{std::move(file)};
}

} // namespace carina
