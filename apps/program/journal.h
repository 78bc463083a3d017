#pragma once

#include "engine/net/node/session_node.h"
#include "ui/scene/station_scene.h"

#include <QCommandLineParser>
#include <QFile>
#include <QJsonArray>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

namespace carina::program
{

/// Logs the displayed state of a program, for later analysis: one JSON object per line, ten times a
/// second. Keys: local_ns (CLOCK_MONOTONIC) and session_ns of the latest frame, facts (number of
/// the last one), session_id, station (its name), anatomy (content hash of the patient drawn),
/// phase, breathing_rate_per_min, tidal_volume_ml, right_lung_ml and left_lung_ml (gas in each,
/// from the mechanics); for the virtual patient patient_owner (a participant's number) and, after
/// an action on it, patient_rate (rad/s, m/s or 1/s of the present motion), patient_xyz_mm,
/// patient_q_xyzw and patient_size: its pose and scale in the anatomy frame. frames has each frame
/// since the line before: session_ns, and of each object of a person that it drew, and of each
/// tracked one of this program's participant (own), object and owner (their numbers), kind (of
/// ObjectKind), xyz_mm and q_xyzw in the anatomy frame (objectsIn); and lifted: of all that it drew
/// lifted out, object, owner, group (a name of groupName, or empty for the second tube), xyz_mm,
/// q_xyzw and size in the anatomy frame (liftedIn). holders has the owner of each object that can
/// be lifted out, by the object's name, while somebody has it; notice, where the program shows one;
/// video_since_ns, the session time of the first picture, while its tracker plays a video.
class Journal
{
public:
    /// What the program tells the person in front of it.
    using Notice = std::function<QString()>;
    /// When the video that it tracks in began; nothing where there is none.
    using VideoSince = std::function<std::optional<SessionTime>()>;

    /// Starts to append to the file, which only its owner may read from then on. @pre all outlive
    /// this.
    /// @returns FileUnwritable with the path.
    [[nodiscard]] static Result<std::unique_ptr<Journal>>
    open(const QString& path, const SessionNode& node, StationId station, StationScene& scene,
         Notice notice, VideoSince videoSince);

    /// Logs another station from now on.
    void setStation(StationId station) { m_station = station; }

private:
    Journal(const SessionNode& node, StationId station, StationScene& scene, Notice notice,
            VideoSince videoSince);
    void writeLine();

    const SessionNode& m_node;
    StationId m_station;
    const StationScene& m_scene;
    /// Since the last line; the scene's listener adds to them while the journal is there.
    std::shared_ptr<QJsonArray> m_frames = std::make_shared<QJsonArray>();
    Notice m_notice;         ///< may be empty
    VideoSince m_videoSince; ///< likewise
    QFile m_file;
    QTimer m_timer;
};

/// Adds `--journal FILE`.
void addJournalOption(QCommandLineParser& parser);

/// The journal for `--journal`; null without it. @returns the errors of Journal::open.
[[nodiscard]] Result<std::unique_ptr<Journal>>
journalFromOptions(const QCommandLineParser& parser, const SessionNode& node, StationId station,
                   StationScene& scene, Journal::Notice notice = {},
                   Journal::VideoSince videoSince = {});

} // namespace carina::program
