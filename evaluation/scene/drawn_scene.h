#pragma once

#include "engine/core/ids.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/session/facts/facts.h"

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

/// Where a program has an object of its own at a session time, between two of its frames.
/// @param longestGap between these two, seconds
/// @returns nothing outside of its frames, or where a frame lacks the object
[[nodiscard]] std::optional<RigidTransform> ownersPose(const DrawnFrames& owners, int object,
                                                       double t, double longestGap);

/// How far viewers were from owners.
struct SceneDifference {
    std::vector<double> angles;    ///< rad
    std::vector<double> distances; ///< m
};

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
    /// Of each program, each other one at its station with tools, and of head, hand and tube: the
    /// share of the program's frames that had it, the least of all. Not counted are the program's
    /// own objects, which it need not draw, the jaw, which all at a station share, and who is at
    /// another station.
    double leastShare = 1.0;
    int pairs = 0;          ///< of which leastShare is the least
    DrawnPair leastDrawn{}; ///< which it is
};

/// Compares the programs of a session, which may be at several stations, between two session times:
/// each object of a person that one drew with where its owner's program had it at that session
/// time. The manikin's jaw is left out, because it is one thing for all at a station.
[[nodiscard]] SceneComparison compareScenes(std::span<const DrawnScene> programs, double from,
                                            double until, double longestGap);

/// The value that a share of the values does not exceed. @pre there are some
[[nodiscard]] double quantileOf(std::vector<double> values, double share);

} // namespace carina
