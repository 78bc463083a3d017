#include "engine/io/anatomy_set/surface_selection.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace carina
{
namespace
{

using Corners = std::array<float, 9>;

/// The triangles by the places of their corners, in an order that does not depend on the file's.
std::vector<Corners> sortedTriangles(const TriangleMesh& mesh)
{
    std::vector<Corners> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        std::array<std::array<float, 3>, 3> p;
        for (std::size_t k = 0; k < 3; ++k)
            for (int axis = 0; axis < 3; ++axis)
                p[k][axis] = mesh.positions[t[k]][axis];
        std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
        Corners corners{};
        for (std::size_t k = 0; k < 9; ++k)
            corners[k] = p[k / 3][k % 3];
        triangles.push_back(corners);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

/// What equal surfaces have in common and is quick to tell.
using Signature = std::tuple<std::size_t, std::size_t, float, float>;

Signature signatureOf(const TriangleMesh& mesh)
{
    const Box box = boundsOf(mesh);
    return {mesh.triangles.size(), mesh.positions.size(), static_cast<float>(box.min.sum()),
            static_cast<float>(box.max.sum())};
}

bool isWholeLung(PartRole role)
{
    return role == PartRole::RightLung || role == PartRole::LeftLung;
}

bool hasLobe(const std::vector<RecognisedSurface>& surfaces, Side side)
{
    return std::any_of(surfaces.begin(), surfaces.end(), [side](const RecognisedSurface& s) {
        return lungSide(s.role) == side && !isWholeLung(s.role);
    });
}

} // namespace

std::vector<std::string> leaveOutRepeated(std::vector<RecognisedSurface>& surfaces)
{
    const bool lobes[] = {hasLobe(surfaces, Side::Right), hasLobe(surfaces, Side::Left)};
    std::multimap<Signature, std::size_t> keptBySignature;
    std::vector<RecognisedSurface> kept;
    std::vector<std::string> leftOut;
    for (RecognisedSurface& s : surfaces) {
        if (isWholeLung(s.role) && lobes[s.role == PartRole::LeftLung ? 1 : 0]) {
            leftOut.push_back(s.file + ": " + s.name + ", whole beside its lobes");
            continue;
        }
        const Signature signature = signatureOf(s.mesh);
        const auto [first, last] = keptBySignature.equal_range(signature);
        const auto same = std::find_if(first, last, [&](const auto& entry) {
            return sortedTriangles(kept[entry.second].mesh) == sortedTriangles(s.mesh);
        });
        if (same != last) {
            leftOut.push_back(s.file + ": " + s.name + ", as in " + kept[same->second].file);
            continue;
        }
        keptBySignature.emplace(signature, kept.size());
        kept.push_back(std::move(s));
    }
    surfaces = std::move(kept);
    return leftOut;
}

} // namespace carina
