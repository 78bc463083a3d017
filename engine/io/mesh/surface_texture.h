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

/// Colours of the vertices of a scene's meshes: from a texture, the vertices or the material, in
/// this order of preference.
///
/// A texture is reduced by averaging to about one texel per triangle, so that the colour of a
/// vertex is that of its surroundings. Pictures are read from the scene or the folder of its file
/// only.
class SurfaceTexture
{
public:
    /// @param linear the scene's plain colours are linear and multiply its textures, as in glTF;
    ///        otherwise they are sRGB and are not used with a texture
    SurfaceTexture(const aiScene& scene, std::filesystem::path folder, bool linear);

    /// One colour per vertex.
    [[nodiscard]] std::vector<Rgb> colorsOf(const aiMesh& mesh);

    /// Why pictures could not be used, one error for each.
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
