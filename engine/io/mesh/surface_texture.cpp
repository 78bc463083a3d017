#include "engine/io/mesh/surface_texture.h"

#include "engine/io/files/folder_path.h"
#include "engine/io/files/whole_file.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <QByteArray>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr float kBrightest = 255.0F;

/// IEC 61966-2-1, both ways, from 0 to 1.
float linearOf(float srgb)
{
    return srgb <= 0.04045F ? srgb / 12.92F : std::pow((srgb + 0.055F) / 1.055F, 2.4F);
}
float srgbOf(float linear)
{
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

Vec3f eachOf(const Vec3f& color, float (*function)(float))
{
    return {function(color[0]), function(color[1]), function(color[2])};
}

Vec3f unitOf(const aiColor4D& color) { return {color.r, color.g, color.b}; }

Rgb rgbOf(const Vec3f& unit)
{
    Rgb color{};
    for (int channel = 0; channel < 3; ++channel) {
        const float value = std::isfinite(unit[channel]) ? unit[channel] : 0.0F;
        color[std::size_t(channel)] =
            static_cast<std::uint8_t>(std::lround(kBrightest * std::clamp(value, 0.0F, 1.0F)));
    }
    return color;
}

/// The picture with squares of `factor` pixels averaged to one; what is left at its edges counts
/// with the last square.
Picture averagedDown(const Picture& picture, std::size_t factor)
{
    Picture small{std::max<std::size_t>(1, picture.width / factor),
                  std::max<std::size_t>(1, picture.height / factor),
                  {}};
    std::vector<Vec3f> sums(small.width * small.height, Vec3f::Zero());
    std::vector<float> counts(sums.size(), 0.0F);
    for (std::size_t y = 0; y < picture.height; ++y)
        for (std::size_t x = 0; x < picture.width; ++x) {
            const std::size_t to = std::min(y / factor, small.height - 1) * small.width
                                   + std::min(x / factor, small.width - 1);
            const Rgb& pixel = picture.pixels[y * picture.width + x];
            sums[to] += Vec3f(pixel[0], pixel[1], pixel[2]);
            counts[to] += 1.0F;
        }
    for (std::size_t i = 0; i < sums.size(); ++i)
        small.pixels.push_back(rgbOf(sums[i] / (counts[i] * kBrightest)));
    return small;
}

/// Pixels of the picture along the side of a square as large as a triangle of the mesh is in it.
std::size_t pixelsPerTriangle(const Picture& picture, const aiMesh& mesh, const aiVector3D* uv)
{
    double area = 0.0;
    std::size_t triangles = 0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3 || std::any_of(face.mIndices, face.mIndices + 3, [&](unsigned v) {
                return v >= mesh.mNumVertices;
            }))
            continue;
        const aiVector3D a = uv[face.mIndices[1]] - uv[face.mIndices[0]];
        const aiVector3D b = uv[face.mIndices[2]] - uv[face.mIndices[0]];
        area += 0.5 * std::abs(double(a.x) * double(b.y) - double(a.y) * double(b.x));
        ++triangles;
    }
    const double pixels = area * double(picture.width) * double(picture.height);
    const double side = std::sqrt(pixels / double(std::max<std::size_t>(1, triangles)));
    const double most = double(std::max(picture.width, picture.height));
    return std::isfinite(side) ? std::size_t(std::clamp(side, 1.0, most)) : 1;
}

/// Of a texture that repeats: which of `count` pixels lie on either side of a place, and how far
/// from the first to the second it is.
struct Between {
    std::size_t first, second;
    float way;
};

Between pixelsAround(float place, std::size_t count)
{
    const float within = std::isfinite(place) ? place - std::floor(place) : 0.0F;
    const float at = within * static_cast<float>(count) - 0.5F + static_cast<float>(count);
    const auto below = static_cast<std::size_t>(at);
    return {below % count, (below + 1) % count, at - std::floor(at)};
}

/// Bilinear; v runs upwards, as in OBJ.
Vec3f sampled(const Picture& picture, const aiVector3D& uv)
{
    const Between x = pixelsAround(uv.x, picture.width);
    const Between y = pixelsAround(1.0F - uv.y, picture.height);
    const auto at = [&](std::size_t column, std::size_t row) -> Vec3f {
        const Rgb& pixel = picture.pixels[row * picture.width + column];
        return Vec3f(pixel[0], pixel[1], pixel[2]) / kBrightest;
    };
    const Vec3f upper = (1.0F - x.way) * at(x.first, y.first) + x.way * at(x.second, y.first);
    const Vec3f lower = (1.0F - x.way) * at(x.first, y.second) + x.way * at(x.second, y.second);
    return (1.0F - y.way) * upper + y.way * lower;
}

