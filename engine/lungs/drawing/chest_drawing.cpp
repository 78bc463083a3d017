#include "engine/lungs/drawing/chest_drawing.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr LungPose kDiaphragm{1.0, 0.0, kQuietBreath.gravity, 0.0};
constexpr LungPose kRibs{0.0, 1.0, 0.0, 0.0};
constexpr LungPose kCollapse{0.0, 0.0, 0.0, 1.0};
constexpr double kUnseen_ml = 0.01;
/// The collapse of a lung that trapped gas has made larger, and into which a mediastinum may still
/// sink: one that is fuller would be pressed through the skin of its back.
constexpr double kFullestLeant = -0.4;
constexpr int kHalvings = 20;
/// Upper limit of the ribs' amplitude for a diaphragm of 1, for surfaces of unusual shape.
constexpr double kMostRibs = 2.0;

/// One lung in a level of detail, leant on by the mediastinum.
struct DrawnLung {
    const LungPair& lungs;
    Side side;
    std::size_t level;
    double shift;

    [[nodiscard]] double shiftInto() const { return side == Side::Left ? shift : -shift; }
    /// Of the range, what the mediastinum leaves it.
    [[nodiscard]] double room() const { return 1.0 - std::max(0.0, shiftInto()) / kMostShift; }
    [[nodiscard]] VolumeCubic cubic(const LungPose& given, const LungPose& along) const
    {
        return lungs.volumeAlong(side, level, given, along, shift);
    }
};

/// The amount of `along`, within a range, at which the lung comes nearest to a volume. Volumes grow
/// or shrink all the way along what lungs are moved by.
double amountFor(const VolumeCubic& cubic, Volume volume, const AmplitudeRange& range)
{
    const auto [least, greatest] = std::minmax({cubic.at(range.least), cubic.at(range.greatest)});
    return amplitudeFor(cubic, std::clamp(volume, least, greatest), 0.0, range).value_or(0.0);
}

/// A breath of amplitude 1, in which the ribs make their share of a small change of volume.
LungPose breathOf(const LungPair& lungs, Side side, double ribShare)
{
    const auto gain = [&](const LungPose& along) {
        return lungs.volumeAlong(side, 0, {}, along, 0.0).c[1];
    };
    const double ribs = ribShare / (1.0 - ribShare) * gain(kDiaphragm) / gain(kRibs);
    return kDiaphragm + std::clamp(ribs, 0.0, kMostRibs) * kRibs;
}

/// A lung in a pose, where its side of the chest stands, and whether the lung encloses what it
/// should without being pressed through the skin.
struct PosedLung {
    LungPose pose;
    LungPose wall;
    bool fits = true;
};

/// Where chest wall and diaphragm make a room, wherever mediastinum and inside of the lung are.
/// What the diaphragm cannot make more, the ribs do.
LungPose wallFor(const DrawnLung& lung, const LungPose& breath, Volume room)
{
    const auto amount = [&](const LungPose& given, const LungPose& along,
                            const AmplitudeRange& range) {
        return amountFor(lung.lungs.volumeAlong(lung.side, lung.level, given, along, 0.0), room,
                         range);
    };
    const AmplitudeRange breaths = amplitudesWithin({}, breath, 0.0).value();
    const double breathed = amount({}, breath, breaths);
    if (breathed < breaths.greatest)
        return breathed * breath;
    const LungPose lowest = breaths.greatest * breath;
    const double most = amplitudesWithin(lowest, kRibs, 0.0).value().greatest;
    return lowest + amount(lowest, kRibs, {0.0, std::max(0.0, most)}) * kRibs;
}

/// Where the collapse that is within the range does not bring the volume: along the range's edge
/// from there to where breathing takes none of it, and on from there by collapse alone.
void moveAlongTheEdge(const DrawnLung& lung, double collapse, Volume volume, PosedLung& posed)
{
    const LungPose from = posed.pose + collapse * kCollapse;
    const bool shrinks = volume < lung.cubic(from, kCollapse).at(0.0);
    const double all = shrinks ? kMostCollapse : kLeastCollapse;
    const LungPose along = lung.room() * all * kCollapse + -1.0 * from;
    const double amount = amountFor(lung.cubic(from, along), volume, {0.0, 1.0});
    posed.pose = from + amount * along;
    if (shrinks && amount == 1.0) {
        const AmplitudeRange alone{lung.room() * kMostCollapse, lung.room() * kMostCollapseAlone};
        posed.pose = amountFor(lung.cubic({}, kCollapse), volume, alone) * kCollapse;
    }
    const double off_ml = inMillilitres(lung.cubic(posed.pose, kCollapse).at(0.0) - volume);
    const bool isLeant = lung.shiftInto() > 0.0;
    posed.fits = std::abs(off_ml) < kUnseen_ml && !(isLeant && posed.pose.collapse < kFullestLeant);
}

