#pragma once

#include "apps/lab/programs/started_session.h"
#include "apps/lab/soak/trend.h"
#include "engine/core/session_time.h"

#include <string>
#include <vector>

namespace carina::lab
{

/// How long the programs run, and how often something happens in that time, evenly spread.
struct SoakSettings {
    Duration length = std::chrono::hours{1};
    int patients = 200; ///< changes of the patient
    int joins = 200;    ///< an observer comes in, stays for a while and leaves
    int events = 600;   ///< changes of the breathing, and pauses
    SessionPrograms programs;
};

/// What a program held in the course of the soak; times in minutes.
struct SoakedProgram {
    std::string name;
    std::vector<TimedFigure> memory_kb{}; ///< see Footprint
    std::vector<TimedFigure> descriptors{};
    std::vector<TimedFigure> threads{};
    double bytesPerFact = 0.0; ///< of the log, in the memory of such a program (LogMemory)
};

struct SoakFigures {
    std::vector<SoakedProgram> programs; ///< console, then trainee
    int patients = 0;                    ///< changes of the patient that were proposed
    int joins = 0;                       ///< times that the observer was admitted
    int events = 0;                      ///< proposed
    int unanswered = 0;                  ///< proposals that were not facts at the end
    std::vector<TimedFigure> facts;      ///< in the log
};

/// Runs a console that hosts a session and a trainee with a simulated tracker, each in its window,
/// takes part in their session, and measures both. Begins to measure when all have come in and a
/// tenth of the time has passed.
/// @returns FileNotFound for a program that there is not; HostSilent if not all come in, or if one
///          ends before the time; the refusal of a proposal; the errors of reading the log.
[[nodiscard]] Result<SoakFigures> soak(const SoakSettings& settings);

} // namespace carina::lab