/// Where the diffuse texture of a mesh lies on it; null where it has none.
const aiVector3D* textureCoordinates(const aiMaterial& material, const aiMesh& mesh)
{
    int channel = 0;
    aiGetMaterialInteger(&material, AI_MATKEY_UVWSRC(aiTextureType_DIFFUSE, 0), &channel);
    if (channel < 0 || channel >= AI_MAX_NUMBER_OF_TEXTURECOORDS)
        return nullptr;
    return mesh.mTextureCoords[channel];
}

} // namespace

SurfaceTexture::SurfaceTexture(const aiScene& scene, std::filesystem::path folder, bool linear)
    : m_scene(scene), m_folder(std::move(folder)), m_linear(linear)
{
}

Result<Picture> SurfaceTexture::readPicture(const std::string& name) const
{
    if (const aiTexture* inside = m_scene.GetEmbeddedTexture(name.c_str())) {
        if (inside->mHeight != 0)
            return fail(Errc::UnknownFormat, "a picture without a format");
        return decodePicture({reinterpret_cast<const char*>(inside->pcData), inside->mWidth});
    }
    std::string decoded =
        QByteArray::fromPercentEncoding(QByteArray::fromStdString(name)).toStdString();
    if (decoded.starts_with('/') || decoded.find("..") != std::string::npos
        || decoded.find('\\') != std::string::npos) // as another machine knows it
        decoded.erase(0, decoded.find_last_of("/\\") + 1);
    const auto bytes =
        pathWithin(m_folder, decoded).and_then([](const std::filesystem::path& file) {
            return readWholeFile(file, kPictureLimit);
        });
    if (!bytes && bytes.error().code == Errc::FileNotFound)
        return fail(Errc::FileNotFound,
                    "there is no such picture in the folder of the file that names it");
    if (!bytes)
        return tl::unexpected(bytes.error());
    return decodePicture(*bytes);
}

const Picture* SurfaceTexture::pictureOf(const aiMaterial& material)
{
    aiString path;
    if (material.GetTexture(aiTextureType_DIFFUSE, 0, &path) != aiReturn_SUCCESS)
        return nullptr;
    const std::string name = path.C_Str();
    auto found = m_pictures.find(name);
    if (found == m_pictures.end())
        found = m_pictures.emplace(name, readPicture(name)).first;
    return found->second ? &*found->second : nullptr;
}

std::vector<Rgb> SurfaceTexture::colorsOf(const aiMesh& mesh)
{
    std::vector<Rgb> colors(mesh.mNumVertices);
    if (mesh.mMaterialIndex >= m_scene.mNumMaterials)
        return colors;
    const aiMaterial& material = *m_scene.mMaterials[mesh.mMaterialIndex];
    const aiVector3D* uv = textureCoordinates(material, mesh);
    const Picture* whole = uv != nullptr ? pictureOf(material) : nullptr;
    const aiColor4D* own = mesh.mColors[0];
    aiColor4D plain{1.0F, 1.0F, 1.0F, 1.0F};
    if (m_linear || (whole == nullptr && own == nullptr))
        material.Get(AI_MATKEY_COLOR_DIFFUSE, plain);
    std::optional<Picture> picture;
    if (whole != nullptr)
        picture = averagedDown(*whole, pixelsPerTriangle(*whole, mesh, uv));
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        Vec3f color = unitOf(plain);
        if (own != nullptr && (m_linear || !picture))
            color = color.cwiseProduct(unitOf(own[i]));
        if (picture) {
            const Vec3f texel = sampled(*picture, uv[i]);
            color = color.cwiseProduct(m_linear ? eachOf(texel, &linearOf) : texel);
        }
        colors[i] = rgbOf(m_linear ? eachOf(color, &srgbOf) : color);
    }
    return colors;
}

std::vector<Error> SurfaceTexture::faults() const
{
    std::vector<Error> faults;
    for (const auto& [name, picture] : m_pictures)
        if (!picture)
            faults.push_back({picture.error().code, name + ": " + picture.error().detail});
    return faults;
}

} // namespace carina
