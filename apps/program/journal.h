#pragma once

#include "engine/net/node/session_node.h"
#include "ui/scene/station_scene.h"

#include <QCommandLineParser>
#include <QFile>
#include <QTimer>

namespace carina::program
{

/// What a program shows, as one JSON object a line ten times a second, for whoever has to
/// understand later what was on which screen when. Keys: local_ns (CLOCK_MONOTONIC) and session_ns
/// of the frame shown last, facts (number of the last), session_id, anatomy
/// (content hash of the patient drawn), phase, breathing_rate_per_min,
/// tidal_volume_ml, right_lung_ml and left_lung_ml (gas in each, by the mechanics); of the virtual
/// patient patient_owner (a participant's number) and, once it was acted on, patient_rate (rad/s,
/// m/s or 1/s of what goes on), patient_xyz_mm, patient_q_xyzw and patient_size, where and how
/// large it is drawn against the anatomy frame.
class Journal
{
public:
    /// Appends to the file from now on. @pre all outlive this.
    /// @returns FileUnwritable with the path.
    [[nodiscard]] static Result<std::unique_ptr<Journal>> open(const QString& path,
                                                               const SessionNode& node,
                                                               StationId station,
                                                               const StationScene& scene);

private:
    Journal(const SessionNode& node, StationId station, const StationScene& scene);
    void writeLine();

    const SessionNode& m_node;
    StationId m_station;
    const StationScene& m_scene;
    QFile m_file;
    QTimer m_timer;
};

/// Adds `--journal FILE`.
void addJournalOption(QCommandLineParser& parser);

/// The journal that `--journal` asks for; null without it. @returns what Journal::open does.
[[nodiscard]] Result<std::unique_ptr<Journal>> journalFromOptions(const QCommandLineParser& parser,
                                                                  const SessionNode& node,
                                                                  StationId station,
                                                                  const StationScene& scene);

} // namespace carina::program
