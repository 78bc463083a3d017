#include "engine/io/mesh_file_codec.h"

#include "engine/io/mesh_codec.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

enum class Answer : std::uint8_t { Surfaces, Failure };

/// What readMeshFile fails with.
constexpr std::array kFailures{Errc::NotFinite, Errc::FileNotFound,  Errc::FileUnreadable,
                               Errc::FileEmpty, Errc::FileMalformed, Errc::UnknownFormat};

MeshFile readSurfaces(ByteReader& reader)
{
    MeshFile file;
    for (auto left = reader.number<std::uint32_t>(); left > 0 && reader.ok(); --left) {
        NamedSurface surface;
        surface.name = readText(reader);
        surface.conceptId = readText(reader);
        surface.mesh = readMesh(reader);
        file.surfaces.push_back(std::move(surface));
    }
    for (auto left = reader.number<std::uint32_t>(); left > 0 && reader.ok(); --left)
        file.attributions.push_back(readText(reader));
    return file;
}

} // namespace

std::vector<std::byte> encodeMeshFile(const Result<MeshFile>& file)
{
    std::vector<std::byte> bytes;
    ByteWriter writer{bytes};
    if (!file) {
        writer.number(static_cast<std::uint8_t>(Answer::Failure));
        writer.number(static_cast<std::uint8_t>(file.error().code));
        writeText(writer, file.error().detail);
        return bytes;
    }
    writer.number(static_cast<std::uint8_t>(Answer::Surfaces));
    writer.number(static_cast<std::uint32_t>(file->surfaces.size()));
    for (const NamedSurface& surface : file->surfaces) {
        writeText(writer, surface.name);
        writeText(writer, surface.conceptId);
        writeMesh(writer, surface.mesh);
    }
    writer.number(static_cast<std::uint32_t>(file->attributions.size()));
    for (const std::string& line : file->attributions)
        writeText(writer, line);
    return bytes;
}

Result<MeshFile> decodeMeshFile(std::span<const std::byte> bytes)
{
    ByteReader reader{bytes};
    const auto answer = static_cast<Answer>(reader.number<std::uint8_t>());
    reader.require(answer == Answer::Surfaces || answer == Answer::Failure, "a known answer");
    if (answer == Answer::Failure) {
        const auto code = static_cast<Errc>(reader.number<std::uint8_t>());
        reader.require(std::find(kFailures.begin(), kFailures.end(), code) != kFailures.end(),
                       "a known failure");
        std::string detail = readText(reader);
        if (reader.ok())
            return fail(code, std::move(detail));
    }
    MeshFile file = readSurfaces(reader);
    reader.require(reader.remaining() == 0, "nothing follows");
    if (!reader.ok())
        return fail(Errc::FileMalformed,
                    std::string{"its reader broke a rule: "} + reader.brokenRule());
    return file;
}

} // namespace carina
