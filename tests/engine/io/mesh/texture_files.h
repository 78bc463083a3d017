#pragma once

#include "tests/engine/io/mesh/surface_files.h"

#include <png.h>
#include <turbojpeg.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace carina::test
{

using Pixel = std::array<unsigned char, 3>;

/// A square picture by what it shows at (u, v), both from 0 to 1, v upwards.
template <class ColorAt> std::vector<Pixel> pixelsOf(int side, const ColorAt& colorAt)
{
    std::vector<Pixel> pixels;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            pixels.push_back(colorAt((column + 0.5) / side, 1.0 - (row + 0.5) / side));
    return pixels;
}

inline std::string pngOf(int side, const std::vector<Pixel>& pixels)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = static_cast<png_uint_32>(side);
    image.format = PNG_FORMAT_RGB;
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t length = bytes.size();
    png_image_write_to_memory(&image, bytes.data(), &length, 0, pixels.data(), 0, nullptr);
    bytes.resize(length);
    return bytes;
}

inline std::string jpegOf(int side, const std::vector<Pixel>& pixels)
{
    constexpr int kQuality = 95;
    const tjhandle encoder = tjInitCompress();
    unsigned char* data = nullptr;
    unsigned long length = 0;
    tjCompress2(encoder, pixels.front().data(), side, 0, side, TJPF_RGB, &data, &length, TJSAMP_444,
                kQuality, 0);
    std::string bytes{reinterpret_cast<const char*>(data), length};
    tjFree(data);
    tjDestroy(encoder);
    return bytes;
}

/// Where a point of a ball lies in its picture: the ball is seen from the front.
inline std::array<double, 2> placeInPicture(double x, double z)
{
    constexpr double kShare = 0.4; // of the picture, from its middle: its edges are not used
    return {0.5 + kShare * x, 0.5 + kShare * z};
}

/// A closed ball with texture coordinates, about (0, 0, z).
inline std::string texturedBallObj(double radius, double z, const std::string& head)
{
    constexpr int kRound = 64;
    constexpr int kUp = 32;
    std::string text = head;
    std::string places;
    for (int i = 0; i <= kUp; ++i)
        for (int k = 0; k < kRound; ++k) {
            const double tilt = std::numbers::pi * i / kUp;
            const double turn = 2.0 * std::numbers::pi * k / kRound;
            const double x = std::sin(tilt) * std::cos(turn);
            const double y = std::sin(tilt) * std::sin(turn);
            const auto [u, v] = placeInPicture(x, std::cos(tilt));
            text += "v " + std::to_string(radius * x) + ' ' + std::to_string(radius * y) + ' '
                    + std::to_string(z + radius * std::cos(tilt)) + '\n';
            places += "vt " + std::to_string(u) + ' ' + std::to_string(v) + '\n';
        }
    text += places;
    const auto corner = [](int i, int k) {
        const std::string index = std::to_string(1 + i * kRound + k % kRound);
        return ' ' + index + '/' + index;
    };
    for (int i = 0; i < kUp; ++i)
        for (int k = 0; k < kRound; ++k)
            text += "f" + corner(i, k) + corner(i + 1, k) + corner(i + 1, k + 1) + corner(i, k + 1)
                    + '\n';
    return text;
}

/// The solid of gltfJson with a texture, which the JSON names, and a base colour factor: three
/// corners lie in the upper left of the picture, one in the lower right.
inline std::string texturedGltf(const Tetrahedron& solid, const std::string& picture)
{
    std::string buffer = gltfBuffer(solid);
    for (const float place : {0.25F, 0.25F, 0.26F, 0.25F, 0.25F, 0.26F, 0.75F, 0.75F})
        buffer += bytesOf(place); // v downwards
    writeFile(picture.substr(0, picture.rfind('/')) + "/textured.bin", buffer);
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
           R"("nodes":[{"mesh":0,"name":"Trachea"}],"meshes":[{"primitives":[{"attributes":)"
           R"({"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":0}]}],)"
           R"("materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,1,1],)"
           R"("baseColorTexture":{"index":0}}}],"textures":[{"source":0}],"images":[{"uri":")"
           + picture.substr(picture.rfind('/') + 1)
           + R"("}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
             R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"},)"
             R"({"bufferView":2,"componentType":5126,"count":4,"type":"VEC2"}],)"
             R"("bufferViews":[{"buffer":0,"byteLength":48},)"
             R"({"buffer":0,"byteOffset":48,"byteLength":24},)"
             R"({"buffer":0,"byteOffset":72,"byteLength":32}],)"
             R"("buffers":[{"uri":"textured.bin","byteLength":104}]})";
}

} // namespace carina::test
