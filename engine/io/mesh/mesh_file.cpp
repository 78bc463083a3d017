#include "engine/io/mesh/mesh_file.h"

#include "engine/geometry/mesh/mesh_weld.h"
#include "engine/io/files/file_limit.h"
#include "engine/io/files/folder_path.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/mesh/surface_check.h"
#include "engine/io/mesh/surface_format.h"
#include "engine/io/mesh/surface_text.h"
#include "engine/io/mesh/surface_texture.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/commonMetaData.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>

namespace carina
{
namespace
{

Result<void> checkFormat(SurfaceFormat format, const std::string& bytes,
                         const std::filesystem::path& folder)
{
    switch (format) {
    case SurfaceFormat::Obj:
        return checkObj(bytes);
    case SurfaceFormat::Ply:
        return checkPly(bytes);
    case SurfaceFormat::Stl:
        return checkStl(bytes);
    case SurfaceFormat::Gltf:
        return checkGltf(bytes, folder);
    case SurfaceFormat::Glb:
        return checkGlb(bytes);
    }
    return fail(Errc::UnknownFormat);
}

/// Names that readers give to what has none.
bool isPlaceholder(std::string_view name)
{
    return name.empty() || name.starts_with("$$$") || name.starts_with('<')
           || name == "defaultobject" || name == "default" || name == "ROOT";
}

/// Adds the triangles of a mesh, placed by its node. False for indices beyond its vertices, or a
/// coordinate that is not finite in `finite`.
bool addMesh(const aiMesh& mesh, const aiMatrix4x4& placed, TriangleMesh& surface, bool& finite)
{
    const auto first = static_cast<std::uint32_t>(surface.positions.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D p = placed * mesh.mVertices[i];
        surface.positions.emplace_back(p.x, p.y, p.z);
        finite = finite && surface.positions.back().allFinite();
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3)
            continue; // points and lines
        Triangle t{};
        for (unsigned k = 0; k < 3; ++k) {
            if (face.mIndices[k] >= mesh.mNumVertices)
                return false;
            t[k] = first + face.mIndices[k];
        }
        surface.triangles.push_back(t);
    }
    return true;
}

bool isOfOneColor(const std::vector<Rgb>& colors)
{
    return std::adjacent_find(colors.begin(), colors.end(), std::not_equal_to<>{}) == colors.end();
}

/// Walks the nodes of a scene and collects one surface from each that has triangles.
class SceneReader
{
public:
    SceneReader(const aiScene& scene, SurfaceTexture& texture, std::string fallbackName)
        : m_scene(scene), m_texture(texture), m_fallbackName(std::move(fallbackName))
    {
    }

    Result<std::vector<NamedSurface>> surfaces()
    {
        if (m_scene.mRootNode != nullptr)
            visit(*m_scene.mRootNode, {});
        if (!m_finite)
            return fail(Errc::NotFinite, "a coordinate that is not finite");
        if (!m_indicesGood)
            return fail(Errc::FileMalformed, "a triangle names a vertex that is not there");
        if (m_surfaces.empty())
            return fail(Errc::FileMalformed, "no triangles");
        return std::move(m_surfaces);
    }

private:
    void visit(const aiNode& node, const aiMatrix4x4& parent)
    {
        const aiMatrix4x4 placed = parent * node.mTransformation;
        TriangleMesh whole;
        std::vector<Rgb> colors;
        for (unsigned i = 0; i < node.mNumMeshes && m_indicesGood; ++i) {
            const aiMesh& mesh = *m_scene.mMeshes[node.mMeshes[i]];
            m_indicesGood = addMesh(mesh, placed, whole, m_finite);
            const std::vector<Rgb> more = m_texture.colorsOf(mesh);
            colors.insert(colors.end(), more.begin(), more.end());
        }
        if (m_finite && m_indicesGood && !whole.empty())
            addSurface(node.mName.C_Str(), whole, colors);
        for (unsigned i = 0; i < node.mNumChildren && m_finite && m_indicesGood; ++i)
            visit(*node.mChildren[i], placed);
    }

    void addSurface(const std::string& name, const TriangleMesh& split,
                    const std::vector<Rgb>& colors)
    {
        NamedSurface surface{isPlaceholder(name) ? m_fallbackName : name,
                             conceptIn(name).value_or(std::string{}),
                             welded(split, metres(0.0)),
                             {}};
        if (surface.mesh.empty())
            return;
        if (!isOfOneColor(colors))
            surface.colors = ColorsByPlace{split.positions, colors}.at(surface.mesh.positions);
        m_surfaces.push_back(std::move(surface));
    }

