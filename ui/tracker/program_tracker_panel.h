#pragma once

#include "models/openigtlink/offer_switch.h"
#include "models/station/tool_status.h"
#include "models/tracker/kept_sound.h"
#include "models/tracker/pose_recording.h"
#include "ui/tracker/tracker_panel.h"

#include <QWidget>

#include <functional>
#include <optional>

class QVBoxLayout;

namespace carina
{

/// The tracker of a program in a session, as far as its window shows it.
struct ProgramTracker {
    /// How it sees its tools now; std::nullopt for a program without one.
    std::function<std::optional<TrackerSight>()> sight{};
    PoseRecording* recording = nullptr; ///< of its poses; outlives the window
    bool canBeGiven = false;            ///< whether a person may connect another
    TreatmentChoice treatment{};        ///< of its poses
    KeptSound sound{};                  ///< when a tool is lost
    OfferSwitch* offer = nullptr;       ///< to other programs; outlives the window
};

/// The tools of a program's tracker as they are seen now; above them a person connects another
/// tracker or goes on without, and below them chooses how its poses are treated, records them, and
/// gives what is shown to programs of other makers.
class ProgramTrackerPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ProgramTrackerPanel(const ProgramTracker& tracker, QWidget* parent = nullptr);

    /// How many tools are visible.
    [[nodiscard]] int seen() const { return m_tools->seen(); }

Q_SIGNALS:
    /// A person wants to connect a tracker, or another one.
    void wanted();
    /// A person wants to go on without the tracker.
    void unwanted();

private:
    void offerAnother(QVBoxLayout& column, const ProgramTracker& tracker);

    TrackerPanel* m_tools = nullptr;
};

} // namespace carina
