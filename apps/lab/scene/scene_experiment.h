#pragma once

#include "apps/lab/programs/started_session.h"
#include "evaluation/network/drift_scenario.h"
#include "evaluation/scene/drawn_scene.h"

#include <QSize>

namespace carina::lab
{

/// Two stations with three trainees each, of whom one is at the end of a long path.
struct SceneSettings {
    SessionPrograms programs;
    DriftScenario scenario; ///< of the long path
    QString netlab{};       ///< the program; empty: relays
    std::uint32_t seed = 1;
    Duration watched{}; ///< how long it is
    QSize size;         ///< of the windows
    QString folder{};   ///< for the pictures; empty: none are taken
};

/// A program of the session, with what it drew.
struct ScenePlayer {
    QString name;
    DrawnScene drawn{};
    double framesPerSecond = 0.0;
};

struct SceneFigures {
    QString network;
    std::vector<ScenePlayer> players{}; ///< the console first
    SceneComparison compared{};
};

/// Runs the console and the trainees, each in its window on a display of its own, watches them, has
/// them take pictures of their windows and compares what they drew, from their journals.
/// @returns FileNotFound for a program that there is not; HostSilent if not all come in and see
/// each
///          other, or one ends before the time; NoGraphics; the errors of netlabSceneNetwork
[[nodiscard]] Result<SceneFigures> runScene(const SceneSettings& settings);

} // namespace carina::lab
