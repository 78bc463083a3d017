#include "engine/io/anatomy_set/set_import.h"

#include "engine/anatomy/airway/airway_path.h"
#include "engine/anatomy/detail.h"
#include "engine/anatomy/role_recognition.h"
#include "engine/geometry/mesh/mesh_repair.h"
#include "engine/geometry/mesh/mesh_winding.h"
#include "engine/io/anatomy_set/set_frame.h"
#include "engine/io/anatomy_set/surface_selection.h"
#include "engine/io/files/parallel.h"
#include "engine/io/mesh/reader_memory.h"
#include "engine/io/mesh/surface_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>

namespace carina
{
namespace
{

constexpr Length kWeldTolerance = millimetres(0.01);
constexpr double kShareOfReading = 0.6; ///< of the time that an import takes

constexpr std::array kShares{0.25, 0.0625, 0.015625};
constexpr double kFewestInALevel = 60.0; ///< triangles; with fewer there is no such level

std::span<const double> sharesFor(std::size_t triangles)
{
    const auto tooFew = [triangles](double share) {
        return share * double(triangles) < kFewestInALevel;
    };
    const auto end = std::find_if(kShares.begin(), kShares.end(), tooFew);
    return std::span{kShares}.first(std::size_t(end - kShares.begin()));
}

Error cancelled() { return {Errc::Cancelled, "the import was stopped"}; }

Result<std::vector<Result<MeshFile>>> readAll(const SetFolder& folder,
                                              const ImportProgress& progress)
{
    const std::size_t count = folder.surfaces.size();
    std::vector<Result<MeshFile>> files(count);
    const auto makeWork = [&] {
        const auto reader =
            std::make_shared<SurfaceReader>(folder.root); // owned by the work of one thread
        return [&, reader](std::size_t i) {
            files[i] = reader->read(folder.root / folder.surfaces[i]);
        };
    };
    const auto goOn = [&](std::size_t done) {
        return progress(kShareOfReading * double(done) / double(count));
    };
    if (!inParallel(count, makeWork, goOn, ReaderMemory::shares()))
        return tl::unexpected(cancelled());
    return files;
}

void addOnce(std::vector<std::string>& lines, const std::vector<std::string>& more)
{
    for (const std::string& line : more)
        if (std::find(lines.begin(), lines.end(), line) == lines.end())
            lines.push_back(line);
}

/// "right_upper_lobe" as "Right upper lobe".
std::string shownName(std::string name)
{
    std::replace(name.begin(), name.end(), '_', ' ');
    if (!name.empty())
        name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
}

/// The surfaces of all files that could be read; the others become faults of the set.
std::vector<RecognisedSurface> recognise(const SetFolder& folder,
                                         std::vector<Result<MeshFile>> files, ImportedSet& set)
{
    std::vector<RecognisedSurface> surfaces;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string& file = folder.surfaces[i];
        if (!files[i]) {
            set.faults.push_back({file, files[i].error()});
            continue;
        }
        addOnce(set.anatomy.attributions, files[i]->attributions);
        for (NamedSurface& s : files[i]->surfaces) {
            PartRole role = recogniseRole(s.conceptId, s.name);
            if (role == PartRole::Other && files[i]->surfaces.size() == 1)
                role = recogniseRole({}, std::filesystem::path{file}.stem().string());
            surfaces.push_back({file, shownName(s.name), std::move(s.conceptId), role,
                                std::move(s.mesh), std::move(s.colors)});
        }
        for (Error& fault : files[i]->textureFaults)
            set.faults.push_back({file, std::move(fault)});
    }
    return surfaces;
}

void moveInto(TriangleMesh& mesh, const SetFrame& frame, const Vec3& p_F_origin)
{
    for (Vec3f& p : mesh.positions)
        p = (frame.metresPerUnit * frame.R_AF * (p.cast<double>() - p_F_origin)).cast<float>();
    if (frame.R_AF.determinant() < 0.0)
        for (Triangle& t : mesh.triangles)
            std::swap(t[1], t[2]);
}

AnatomyPart makePart(RecognisedSurface surface)
{
    const ColorsByPlace colors{surface.colors.empty() ? std::span<const Vec3f>{}
                                                      : std::span{surface.mesh.positions},
                               surface.colors};
    TriangleMesh mesh = std::move(surface.mesh);
    if (lungSide(surface.role))
        mesh = closedSurface(mesh, kWeldTolerance);
    else if (isClosed(mesh) && signedVolume(mesh) < 0.0)
        for (Triangle& t : mesh.triangles)
            std::swap(t[1], t[2]);
    const auto shares = sharesFor(mesh.triangles.size());
    auto levels = levelsOfDetail(std::move(mesh), shares);
    AnatomyPart part{std::move(surface.name), surface.role, std::move(surface.conceptId),
                     std::move(levels.meshes), std::move(levels.deviations)};
    for (const TriangleMesh& level : part.levels)
        if (!surface.colors.empty())
            part.colors.push_back(colors.at(level.positions));
    return part;
}

/// The parts in the axes of A, in metres, about the point p_F_origin of F.
Result<std::vector<AnatomyPart>> makeParts(std::vector<RecognisedSurface> surfaces,
                                           const SetFrame& frame, const Vec3& p_F_origin,
                                           const ImportProgress& progress)
{
    std::vector<AnatomyPart> parts(surfaces.size());
    const auto work = [&](std::size_t i) {
        moveInto(surfaces[i].mesh, frame, p_F_origin);
        parts[i] = makePart(std::move(surfaces[i]));
    };
    const auto goOn = [&](std::size_t done) {
        const double share = double(done) / double(parts.size());
        return progress(kShareOfReading + (1.0 - kShareOfReading) * share);
    };
    if (!inParallel(
            parts.size(), [&] { return work; }, goOn))
        return tl::unexpected(cancelled());
    std::erase_if(parts, [](const AnatomyPart& part) { return part.levels.front().empty(); });
    return parts;
}

/// By value: the new origin is a landmark of the anatomy itself, which moves under way.
void moveOrigin(Anatomy& anatomy, const Vec3 p_A_newOrigin)
{
    for (AnatomyPart& part : anatomy.parts)
        for (TriangleMesh& level : part.levels)
            for (Vec3f& p : level.positions)
                p = (p.cast<double>() - p_A_newOrigin).cast<float>();
    AirwayLandmarks& landmarks = anatomy.landmarks;
    for (Vec3* p : {&landmarks.p_A_incisors, &landmarks.p_A_glottis, &landmarks.p_A_carina})
        *p -= p_A_newOrigin;
    for (Vec3& p : landmarks.path_A)
        p -= p_A_newOrigin;
}

Vec3 middleOf(const std::vector<RecognisedSurface>& surfaces)
{
    Box box;
    for (const RecognisedSurface& s : surfaces)
        box.include(boundsOf(s.mesh));
    return box.centre();
}

Result<void> isUsable(const std::vector<RecognisedSurface>& surfaces, const SetFolder& folder,
                      const ImportedSet& set)
{
    if (std::any_of(surfaces.begin(), surfaces.end(),
                    [](const RecognisedSurface& s) { return s.role != PartRole::Other; }))
        return {};
    std::string detail = folder.root.string() + ": nothing of a patient in "
                         + std::to_string(folder.surfaces.size()) + " files";
    if (!set.faults.empty())
        detail += "; " + set.faults.front().error.detail;
    return fail(Errc::NothingRecognised, detail);
}

std::string keyOf(const RecognisedSurface& surface) { return surface.file + ": " + surface.name; }

SetDraft draftOf(const std::vector<RecognisedSurface>& surfaces, const ImportedSet& set)
{
    SetDraft draft;
    for (const RecognisedSurface& s : surfaces)
        draft.surfaces.push_back({keyOf(s), s.role, s.mesh.triangles.size()});
    if (const auto frame = findSetFrame(surfaces))
        draft.frame = *frame;
    draft.faults = set.faults;
    return draft;
}

void correct(std::vector<RecognisedSurface>& surfaces, const SetCorrections& corrections,
             ImportedSet& set)
{
    std::erase_if(surfaces, [&](RecognisedSurface& s) {
        const auto found = corrections.roles.find(keyOf(s));
        if (found == corrections.roles.end())
            return false;
        s.role = found->second.value_or(PartRole::Other);
        if (!found->second)
            set.leftOut.push_back(keyOf(s) + ", as asked for");
        return !found->second;
    });
}

} // namespace

