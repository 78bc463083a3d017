#pragma once

#include "models/station/tool_status.h"

#include <QWidget>

#include <functional>
#include <map>

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
/// and what keeps the tracker from tracking. On request a sound is made when a tool is lost.
class TrackerPanel : public QWidget
{
    Q_OBJECT

public:
    /// std::nullopt without a tracker; may be empty.
    using Sight = std::function<std::optional<TrackerSight>()>;

    static constexpr int kInterval_ms = 500;

    explicit TrackerPanel(Sight sight, QWidget* parent = nullptr);

    /// Offers to have poses predicted or not, and smoothed: two boxes below the table.
    /// @pre not called before.
    void offer(const TreatmentChoice& choice);

    /// Shows how it is now; a timer calls it every kInterval_ms.
    void look();

Q_SIGNALS:
    /// A tool was seen and is not any more, since two looks.
    void lost(const QString& tool);

private:
    void show(const std::vector<ToolStatus>& tools);
    void listen(const std::vector<ToolStatus>& tools);
    void suggest(KnownVolume volume);
    void place(const std::vector<ToolStatus>& tools);
    [[nodiscard]] QWidget* volumeRow();

    Sight m_sight;
    QLabel* m_trouble;
    QTableWidget* m_table;
    QCheckBox* m_sound;
    QComboBox* m_volume;
    VolumeView* m_places;
    std::optional<KnownVolume> m_suggested; ///< last
    std::map<QString, int> m_unseen;        ///< looks since a tool was seen, by name
};

} // namespace carina