    const aiScene& m_scene;
    SurfaceTexture& m_texture;
    std::string m_fallbackName;
    std::vector<NamedSurface> m_surfaces;
    bool m_finite = true;
    bool m_indicesGood = true;
};

Result<MeshFile> readScene(const aiScene& scene, SurfaceTexture texture, const std::string& stem,
                           SurfaceNotes notes)
{
    auto surfaces = SceneReader{scene, texture, stem}.surfaces();
    if (!surfaces)
        return tl::unexpected(surfaces.error());
    MeshFile file{std::move(*surfaces), std::move(notes.attributions), texture.faults()};
    if (file.surfaces.size() == 1) {
        NamedSurface& only = file.surfaces.front();
        only.name = notes.name.empty() ? only.name : notes.name;
        only.conceptId = notes.conceptId.empty() ? only.conceptId : notes.conceptId;
        if (only.conceptId.empty())
            only.conceptId = conceptIn(stem).value_or(std::string{});
    }
    aiString copyright;
    if (scene.mMetaData != nullptr && scene.mMetaData->Get(AI_METADATA_SOURCE_COPYRIGHT, copyright)
        && copyright.length > 0)
        file.attributions.emplace_back(copyright.C_Str());
    return file;
}

/// Opens what lies in one folder or below it, within the limits of its kind, and nothing else,
/// whatever a file refers to. Why it refused a file becomes one of the faults.
class FolderFiles : public Assimp::DefaultIOSystem
{
public:
    FolderFiles(std::filesystem::path folder, std::vector<Error>& faults)
        : m_folder(std::move(folder)), m_faults(faults)
    {
    }

    Assimp::IOStream* Open(const char* file, const char* mode) override
    {
        const auto found = pathWithin(m_folder, file);
        const auto size =
            found ? readableSize(*found, limitOfSetFile(*found)) : tl::unexpected(found.error());
        if (size)
            return DefaultIOSystem::Open(found->c_str(), mode);
        const bool isNew = std::find(m_faults.begin(), m_faults.end(), size.error())
                           == m_faults.end(); // the library tries more than once
        if (size.error().code != Errc::FileNotFound && isNew)
            m_faults.push_back(size.error());
        return nullptr;
    }

private:
    std::filesystem::path m_folder;
    std::vector<Error>& m_faults;
};

/// Whether a file may refer to others: the materials of an OBJ, the buffers of a glTF.
bool refersToFiles(SurfaceFormat format)
{
    return format == SurfaceFormat::Gltf || format == SurfaceFormat::Obj;
}

Result<MeshFile> parse(const std::filesystem::path& file, SurfaceFormat format,
                       const std::string& bytes)
{
    const bool linear = format == SurfaceFormat::Gltf || format == SurfaceFormat::Glb;
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    std::vector<Error> refused;
    Assimp::Importer importer;
    try {
        importer.SetIOHandler(new FolderFiles{folder, refused}); // the importer owns it
        const aiScene* scene =
            refersToFiles(format)
                ? importer.ReadFile((folder / file.filename()).string(), aiProcess_Triangulate)
                : importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate,
                                              endingOf(format));
        if (scene == nullptr)
            return fail(Errc::FileMalformed, importer.GetErrorString());
        const bool text = format == SurfaceFormat::Obj || format == SurfaceFormat::Ply;
        auto read = readScene(*scene, {*scene, folder, linear}, file.stem().string(),
                              text ? notesIn(bytes) : SurfaceNotes{});
        if (read)
            read->textureFaults.insert(read->textureFaults.end(), refused.begin(), refused.end());
        return read;
    } catch (const std::exception& thrown) {
        return fail(Errc::FileMalformed, thrown.what());
    }
}

} // namespace

Result<MeshFile> readMeshFile(const std::filesystem::path& file)
{
    const auto bytes =
        pathWithin(file.parent_path(), file.filename()).and_then([](const auto& found) {
            return readWholeFile(found, kSurfaceLimit);
        });
    if (!bytes)
        return tl::unexpected(bytes.error());
    const auto named = [&](const Error& error) {
        return fail(error.code, file.string() + ": " + error.detail);
    };
    const auto format = surfaceFormat(file);
    if (!format)
        return named({Errc::UnknownFormat, "not OBJ, PLY, STL, glTF or GLB by its name"});
    if (const auto good = checkFormat(*format, *bytes, file.parent_path()); !good)
        return named(good.error());
    auto read = parse(file, *format, *bytes);
    if (!read)
        return named(read.error());
    return read;
}

} // namespace carina