Result<ImportedSet> importSetFolder(const SetFolder& folder, const ImportProgress& progress,
                                    const SetReview& review)
{
    auto files = readAll(folder, progress);
    if (!files)
        return tl::unexpected(files.error());
    ImportedSet set;
    set.faults = missingFiles(folder);
    auto surfaces = recognise(folder, std::move(*files), set);
    if (set.anatomy.attributions.empty())
        set.anatomy.attributions = attributionsBeside(folder);
    const auto corrections = review ? review(draftOf(surfaces, set)) : SetCorrections{};
    if (!corrections)
        return tl::unexpected(cancelled());
    correct(surfaces, *corrections, set);
    if (const auto usable = isUsable(surfaces, folder, set); !usable)
        return tl::unexpected(usable.error());
    addOnce(set.leftOut, leaveOutRepeated(surfaces));
    const auto frame =
        corrections->frame ? Result<SetFrame>{*corrections->frame} : findSetFrame(surfaces);
    if (!frame)
        return fail(frame.error().code, folder.root.string() + ": " + frame.error().detail);
    set.frame = *frame;
    const Vec3 p_F_middle = middleOf(surfaces);
    auto parts = makeParts(std::move(surfaces), set.frame, p_F_middle, progress);
    if (!parts)
        return tl::unexpected(parts.error());
    set.anatomy.parts = std::move(*parts);
    if (auto landmarks = findAirway(set.anatomy.parts)) {
        set.anatomy.landmarks = std::move(*landmarks);
        moveOrigin(set.anatomy, set.anatomy.landmarks.p_A_carina);
    }
    return set;
}

} // namespace carina
