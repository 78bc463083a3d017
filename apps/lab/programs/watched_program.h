#pragma once

#include "engine/core/result.h"

#include <QProcess>

#include <cstdint>
#include <optional>
#include <string>

namespace carina::lab
{

/// What a process holds of the system, as /proc tells it.
struct Footprint {
    double memory_kb = 0.0; ///< resident memory that no file stands behind (RssAnon), kB
    int descriptors = 0;
    int threads = 0;
};

/// @returns std::nullopt for a process that there is not, or that has ended.
[[nodiscard]] std::optional<Footprint> footprintOf(std::int64_t processId);

/// A program that runs beside this one, and whose footprint is measured.
class WatchedProgram
{
public:
    /// Starts it. @param words the program and its arguments
    WatchedProgram(std::string name, const QStringList& words);
    /// Ends it.
    ~WatchedProgram();
    WatchedProgram(const WatchedProgram&) = delete;
    WatchedProgram& operator=(const WatchedProgram&) = delete;

    [[nodiscard]] const std::string& name() const { return m_name; }
    [[nodiscard]] bool hasEnded() const { return m_process.state() == QProcess::NotRunning; }
    [[nodiscard]] std::int64_t processId() const { return m_process.processId(); }
    [[nodiscard]] std::optional<Footprint> footprint() const { return footprintOf(processId()); }

private:
    std::string m_name;
    QProcess m_process;
};

} // namespace carina::lab
