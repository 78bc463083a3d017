#include "apps/lab/breathing/drawn_breathing.h"

#include "apps/lab/breathing/drawn_lungs.h"
#include "engine/lungs/drawing/chest_drawing.h"

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
    DrawnLungs onCard;

    Result<DrawnTrial> draw(const std::vector<ChestShape>& shapes)
    {
        DrawnTrial trial;
        Volume least = cubicMetres(std::numeric_limits<double>::infinity());
        Volume greatest = cubicMetres(-std::numeric_limits<double>::infinity());
        for (const ChestShape& shape : shapes) {
            const auto drawn = onCard.volumes(drawnPose(lungs, shape, level));
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
    auto onCard = DrawnLungs::of(lungs, level);
    if (!onCard)
        return tl::unexpected(onCard.error());
    const auto rest = onCard->volumes({});
    if (!rest)
        return tl::unexpected(rest.error());
    DrawnLevel result = undrawn(lungs, level, *rest);
    LevelDrawer drawer{lungs, level, frc, *std::move(onCard)};
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
        return fail(Errc::WrongOption, anatomy.name + " has levels 0 to "
                                           + std::to_string(lungs->levelCount() - 1) + ".");
    const auto frc =
        DrawnLungs::of(*lungs, 0).and_then([](DrawnLungs onCard) { return onCard.volumes({}); });
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
