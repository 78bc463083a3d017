#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace carina::test
{

/// A tetrahedron with three edges of `size` along x, y and z from (x, y, z): volume size^3 / 6.
/// Written out here in every format by hand, so that readers are judged by what was meant.
struct Tetrahedron {
    float size = 1.0F;
    float x = 0.0F;
    float y = 0.0F;
    float z = 0.0F;

    [[nodiscard]] std::vector<float> coordinates() const
    {
        return {x, y, z, x + size, y, z, x, y + size, z, x, y, z + size};
    }
    [[nodiscard]] static std::vector<std::uint32_t> corners()
    {
        return {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    }
};

inline void writeFile(const std::filesystem::path& file, const std::string& bytes)
{
    std::filesystem::create_directories(file.parent_path());
    std::ofstream{file, std::ios::binary} << bytes;
}

/// The bytes of a number as this (little-endian) machine has them, or turned about.
template <class Number> std::string bytesOf(Number number, bool bigEndian = false)
{
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    return bigEndian ? std::string{bytes.rbegin(), bytes.rend()} : bytes;
}

inline std::string objOf(const Tetrahedron& solid, std::uint32_t firstVertex = 1)
{
    std::string text;
    const auto p = solid.coordinates();
    for (std::size_t i = 0; i < p.size(); i += 3)
        text += "v " + std::to_string(p[i]) + ' ' + std::to_string(p[i + 1]) + ' '
                + std::to_string(p[i + 2]) + '\n';
    const auto c = Tetrahedron::corners();
    for (std::size_t i = 0; i < c.size(); i += 3)
        text += "f " + std::to_string(c[i] + firstVertex) + ' '
                + std::to_string(c[i + 1] + firstVertex) + ' '
                + std::to_string(c[i + 2] + firstVertex) + '\n';
    return text;
}

inline std::string plyHeader(const std::string& format, const std::string& comments = {})
{
    return "ply\nformat " + format + " 1.0\n" + comments
           + "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string asciiPlyOf(const Tetrahedron& solid, const std::string& comments = {})
{
    std::string text = plyHeader("ascii", comments);
    const auto p = solid.coordinates();
    for (std::size_t i = 0; i < p.size(); i += 3)
        text += std::to_string(p[i]) + ' ' + std::to_string(p[i + 1]) + ' '
                + std::to_string(p[i + 2]) + '\n';
    const auto c = Tetrahedron::corners();
    for (std::size_t i = 0; i < c.size(); i += 3)
        text += "3 " + std::to_string(c[i]) + ' ' + std::to_string(c[i + 1]) + ' '
                + std::to_string(c[i + 2]) + '\n';
    return text;
}

inline std::string binaryPlyOf(const Tetrahedron& solid, bool bigEndian)
{
    std::string bytes = plyHeader(bigEndian ? "binary_big_endian" : "binary_little_endian");
    for (const float p : solid.coordinates())
        bytes += bytesOf(p, bigEndian);
    const auto c = Tetrahedron::corners();
    for (std::size_t i = 0; i < c.size(); ++i)
        bytes += (i % 3 == 0 ? std::string{'\3'} : std::string{}) + bytesOf(c[i], bigEndian);
    return bytes;
}

inline std::string asciiStlOf(const Tetrahedron& solid, const std::string& name)
{
    std::string text = "solid " + name + '\n';
    const auto p = solid.coordinates();
    const auto c = Tetrahedron::corners();
    for (std::size_t i = 0; i < c.size(); ++i) {
        text += i % 3 == 0 ? "facet normal 0 0 0\nouter loop\n" : "";
        text += "vertex";
        for (int axis = 0; axis < 3; ++axis)
            text += ' ' + std::to_string(p[3 * c[i] + axis]);
        text += i % 3 == 2 ? "\nendloop\nendfacet\n" : "\n";
    }
    return text + "endsolid " + name + '\n';
}

inline std::string binaryStlOf(const Tetrahedron& solid)
{
    std::string bytes(80, ' ');
    bytes += bytesOf(std::uint32_t{4});
    const auto p = solid.coordinates();
    const auto c = Tetrahedron::corners();
    for (std::size_t i = 0; i < c.size(); ++i) {
        bytes += i % 3 == 0 ? std::string(12, '\0') : std::string{};
        for (int axis = 0; axis < 3; ++axis)
            bytes += bytesOf(p[3 * c[i] + axis]);
        bytes += i % 3 == 2 ? std::string(2, '\0') : std::string{};
    }
    return bytes;
}

/// What the buffer of gltfJson holds: 48 bytes of positions, 24 of corners.
inline std::string gltfBuffer(const Tetrahedron& solid)
{
    std::string bytes;
    for (const float p : solid.coordinates())
        bytes += bytesOf(p);
    for (const std::uint32_t c : Tetrahedron::corners())
        bytes += bytesOf(static_cast<std::uint16_t>(c));
    return bytes;
}

/// Two nodes with the same surface: "Trachea" as it is, "Left lung" moved by (5, 0, 0).
inline std::string gltfJson(const std::string& uri)
{
    return R"({"asset":{"version":"2.0","copyright":"CC BY 4.0, Somebody"},"scene":0,)"
           R"("scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"name":"Trachea"},)"
           R"({"mesh":0,"name":"Left lung","translation":[5,0,0]}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
           R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":48},)"
           R"({"buffer":0,"byteOffset":48,"byteLength":24}],"buffers":[{)"
           + (uri.empty() ? std::string{} : "\"uri\":\"" + uri + "\",") + R"("byteLength":72}]})";
}

inline std::string glbOf(const Tetrahedron& solid)
{
    std::string json = gltfJson({});
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::string buffer = gltfBuffer(solid);
    const auto length = static_cast<std::uint32_t>(28 + json.size() + buffer.size());
    return "glTF" + bytesOf(std::uint32_t{2}) + bytesOf(length)
           + bytesOf(static_cast<std::uint32_t>(json.size())) + "JSON" + json
           + bytesOf(static_cast<std::uint32_t>(buffer.size())) + std::string{"BIN\0", 4} + buffer;
}

} // namespace carina::test
