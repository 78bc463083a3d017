#pragma once

#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/io/anatomy_set/carried_sets.h"

#include <QCryptographicHash>
#include <QFile>

namespace carina::test
{

inline const std::string kSetHash(64, 'c');

/// A tetrahedron with a centimetre's edge, repeated as often as bytes are wanted, and a straight
/// airway that a tube lies in.
inline ImportedSet carriedSample(std::size_t copies = 1)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {0.01F, 0, 0}, {0, 0.01F, 0}, {0, 0, 0.01F}};
    mesh.normals.assign(4, Vec3f::UnitZ());
    for (std::size_t i = 0; i < copies; ++i)
        for (const Triangle& t :
             {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{0, 3, 2}, Triangle{1, 2, 3}})
            mesh.triangles.push_back(t);
    ImportedSet set;
    set.anatomy.name = "Somebody";
    set.anatomy.contentHash = kSetHash;
    set.anatomy.parts = {{"Trachea", PartRole::Trachea, "FMA7394", {std::move(mesh)}}};
    set.anatomy.landmarks.p_A_incisors = {0.0, 0.0, 0.25};
    set.anatomy.landmarks.p_A_glottis = {0.0, 0.0, 0.12};
    for (int cm = 35; cm >= 0; --cm)
        set.anatomy.landmarks.path_A.emplace_back(0.0, 0.0, 0.01 * cm);
    set.anatomy.attributions = {"CC0", "by Somebody"};
    set.faults = {{"a.obj", {Errc::FileEmpty, "/folder/of/the/host/a.obj: it is empty"}}};
    set.leftOut = {"b.obj: Hyoid bone"};
    return set;
}

/// The set, imported on the computer with this cache.
inline void importInto(const std::filesystem::path& cache, const ImportedSet& set)
{
    const auto stored = AnatomyCache{cache}.store(set, std::string(64, 'd'));
    Q_ASSERT(stored);
}

inline QByteArray contentOf(const std::filesystem::path& file)
{
    QFile opened{QString::fromStdString(file.string())};
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray{};
}

inline void putContent(const std::filesystem::path& file, const QByteArray& bytes)
{
    std::filesystem::create_directories(file.parent_path());
    QFile opened{QString::fromStdString(file.string())};
    const bool put = opened.open(QIODevice::WriteOnly) && opened.write(bytes) == bytes.size();
    Q_ASSERT(put);
}

inline std::span<const std::byte> bytesOf(const QByteArray& bytes)
{
    return std::as_bytes(std::span{bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

} // namespace carina::test
