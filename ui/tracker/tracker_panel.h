#pragma once

#include "models/station/tool_status.h"
#include "models/tracker/kept_sound.h"
#include "models/tracker/tool_alarm.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QLabel;
class QTableWidget;

namespace carina
{

class VolumeView;

/// The tools of a tracker as they are seen now, twice a second: visibility, rate, age of the last
/// pose, how well the markers fit, the error that they let expect, what prediction achieves, and
/// where in the working volume they are, in figures and drawn;
/// and what keeps the tracker from tracking. Unless a person silences it, a sound is made when a
/// tool that is needed is lost, and another one when it is back.
class TrackerPanel : public QWidget
{
    Q_OBJECT

public:
    /// std::nullopt without a tracker; may be empty.
    using Sight = std::function<std::optional<TrackerSight>()>;

    static constexpr int kInterval_ms = 500;
    /// So many beeps tell that a tool was lost, and that it is back.
    static constexpr int kBeepsWhenLost = 2;
    static constexpr int kBeepsWhenBack = 1;

    /// @param sound whether there is one, as it was kept
    /// @param use of the tools: which are needed
    explicit TrackerPanel(Sight sight, KeptSound sound = KeptSound{},
                          ToolUse use = ToolUse::Session, QWidget* parent = nullptr);

    /// Offers to have poses predicted or not, and smoothed: two boxes below the table.
    /// @pre not called before.
    void offer(const TreatmentChoice& choice);

    /// Shows how it is now; a timer calls it every kInterval_ms.
    void look();
    /// How many tools were visible then.
    [[nodiscard]] int seen() const { return m_seen; }

Q_SIGNALS:
    /// A tool was seen and is not any more, since two looks.
    void lost(const QString& tool);
    /// One that was lost is seen again.
    void back(const QString& tool);
    /// A sound is made, of so many beeps.
    void sounded(int beeps);

private:
    void show(const std::vector<ToolStatus>& tools);
    void fitRows();
    void listen(const std::vector<ToolStatus>& tools);
    void makeSound(int beeps);
    void suggest(KnownVolume volume);
    void place(const std::vector<ToolStatus>& tools);
    [[nodiscard]] QWidget* volumeRow();

    Sight m_sight;
    KeptSound m_kept;
    ToolAlarm m_alarm;
    QLabel* m_trouble;
    QTableWidget* m_table;
    QCheckBox* m_sound;
    QComboBox* m_volume;
    VolumeView* m_places;
    int m_seen = 0;
    std::optional<KnownVolume> m_suggested; ///< last
};

} // namespace carina
