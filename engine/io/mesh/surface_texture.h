#pragma once

#include "engine/core/result.h"
#include "engine/geometry/mesh/vertex_color.h"
#include "engine/io/mesh/picture_codec.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

struct aiMaterial;
struct aiMesh;
struct aiScene;

namespace carina
{

/// What colours the vertices of a scene's meshes have: by a texture, by themselves, or by their
/// material, in this order.
///
/// A texture is averaged down until about one texel lies in a triangle, so that a vertex has the
/// colour of what is around it. Pictures lie in the scene or in the folder of its file, nowhere
/// else.
class SurfaceTexture
{
public:
    /// @param linear the scene's plain colours are linear, and multiply its textures, as in glTF;
    ///        else they are sRGB, and a texture counts alone
    SurfaceTexture(const aiScene& scene, std::filesystem::path folder, bool linear);

    /// One colour per vertex.
    [[nodiscard]] std::vector<Rgb> colorsOf(const aiMesh& mesh);

    /// Why pictures that were asked for cannot be used, each once.
    [[nodiscard]] std::vector<Error> faults() const;

private:
    const Picture* pictureOf(const aiMaterial& material);
    [[nodiscard]] Result<Picture> readPicture(const std::string& name) const;

    const aiScene& m_scene;
    std::filesystem::path m_folder;
    bool m_linear;
    std::map<std::string, Result<Picture>> m_pictures;
};

} // namespace carina
