#include "apps/lab/drawn_breathing.h"

#include "engine/lungs/chest_drawing.h"
#include "widgets/scene/drawn_vertices.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace carina::lab
{
namespace
{

using Volumes = std::array<Volume, 2>; // right, left

Volume total(const Volumes& volumes) { return volumes[0] + volumes[1]; }

/// One closed part on the graphics card, and the triangles between its vertices.
struct DrawnPart {
    std::size_t lung = 0; // as indexOf
    ChestRegion region = ChestRegion::Still;
    const std::vector<Triangle>* triangles = nullptr;
    DrawnVertices vertices;
};

/// Volume inside a closed surface: the tetrahedra that its triangles span with its first vertex.
double enclosedVolume(const std::vector<Vec3f>& positions, const std::vector<Triangle>& triangles)
{
    const Vec3 apex = positions.front().cast<double>();
    double sum = 0.0;
    for (const auto& [i, j, k] : triangles) {
        const Vec3 u = positions[i].cast<double>() - apex;
        const Vec3 v = positions[j].cast<double>() - apex;
        const Vec3 w = positions[k].cast<double>() - apex;
        sum += u.x() * (v.y() * w.z() - v.z() * w.y()) + u.y() * (v.z() * w.x() - v.x() * w.z())
               + u.z() * (v.x() * w.y() - v.y() * w.x());
    }
    return sum / 6.0;
}

/// The parts of both lungs in one level of detail.
Result<std::vector<DrawnPart>> upload(const LungPair& lungs, std::size_t level)
{
    std::vector<DrawnPart> parts;
    for (const BreathingPart& part : lungs.parts()) {
        const TriangleMesh& mesh = levelOf(part, level);
        Result<DrawnVertices> vertices = DrawnVertices::of(mesh);
        if (!vertices)
            return tl::unexpected(vertices.error());
        parts.push_back({indexOf(part.side), part.region, &mesh.triangles, std::move(*vertices)});
    }
    return parts;
}

Result<Volumes> volumesDrawn(std::vector<DrawnPart>& parts, const ChestField& field,
                             const ChestPose& pose)
{
    Volumes sums;
    for (DrawnPart& part : parts) {
        const auto drawn = part.vertices.positions(field, motionOf(part.region, pose, field));
        if (!drawn)
            return tl::unexpected(drawn.error());
        sums[part.lung].si += enclosedVolume(*drawn, *part.triangles);
    }
    return sums;
}

/// What the mechanics give to be drawn, frame by frame.
std::vector<ChestShape> shapesOf(const BreathingTrial& trial)
{
    RespiratoryFold fold{trial.settings};
    std::vector<ChestShape> shapes;
    const auto frames = static_cast<std::size_t>(trial.seconds * trial.framesPerSecond);
    std::int64_t step = 0;
    for (std::size_t frame = 0; frame <= frames; ++frame) {
        const double time = trial.settle + static_cast<double>(frame) / trial.framesPerSecond;
        for (; step < std::llround(time / kRespiratoryStep); ++step)
            fold.step();
        shapes.push_back(
            chestShape(trial.settings.build, fold.system(), fold.content(), fold.moment()));
    }
    return shapes;
}

void raiseTo(Volume& largest, Volume error)
{
    largest = std::max(largest, cubicMetres(std::abs(error.si)));
}

/// A level of detail before its first frame.
DrawnLevel undrawn(const LungPair& lungs, std::size_t level, const Volumes& rest)
{
    DrawnLevel result;
    result.level = level;
    for (const BreathingPart& part : lungs.parts()) {
        DrawnLung& lung = result.lungs[indexOf(part.side)];
        lung.vertices += levelOf(part, level).positions.size();
        lung.triangles += levelOf(part, level).triangles.size();
    }
    for (std::size_t lung = 0; lung < rest.size(); ++lung)
        result.lungs[lung].restVolume = rest[lung];
    return result;
}

/// The lungs in one level of detail; `frc` are their volumes at rest in the finest.
struct LevelDrawer {
    const LungPair& lungs;
    std::size_t level;
    const Volumes& frc;
    std::vector<DrawnPart> parts;

    Result<DrawnTrial> draw(const std::vector<ChestShape>& shapes)
    {
        DrawnTrial trial;
        Volume least = cubicMetres(std::numeric_limits<double>::infinity());
        Volume greatest = cubicMetres(-std::numeric_limits<double>::infinity());
        for (const ChestShape& shape : shapes) {
            const auto drawn = volumesDrawn(parts, lungs.field(), drawnPose(lungs, shape, level));
            if (!drawn)
                return tl::unexpected(drawn.error());
            compare(*drawn, shape, trial.errors);
            least = std::min(least, total(*drawn));
            greatest = std::max(greatest, total(*drawn));
            ++trial.frames;
        }
        trial.tidalVolume = greatest - least;
        return trial;
    }

    void compare(const Volumes& drawn, const ChestShape& shape, DrawnErrors& errors) const
    {
        Volumes off;
        for (std::size_t lung = 0; lung < frc.size(); ++lung) {
            const LungShape& commanded = shape.lungs[lung];
            off[lung] = drawn[lung] - (frc[lung] + commanded.gas - commanded.healthy);
            raiseTo(errors.lungs[lung], off[lung]);
        }
        raiseTo(errors.both, total(off));
    }
};

Result<DrawnLevel> drawLevel(const LungPair& lungs, std::size_t level, const Volumes& frc,
                             const std::vector<std::vector<ChestShape>>& trials)
{
    auto parts = upload(lungs, level);
    if (!parts)
        return tl::unexpected(parts.error());
    const auto rest = volumesDrawn(*parts, lungs.field(), {});
    if (!rest)
        return tl::unexpected(rest.error());
    DrawnLevel result = undrawn(lungs, level, *rest);
    LevelDrawer drawer{lungs, level, frc, *std::move(parts)};
    for (const std::vector<ChestShape>& shapes : trials) {
        const auto trial = drawer.draw(shapes);
        if (!trial)
            return tl::unexpected(trial.error());
        result.trials.push_back(*trial);
    }
    return result;
}

} // namespace

Volume DrawnErrors::largest() const { return std::max({lungs[0], lungs[1], both}); }

Result<DrawnBreathing> drawBreathing(const Anatomy& anatomy, std::span<const BreathingTrial> trials,
                                     std::optional<std::size_t> level)
{
    const auto lungs = LungPair::of(anatomy);
    if (!lungs)
        return tl::unexpected(lungs.error());
    if (lungs->parts().empty())
        return fail(Errc::NothingRecognised, anatomy.name + " has no lungs.");
    if (level && *level >= lungs->levelCount())
        return fail(Errc::OutOfRange, anatomy.name + " has levels 0 to "
                                          + std::to_string(lungs->levelCount() - 1) + ".");
    const auto frc = upload(*lungs, 0).and_then(
        [&](std::vector<DrawnPart> parts) { return volumesDrawn(parts, lungs->field(), {}); });
    if (!frc)
        return tl::unexpected(frc.error());
    std::vector<std::vector<ChestShape>> shapes;
    std::ranges::transform(trials, std::back_inserter(shapes), shapesOf);
    DrawnBreathing drawn{total(*frc), {}};
    const std::size_t last = level.value_or(lungs->levelCount() - 1);
    for (std::size_t drawnAt = level.value_or(0); drawnAt <= last; ++drawnAt) {
        const auto drawnLevel = drawLevel(*lungs, drawnAt, *frc, shapes);
        if (!drawnLevel)
            return tl::unexpected(drawnLevel.error());
        drawn.levels.push_back(*drawnLevel);
    }
    return drawn;
}

} // namespace carina::lab
