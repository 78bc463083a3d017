#pragma once

#include "apps/program/played_intubation.h"
#include "apps/program/program.h"
#include "engine/net/node/session_node.h"
#include "models/session/session_plan.h"
#include "models/station/stations_model.h"

#include <vector>

namespace carina
{

/// A station of `--add-station`.
struct WantedStation {
    QString name;
    QString patient;
};

/// What the command line says of the sessions of a console.
struct ConsoleOptions {
    program::MeasureOptions measure{};
    QString folder{}; ///< that sessions are stored in
    QString codes{};  ///< file to write the codes into; empty: none
    std::uint16_t port = 0;
    SessionReach reach = SessionReach::ThisComputer;
    std::optional<CertificateFiles> certificate{};
    std::optional<StrategyKind> strategy{};
    std::vector<WantedStation> stations{};
    QString site{}; ///< by which readiness is judged
    /// That a trainee's program plays, and this console assists at.
    std::optional<program::PlayedIntubation> played{};
    bool isNew = false;    ///< the stored session is left
    bool starts = false;   ///< a session that is ready to start
    bool asksFirst = true; ///< on the start page, in place of beginning at once
};

/// Adds all options of the console.
void addConsoleOptions(QCommandLineParser& parser);

/// @returns WrongOption; the errors of measureOptions.
[[nodiscard]] Result<ConsoleOptions> consoleOptions(const QCommandLineParser& parser);

} // namespace carina
