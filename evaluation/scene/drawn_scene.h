#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/session/facts/facts.h"
#include "engine/sync/strategies/drift.h"

#include <QString>

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// An object of a person in a frame of a program's journal: as it was drawn, or, of the program's
/// own participant, as this had it.
struct DrawnObject {
    int owner = 0; ///< a participant's number
    int kind = 0;  ///< of ObjectKind
    bool isOwn = false;
    RigidTransform X_AO;
};

/// The objects in each frame of a program, by session time in seconds.
using DrawnFrames = std::map<double, std::map<int, DrawnObject>>;

/// What a program of a session drew of the people at its station.
struct DrawnScene {
    int participant = 0;   ///< the number of who sits there
    QString station{};     ///< that it shows
    bool isRemote = false; ///< whether what it says comes over the long path
    bool hasTools = false; ///< whether it has objects of its own
    DrawnFrames frames{};
};

/// Reads the journal of a program; what is no line of a journal is left out.
[[nodiscard]] DrawnFrames drawnFramesIn(const QString& journal);

/// An object of its own at a session time, as a program has it between two of its frames.
struct OwnersView {
    RigidTransform X_AO;
    double turning = 0.0; ///< rad/s, and m/s, from the one frame to the other
    double moving = 0.0;
    double gap = 0.0; ///< seconds between the two frames
};

/// @param longestGap between the two frames, seconds
/// @returns nothing outside of the program's frames, or where a frame lacks the object
[[nodiscard]] std::optional<OwnersView> ownersView(const DrawnFrames& owners, int object, double t,
                                                   double longestGap);

/// What the paths between programs are, and how far apart frames may be.
struct SceneConditions {
    double longestGap = 0.0; ///< between two frames of an owner's program, seconds
    Duration toHost{};       ///< from a remote program
    Duration fromHost{};     ///< to a remote program
};

/// How far viewers were from owners.
struct SceneDifference {
    std::vector<double> angles;    ///< rad
    std::vector<double> distances; ///< m
    std::size_t beyond = 0;        ///< of these, those where one of the two was above its bound
};

/// What most comparisons are to be far below of their own bound: what is between two frames of an
/// owner is in that, so that an offset of everything by some millimetres would stay within it.
struct SceneBounds {
    Drift median;
    Drift p95;
};

/// Of programs that draw 5 frames a second and more; measured were 0.24 mm and 1.1 mm at most.
inline constexpr SceneBounds kBoundsOnTheSpot{{degrees(1.0), millimetres(1.0)},
                                              {degrees(2.5), millimetres(2.5)}};
/// With a path of 40 ms on either side; measured were 0.35 mm and 1.6 mm at most.
inline constexpr SceneBounds kBoundsOfRemote{{degrees(1.5), millimetres(1.5)},
                                             {degrees(4.0), millimetres(4.0)}};

/// Whether median and 95th percentile are below these; false where nothing was compared.
[[nodiscard]] bool isWithin(const SceneDifference& difference, const SceneBounds& bounds);

/// A program, and an object of another that it has to draw.
struct DrawnPair {
    int viewer = 0; ///< participants' numbers
    int owner = 0;
    ObjectKind kind = ObjectKind::Head;
};

/// What comes of comparing the programs of a session.
struct SceneComparison {
    SceneDifference near{}; ///< of programs and owners that are both not remote
    SceneDifference far{};  ///< the others
    int ownerChanges = 0;   ///< frames in which an object had another owner or kind than before
    /// Objects in frames that were where the same thing of another person was, and not where their
    /// owner had them; and those of which that could be told, because the two were far apart.
    std::size_t mistaken = 0;
    std::size_t recognisable = 0;
    /// Of each program, each other one at its station with tools, and of head, hand and tube: the
    /// share of the program's frames that had it, of those at whose time its owner's program had it
    /// (ownersView), the least of all. Not counted are the program's
    /// own objects, which it need not draw, the jaw, which all at a station share, and who is at
    /// another station.
    double leastShare = 1.0;
    int pairs = 0;          ///< of which leastShare is the least
    DrawnPair leastDrawn{}; ///< which it is
};

/// Compares the programs of a session, which may be at several stations, between two session times:
/// each object of a person that one drew with where its owner's program had it at that session
/// time. The manikin's jaw is left out, because it is one thing for all at a station.
///
/// The bound is that of trackedViewBound for the delay of the path from the owner to the viewer and
/// the object's own speed, the larger of those at that time and when what the viewer knows was
/// measured; and what a straight line between the owner's frames is off by, a g^2 / 8 for frames
/// that are g apart. Of a path that is longer one way than the other the two clocks disagree by
/// half the difference, which is added to its delay.
///
/// Whose an object is, is also told from where it was drawn. Everybody's things move on paths of
/// their own, so that what is drawn in another's place is where that one's program has it: nearer
/// than to its owner, while the two are farther apart than twice the bound.
[[nodiscard]] SceneComparison compareScenes(std::span<const DrawnScene> programs, double from,
                                            double until, const SceneConditions& conditions);

/// The value that a share of the values does not exceed. @pre there are some
[[nodiscard]] double quantileOf(std::vector<double> values, double share);

} // namespace carina