PosedLung poseOf(const DrawnLung& lung, double sag, const LungPose& breath, Volume room,
                 Volume volume)
{
    const LungPose lying{0.0, 0.0, lung.room() * sag, 0.0};
    const LungPose wall = wallFor(lung, breath, room);
    const AmplitudeRange along =
        amplitudesWithin(lying, wall, lung.shiftInto()).value_or(AmplitudeRange{});
    PosedLung posed{lying + std::min(1.0, along.greatest) * wall, lying + wall};
    const AmplitudeRange collapses =
        amplitudesWithin(posed.pose, kCollapse, lung.shiftInto()).value_or(AmplitudeRange{});
    const double collapse = amountFor(lung.cubic(posed.pose, kCollapse), volume, collapses);
    if (collapse > collapses.least && collapse < collapses.greatest)
        posed.pose = posed.pose + collapse * kCollapse;
    else
        moveAlongTheEdge(lung, collapse, volume, posed);
    return posed;
}

struct PosedChest {
    ChestPose pose;
    bool fits = true;
};

PosedChest posedWith(const LungPair& lungs, const ChestShape& shape, std::size_t level,
                     double shift)
{
    PosedChest posed;
    posed.pose.mediastinalShift = shift;
    std::array<LungPose, 2>& walls = posed.pose.walls.emplace();
    for (const Side side : {Side::Right, Side::Left}) {
        if (lungs.restVolume(side).si == 0.0)
            continue;
        const LungShape& lung = shape.lungs[indexOf(side)];
        const PosedLung drawn = poseOf(
            {lungs, side, level, shift}, shape.sag, breathOf(lungs, side, shape.ribShare),
            lungs.restVolume(side) + lung.room - lung.healthy, drawnVolume(lungs, shape, side));
        posed.pose.lungs[indexOf(side)] = drawn.pose;
        walls[indexOf(side)] = drawn.wall;
        posed.fits = posed.fits && drawn.fits;
    }
    return posed;
}

} // namespace

Volume drawnVolume(const LungPair& lungs, const ChestShape& shape, Side side)
{
    const LungShape& lung = shape.lungs[indexOf(side)];
    return lungs.restVolume(side) + lung.gas - lung.healthy;
}

Volume notDrawn(const LungPair& lungs, const ChestShape& shape, const ChestPose& drawn,
                std::size_t level)
{
    Volume missing{};
    for (const Side side : {Side::Right, Side::Left}) {
        if (lungs.restVolume(side).si == 0.0)
            continue;
        const Volume enclosed = lungs
                                    .volumeAlong(side, level, drawn.lungs[indexOf(side)], kCollapse,
                                                 drawn.mediastinalShift)
                                    .at(0.0);
        missing = missing + std::max(Volume{}, drawnVolume(lungs, shape, side) - enclosed);
    }
    return missing;
}

ChestPose drawnPose(const LungPair& lungs, const ChestShape& shape, std::size_t level)
{
    const double asked = std::clamp(shape.mediastinalShift.si * lungs.field().frame().perMetre.u,
                                    -kDrawnShift, kDrawnShift);
    const PosedChest posed = posedWith(lungs, shape, level, asked);
    if (posed.fits)
        return posed.pose;
    // As far aside as leaves both lungs their volumes.
    double fits = 0.0;
    double tooFar = 1.0;
    for (int halving = 0; halving < kHalvings; ++halving) {
        const double middle = 0.5 * (fits + tooFar);
        (posedWith(lungs, shape, level, middle * asked).fits ? fits : tooFar) = middle;
    }
    return posedWith(lungs, shape, level, fits * asked).pose;
}

} // namespace carina
